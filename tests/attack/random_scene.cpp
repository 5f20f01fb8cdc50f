#include "attack/random_scene.h"

#include <array>
#include <sstream>

#include "thigma/math/elementary.h"
#include "thigma/math/random.h"
#include "thigma/mesh/shapes.h"

namespace thigma::test {
namespace {

/// Any of the closed shapes, about 1 in radius.
TriangleMesh random_shape(Random& random) {
  const int fine = 2 + static_cast<int>(random.below(5));
  switch (random.below(8)) {
    case 0:
      return make_ball(1.0, fine);
    case 1:
      return make_box({1.4, 1.2, 0.9}, {fine, fine, fine});
    case 2:
      return make_torus(0.7, 0.3, 4 * fine, 3 * fine);
    case 3:
      return make_l_shape(1.4, 0.4);
    case 4:
      return make_cylinder(0.7, 1.4, 5 * fine, fine);
    case 5:
      return make_cone(0.8, 1.4, 5 * fine, fine);
    case 6:
      return make_capsule(0.5, 1.0, 4 * fine);
    default:
      return make_hollow_ball(1.0, 0.6, fine);
  }
}

/// Stretched along the axes, waved, sometimes with every corner moved a little.
TriangleMesh deformed(TriangleMesh mesh, Random& random) {
  const Vec3 stretch(random.uniform(0.3, 1.0), random.uniform(0.3, 1.0), random.uniform(0.3, 1.0));
  const double height = random.below(2) == 0 ? 0.0 : random.uniform(0.0, 0.15);
  const Vec3 waves = 6.0 * random.in_cube(1.0), along = random.direction();
  const double noise = random.below(3) == 0 ? 0.02 : 0.0;
  for (Vec3& p : mesh.positions) {
    const double wave = height * sine(waves.dot(p));
    p += wave * along + noise * random.in_cube(1.0);
    p = p.cwiseProduct(stretch);
  }
  return mesh;
}

template <std::size_t N>
const char* any_of(Random& random, const std::array<const char*, N>& list) {
  return list[random.below(N)];
}

}  // namespace

RandomScene random_scene(std::uint64_t number) {
  Random random(0x7269676d61 + number);
  RandomScene scene;
  scene.object = deformed(random_shape(random), random);
  scene.ground = deformed(random_shape(random), random);
  const double size = random.uniform(0.5, 3.0);  // of the ground over the object
  for (Vec3& p : scene.ground.positions) p *= size;
  // From a tenth of a millimetre to ten metres; in a unit of its own.
  const double unit = std::array{1.0, 1e-3, 0.0254}[random.below(3)];
  scene.radius = 1e-4 * std::array{1.0, 10.0, 1e2, 1e2, 1e2, 1e3, 1e5}[random.below(7)] *
                 random.uniform(1.0, 9.0);
  scene.scale = unit;
  for (TriangleMesh* mesh : {&scene.object, &scene.ground})
    for (Vec3& p : mesh->positions) p *= scene.radius / unit;
  constexpr std::array kResponses = {"constraint", "constraint", "penalty", "potential", "direct"};
  scene.response = any_of(random, kResponses);
  scene.duration = random.uniform(0.8, 1.6);
  std::ostringstream text;
  text.precision(17);
  const Quat turn = random.orientation();
  const Vec3 place = random.uniform(0.0, 1.2) * scene.radius * random.direction();
  text << "[object]\nmesh = \"object.ply\"\nunit_scale = " << scene.scale << "\nposition = ["
       << place.x() << ", " << place.y() << ", " << place.z() << "]\nquat_xyzw = [" << turn.x()
       << ", " << turn.y() << ", " << turn.z() << ", " << turn.w()
       << "]\n[[static]]\nmesh = \"ground.ply\"\nunit_scale = " << scene.scale
       << "\n[contact]\nresponse = \"" << scene.response << "\"\n";
  text << "tolerance = " << scene.radius * random.uniform(0.003, 0.02) << "\n";
  if (random.below(2) == 0) text << "friction = " << random.uniform(0.0, 1.2) << "\n";
  const bool has_levels = random.below(3) == 0 && scene.response != "potential";
  if (has_levels) text << "threshold = " << random.uniform(0.005, 0.1) << "\n";
  if (!has_levels && scene.response != "constraint" && scene.response != "potential")
    text << "exact = true\n";
  text << "[solver]\ncontact_every = " << std::array{1, 1, 3, 10, 33}[random.below(5)] << "\n";
  scene.text = text.str();
  constexpr std::array kPaths = {"press", "slide", "tap", "circle", "demo"};
  scene.device = std::string("hand:?path=") + any_of(random, kPaths) +
                 "&force=" + std::to_string(random.uniform(0.2, 3.0));
  if (random.below(4) == 0) scene.device += "&dof=3";
  return scene;
}

}  // namespace thigma::test
