// SPDX-License-Identifier: MIT
// Drivers that crash, leave or say no when they are asked for a context: found out in a child process.
#include <unistd.h>

#include <catch2/catch.hpp>
#include <csignal>
#include <cstdlib>

#include "render/context/probe.h"

namespace pabd::test_probe {

namespace {

struct NoContext final : GlContext {
  void make_current() override {}
  void release() override {}
  void* proc_address(const char*) override { return nullptr; }
  void framebuffer_size(int& width, int& height) const override { width = height = 0; }
  void present() override {}
  std::string name() const override { return "none"; }
  std::unique_ptr<GlContext> share() override { return nullptr; }
};

ContextCandidate works(const std::string& name) {
  return {name, [](std::string&) { return std::make_unique<NoContext>(); }};
}

ContextCandidate dies(const std::string& name, int signal) {
  return {name, [signal](std::string&) -> std::unique_ptr<GlContext> {
            ::raise(signal);
            return nullptr;
          }};
}

ContextCandidate leaves(const std::string& name) {
  return {name, [](std::string&) -> std::unique_ptr<GlContext> { ::_exit(0); }};
}

ContextCandidate refuses(const std::string& name) {
  return {name, [](std::string& failure) -> std::unique_ptr<GlContext> {
            failure = "not today";
            return nullptr;
          }};
}

ContextFamily family(const std::string& name, const std::vector<ContextCandidate>& list) {
  return {name,
          [list](std::vector<ContextCandidate>& out) { out.insert(out.end(), list.begin(), list.end()); }};
}

// "name: failure" of each attempt.
std::vector<std::string> probed(const std::vector<ContextFamily>& families) {
  std::vector<std::string> out;
  for (const ContextAttempt& attempt : probe_contexts(families))
    out.push_back(attempt.name + ": " + attempt.failure);
  return out;
}

using List = std::vector<std::string>;

}  // namespace

TEST_CASE("candidates are tried in order, past those that crash, to the first that works") {
  CHECK(probed({family("x", {works("a"), dies("b", SIGSEGV)})}) == List{"a: "});
  CHECK(probed({family("x", {refuses("a"), dies("b", SIGSEGV), refuses("c"), dies("d", SIGABRT)}),
                family("y", {leaves("e"), works("f"), dies("g", SIGSEGV)})}) ==
        List{"a: not today", "b: the driver crashed (signal 11)", "c: not today",
             "d: the driver crashed (signal 6)", "e: the driver ended the process", "f: "});
}

TEST_CASE("when none works every one says why, and this process lives") {
  CHECK(probed({family("x", {dies("a", SIGILL)}), family("y", {refuses("b")})}) ==
        List{"a: the driver crashed (signal 4)", "b: not today"});
}

TEST_CASE("a library that crashes when it is asked what there is") {
  const ContextFamily crashing = {"x", [](std::vector<ContextCandidate>&) { ::raise(SIGBUS); }};
  CHECK(probed({crashing, family("y", {works("b")})}) == List{"x: the driver crashed (signal 7)", "b: "});
  CHECK(probed({family("y", {refuses("b")}), crashing}) ==
        List{"b: not today", "x: the driver crashed (signal 7)"});
}

}  // namespace pabd::test_probe
