#include "engine/geometry/convex.h"

#include <gtest/gtest.h>

#include "engine/geometry/make.h"

namespace brittle::geometry {
namespace {

TEST(Convex, BoxIsValid) {
  const Convex box = makeBox<float>(Vec3(1.0f, 2.0f, 3.0f));
  EXPECT_STREQ(findTopologyError(box.view()), nullptr);
  EXPECT_EQ(convexityError(box), 0.0f);
  EXPECT_EQ(extentOf(box.view()), 6.0f);
}

}  // namespace
}  // namespace brittle::geometry
