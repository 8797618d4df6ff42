// SPDX-License-Identifier: MIT
// What probe_contexts() starts in its tests: OpenGL drivers of every kind, named after what they do when they
// are asked for a context. Each word is one family, "x:works,segv" with two candidates; those to skip come
// after "--".
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <sstream>

#include "render/context/probe.h"

namespace {

using namespace pabd;

struct NoContext final : GlContext {
  void make_current() override {}
  void release() override {}
  void* proc_address(const char*) override { return nullptr; }
  void framebuffer_size(int& width, int& height) const override { width = height = 0; }
  void present() override {}
  std::string name() const override { return "none"; }
  std::unique_ptr<GlContext> share() override { return nullptr; }
};

std::unique_ptr<GlContext> act(const std::string& name, std::string& failure) {
  if (name == "segv") ::raise(SIGSEGV);
  if (name == "abrt") ::raise(SIGABRT);
  if (name == "bus") ::raise(SIGBUS);
  if (name == "leaves") ::_exit(0);
  if (name == "stays") ::pause();
  if (name == "works") return std::make_unique<NoContext>();
  failure = "not\ntoday";
  return nullptr;
}

ContextFamily family(const std::string& word) {
  const std::size_t colon = word.find(':');
  return {word.substr(0, colon), [word, colon](std::vector<ContextCandidate>& out) {
            std::istringstream names(word.substr(colon + 1));
            for (std::string name; std::getline(names, name, ',');) {
              if (name == "crashes") ::raise(SIGBUS);  // when it is asked what there is
              out.push_back({name, [name](std::string& failure) { return act(name, failure); }});
            }
          }};
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> words(argv + 1, argv + argc);
  const auto end = std::find(words.begin(), words.end(), "--");
  std::vector<ContextFamily> families;
  for (auto word = words.begin(); word != end; ++word) families.push_back(family(*word));
  try_contexts(families, {end, words.end()});
}
