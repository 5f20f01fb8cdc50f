#include "thigma/scene/detail/world_joints.h"

#include "thigma/core/error.h"
#include "thigma/core/index.h"
#include "thigma/models/make_model.h"

namespace thigma::detail {
namespace {

constexpr int kMostCopies = 1000;

void read_motor(TomlTable& table, JointMotor& motor) {
  motor.is_on = true;
  const std::optional<double> speed = table.number("speed"), target = table.number("target");
  const std::optional<double> most = table.number("most", Range::not_negative);
  if (!speed == !target) table.fail_here("no speed or target, or both", "expected one of the two");
  if (!most) table.fail_here("no most", "expected most = its largest force or torque");
  motor.is_servo = target.has_value();
  motor.target = target ? *target : *speed;
  motor.most = *most;
  motor.stiffness = table.number("stiffness", Range::not_negative).value_or(0.0);
  motor.damping = table.number("damping", Range::not_negative).value_or(0.0);
  if (motor.is_servo && !(motor.stiffness > 0.0))
    table.fail_here("a target without stiffness", "expected stiffness above 0");
  if (!motor.is_servo && (table.has("stiffness") || table.has("damping")))
    table.fail_here("stiffness or damping beside speed", "expected them beside target");
  table.finish();
}

/// Name of a body for the i-th copy: "link #" is "link 1", "link 2" and so on, "link #-1" the one
/// before.
std::string numbered(std::string name, int i) {
  const std::size_t at = name.find('#');
  if (at == std::string::npos) return name;
  const bool is_before = name.compare(at, 3, "#-1") == 0;
  return name.replace(at, is_before ? 3 : 1, std::to_string(is_before ? i : i + 1));
}

std::int32_t body_of(const WorldSceneJoint& joint, const std::string& name,
                     const std::vector<WorldBody>& bodies) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (bodies[i].name == name) return static_cast<std::int32_t>(i);
    names.push_back(bodies[i].name);
  }
  const std::string nearest = models::nearest_word(name, names);
  throw InputError("joint '" + joint.name + "': no body '" + name + "', expected " +
                   (nearest.empty() ? "the name of a body" : "'" + nearest + "'?"));
}

}  // namespace

void read_joint(TomlTable& table, std::vector<WorldSceneJoint>& joints) {
  WorldSceneJoint joint;
  const std::optional<std::string> name = table.text("name"), body = table.text("body");
  const auto kind = table.choice("kind", {"fixed", "hinge", "slider", "ball", "spring"});
  if (!kind) table.fail_here("no kind", "expected fixed, hinge, slider, ball or spring");
  if (!body) table.fail_here("no body", "expected the name of a body");
  joint.kind = static_cast<JointKind>(*kind);
  joint.to = table.text("to").value_or("");
  const std::optional<Vec3> position = table.vector("position"), axis = table.vector("axis");
  const bool has_axis = joint.kind == JointKind::hinge || joint.kind == JointKind::slider;
  if (!position) table.fail_here("no position", "expected position = [x, y, z]");
  if (has_axis && !axis) table.fail_here("no axis", "expected axis = [x, y, z]");
  if (!has_axis && axis)
    table.fail("axis", "is not for this kind", "expected it of a hinge or a slider");
  if (axis && !(axis->cwiseAbs().maxCoeff() > 0.0))
    table.fail("axis", "has no direction", "expected [x, y, z] of any length above 0");
  joint.position = *position;
  joint.axis = axis ? axis->stableNormalized() : joint.axis;
  joint.to_position = table.vector("to_position");
  if (joint.to_position && joint.kind != JointKind::spring)
    table.fail("to_position", "is not for this kind", "expected it of a spring");
  joint.lower = table.number("lower");
  joint.upper = table.number("upper");
  joint.rest = table.number("rest");
  joint.stiffness = table.number("stiffness", Range::not_negative).value_or(0.0);
  joint.damping = table.number("damping", Range::not_negative).value_or(0.0);
  joint.touches = table.truth("touches").value_or(false);
  if (auto motor = table.table("motor")) read_motor(*motor, joint.motor);
  const int copies = table.whole("copies", 1, kMostCopies).value_or(1);
  const std::optional<Vec3> spacing = table.vector("spacing");
  if (copies > 1 && !spacing)
    table.fail("copies", "stands without spacing", "expected spacing = [x, y, z] between them");
  table.finish();
  const std::string own = name.value_or("joint " + std::to_string(joints.size() + 1));
  const std::string to = joint.to;
  for (int i = 0; i < copies; ++i) {
    joint.name = copies > 1 ? own + " " + std::to_string(i + 1) : own;
    joint.body = numbered(*body, i);
    joint.to = numbered(to, i);
    joints.push_back(joint);
    joint.position += spacing.value_or(Vec3::Zero());
    if (joint.to_position) *joint.to_position += spacing.value_or(Vec3::Zero());
  }
}

std::vector<WorldJoint> world_joints(const std::vector<WorldSceneJoint>& joints,
                                     const std::vector<WorldBody>& bodies) {
  std::vector<BodyState> start;
  for (const WorldBody& body : bodies) start.push_back(body.start);
  std::vector<WorldJoint> out;
  for (const WorldSceneJoint& given : joints) {
    WorldJoint joint;
    joint.name = given.name;
    joint.kind = given.kind;
    joint.a = body_of(given, given.body, bodies);
    if (!given.to.empty()) joint.b = body_of(given, given.to, bodies);
    place_joint(joint, joint_frame(given.position, given.axis), start);
    if (given.to_position) {
      WorldJoint other = joint;
      place_joint(other, joint_frame(*given.to_position, given.axis), start);
      joint.b_from_joint = other.b_from_joint;
    }
    joint.lower = given.lower.value_or(joint.lower);
    joint.upper = given.upper.value_or(joint.upper);
    joint.stiffness = given.stiffness;
    joint.damping = given.damping;
    // A spring is at ease as it stands; angles and ways count from there.
    const double distance = (given.to_position.value_or(given.position) - given.position).norm();
    joint.rest = given.rest.value_or(given.kind == JointKind::spring ? distance : 0.0);
    joint.motor = given.motor;
    joint.touches = given.touches;
    out.push_back(joint);
  }
  return out;
}

}  // namespace thigma::detail
