// The exact query on the shared real meshes, against an independent search. Poses: MANIFEST,
// "Contact scenes".

#include "support/pressing.h"
#include "support/query_path.h"
#include "support/shared.h"
#include <gtest/gtest.h>

#include "thigma/import/load_mesh.h"

namespace thigma {
namespace {

using test::Approach;
using test::CheckedPair;
using test::turn;

CheckedPair shared_pair(const std::filesystem::path& folder, const std::string& name,
                        const char* object, double scale, const char* scene) {
  return test::checked(name, load_usable_mesh((folder / "meshes" / object).string(), scale),
                       load_usable_mesh((folder / "meshes" / scene).string(), 1.0));
}

TEST(RealMeshes, DentalCasts) {
  THIGMA_NEEDS_SHARED(shared);
  const CheckedPair pair = shared_pair(shared, "dental casts", "a02_dental_cast_lower.obj", 1.0,
                                       "a01_dental_cast_upper.obj");
  // MANIFEST: turn -4 degrees about x through (0, 18.55, 97.07), then move, less 10 units so as to
  // start outside.
  Approach approach;
  approach.start.orientation = turn(Vec3::UnitX(), -4.0);
  const Vec3 pivot(0, 18.55, 97.07);
  approach.start.position = pivot - approach.start.orientation * pivot + Vec3(12.04, 24.09, 27.87);
  approach.direction = Vec3::UnitZ();
  test::check_pair(pair, approach, 0.01 * pair.radius);
}

Approach into_the_socket() {
  Approach approach;
  approach.start.orientation = turn(Vec3::UnitZ(), 120.0) * turn(Vec3::UnitY(), 90.0);
  approach.start.position = approach.start.orientation * (-0.8 * Vec3(273.95, 356.91, -545.30)) +
                            Vec3(-7.12, -133.11, 518.78);
  approach.direction = Vec3(-0.989, -0.098, 0.111).normalized();
  return approach;
}

TEST(RealMeshes, FemurInHip) {
  THIGMA_NEEDS_SHARED(shared);
  const CheckedPair pair = shared_pair(shared, "femur in hip", "a03_femur_right.obj", 0.8,
                                       "a04_hip_bone_right_mirrored.obj");
  test::check_pair(pair, into_the_socket(), 0.005 * pair.radius);
}

TEST(RealMeshes, FemurPressedIntoHip) {
  THIGMA_NEEDS_SHARED(shared);
  const CheckedPair pair = shared_pair(shared, "femur in hip", "a03_femur_right.obj", 0.8,
                                       "a04_hip_bone_right_mirrored.obj");
  test::expect_smooth_pressing(pair, into_the_socket());
}

TEST(RealMeshes, Gears) {
  THIGMA_NEEDS_SHARED(shared);
  const CheckedPair pair =
      shared_pair(shared, "gear pair", "a06_gear_medium_40t.obj", 1.0, "a05_gear_large_60t.obj");
  Approach approach;  // as authored: meshing, 0.18 mm of play
  approach.direction = -Vec3::UnitX();
  test::check_pair(pair, approach, 0.002 * pair.radius);
}

}  // namespace
}  // namespace thigma
