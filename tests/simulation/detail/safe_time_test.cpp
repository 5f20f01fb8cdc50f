#include "thigma/simulation/detail/safe_time.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "thigma/clod/build_hierarchy.h"
#include "thigma/math/random.h"
#include "thigma/mesh/measure.h"
#include "thigma/mesh/shapes.h"
#include "thigma/simulation/free_motion.h"

namespace thigma {
namespace {

// Bodies near a floor in random motion: after the time no corner is lower than the promise, and it
// is not uselessly short.
TEST(SafeTime, NothingMeetsWithinIt) {
  const TriangleMesh mesh = make_l_shape(0.1, 0.03);
  TriangleMesh slab = make_box(Vec3(2, 2, 0.2), {4, 4, 1});
  for (Vec3& p : slab.positions) p.z() -= 0.1;
  const ClodHierarchy object = build_exact_hierarchy(mesh), floor = build_exact_hierarchy(slab);
  const MassProperties solid = mass_properties(mesh);
  SimulationWorld world;
  world.body = make_body(1000.0 * solid.volume, 1000.0 * solid.inertia, Vec3(0, 0, -9.81));
  world.object = &object;
  world.body_from_mesh.position = -solid.center_of_mass;
  world.scene.push_back({&floor, Pose{}});
  world.tolerance = 2e-3;
  ContactFront front;
  ContactSet set;
  set.contacts.reserve(1000);
  Random random(11);
  const auto lowest = [&](const BodyState& s) {
    double low = 1.0;
    for (const Vec3& p : mesh.positions)
      low = std::min(low, (s.position + s.orientation * (p - solid.center_of_mass)).z());
    return low;
  };
  int touching = 0;
  for (int trial = 0; trial < 400; ++trial) {
    BodyState s;
    s.orientation = random.orientation();
    s.position.z() -= lowest(s);
    s.position.z() += world.tolerance * random.uniform(0.0, 2.0);
    s.linear_momentum = world.body.mass * random.in_cube(1.0);
    s.angular_momentum = world.body.inertia * random.in_cube(10.0);
    const double gap = lowest(s);
    clear(set);
    query_contacts({object, Pose{s.position, s.orientation} * world.body_from_mesh}, {floor},
                   {.tolerance = world.tolerance}, front, set);
    const double reach = (-solid.center_of_mass + object.center).norm() + 1.02 * object.radius;
    const double time = detail::safe_time(world, s, set, reach);
    ASSERT_GT(time, 1e-6);
    const double near = detail::collision_gap(world);
    const double least = gap > near ? 0.5 * near : gap - detail::kShortestFall * near;
    touching += gap <= near;
    for (const double part : {0.3, 0.7, 1.0}) {
      ASSERT_GE(lowest(free_motion(world.body, s, part * time)), std::min(least, gap) - 1e-9)
          << trial;
    }
  }
  EXPECT_GT(touching, 20);
}

}  // namespace
}  // namespace thigma
