#pragma once
// A world of several rigid bodies: what never changes while it runs, and its state.

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "thigma/clod/hierarchy.h"
#include "thigma/dynamics/body.h"
#include "thigma/dynamics/constraint_model.h"
#include "thigma/multibody/joint.h"

namespace thigma {

/// What moves a body.
enum class BodyKind : std::uint8_t {
  fixed,       // nothing
  moving,      // gravity and contacts, and hands that take hold of it
  prescribed,  // a velocity that is given at every step; contacts stop it only where nothing gives
  held,        // as moving; of a scene: one device holds it all the time
};

/// Whether gravity and contacts move it, and a hand may take hold of it.
inline bool moves_freely(BodyKind kind) noexcept {
  return kind == BodyKind::moving || kind == BodyKind::held;
}

/// A surface in the frame of a body: origin at its centre of mass.
struct BodyShape {
  const ClodHierarchy* hierarchy = nullptr;  // outlives the world
  Pose body_from_mesh;
  friend bool operator==(const BodyShape& a, const BodyShape& b) noexcept {
    return a.hierarchy == b.hierarchy && a.body_from_mesh.position == b.body_from_mesh.position &&
           a.body_from_mesh.orientation.coeffs() == b.body_from_mesh.orientation.coeffs();
  }
};

/// A body as a scene describes it.
struct WorldBody {
  std::string name;
  BodyKind kind = BodyKind::moving;
  BodyShape shape;
  double mass = 0.0;                // of moving and held [kg]
  Mat3 inertia = Mat3::Identity();  // about the centre of mass [kg m^2; body frame]
  Friction friction{0.3, 0.3};      // of its material
  double restitution = 0.0;         // of its material, 0..1
  BodyState start;                  // pose, momenta of moving and held
};

/// What pairs of shapes need to make rows (detail/pair_kinds.h).
struct PairKinds;

/// Half sizes and middle of a box about a shape [m; body frame].
struct ShapeBox {
  Vec3 middle = Vec3::Zero(), half = Vec3::Zero();
  double reach = 0.0;  // of the farthest vertex from the centre of mass
};

/// What is constant while a world runs. Made by make_world.
struct World {
  Vec3 gravity = Vec3::Zero();  // [m/s^2]
  std::vector<WorldBody> bodies;
  std::vector<RigidBody> rigid;  // one a body; of prescribed ones so heavy that nothing stops them
  std::vector<std::int32_t> shape;              // of a body, into `shapes`
  std::vector<BodyShape> shapes;                // each once
  std::vector<ShapeBox> boxes;                  // of the shapes
  std::shared_ptr<const PairKinds> pair_kinds;  // of all shapes that may meet
  std::vector<std::int32_t> kind_of;  // shapes x shapes, into pair_kinds; -1: they never meet
  std::vector<WorldJoint> joints;
  std::vector<double> joint_arm;  // by joint: what turns an angle into a way, its size [m]
  // pairs of bodies, lower * bodies + higher, sorted: a joint holds them, and they never touch
  std::vector<std::int64_t> never_touch;
  // Levels of detail far away: s0 of a pair of surfaces that both have levels, times the smaller
  // radius; 0: all contacts are exact
  double threshold = 0.0;
  bool sleeps = true;  // what rests is not looked at until something comes near
};

/// The state of all bodies.
struct WorldState {
  std::vector<BodyState> bodies;
  std::vector<double> still;            // how long a body has not moved [s]
  std::vector<std::uint8_t> is_asleep;  // of a moving body: it rests with all it touches
  double time = 0.0;                    // [s]
};

/// Whether contacts and forces move it.
inline bool is_dynamic(const World& world, std::int32_t body) noexcept {
  return world.bodies[static_cast<std::size_t>(body)].kind != BodyKind::fixed;
}

/// Checks bodies and prepares what pairs of them need.
///
/// bodies    names differ; mass > 0 and inertia positive definite of moving and held ones
/// gravity   [m/s^2; world]
/// joints    names differ; met at the start; one of their bodies moves
/// errors    InputError with the body's name: mass, inertia, pose, momentum, friction,
///           restitution, no surface, a name twice; with the joint's: check_joint, a name twice,
///           nothing that moves
/// Thread    [offline]; throws std::bad_alloc
World make_world(std::vector<WorldBody> bodies, const Vec3& gravity,
                 std::vector<WorldJoint> joints = {});

/// Whether a joint keeps two bodies from touching each other. Thread: any.
bool never_touch(const World& world, std::int32_t a, std::int32_t b) noexcept;

/// Its state at the start.
/// Thread    [offline]; throws std::bad_alloc.
WorldState start_state(const World& world);

/// Friction of two materials: the geometric mean. Thread: any.
Friction friction_between(const WorldBody& a, const WorldBody& b) noexcept;

/// Restitution of two materials: the larger. Thread: any.
double restitution_between(const WorldBody& a, const WorldBody& b) noexcept;

/// Sum over moving and held bodies of the kinetic energy and of what gravity has still to give,
/// counted from the origin, and of what springs of joints hold [J]. Thread: any.
double mechanical_energy(const World& world, const WorldState& state) noexcept;

/// Sum of the momenta of moving and held bodies: linear [kg m/s], and angular about the world's
/// origin [kg m^2/s]. Thread: any.
struct WorldMomentum {
  Vec3 linear = Vec3::Zero(), angular = Vec3::Zero();
};
WorldMomentum momentum(const World& world, const WorldState& state) noexcept;

}  // namespace thigma
