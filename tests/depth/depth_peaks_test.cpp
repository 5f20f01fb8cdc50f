#include "thigma/depth/depth_peaks.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "depth/textured_plates.h"
#include <gtest/gtest.h>

namespace thigma {
namespace {

PeakRequest request_for(double travel) {
  PeakRequest request;
  request.travel = travel;
  request.least = -1e-3;
  request.near = -1e-3;
  request.error = 1e-7;
  request.least_travel = 1e-6;
  return request;
}

double shape_at(const DepthPeak& peak, const Vec2& way) {
  return peak.depth + peak.slope.dot(way) + 0.5 * way.dot(peak.bend * way);
}

DepthContact moved_along(const test::Hills& hills, const Vec3& way) {
  DepthContact contact = hills.contact;
  contact.object.world_from_body.position +=
      contact_frame(contact.point, contact.normal).world_from_contact * way;
  return contact;
}

TEST(DepthPeaks, TwoHillsHaveOneWhoseShapeHoldsWhereTheObjectGoes) {
  const test::Hills hills;
  const auto search = std::make_unique<PeakScratch>();
  DepthPeaks peaks;
  const PeakStats stats = find_peaks(hills.contact, request_for(2e-4), *search, peaks);
  EXPECT_TRUE(stats.is_found && stats.is_height_field);
  ASSERT_EQ(peaks.size(), 1u);
  // The hills bend by 20 and 30 1/m: where both give way the depth bends by 20 30 / (20 + 30).
  // A peak lies on a corner of facets, the depths beside it mostly not: 0.8 is 16 nm of way.
  EXPECT_NEAR(peaks[0].bend(0, 0), -12.0, 0.8);
  EXPECT_NEAR(peaks[0].bend(1, 1), -12.0, 0.8);
  EXPECT_NEAR(peaks[0].bend(0, 1), 0.0, 0.3);
  const auto branch = make_branch_depth({});
  Random random(3);
  for (int trial = 0; trial < 20; ++trial) {
    Vec3 way = 2e-4 * random.in_cube(0.7);
    const double depth = test::depth_of(*branch, moved_along(hills, way)).depth[0];
    EXPECT_NEAR(shape_at(peaks[0], way.head<2>()) + way.z(), depth, 1e-7) << trial;
  }
}

TEST(DepthPeaks, TheDeepestIsTheDepthOverAllTexels) {
  Random random(7);
  const auto search = std::make_unique<PeakScratch>();
  for (int trial = 0; trial < 6; ++trial) {
    const test::PlateContact plates(random, {.cells = 1, .texels = 33, .waves = 2.0});
    DepthPeaks peaks;
    PeakRequest request = request_for(2e-5);
    request.least = request.near = -0.1;
    find_peaks(plates.contact, request, *search, peaks);
    const double depth = test::slow_depth(plates.contact);
    if (depth == kNoDepth) continue;
    ASSERT_FALSE(peaks.empty()) << trial;
    // Between texels it may be deeper than at any. Tilted plates are deepest at a corner of the
    // domain, which a climb comes to within a thirtieth of a texel, 0.6 mm.
    EXPECT_GE(peaks[0].depth, depth - 2e-5) << trial;
    EXPECT_LE(peaks[0].depth, depth + 4e-5) << trial;
    for (std::size_t i = 1; i < peaks.size(); ++i)
      EXPECT_LE(peaks[i].depth, peaks[i - 1].depth) << trial;
  }
}

/// A plate of 20 mm with ridges along y, every 5 mm; reversed it lies on the other everywhere.
HapticTexture ridged(bool is_reversed, double texels = 50.0) {
  Random random(1);
  TextureSource source = test::plate_source(
      random, {.cells = 1, .texels = 201, .bend = 0.0, .is_reversed = is_reversed});
  for (int j = 0; j < 201; ++j)
    for (int i = 0; i < 201; ++i)
      source.texels[static_cast<std::size_t>(201 * j + i)] = {
          0.0f, 0.0f, static_cast<float>(1e-4 * std::cos(2.0 * M_PI * i / texels))};
  return make_texture(std::move(source), "ridged");
}

TEST(DepthPeaks, RidgesThatLieOnAPlateHavePeaksNearBothEnds) {
  const HapticTexture object = ridged(false);
  Random random(1);
  TextureSource flat = test::plate_source(
      random, {.cells = 1, .texels = 3, .amplitude = 0.0, .bend = 0.0, .is_reversed = true});
  const HapticTexture scene = make_texture(std::move(flat), "flat");
  const std::vector<std::int32_t> triangles = test::all_triangles(object);
  DepthContact contact;
  contact.object = {&object, triangles, Pose{Vec3(0.0, 0.0, -1.1e-4), Quat::Identity()}};
  contact.scene = {&scene, triangles, Pose{}};
  PeakRequest request = request_for(1e-5);
  request.least = request.near = -3e-5;
  request.turn = 1e-3;
  DepthPeaks peaks;
  find_peaks(contact, request, *std::make_unique<PeakScratch>(), peaks);
  double low = 0.0, high = 0.0;
  for (const DepthPeak& peak : peaks) {
    EXPECT_NEAR(peak.depth, -1e-5, 1e-8);
    const Vec3 at = contact_frame(contact.point, contact.normal).world_from_contact *
                    Vec3(peak.at.x(), peak.at.y(), 0.0);
    low = std::min(low, at.y());
    high = std::max(high, at.y());
    EXPECT_NEAR(std::remainder(at.x(), 5e-3), 0.0, 1e-4);
    if (std::fabs(at.x()) > 9e-3) continue;  // where a side ends
    EXPECT_NEAR(peak.slope.norm(), 0.0, 1e-3);
  }
  EXPECT_LT(low, -9.5e-3);
  EXPECT_GT(high, 9.5e-3);
}

TEST(DepthPeaks, SurfacesThatConformTouchOnTheOtherFlankAfterAWay) {
  // Ridges in grooves, 20 um off to one side: they touch on that flank of every ridge, and on the
  // other one after a way to the other side. Ridges as far apart as blocks of samples: each block
  // has both.
  const HapticTexture object = ridged(false, 25.0), scene = ridged(true, 25.0);
  const std::vector<std::int32_t> triangles = test::all_triangles(object);
  const auto contact_at = [&](double x) {
    DepthContact contact;
    contact.object = {&object, triangles, Pose{Vec3(x, 0.0, 0.0), Quat::Identity()}};
    contact.scene = {&scene, triangles, Pose{Vec3(0.0, 0.0, 1e-5), Quat::Identity()}};
    return contact;
  };
  constexpr double kTravel = 1.5e-4;
  PeakRequest request = request_for(kTravel);
  request.least = -3.0 * kTravel - 2e-4;
  request.near = request.least;
  request.error = 1e-6;
  DepthPeaks peaks;
  const DepthContact contact = contact_at(2e-5);
  const Mat3 axes = contact_frame(contact.point, contact.normal).world_from_contact;
  const auto search = std::make_unique<PeakScratch>();
  const PeakStats stats = find_peaks(contact, request, *search, peaks);
  EXPECT_EQ(stats.left_out, 0);
  EXPECT_LE(stats.excess, request.error);
  const auto branch = make_branch_depth({});
  for (const double way : {-0.9, -0.5, 0.5, 0.9}) {
    const Vec3 by = axes.transpose() * Vec3(way * kTravel, 0.0, 0.0);
    double shape = kNoDepth;
    for (const DepthPeak& peak : peaks) shape = std::max(shape, shape_at(peak, by.head<2>()));
    const double depth = test::depth_of(*branch, contact_at(2e-5 + way * kTravel)).depth[0];
    EXPECT_GE(shape, depth - request.error) << way;
    EXPECT_LE(shape, depth + 5e-6) << way;
  }
}

TEST(DepthPeaks, TravelEndsWhereTheShapeDoes) {
  const HapticTexture object = ridged(false);
  const HapticTexture scene = make_texture(test::hill(30.0, true), "scene");
  const std::vector<std::int32_t> triangles = test::all_triangles(object);
  DepthContact contact;
  contact.object = {&object, triangles, Pose{Vec3(8e-4, 0.0, 0.0), Quat::Identity()}};
  contact.scene = {&scene, triangles, Pose{}};
  DepthPeaks peaks;
  PeakRequest request = request_for(1e-3);
  request.error = 5e-8;
  const PeakStats stats = find_peaks(contact, request, *std::make_unique<PeakScratch>(), peaks);
  EXPECT_LT(stats.travel, 1e-3);
  EXPECT_GT(stats.travel, 3e-5);
  EXPECT_LE(stats.excess, request.error);
  const auto branch = make_branch_depth({});
  for (int i = 0; i < 12; ++i) {
    const Vec2 way = stats.travel * Vec2(std::cos(0.5 * i), std::sin(0.5 * i));
    double shape = kNoDepth;
    for (const DepthPeak& peak : peaks) shape = std::max(shape, shape_at(peak, way));
    DepthContact there = contact;
    there.object.world_from_body.position +=
        contact_frame(contact.point, contact.normal).world_from_contact *
        Vec3(way.x(), way.y(), 0.0);
    // Of texel centres alone.
    EXPECT_LE(test::depth_of(*branch, there).depth[0], shape + request.error + 1e-7) << i;
  }
}

TEST(DepthPeaks, PatchesWithoutACommonDomainHaveNone) {
  test::Hills hills;
  hills.contact.object.world_from_body.position.x() += 0.1;
  DepthPeaks peaks;
  EXPECT_FALSE(find_peaks(hills.contact, request_for(1e-4), *std::make_unique<PeakScratch>(), peaks)
                   .is_found);
  EXPECT_TRUE(peaks.empty());
}

TEST(DepthPeaks, SameContactSamePeaks) {
  const test::Hills hills;
  const auto a = std::make_unique<PeakScratch>(), b = std::make_unique<PeakScratch>();
  DepthPeaks first, second;
  find_peaks(hills.contact, request_for(2e-4), *a, first);
  find_peaks(moved_along(hills, Vec3(1e-3, 0.0, 0.0)), request_for(1e-4), *b, second);
  find_peaks(hills.contact, request_for(2e-4), *b, second);
  ASSERT_EQ(first.size(), second.size());
  for (std::size_t i = 0; i < first.size(); ++i) {
    EXPECT_EQ(first[i].at, second[i].at);
    EXPECT_EQ(first[i].bend, second[i].bend);
  }
}

}  // namespace
}  // namespace thigma
