#include "thigma/multibody/world.h"

#include <algorithm>
#include <cmath>

#include "thigma/core/error.h"
#include "thigma/core/index.h"
#include "thigma/multibody/detail/pair_kinds.h"

namespace thigma {
namespace {

[[noreturn]] void refuse(const WorldBody& body, const std::string& what) {
  throw InputError("body '" + body.name + "': " + what);
}

void check(const WorldBody& body) {
  if (body.shape.hierarchy == nullptr || body.shape.hierarchy->nodes.empty())
    refuse(body, "no surface, expected a hierarchy");
  const Pose& mesh = body.shape.body_from_mesh;
  const bool is_finite = mesh.position.allFinite() && body.start.position.allFinite() &&
                         body.start.linear_momentum.allFinite() &&
                         body.start.angular_momentum.allFinite();
  constexpr double kUnit = 1e-6;
  const auto is_unit = [](const Quat& q) { return std::fabs(q.norm() - 1.0) <= kUnit; };
  if (!is_finite || !is_unit(mesh.orientation) || !is_unit(body.start.orientation))
    refuse(body, "pose or momentum, expected finite numbers and unit quaternions");
  if (!is_valid(body.friction)) refuse(body, "friction, expected 0 <= kinetic <= static");
  if (!(body.restitution >= 0.0 && body.restitution <= 1.0))
    refuse(body, "restitution " + std::to_string(body.restitution) + ", expected 0 to 1");
}

std::int32_t shape_index(const BodyShape& shape, std::vector<BodyShape>& shapes) {
  const auto at = std::find(shapes.begin(), shapes.end(), shape) - shapes.begin();
  if (at == static_cast<std::ptrdiff_t>(shapes.size())) shapes.push_back(shape);
  return static_cast<std::int32_t>(at);
}

ShapeBox box_of(const BodyShape& shape) {
  const SurfaceFeatures features = find_features(*shape.hierarchy);
  ShapeBox box;
  Vec3 low = Vec3::Constant(kInfinity), high = Vec3::Constant(-kInfinity);
  for (const Vec3& v : features.vertices) {
    const Vec3 p = transform_point(shape.body_from_mesh, v);
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
    box.reach = std::max(box.reach, p.norm());
  }
  box.middle = 0.5 * (low + high);
  box.half = 0.5 * (high - low);
  return box;
}

/// Bodies that nothing stops: heavier by so much than all others together. More would cost digits.
constexpr double kUnstoppable = 1e6;

void make_rigid(World& world) {
  double total = 0.0;
  for (const WorldBody& body : world.bodies) {
    if (body.kind != BodyKind::moving && body.kind != BodyKind::held) continue;
    try {
      make_body(body.mass, body.inertia, world.gravity);
    } catch (const InputError& error) {
      const std::string what = error.what();
      refuse(body, what.rfind("body: ", 0) == 0 ? what.substr(6) : what);
    }
    total += body.mass;
  }
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    const WorldBody& body = world.bodies[i];
    if (moves_freely(body.kind)) {
      world.rigid.push_back(make_body(body.mass, body.inertia, world.gravity));
      continue;
    }
    const double mass = kUnstoppable * (total > 0.0 ? total : 1.0);
    const double reach = world.boxes[idx(world.shape[i])].reach;
    world.rigid.push_back(make_body(mass, mass * reach * reach * Mat3::Identity()));
  }
}

/// Whether two shapes may meet: some body that moves has one, another body the other.
bool may_meet(const World& world, std::int32_t a, std::int32_t b) {
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    if (world.shape[i] != a) continue;
    for (std::size_t k = 0; k < world.bodies.size(); ++k) {
      if (k == i || world.shape[k] != b) continue;
      if (moves_freely(world.bodies[i].kind) || moves_freely(world.bodies[k].kind)) return true;
    }
  }
  return false;
}

void make_pair_kinds(World& world) {
  const auto count = static_cast<std::int32_t>(world.shapes.size());
  auto kinds = std::make_shared<PairKinds>();
  world.kind_of.assign(idx(count) * idx(count), -1);
  for (std::int32_t a = 0; a < count; ++a) {
    for (std::int32_t b = a; b < count; ++b) {
      if (!may_meet(world, a, b)) continue;
      // The smaller one's travel is measured: turning moves it least.
      const bool in_order = world.boxes[idx(a)].reach <= world.boxes[idx(b)].reach;
      PairKind kind;
      kind.first = in_order ? a : b;
      kind.second = in_order ? b : a;
      const BodyShape &first = world.shapes[idx(kind.first)],
                      &second = world.shapes[idx(kind.second)];
      const SceneBody scene{second.hierarchy, second.body_from_mesh};
      kind.constraints = make_constraint_world(*first.hierarchy, first.body_from_mesh, {&scene, 1});
      widen(kind.constraints);
      world.kind_of[idx(a) * idx(count) + idx(b)] = world.kind_of[idx(b) * idx(count) + idx(a)] =
          static_cast<std::int32_t>(kinds->list.size());
      kinds->list.push_back(std::move(kind));
    }
  }
  world.pair_kinds = std::move(kinds);
}

