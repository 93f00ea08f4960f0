// platform/headless/context.h - the kinds of off-screen GL context behind one small interface; see headless.h for their
// use.
#pragma once

#include <memory>

#include "engine/core/result.h"
#include "engine/runtime/platform.h"

namespace brittle::platform {

/// A context that is current from creation to destruction.
class Context {
 public:
  virtual ~Context() = default;
  virtual runtime::GlLoader loader() const = 0;
};

Result<std::unique_ptr<Context>> createEglContext();
Result<std::unique_ptr<Context>> createOsMesaContext();
std::unique_ptr<Context> createNullContext();

}  // namespace brittle::platform
