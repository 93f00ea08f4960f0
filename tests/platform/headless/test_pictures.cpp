#include <gtest/gtest.h>

#include "engine/render/gl.h"
#include "gallery.h"
#include "platform/headless/headless.h"

namespace brittle::render {
namespace {

using platform::HeadlessBackend;

/// A context, a renderer and the gallery on it.
class Pictures : public ::testing::TestWithParam<HeadlessBackend> {
 protected:
  static Image draw(HeadlessBackend backend, const RendererDef& def) {
    const auto device = platform::createHeadless(backend, {def.width, def.height});
    if (!device) {
      ADD_FAILURE() << device.error().message;
      return {};
    }
    Result<Gl> gl = loadGl((*device)->glLoader());
    if (!gl) {
      ADD_FAILURE() << gl.error().message;
      return {};
    }
    const auto renderer = Renderer::create(*gl, def);
    if (!renderer) {
      ADD_FAILURE() << renderer.error().message;
      return {};
    }
    Gallery gallery;
    fillGallery(gallery);
    gallery.frame.statics.push_back({(*renderer)->createStatic(gallery.room.vertices, gallery.room.indices), Vec3::Zero()});
    (*renderer)->draw(gallery.frame);
    EXPECT_EQ(glErrorName(gl->GetError()), "no error");
    return (*renderer)->readBack();
  }
};

constexpr RendererDef kSmall = {.width = 320, .height = 180};

TEST_F(Pictures, OfBothBackendsAgree) {
  const ImageDifference difference = compare(draw(HeadlessBackend::Egl, kSmall), draw(HeadlessBackend::OsMesa, kSmall));
  // Measured: identical on one machine. The limit allows for drivers of different builds.
  EXPECT_LE(difference.largest, 16);
  EXPECT_LT(difference.mean, 0.25);
}

}  // namespace
}  // namespace brittle::render
