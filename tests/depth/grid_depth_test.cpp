#include "depth/textured_plates.h"
#include "support/full.h"
#include <gtest/gtest.h>

#include "thigma/math/rotation.h"

namespace thigma {
namespace {

// Largest depth over the centres of resolution x resolution cells of the common box, by the slow
// search.
double slow_grid_depth(const DepthContact& contact, const ContactFrame& frame, const PlaneBox& box,
                       int resolution) {
  const Vec3 u = frame.world_from_contact.col(0), v = frame.world_from_contact.col(1);
  const MapGrid grid{box, resolution, resolution};
  double best = kNoDepth;
  for (int k = 0; k < resolution * resolution; ++k) {
    const Vec2 at = grid.at(k % resolution, k / resolution);
    const Vec3 world = contact.point + at.x() * u + at.y() * v;
    const double object =
        test::slow_height(contact.object, world, u, v, contact.normal, test::SlowHeight::of_maps);
    const double scene =
        test::slow_height(contact.scene, world, u, v, -contact.normal, test::SlowHeight::of_maps);
    if (object != kNoDepth && scene != kNoDepth) best = std::max(best, object + scene);
  }
  return best;
}

PlaneBox common_box(const DepthContact& contact, const ContactFrame& frame) {
  ProjectedPatch object, scene;
  project_patch({contact.object.texture, contact.object.triangles, contact.object.world_from_body},
                frame, Facing::along, object);
  project_patch({contact.scene.texture, contact.scene.triangles, contact.scene.world_from_body},
                frame, Facing::against, scene);
  return intersection(object.box, scene.box);
}

TEST(GridDepth, equals_the_maximum_over_the_grid) {
  Random random(1);
  const int resolution = 20;
  const auto backend = make_grid_depth({.resolution = resolution, .is_polished = false}),
             of_texels = make_grid_depth(
                 {.resolution = resolution, .has_quads = false, .is_polished = false});
  for (int i = 0; i < 20; ++i) {
    const test::PlateContact p(random, {.cells = 1 + i % 3, .bend = 2.0});
    const DepthSamples got = test::depth_of(*backend, p.contact),
                       exact = test::depth_of(*of_texels, p.contact);
    ASSERT_TRUE(got.is_found);
    const PlaneBox box = common_box(p.contact, got.frame);
    const double want = slow_grid_depth(p.contact, got.frame, box, resolution);
    EXPECT_NEAR(exact.depth[0], want, 1e-9);
    // Heights in 16 bits: each side a 65,536th of its range. Plates lean by up to 0.3.
    const double range = kMostSteps * (p.object.quads.step + p.scene.quads.step);
    EXPECT_NEAR(got.depth[0], want, range / 65536.0 / 0.9 + 1e-9);
    EXPECT_TRUE(std::isinf(got.remaining));
  }
}

// A tilted triangle under a plate that is all but flat: the deepest point is a corner, and samples
// lie far from it where it is sharp. Steps along the axes leave the triangle; those along its edges
// do not.
TEST(GridDepth, climbs_along_slanting_edges) {
  Random random(7);
  constexpr double kSide = 0.02, kRelief = 1e-6;
  const HapticTexture plate = make_texture(test::plate_source(random, {.size = 2.0 * kSide,
                                                                       .texels = 128,
                                                                       .amplitude = kRelief / 3.0,
                                                                       .bend = 0.0,
                                                                       .is_reversed = true}),
                                           "plate");
  const std::vector<std::int32_t> all = test::all_triangles(plate), only = {0};
  const auto grid = make_grid_depth({}), coarse = make_grid_depth({.is_polished = false});
  double missed_before = 0.0;
  for (int i = 0; i < 100; ++i) {
    // An angle of 6 to 35 degrees at the corner that is raised.
    const double half = random.uniform(0.05, 0.3), slope = random.uniform(0.03, 0.1);
    TriangleMesh mesh;
    for (const double angle : {0.0, -half, half}) {
      const double length = angle == 0.0 ? 0.0 : kSide;
      const Vec3 at(length * cosine(angle), length * sine(angle), 0.0);
      mesh.positions.push_back(at - Vec3(0.5 * kSide, 0.0, slope * at.x()));
    }
    mesh.triangles = {{0, 1, 2}};
    const HapticTexture triangle = make_plain_texture(mesh, "triangle");
    DepthContact contact;
    contact.object = {
        &triangle, only,
        Pose{Vec3::Zero(), rotation_from_vector(Vec3(0.0, 0.0, random.uniform(-3.0, 3.0)))}};
    contact.scene = {&plate, all, Pose{}};
    const double got = test::depth_of(*grid, contact).depth[0];
    // An eighth of a texel is the last step; across a sharp corner it fits only so far from the
    // tip.
    const double from_tip = 0.125 * plate.texel_size * (1.0 + 1.0 / half);
    EXPECT_NEAR(got, 0.0, 2.0 * kRelief + from_tip * slope) << i;
    missed_before = std::max(missed_before, -test::depth_of(*coarse, contact).depth[0]);
  }
  EXPECT_GT(missed_before, 2e-5) << "or there is nothing to climb";
}

// On many contacts: bit for bit, which is more than 1e-6 of the amplitude.
// Waves about as long as two cells: the samples alias, and the highest of them is often on a wrong
// crest.
TEST(GridDepth, finds_crests_that_lie_between_samples) {
  Random random(11);
  const auto grid = make_grid_depth({}), branch = make_branch_depth({});
  double missed = 0.0;
  constexpr int kContacts = 40;
  for (int i = 0; i < kContacts; ++i) {
    test::PlateContact p(random, {.texels = 256, .amplitude = 1e-4, .bend = 0.1, .waves = 25.0});
    const double want = test::depth_of(*branch, p.contact).depth[0],
                 got = test::depth_of(*grid, p.contact).depth[0];
    missed += std::max(want - got, 0.0) / (p.object.amplitude + p.scene.amplitude) / kContacts;
  }
  RecordProperty("missed", std::to_string(missed));
  EXPECT_LT(missed, 0.05) << "0.065 with one summit looked at";
}

// A slanting end of one side cuts a narrow hill of the other beside its top: what is left of it is
// less than a cell wide, and the deepest place is on the end.
TEST(GridDepth, finds_the_deepest_place_on_the_end_of_a_patch) {
  Random random(13);
  constexpr double kSide = 0.02, kHeight = 5e-4, kRadius = 3e-4, kSlope = kHeight / kRadius;
  constexpr int kTexels = 513;
  const double texel = kSide / (kTexels - 1);
  const auto grid = make_grid_depth({});
  double worst = 0.0;
  for (int i = 0; i < 40; ++i) {
    TextureSource source = test::plate_source(
        random, {.size = kSide, .cells = 1, .texels = kTexels, .amplitude = 0.0, .bend = 0.0});
    const Vec2 top(0.3 * kSide * random.uniform(-1.0, 1.0),
                   0.3 * kSide * random.uniform(-1.0, 1.0));
    for (int k = 0; k < kTexels * kTexels; ++k) {
      const Vec2 at = texel * Vec2(k % kTexels, k / kTexels) - Vec2::Constant(0.5 * kSide);
      const double height = std::max(kHeight - kSlope * (at - top).norm(), 0.0);
      source.texels[static_cast<std::size_t>(k)].z = static_cast<float>(height);
    }
    const HapticTexture hill = make_texture(std::move(source), "hill");
    // The end passes the top at a distance, which lies outside.
    const double angle = random.uniform(-3.0, 3.0), aside = kRadius * random.uniform(0.3, 0.7);
    const Vec3 out(cosine(angle), sine(angle), 0.0), along(-out.y(), out.x(), 0.0);
    const Vec3 end = Vec3(top.x(), top.y(), 0.0) - aside * out;
    TriangleMesh mesh;
    mesh.positions = {end + 3.0 * kSide * along, end - 3.0 * kSide * along,
                      end - 3.0 * kSide * out};
    mesh.triangles = {{0, 1, 2}};
    const HapticTexture cut = make_plain_texture(mesh, "cut");
    const std::vector<std::int32_t> both = test::all_triangles(hill), only = {0};
    DepthContact contact;
    contact.object = {&hill, both, Pose{}};
    contact.scene = {&cut, only, Pose{}};
    const double want = kHeight - kSlope * aside, got = test::depth_of(*grid, contact).depth[0];
    worst = std::max(worst, std::fabs(got - want));
  }
  RecordProperty("worst", std::to_string(worst));
  EXPECT_LT(worst, 0.5 * texel * kSlope) << "missed by as much as what is left, where it was not";
}

TEST(GridDepth, scalar_and_widest_are_the_same) {
  Random random(2);
  const auto scalar = make_grid_depth({.width = SpanWidth::scalar});
  const auto widest = make_grid_depth({.width = SpanWidth::widest});
  const int plates = test::is_full() ? 1000 : 20;  // ten contacts each
  int found = 0;
  for (int i = 0; i < plates; ++i) {
    test::PlateContact p(random, {.cells = 1 + i % 3, .bend = 2.0, .noise = 5e-5});
    for (int k = 0; k < 10; ++k) {
      test::shuffle_contact(random, p, 0.02);
      const DepthRequest request{.has_differences = true, .near = k % 2 ? 1e-4 : 0.0};
      const DepthSamples a = test::depth_of(*scalar, p.contact, request),
                         b = test::depth_of(*widest, p.contact, request);
      ASSERT_EQ(a.is_found, b.is_found);
      EXPECT_EQ(a.depth, b.depth);
      EXPECT_EQ(a.at, b.at);
      EXPECT_EQ(a.near.size(), b.near.size());
      found += a.is_found;
    }
  }
  EXPECT_GT(found, 9 * plates);
}

TEST(GridDepth, polishing_finds_more_than_the_grid_and_never_more_than_all_texels_allow) {
  Random random(3);
  const auto rough = make_grid_depth({.is_polished = false}), polished = make_grid_depth({});
  const auto exact = make_branch_depth({});
  double missed_rough = 0.0, missed_polished = 0.0;
  for (int i = 0; i < 12; ++i) {
    // leaning plates: steeper turns over
    const test::PlateShape shape{.texels = 256, .amplitude = 4e-5, .waves = 20.0};
    const test::PlateContact p(random, shape);
    const double all = test::depth_of(*exact, p.contact).depth[0];
    const double best = test::depth_of(*polished, p.contact).depth[0],
                 grid = test::depth_of(*rough, p.contact).depth[0];
    // maps are right to first order in what lies sideways
    EXPECT_GE(best, grid - 0.1 * shape.amplitude);
    // Between texels of both sides the depth can exceed that at texels by what interpolation does
    // over half a texel, and at the end of a plate, where no texel's fine point is but the nearest
    // one stands in, by its slope.
    EXPECT_LE(best, all + 0.2 * shape.amplitude);
    missed_rough += all - grid;
    missed_polished += std::max(all - best, 0.0);
  }
  EXPECT_LT(missed_polished, 0.5 * missed_rough);
}

TEST(GridDepth, moved_configurations_are_those_of_the_moved_object) {
  Random random(4);
  const int resolution = 64;
  const auto backend = make_grid_depth({.resolution = resolution, .is_polished = false});
  for (int i = 0; i < 3; ++i) {
    test::Hills hills;
    const DepthContact& contact = hills.contact;
    hills.contact.object.world_from_body.orientation =
        rotation_from_vector(Vec3(0.01, 0.02, 1.0 * i));
    const DepthSamples got = test::depth_of(*backend, contact, {.has_differences = true});
    ASSERT_TRUE(got.is_found);
    EXPECT_GT(got.shift, 0.0);
    EXPECT_NEAR(got.turn * (contact.point - contact.centre).norm(), got.shift, 1e-12);
    const PlaneBox box = common_box(contact, got.frame);
    for (int k = 1; k < kConfigurations; ++k) {
      DepthContact moved = contact;
      moved.object.world_from_body =
          configuration_motion(got, contact.centre, k) * moved.object.world_from_body;
      const double want = slow_grid_depth(moved, got.frame, box, resolution);
      // Rendered anew, the tilted ones are exact; the others interpolate between samples 0.3 mm
      // apart.
      const bool is_tilted = k >= 5 && k <= 8;
      EXPECT_NEAR(got.depth[static_cast<std::size_t>(k)], want, is_tilted ? 1e-9 : 2e-6) << k;
    }
  }
}

TEST(GridDepth, patches_apart_sideways_and_nonsense_have_no_depth) {
  Random random(6);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  test::PlateContact p(random, {});
  const DepthContact good = p.contact;
  for (const auto& backend : {make_grid_depth({}), make_branch_depth({})}) {
    EXPECT_TRUE(test::depth_of(*backend, good).is_found);
    std::vector<DepthContact> bad(8, good);
    const ContactFrame frame = contact_frame(good.point, good.normal);
    bad[0].object.world_from_body.position += 0.05 * frame.world_from_contact.col(0);
    bad[1].object.world_from_body.position.x() = nan;
    bad[2].scene.world_from_body.orientation.w() = nan;
    bad[3].normal.y() = nan;
    bad[4].normal.setZero();
    bad[5].object.triangles = {};
    bad[6].scene.texture = nullptr;
    bad[7].object.world_from_body.position.z() = 1e200;
    for (const DepthContact& contact : bad) {
      const DepthSamples got =
          test::depth_of(*backend, contact, {.has_differences = true, .near = 1e-4});
      EXPECT_FALSE(got.is_found);
      EXPECT_EQ(got.depth[0], kNoDepth);
    }
    EXPECT_TRUE(test::depth_of(*backend, good).is_found);
    for (const double far : {1e6, 1e12, 1e30, 1e90}) {  // whatever comes of it, it comes to an end
      DepthContact away = good;
      away.point += Vec3::Constant(far);
      const DepthSamples got = test::depth_of(*backend, away, {.has_differences = true});
      EXPECT_TRUE(!got.is_found || std::isfinite(got.depth[0]));
    }
  }
}

TEST(GridDepth, batch_gives_what_single_calls_give) {
  Random random(7);
  std::vector<std::unique_ptr<test::PlateContact>> plates;
  std::vector<DepthContact> contacts;
  for (int i = 0; i < 5; ++i) {
    plates.push_back(
        std::make_unique<test::PlateContact>(random, test::PlateShape{.cells = 1 + i}));
    contacts.push_back(plates.back()->contact);
  }
  const DepthRequest request{.has_differences = true};
  for (const auto& make :
       {+[] { return make_grid_depth({}); }, +[] { return make_branch_depth({}); }}) {
    std::vector<DepthSamples> results(5);
    make()->sample(contacts, request, results);
    for (std::size_t i = 0; i < 5; ++i)
      EXPECT_EQ(results[i].depth, test::depth_of(*make(), contacts[i], request).depth);
  }
}

}  // namespace
}  // namespace thigma
