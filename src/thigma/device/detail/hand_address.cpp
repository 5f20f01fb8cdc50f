#include "thigma/device/detail/hand_address.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "thigma/device/detail/address.h"
#include "thigma/device/detail/hand_table.h"
#include "thigma/device/device_limits.h"
#include "thigma/device/script.h"

namespace thigma {
namespace {

using detail::parse_flag;
using detail::parse_value;
using detail::quoted;
using detail::shortest;
using detail::unknown_name;

// Of clearance and reach, as the table has it [m]: scenes of any size open, though a hand takes its
// time there.
constexpr double kFarthest = 1e3;

// Of the demo, unless the address has its own [m]: a third of an encoder step, as a calm hand
// shakes, so that runs of different seeds differ. Paths for measurements are still.
constexpr double kDemoTremor = 1e-5;

struct PathName {
  std::string_view name;
  HandPath path;
};

constexpr PathName kPaths[] = {{"demo", HandPath::demo},   {"rest", HandPath::rest},
                               {"press", HandPath::press}, {"slide", HandPath::slide},
                               {"tap", HandPath::tap},     {"circle", HandPath::circle},
                               {"turn", HandPath::turn}};

std::vector<std::string_view> hand_names() {
  std::vector<std::string_view> names = {
      "device", "path", "dof", "senses_rotation", "actuates_rotation", "seed"};
  for (const detail::HandNumber& number : detail::hand_numbers()) names.push_back(number.name);
  return names;
}

std::uint64_t parse_seed(const std::string& scheme, const std::string& value) {
  const double seed = parse_value(scheme, "seed", value);
  if (seed < 0.0 || seed > 9007199254740992.0 || seed != std::floor(seed)) {
    throw DeviceAddressError(scheme + " seed = " + quoted(value) +
                             ", expected an integer from 0 to 2^53");
  }
  return static_cast<std::uint64_t>(seed);
}

void apply_model(const std::string& name, HandParams& params) {
  const DeviceModel* model = find_device_model(name);
  if (model == nullptr) {
    std::vector<std::string_view> names;
    for (const DeviceModel& known : device_models()) names.push_back(known.name);
    throw DeviceAddressError("hand: no device " + quoted(name) + ", nearest is " +
                             quoted(detail::nearest_name(name, names)));
  }
  params.device = model->name;
  if (model->max_force > 0.0) params.max_force = model->max_force;
  if (model->max_torque > 0.0) params.max_torque = model->max_torque;
  if (model->max_stiffness > 0.0) params.max_stiffness = model->max_stiffness;
  if (model->max_angular_stiffness > 0.0) {
    params.max_angular_stiffness = model->max_angular_stiffness;
  }
  params.senses_rotation = model->senses_rotation;
  params.actuates_rotation = model->actuates_rotation;
}

void apply_path(const std::string& value, HandParams& params) {
  for (const PathName& known : kPaths) {
    if (value == known.name) {
      params.program.path = known.path;
      return;
    }
  }
  if (value.empty()) {
    throw DeviceAddressError(
        "hand: path is empty, expected demo, rest, press, slide, tap, circle, turn or a file");
  }
  params.script = read_script(value);
}

void apply_dof(const std::string& value, HandParams& params) {
  if (value != "6" && value != "3") {
    throw DeviceAddressError("hand: dof = " + quoted(value) + ", expected 6 or 3");
  }
  params.senses_rotation = params.actuates_rotation = value == "6";
}

// True when `name` is one of the numbers; program lengths given here win over those of the context.
bool apply_number(const std::string& name, const std::string& value, HandParams& params) {
  for (const detail::HandNumber& number : detail::hand_numbers()) {
    if (number.name != name) continue;
    number.field(params) = parse_value("hand:", name, value);
    return true;
  }
  return false;
}

HandParams hand_in_context(const DeviceContext& context) {
  HandParams params;
  params.seed = context.seed;
  params.program.start = context.start;
  const double length = std::sqrt(context.approach.squaredNorm());
  if (length > 0.0 && std::isfinite(length)) params.program.approach = context.approach / length;
  // Across the approach: the axis most nearly across, made exactly so.
  int axis = 0;
  params.program.approach.cwiseAbs().minCoeff(&axis);
  const Vec3 across = Vec3::Unit(axis);
  const Vec3& n = params.program.approach;
  params.program.slide = (across - n.dot(across) * n).normalized();
  params.program.clearance = std::min(context.clearance, kFarthest);
  params.program = scale_to_object(params.program, context.object_radius);
  params.program.reach = std::min(params.program.reach, kFarthest);
  params.tremor = kDemoTremor;
  return params;
}

}  // namespace

HandParams parse_hand(std::string_view query, const DeviceContext& context) {
  const auto parts = detail::split_query(query, "hand:");
  HandParams params = hand_in_context(context);
  // A model first, whatever its place, so that single numbers win over it.
  for (const auto& [name, value] : parts) {
    if (name == "device") apply_model(value, params);
  }
  bool has_reach = false, has_tremor = false;
  for (const auto& [name, value] : parts) {
    if (name == "path") {
      apply_path(value, params);
    } else if (name == "dof") {
      apply_dof(value, params);
    } else if (name == "seed") {
      params.seed = parse_seed("hand:", value);
    } else if (name != "device" && name != "senses_rotation" && name != "actuates_rotation" &&
               !apply_number(name, value, params)) {
      unknown_name("hand:", name, hand_names());
    }
    has_reach = has_reach || name == "reach";
    has_tremor = has_tremor || name == "tremor";
  }
  for (const auto& [name, value] : parts) {
    if (name == "senses_rotation") params.senses_rotation = parse_flag("hand:", name, value);
    if (name == "actuates_rotation") params.actuates_rotation = parse_flag("hand:", name, value);
  }
  const bool is_demo = params.script.empty() && params.program.path == HandPath::demo;
  if (!has_tremor && !is_demo) params.tremor = 0.0;
  if (!has_reach) {
    params.program.reach =
        std::min(1.5 * params.program.clearance + context.object_radius, kFarthest);
  }
  const std::string problem = what_is_wrong(params);
  if (!problem.empty()) throw DeviceAddressError("hand: " + problem);
  return params;
}

std::vector<DeviceParameter> detail::hand_parameters() {
  std::string models;
  for (const DeviceModel& model : device_models()) {
    models += (models.empty() ? "" : ", ") + std::string(model.name);
  }
  std::vector<DeviceParameter> parameters = {
      {"device", "", "", "published limits of a product: " + models},
      {"path", "", "demo", "demo, rest, press, slide, tap, circle, turn, or a file as for script:"},
      {"dof", "", "6", "6, or 3: rotation neither sensed nor actuated"},
      {"senses_rotation", "", "1", "0 or 1, instead of dof"},
      {"actuates_rotation", "", "1", "0 or 1, instead of dof"},
      {"seed", "", "of the session", "of tremor and jitter"}};
  HandParams defaults = hand_in_context({});
  for (const detail::HandNumber& number : detail::hand_numbers()) {
    parameters.push_back({std::string(number.name), std::string(number.unit),
                          shortest(number.field(defaults)), std::string(number.meaning)});
  }
  return parameters;
}

}  // namespace thigma
