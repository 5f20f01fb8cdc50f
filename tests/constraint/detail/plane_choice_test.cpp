#include "thigma/constraint/detail/plane_choice.h"

#include <gtest/gtest.h>

namespace thigma {
namespace {

detail::RowSearch search_for(const LikelyWay& way) {
  detail::RowSearch search;
  search.reach = {.travel = 1.0, .turn = 0.1, .way = way};
  search.way = way;
  search.least_gap = 0.0;
  return search;
}

double forbidden_at_origin(const detail::RowSearch& search, const Vec3& normal) {
  constexpr double kHeight = 0.2;
  return detail::forbidden(search, Vec3::Zero(), normal, kHeight);
}

TEST(PlaneChoice, WithoutAWayEveryPlaneThatIsNearForbidsAlike) {
  const detail::RowSearch search = search_for({});
  for (const Vec3& normal : {Vec3(1.0, 0.0, 0.0), Vec3(-1.0, 0.0, 0.0), Vec3(0.0, 0.0, 1.0)})
    EXPECT_DOUBLE_EQ(forbidden_at_origin(search, normal), 0.3);  // of half of the travel
}

TEST(PlaneChoice, APlaneThatTheObjectLeavesForbidsNothing) {
  const detail::RowSearch search = search_for({true, 0.4 * Vec3::UnitX()});
  EXPECT_DOUBLE_EQ(forbidden_at_origin(search, Vec3::UnitX()), 0.3);
  EXPECT_DOUBLE_EQ(forbidden_at_origin(search, -Vec3::UnitX()), 0.0);
  // Nor is the way known that well: across it the plane is met by a little.
  EXPECT_NEAR(forbidden_at_origin(search, Vec3::UnitZ()), 0.05, 1e-12);
}

TEST(PlaneChoice, InTheAirTheWaySaysNothing) {
  detail::RowSearch search = search_for({true, 0.4 * Vec3::UnitX()});
  search.least_gap = 0.5;
  EXPECT_DOUBLE_EQ(forbidden_at_origin(search, -Vec3::UnitX()), 0.3);
}

TEST(PlaneChoice, TurningComesToAPlaneOnOneSideOfTheMiddle) {
  const Vec3 turn = 0.1 * Vec3::UnitY();
  for (const double side : {1.0, -1.0}) {
    const detail::RowSearch search =
        search_for({true, Vec3::Zero(), turn, Vec3(-4.0 * side, 0.0, 0.0)});
    // The place is to one side of the middle, and goes down or up.
    const double down = forbidden_at_origin(search, -Vec3::UnitZ());
    EXPECT_DOUBLE_EQ(down, side > 0.0 ? 0.3 : 0.0);
  }
}

}  // namespace
}  // namespace thigma
