#include "thigma/contact/distribute_contacts.h"

#include <cmath>

#include "support/query_path.h"
#include <gtest/gtest.h>

#include "thigma/contact/detail/shared_area.h"
#include "thigma/math/random.h"
#include "thigma/math/rotation.h"
#include "thigma/mesh/shapes.h"

namespace thigma {
namespace {

/// Height along n of the highest (side 1) or lowest (-1) triangle over a point; NaN where there is
/// none.
double height_by_loop(const HullView& hull, const Pose& a_from_hull, const Mat3& frame,
                      const Vec2& at, double side) {
  double best = std::nan("");
  for (int i = 0; i < hull.triangle_count; ++i) {
    Vec3 p[3];
    for (int k = 0; k < 3; ++k)
      p[k] = frame * transform_point(a_from_hull, hull.vertices[hull.triangles[i].corner[k]]);
    const Vec3 normal = (p[1] - p[0]).cross(p[2] - p[0]);
    if (!(side * normal.z() > 0.1 * normal.norm())) continue;
    bool is_inside = true;
    for (int k = 0; k < 3; ++k) {
      const Vec3 edge = p[(k + 1) % 3] - p[k], way = Vec3(at.x(), at.y(), 0.0) - p[k];
      is_inside &= side * (edge.x() * way.y() - edge.y() * way.x()) >= 0.0;
    }
    if (!is_inside) continue;
    best = p[0].z() -
           ((at.x() - p[0].x()) * normal.x() + (at.y() - p[0].y()) * normal.y()) / normal.z();
  }
  return best;
}

struct SampledArea {
  double size = 0.0, weight = 0.0;  // of the area, and the integral of depth + tolerance over it
  Vec3 first = Vec3::Zero();        // the same of it times the point
  double second = 0.0;              // and of it times the squared distance from the middle
};

SampledArea area_by_samples(const HullView& a, const HullView& b, const Pose& a_from_b,
                            const Vec3& normal, double tolerance, int per_side) {
  Mat3 frame;
  frame.row(2) = normal;
  frame.row(0) = normal.unitOrthogonal();
  frame.row(1) = normal.cross(Vec3(frame.row(0)));
  const Vec3 middle = frame * a.center;
  const double cell = 2.0 * a.radius / per_side;
  SampledArea sum;
  std::vector<std::pair<Vec3, double>> points;
  for (int i = 0; i < per_side; ++i) {
    for (int j = 0; j < per_side; ++j) {
      const Vec2 at =
          middle.head<2>() + Vec2((i + 0.5) * cell - a.radius, (j + 0.5) * cell - a.radius);
      const double height = height_by_loop(a, {}, frame, at, 1.0);
      const double reach = height - height_by_loop(b, a_from_b, frame, at, -1.0) + tolerance;
      if (!(reach > 0.0)) continue;
      sum.size += cell * cell;
      sum.weight += cell * cell * reach;
      points.push_back({frame.transpose() * Vec3(at.x(), at.y(), height), cell * cell * reach});
      sum.first += points.back().second * points.back().first;
    }
  }
  for (const auto& [point, weight] : points) {
    const Vec3 way = frame * (point - sum.first / sum.weight);
    sum.second += weight * way.head<2>().squaredNorm();
  }
  return sum;
}

TEST(SharedArea, two_squares_share_a_rectangle) {
  const ClodHierarchy up = build_exact_hierarchy(make_sheet(2.0, 2.0, 1, 1));
  const ClodHierarchy down = build_exact_hierarchy(flipped(make_sheet(2.0, 2.0, 1, 1)));
  ASSERT_EQ(up.patches.size(), 1u);
  const Pose a_from_b{Vec3(0.5, -0.25, 0.01), Quat::Identity()};
  const auto share = [&](const Pose& pose) {
    return detail::shared_area({hull_view(up, up.patches[0].node),
                                hull_view(down, down.patches[0].node), relative_pose({}, pose)},
                               Vec3::UnitZ(), 0.1);
  };
  const detail::SharedArea area = share(a_from_b);
  EXPECT_NEAR(area.size, 1.5 * 1.75, 1e-12);
  EXPECT_NEAR(area.weight, 1.5 * 1.75 * 0.09, 1e-12);
  EXPECT_LE((area.middle - Vec3(0.25, -0.125, 0.0)).norm(), 1e-12);
  // Of a rectangle of sides s: s / sqrt(12), the longer one first.
  EXPECT_LE((area.axis[0].cwiseAbs() - Vec3(0.0, 1.75 / std::sqrt(12.0), 0.0)).norm(), 1e-12);
  EXPECT_LE((area.axis[1].cwiseAbs() - Vec3(1.5 / std::sqrt(12.0), 0.0, 0.0)).norm(), 1e-12);
  // Beside each other, too far, and the wrong way round: nothing.
  for (const Pose& none :
       {Pose{Vec3(2.1, 0, 0.01), Quat::Identity()}, Pose{Vec3(0, 0, 0.11), Quat::Identity()},
        Pose{Vec3(0, 0, 0.01), rotation_from_vector(3.14159 * Vec3::UnitX())}}) {
    EXPECT_EQ(share(none).size, 0.0);
    EXPECT_EQ(share(none).weight, 0.0);
  }
}

TEST(SharedArea, agrees_with_samples_of_curved_patches) {
  Random random(5);
  int shared = 0;
  for (int i = 0; i < 40; ++i) {
    const Vec3 axes = Vec3(1.0, 1.2, 1.5) + random.in_cube(0.2);
    const ClodHierarchy object = build_exact_hierarchy(make_ellipsoid(axes, 3));
    const ClodHierarchy scene = build_exact_hierarchy(make_ellipsoid(axes.reverse(), 2));
    const HullView a = hull_view(object, object.patches[0].node);
    const HullView b = hull_view(scene, scene.patches[0].node);
    const Quat turn = random.orientation();
    const Vec3 normal =
        a.faces[static_cast<std::size_t>(i) % static_cast<std::size_t>(a.face_count)].normal;
    // b's ellipsoid beside a's face, up to a tenth into it.
    const Vec3 on_a = a.vertices[0];
    Vec3 lowest = turn * b.vertices[0];
    for (int v = 1; v < b.vertex_count; ++v)
      if (normal.dot(turn * b.vertices[v]) < normal.dot(lowest)) lowest = turn * b.vertices[v];
    double highest = normal.dot(on_a);
    for (int v = 0; v < a.vertex_count; ++v) highest = std::max(highest, normal.dot(a.vertices[v]));
    const Vec3 target = on_a + (highest - normal.dot(on_a) - random.uniform(-0.05, 0.1)) * normal;
    const Pose a_from_b{target - lowest, turn};
    constexpr double kTolerance = 0.1;
    const detail::SharedArea got =
        detail::shared_area({a, b, relative_pose({}, a_from_b)}, normal, kTolerance);
    constexpr int kPerSide = 100;
    const SampledArea want = area_by_samples(a, b, a_from_b, normal, kTolerance, kPerSide);
    const double cell = 2.0 * a.radius / kPerSide;
    // cells that the outline cuts
    const double edge = 8.0 * cell * std::sqrt(std::max(want.size, cell * cell));
    EXPECT_NEAR(got.size, want.size, edge) << i;
    if (!(want.size > 100.0 * cell * cell)) continue;
    // Few of those cells are deep: what they leave out is small in the integrals.
    EXPECT_NEAR(got.weight, want.weight, 0.05 * want.weight) << i;
    EXPECT_LE((got.middle - want.first / want.weight).norm(), cell) << i;
    const double second = want.second / want.weight;
    EXPECT_NEAR(got.axis[0].squaredNorm() + got.axis[1].squaredNorm(), second,
                0.05 * second + cell * cell)
        << i;
    EXPECT_NEAR(got.axis[0].dot(got.axis[1]), 0.0, 1e-12) << i;
    EXPECT_NEAR(got.axis[0].dot(normal), 0.0, 1e-12) << i;
    ++shared;
  }
  EXPECT_GE(shared, 8);
}

/// A cube of side `size` on a floor, its lowest corner at `depth`, turned by `angle` about a
/// horizontal axis.
struct CubeOnFloor {
  double size = 0.0, tolerance = 0.0;
  ClodHierarchy cube, floor;