void make_joints(World& world) {
  std::vector<BodyState> start;
  for (const WorldBody& body : world.bodies) {
    start.push_back(body.start);
    start.back().orientation.normalize();
  }
  const auto count = static_cast<std::int64_t>(world.bodies.size());
  for (std::size_t i = 0; i < world.joints.size(); ++i) {
    WorldJoint& joint = world.joints[i];
    const auto fail = [&](const std::string& what) {
      throw InputError("joint '" + joint.name + "': " + what);
    };
    for (std::size_t k = 0; k < i; ++k)
      if (world.joints[k].name == joint.name) fail("name given twice, expected one of its own");
    double arm = 0.0;  // of the smaller body: of what turns most
    const auto moves = [&](std::int32_t body) {
      if (body < 0 || body >= count) return false;
      const BodyKind kind = world.bodies[idx(body)].kind;
      if (kind != BodyKind::moving && kind != BodyKind::held) return false;
      const double reach = world.boxes[idx(world.shape[idx(body)])].reach;
      arm = arm > 0.0 ? std::min(arm, reach) : reach;
      return true;
    };
    const bool has_moving = static_cast<int>(moves(joint.a)) + static_cast<int>(moves(joint.b)) > 0;
    check_joint(joint, start, arm > 0.0 ? arm : 1.0);
    if (!has_moving) fail("holds nothing that moves, expected a moving body");
    joint.a_from_joint.orientation.normalize();
    joint.b_from_joint.orientation.normalize();
    world.joint_arm.push_back(arm);
    if (!joint.touches && joint.b >= 0)
      world.never_touch.push_back(std::min(joint.a, joint.b) * count + std::max(joint.a, joint.b));
  }
  std::sort(world.never_touch.begin(), world.never_touch.end());
}

}  // namespace

World make_world(std::vector<WorldBody> bodies, const Vec3& gravity,
                 std::vector<WorldJoint> joints) {
  if (!gravity.allFinite()) throw InputError("world: gravity, expected three finite numbers");
  World world;
  world.gravity = gravity;
  world.bodies = std::move(bodies);
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    check(world.bodies[i]);
    for (std::size_t k = 0; k < i; ++k) {
      if (world.bodies[k].name == world.bodies[i].name)
        refuse(world.bodies[i], "name given twice, expected one of its own (name = \"...\")");
    }
    world.shape.push_back(shape_index(world.bodies[i].shape, world.shapes));
  }
  for (const BodyShape& shape : world.shapes) world.boxes.push_back(box_of(shape));
  make_rigid(world);
  make_pair_kinds(world);
  world.joints = std::move(joints);
  make_joints(world);
  return world;
}

bool never_touch(const World& world, std::int32_t a, std::int32_t b) noexcept {
  const std::int64_t key =
      static_cast<std::int64_t>(std::min(a, b)) * static_cast<std::int64_t>(world.bodies.size()) +
      std::max(a, b);
  return std::binary_search(world.never_touch.begin(), world.never_touch.end(), key);
}

WorldState start_state(const World& world) {
  WorldState state;
  for (const WorldBody& body : world.bodies) {
    state.bodies.push_back(body.start);
    state.bodies.back().orientation.normalize();
  }
  state.still.assign(world.bodies.size(), 0.0);
  state.is_asleep.assign(world.bodies.size(), 0);
  return state;
}

Friction friction_between(const WorldBody& a, const WorldBody& b) noexcept {
  return {std::sqrt(a.friction.kinetic * b.friction.kinetic),
          std::sqrt(a.friction.at_rest * b.friction.at_rest)};
}

double restitution_between(const WorldBody& a, const WorldBody& b) noexcept {
  return std::max(a.restitution, b.restitution);
}

double mechanical_energy(const World& world, const WorldState& state) noexcept {
  double sum = 0.0;
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    if (world.bodies[i].kind != BodyKind::moving && world.bodies[i].kind != BodyKind::held)
      continue;
    sum += kinetic_energy(world.rigid[i], state.bodies[i]) -
           world.rigid[i].mass * world.gravity.dot(state.bodies[i].position);
  }
  for (const WorldJoint& joint : world.joints) sum += joint_energy(joint, state.bodies);
  return sum;
}

WorldMomentum momentum(const World& world, const WorldState& state) noexcept {
  WorldMomentum sum;
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    if (world.bodies[i].kind != BodyKind::moving && world.bodies[i].kind != BodyKind::held)
      continue;
    const BodyState& y = state.bodies[i];
    sum.linear += y.linear_momentum;
    sum.angular += y.angular_momentum + y.position.cross(y.linear_momentum);
  }
  return sum;
}

}  // namespace thigma
