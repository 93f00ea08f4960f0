#include "engine/core/log.h"
#include "engine/render/gl_null.h"
#include "platform/headless/context.h"

namespace brittle::platform {
namespace {

/// What is wrong with the calls it was given is said in the log: nobody sees it in a picture.
class NullContext : public Context {
 public:
  ~NullContext() override {
    for (const std::string& complaint : gl_.complaints()) logWarning("null backend: " + complaint);
  }
  runtime::GlLoader loader() const override { return render::NullGl::find; }

 private:
  render::NullGl gl_;
};

}  // namespace

std::unique_ptr<Context> createNullContext() {
  return std::make_unique<NullContext>();
}

}  // namespace brittle::platform