  explicit CubeOnFloor(double scale)
      : size(0.02 * scale),
        tolerance(2e-4 * scale),
        cube(build_exact_hierarchy(make_box(size * Vec3::Ones()))),
        floor(build_exact_hierarchy(make_sheet(10.0 * size, 10.0 * size, 2, 2))) {}

  Pose pose(double angle, double depth) const {
    const Quat turn = rotation_from_vector(angle * Vec3(0.1, 1.0, 0.0).normalized());
    double lowest = 0.0;
    for (int corner = 0; corner < 8; ++corner) {
      const Vec3 local((corner & 1) ? 0.5 : -0.5, (corner & 2) ? 0.5 : -0.5,
                       (corner & 4) ? 0.5 : -0.5);
      lowest = std::min(lowest, (turn * (size * local)).z());
    }
    return {Vec3(0.05 * size, 0.1 * size, -lowest - depth), turn};
  }

  std::vector<Contact> contacts(const Pose& at, bool distributes_wide_contacts) const {
    ContactFront front;
    ContactSet set;
    set.contacts.reserve(1000);
    query_contacts({cube, at}, {floor}, {.tolerance = tolerance}, front, set);
    if (!distributes_wide_contacts) return set.contacts;
    std::vector<Contact> spread;
    spread.reserve(1000);
    const SceneBody bodies[] = {{&floor, Pose{}}};
    distribute_contacts({cube, at}, bodies, set.contacts, tolerance, spread);
    return spread;
  }
};

/// Sum of weight (depth + d) and of it times the point.
std::pair<double, Vec3> press(const std::vector<Contact>& contacts, double tolerance) {
  double sum = 0.0;
  Vec3 moment = Vec3::Zero();
  for (const Contact& c : contacts) {
    sum += c.weight * (c.depth + tolerance);
    moment += c.weight * (c.depth + tolerance) * c.point;
  }
  return {sum, sum > 0.0 ? Vec3(moment / sum) : moment};
}

TEST(SpreadContacts, a_tilting_cube_is_pressed_at_a_point_that_moves_gradually) {
  for (const auto& [scale, depth] : {std::pair{1e-7, -0.5}, {1.0, -0.5}, {1e5, -0.5}, {1.0, 0.5}}) {
    const CubeOnFloor scene(scale);
    double step_spread = 0.0, step_alone = 0.0;
    Vec3 last_spread = Vec3::Zero(), last_alone = Vec3::Zero();
    for (int i = 0; i <= 400; ++i) {
      const Pose at = scene.pose(-0.02 + 1e-4 * i, depth * scene.tolerance);
      const auto [sum, spread] = press(scene.contacts(at, true), scene.tolerance);
      const auto [sum_alone, alone] = press(scene.contacts(at, false), scene.tolerance);
      // As heavy as before.
      EXPECT_NEAR(sum, sum_alone, 1e-9 * sum_alone);
      if (i > 0) {
        step_spread = std::max(step_spread, (spread - last_spread).norm());
        step_alone = std::max(step_alone, (alone - last_alone).norm());
      }
      last_spread = spread;
      last_alone = alone;
    }
    // The test sees the jump; where surfaces meet, the point between all that intersects moves more
    // gradually.
    EXPECT_GT(step_alone, (depth < 0.0 ? 0.5 : 0.05) * scene.size);
    EXPECT_LT(step_spread, 0.03 * scene.size);
  }
}

TEST(SpreadContacts, parts_are_where_the_surface_is_and_weigh_one_together) {
  const CubeOnFloor scene(1.0);
  const Pose at = scene.pose(0.004, 0.0);
  const std::vector<Contact> alone = scene.contacts(at, false), contacts = scene.contacts(at, true);
  ASSERT_EQ(alone.size(), 1u);
  ASSERT_EQ(contacts.size(), 4u);
  double weight = 0.0, middle = 0.0;
  for (const Contact& c : contacts) {
    EXPECT_EQ(c.depth, alone[0].depth);
    EXPECT_EQ(c.normal, alone[0].normal);
    EXPECT_EQ(c.body, 0);
    EXPECT_GT(c.weight, 0.0);
    weight += c.weight;
    // Above the wedge below the cube's face that is less than the tolerance above the floor, which
    // is z = 0.
    const Vec3 local = at.orientation.conjugate() * (c.point - at.position);
    EXPECT_NEAR(local.z(), -0.5 * scene.size, 0.5 * scene.tolerance);
    EXPECT_LE(local.head<2>().cwiseAbs().maxCoeff(), 0.5 * scene.size + 1e-12);
    middle += c.weight * local.z();
    EXPECT_NEAR((c.point - c.scene_point).dot(c.normal), c.depth, 1e-12);
  }
  EXPECT_NEAR(weight, 1.0, 1e-9);
  EXPECT_NEAR(middle, -0.5 * scene.size, 1e-12);
}

TEST(SpreadContacts, a_corner_that_touches_stays_one_contact) {
  const CubeOnFloor scene(1.0);
  for (const double depth : {-0.5, 0.5}) {
    Pose at = scene.pose(0.0, 0.0);
    at.orientation = Quat::FromTwoVectors(Vec3(-1, -1, -1), -Vec3::UnitZ());
    at.position.z() = 0.5 * std::sqrt(3.0) * scene.size - depth * scene.tolerance;
    const std::vector<Contact> alone = scene.contacts(at, false),
                               contacts = scene.contacts(at, true);
    ASSERT_EQ(alone.size(), 1u);
    ASSERT_EQ(contacts.size(), 1u);
    EXPECT_EQ(contacts[0].point, alone[0].point);
    EXPECT_EQ(contacts[0].weight, 1.0);
  }
}

TEST(SpreadContacts, small_patches_and_other_states_stay_as_they_are) {
  const CubeOnFloor scene(1.0);
  const Pose at = scene.pose(0.0, 0.0);
  std::vector<Contact> found = scene.contacts(at, false);
  ASSERT_FALSE(found.empty());
  const SceneBody bodies[] = {{&scene.floor, Pose{}}};
  std::vector<Contact> spread;
  const auto expect_untouched = [&](double tolerance) {
    distribute_contacts({scene.cube, at}, bodies, found, tolerance, spread);
    ASSERT_EQ(spread.size(), found.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
      EXPECT_EQ(spread[i].point, found[i].point);
      EXPECT_EQ(spread[i].weight, found[i].weight);
    }
  };
  spread.reserve(1000);
  expect_untouched(scene.size);  // larger than the patch
  for (Contact& c : found) c.status = ContactStatus::grazing;
  expect_untouched(scene.tolerance);
  // not of a mesh
  for (Contact& c : found) c.status = ContactStatus::separated, c.object_patch = -1;
  expect_untouched(scene.tolerance);
  for (Contact& c : found) c.object_patch = 0, c.body = 7;  // nor of this scene
  expect_untouched(scene.tolerance);
  // No room: as many as there were.
  for (Contact& c : found) c.body = 0;
  std::vector<Contact> small;
  small.reserve(found.size());
  spread.swap(small);
  expect_untouched(scene.tolerance);
}

}  // namespace
}  // namespace thigma
