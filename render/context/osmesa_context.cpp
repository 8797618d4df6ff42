// SPDX-License-Identifier: MIT
// Headless context from OSMesa: Mesa's software renderer without any display system.
#include <GL/osmesa.h>

#include <array>

#include "render/context/candidate.h"
#include "render/context/shared_library.h"
#include "sim/base/error.h"

namespace pabd {
namespace {

constexpr const char* kMesaNames[] = {"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so", nullptr};
constexpr int kSize = 16;  // of the buffer that OSMesa insists on; frames are drawn into framebuffer objects

struct OsMesaLibrary {
  OsMesaLibrary() : library(kMesaNames) {
    if (!library.is_open()) {
      failure = library.error();
      return;
    }
    create = library.find<decltype(create)>("OSMesaCreateContextAttribs");
    destroy = library.find<decltype(destroy)>("OSMesaDestroyContext");
    make_current = library.find<decltype(make_current)>("OSMesaMakeCurrent");
    get_current = library.find<decltype(get_current)>("OSMesaGetCurrentContext");
    get_proc_address = library.find<decltype(get_proc_address)>("OSMesaGetProcAddress");
    if (!create || !destroy || !make_current || !get_current || !get_proc_address) {
      failure = "libOSMesa lacks OSMesaCreateContextAttribs: Mesa 12 or newer is needed";
    }
  }

  SharedLibrary library;
  std::string failure;
  OSMesaContext (*create)(const int*, OSMesaContext) = nullptr;
  void (*destroy)(OSMesaContext) = nullptr;
  GLboolean (*make_current)(OSMesaContext, void*, GLenum, GLsizei, GLsizei) = nullptr;
  OSMesaContext (*get_current)() = nullptr;
  OSMESAproc (*get_proc_address)(const char*) = nullptr;
};

class OsMesaContext final : public GlContext {
 public:
  // `partner`: whose buffers it has, or null.
  explicit OsMesaContext(std::shared_ptr<const OsMesaLibrary> library, const OsMesaContext* partner = nullptr)
      : library_(std::move(library)), partner_(partner ? partner->context_ : nullptr) {}

  ~OsMesaContext() override {
    if (context_ == nullptr) return;
    release();
    library_->destroy(context_);
  }

  OsMesaContext(const OsMesaContext&) = delete;
  OsMesaContext& operator=(const OsMesaContext&) = delete;

  // Empty on success, otherwise the reason. Current afterwards.
  std::string open() {
    if (!create()) return "OSMesaCreateContextAttribs refused OpenGL 3.3 core";
    if (!bind()) return "OSMesaMakeCurrent failed";
    return check_gl_version(*this);
  }

  std::unique_ptr<GlContext> share() override {
    auto out = std::make_unique<OsMesaContext>(library_, this);
    if (!out->create()) throw Error(ErrorKind::no_context, "OSMesa refused a context that shares buffers");
    return out;
  }

  void make_current() override {
    if (!bind()) throw Error(ErrorKind::no_context, "OSMesa: OSMesaMakeCurrent failed");
  }

  void release() override {
    if (library_->get_current() == context_) library_->make_current(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0);
  }

  void* proc_address(const char* name) override {
    return reinterpret_cast<void*>(library_->get_proc_address(name));
  }
  std::string name() const override { return "OSMesa"; }

 private:
  bool create() {
    for (const auto [major, minor] : kAskedVersions) {
      const int attributes[] = {OSMESA_FORMAT,
                                OSMESA_RGBA,
                                OSMESA_PROFILE,
                                OSMESA_CORE_PROFILE,
                                OSMESA_CONTEXT_MAJOR_VERSION,
                                major,
                                OSMESA_CONTEXT_MINOR_VERSION,
                                minor,
                                0};
      context_ = library_->create(attributes, partner_);
      if (context_ != nullptr) break;
    }
    return context_ != nullptr;
  }

  bool bind() {
    return library_->make_current(context_, buffer_.data(), GL_UNSIGNED_BYTE, kSize, kSize) == GL_TRUE;
  }

  std::shared_ptr<const OsMesaLibrary> library_;
  OSMesaContext partner_, context_ = nullptr;
  std::array<unsigned char, 4 * kSize * kSize> buffer_{};
};

}  // namespace

void add_osmesa_candidates(std::vector<ContextCandidate>& out) {
  out.push_back({"OSMesa", [](std::string& failure) -> std::unique_ptr<GlContext> {
                   const auto library = std::make_shared<const OsMesaLibrary>();
                   failure = library->failure;
                   if (!failure.empty()) return nullptr;
                   auto context = std::make_unique<OsMesaContext>(library);
                   failure = context->open();
                   if (!failure.empty()) return nullptr;
                   return context;
                 }});
}

}  // namespace pabd
