// SPDX-License-Identifier: MIT
// A context inside another one, some of whose functions a test replaces.
#pragma once

#include "render/context/context.h"

namespace pabd::testing {

class WrappedContext : public GlContext {
 public:
  explicit WrappedContext(GlContext& inside) : inside_(inside) {}
  void make_current() override { inside_.make_current(); }
  void release() override { inside_.release(); }
  void* proc_address(const char* name) override { return inside_.proc_address(name); }
  void framebuffer_size(int& width, int& height) const override { inside_.framebuffer_size(width, height); }
  void present() override {}
  std::string name() const override { return inside_.name(); }
  std::unique_ptr<GlContext> share() override { return inside_.share(); }

 private:
  GlContext& inside_;
};

}  // namespace pabd::testing
