#include "platform/headless/headless.h"

#include <gtest/gtest.h>

#include "engine/render/gl.h"
#include "platform/headless/library.h"

namespace brittle::platform {
namespace {

using runtime::Event;
using runtime::EventKind;

class BothBackends : public ::testing::TestWithParam<HeadlessBackend> {};
INSTANTIATE_TEST_SUITE_P(Headless, BothBackends, ::testing::Values(HeadlessBackend::Egl, HeadlessBackend::OsMesa),
                         [](const auto& backend) { return std::string(nameOf(backend.param)); });

TEST_P(BothBackends, GivesAContextForGles3) {
  const auto device = createHeadless(GetParam(), {640, 360});
  ASSERT_TRUE(device) << device.error().message;
  const Result<render::Gl> gl = render::loadGl((*device)->glLoader());
  ASSERT_TRUE(gl) << gl.error().message;
  EXPECT_FALSE(gl->description.empty());
  EXPECT_FALSE((*device)->hasDefaultFramebuffer());
  EXPECT_EQ((*device)->size(), (runtime::PictureSize{640, 360}));
}

TEST_P(BothBackends, CanBeMadeAgainAndAgain) {
  for (int i = 0; i < 3; ++i) ASSERT_TRUE(createHeadless(GetParam(), {8, 8}));
}

TEST_P(BothBackends, GivesTheEventsThatWereSent) {
  const auto device = createHeadless(GetParam(), {640, 360});
  ASSERT_TRUE(device);
  Event event;
  event.kind = EventKind::Resized;
  event.width = 320;
  event.height = 180;
  (*device)->send(event);
  (*device)->send({});
  std::vector<Event> events;
  (*device)->pollEvents(events);
  ASSERT_EQ(events.size(), 2u);
  EXPECT_EQ(events[0].kind, EventKind::Resized);
  EXPECT_EQ(events[1].kind, EventKind::Quit);
  EXPECT_EQ((*device)->size(), (runtime::PictureSize{320, 180}));
  (*device)->pollEvents(events);
  EXPECT_EQ(events.size(), 2u);
}

TEST(Headless, NullTakesEveryCallWithoutADriver) {
  const auto device = createHeadless(HeadlessBackend::Null, {640, 360});
  ASSERT_TRUE(device) << device.error().message;
  const Result<render::Gl> gl = render::loadGl((*device)->glLoader());
  ASSERT_TRUE(gl) << gl.error().message;
  EXPECT_NE(gl->description.find("null"), std::string::npos) << gl->description;
  EXPECT_EQ((*device)->glLoader()("glNoSuchCall"), nullptr);
}

TEST(Headless, RefusesAnEmptyPicture) {
  const auto device = createHeadless(HeadlessBackend::Egl, {0, 360});
  ASSERT_FALSE(device);
  EXPECT_EQ(device.error().message, "picture size 0 x 360: both must be at least 1 pixel");
}

TEST(Library, SaysWhichPackageBringsIt) {
  const Result<Library> library = Library::open("libnosuch.so.1", "libnosuch1");
  ASSERT_FALSE(library);
  EXPECT_EQ(library.error().message, "libnosuch.so.1 is missing: apt-get install libnosuch1");
}

}  // namespace
}  // namespace brittle::platform
