// thigma tune: gains for a scene, or for an object in a device, and what limits them.

#include <charconv>
#include <cmath>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>

#include "device_errors.h"
#include "json_out.h"
#include "run_options.h"
#include "verbs.h"

#include "thigma/core/error.h"
#include "thigma/device/open_device.h"
#include "thigma/scene/asset_cache.h"
#include "thigma/scene/gain_task.h"
#include "thigma/scene/scene_file.h"

namespace thigma::app {
namespace {

using Json = nlohmann::ordered_json;

struct TuneOptions {
  std::string scene, device, inertia, response;
  std::optional<double> mass, rate, delay, motion_scale;
};

/// What is tuned: the task, and what a scene has chosen, where there is one.
struct Tuned {
  std::string title, device;
  GainTask task;
  std::optional<SessionConfig> chosen;
  bool is_potential = false;  // the contact stiffness is of an area
};

/// One moment or three principal ones, "I" or "I,I,I" [kg m^2]; none where the text is something
/// else.
std::optional<Vec3> parse_inertia(const std::string& text) {
  Vec3 moments = Vec3::Zero();
  int count = 0;
  const char* at = text.data();
  const char* const end = at + text.size();
  while (count < 3) {
    const auto [next, error] = std::from_chars(at, end, moments[count]);
    if (error != std::errc{} || !(moments[count] > 0.0) || !std::isfinite(moments[count]))
      return std::nullopt;
    ++count;
    at = next;
    if (at == end) break;
    if (*at++ != ',') return std::nullopt;
  }
  if (at != end || count == 2) return std::nullopt;
  return count == 1 ? Vec3::Constant(moments[0]) : moments;
}

/// What is wrong with the options as such, "" when nothing.
std::string check(const TuneOptions& o) {
  const auto is_above = [](const std::optional<double>& value) {
    return !value || (*value > 0.0 && std::isfinite(*value));
  };
  if (o.scene.empty() && (o.device.empty() || !o.mass || o.inertia.empty()))
    return "tune needs a scene, or --device URI --mass M --inertia I";
  if (!o.scene.empty() && (o.mass || !o.inertia.empty()))
    return "--mass and --inertia belong to --device without a scene; a scene has its own";
  if (!is_above(o.mass)) return "--mass must be a number above 0 [kg]";
  if (!o.inertia.empty() && !parse_inertia(o.inertia))
    return "--inertia must be one moment above 0, or three as I,I,I [kg m^2]";
  if (!o.response.empty() && !response_of(o.response)) return kWrongResponse;
  if (o.rate && !(*o.rate >= 50.0 && *o.rate <= 20000.0)) return "--rate must be 50 to 20000 Hz";
  if (o.delay && !(*o.delay >= 0.0 && *o.delay <= 1.0)) return "--delay must be 0 to 1 s";
  if (!is_above(o.motion_scale)) return "--motion-scale must be a number above 0";
  return {};
}

LoadedObject load_measures(const SceneObject& object, const Common& common) {
  if (object.model || !is_clod_file(object.mesh)) return load_object(object);
  const Log log = common.quiet ? Log{} : [](const std::string& line) { print_error(line); };
  const ClodAsset asset = load_clod({.name = object.mesh, .scale = object.unit_scale}, log);
  LoadedObject loaded;
  loaded.measure = asset.mass.measure;
  loaded.ball = {asset.hierarchy.center, asset.hierarchy.radius};
  return loaded;
}

Tuned tune_scene(const TuneOptions& options, const Common& common) {
  Tuned tuned;
  SceneDescription scene = read_scene(options.scene);
  if (!options.device.empty()) scene.device.uri = options.device;
  scene.rate = options.rate.value_or(scene.rate);
  if (options.motion_scale) scene.device.motion_scale = options.motion_scale;
  const auto asked = response_of(options.response);
  if (asked || !scene.contact.response)
    scene.contact.response = asked.value_or(default_response(scene, true));
  const DevicePort port = describe_device(scene.device.uri);
  tuned.chosen = make_session_config(scene, load_measures(scene.object, common));
  const HapticParams& haptic = tuned.chosen->haptic;
  tuned.title = scene.file;
  tuned.device = scene.device.uri;
  tuned.task = gain_task(port, haptic.body, haptic.workspace, scene.rate, haptic.response);
  tuned.is_potential = haptic.response == ResponseKind::potential;
  return tuned;
}

Tuned tune_body(const TuneOptions& options) {
  Tuned tuned;
  const DevicePort port = describe_device(options.device);
  const Mat3 inertia = parse_inertia(options.inertia)->asDiagonal();
  const Workspace workspace =
      stiffness_keeping_workspace(Pose{}, options.motion_scale.value_or(1.0));
  tuned.device = options.device;
  const ResponseKind response =
      response_of(options.response).value_or(default_response(SceneDescription{}, false));
  tuned.task = gain_task(port, make_body(*options.mass, inertia), workspace,
                         options.rate.value_or(1000.0), response);
  tuned.is_potential = response == ResponseKind::potential;
  return tuned;
}

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }
Json known(double value) { return value > 0.0 ? number(value) : Json(nullptr); }

Json choice_json(const GainChoice& choice) {
  Json json;
  json["stiffness"] = number(choice.stiffness);
  json["damping"] = number(choice.damping);
  json["limit"] = number(choice.limit);
  json["binds"] = limit_name(choice.binds);
  for (int i = 0; i < kGainLimits; ++i) {
    json["limits"][limit_name(static_cast<GainLimit>(i))] =
        number(choice.limits[static_cast<std::size_t>(i)]);
  }
  return json;
}

/// Contacts that are constraints have neither stiffness nor damping.
Json contact_number(const SessionConfig& config, double value) {
  return config.haptic.response == ResponseKind::constrained ? Json(nullptr) : Json(value);
}

Json chosen_json(const SessionConfig& config) {
  const Coupling& c = config.haptic.coupling;
  Json json;
  json["linear_stiffness"] = c.linear_stiffness;
  json["linear_damping"] = c.linear_damping;
  json["angular_stiffness"] = c.angular_stiffness;
  json["angular_damping"] = c.angular_damping;
  json["contact_stiffness"] = contact_number(config, config.contact.response.stiffness);
  json["contact_damping"] = contact_number(config, config.contact.response.damping);
  const bool is_potential = config.haptic.response == ResponseKind::potential;
  const PotentialLaw& law = config.contact.potential_law;
  json["contact_area"] = is_potential ? Json(law.area) : Json(nullptr);
  json["contact_exponent"] = is_potential ? Json(law.exponent) : Json(nullptr);
  json["max_force"] = c.linear_saturation ? Json(c.linear_saturation->max_force) : Json(nullptr);
  json["max_torque"] = c.angular_saturation ? Json(c.angular_saturation->max_force) : Json(nullptr);
  return json;
}

Json to_json(const Tuned& tuned, const GainProposal& proposal,
             const std::vector<GainWarning>& warnings) {
  Json json;
  json["scene"] = tuned.title.empty() ? Json(nullptr) : Json(tuned.title);
  json["device"] = tuned.device;
  json["mass"] = tuned.task.body.mass;
  json["inertia"] = Json::array();
  for (int i = 0; i < 3; ++i) {
    const Vec3 row = tuned.task.body.inertia.row(i);
    json["inertia"].push_back({row.x(), row.y(), row.z()});
  }
  json["rate_hz"] = tuned.task.rate;
  json["delay"] = tuned.task.delay;
  json["motion_scale"] = tuned.task.motion_scale;
  json["force_scale"] = tuned.task.force_scale;
  json["linear"] = choice_json(proposal.linear);
  json["angular"] = choice_json(proposal.angular);
  json["contact"] = tuned.task.is_constrained ? Json(nullptr) : choice_json(proposal.contact);
  json["max_force"] = known(proposal.max_force);
  json["max_torque"] = known(proposal.max_torque);
  json["scene_gains"] = tuned.chosen ? chosen_json(*tuned.chosen) : Json(nullptr);
  json["warnings"] = Json::array();
  for (const GainWarning& w : warnings) {
    json["warnings"].push_back(
        {{"gain", w.gain}, {"value", w.value}, {"limit", number(w.limit)}, {"text", w.text}});
  }
  return json;
}

void print_choice(const char* table, const char* key, const char* damping_key, const char* unit,
                  const GainChoice& choice) {
  std::printf("  %-11s %s = %.4g, %s = %.4g   of at most %.4g %s: %s\n", table, key,
              choice.stiffness, damping_key, choice.damping, choice.limit, unit,
              limit_name(choice.binds));
}

void print_text(const Tuned& tuned, const GainProposal& proposal,
                const std::vector<GainWarning>& warnings) {
  std::printf("%s%s%s, %.4g kg at %g Hz, samples %.3g ms late, motion scale %.3g\n",
              tuned.title.c_str(), tuned.title.empty() ? "" : " in ", tuned.device.c_str(),
              tuned.task.body.mass, tuned.task.rate, 1e3 * tuned.task.delay,
              tuned.task.motion_scale);
  print_choice("[coupling]", "linear_stiffness", "linear_damping", "N/m", proposal.linear);
  print_choice("", "angular_stiffness", "angular_damping", "N m/rad", proposal.angular);
  if (!tuned.task.is_constrained)
    print_choice("[contact]", "stiffness", "damping", "N/m", proposal.contact);
  if (proposal.max_force > 0.0) std::printf("  %-11s max_force = %.4g\n", "", proposal.max_force);
  if (proposal.max_torque > 0.0)
    std::printf("  %-11s max_torque = %.4g\n", "", proposal.max_torque);
  if (tuned.task.is_constrained) {
    std::printf(
        "  %-11s constraint: no stiffness; the object stays outside, and the hand feels the "
        "coupling alone\n",
        "[contact]");
  }
  if (tuned.is_potential) {
    std::printf(
        "  %-11s potential: the stiffness is that of an area A0 in even contact; of an area A it "
        "is (A/A0)^(2/p) times as much\n",
        "[contact]");
  }
  if (tuned.is_potential && tuned.chosen) {
    const PotentialLaw& law = tuned.chosen->contact.potential_law;
    const double k = tuned.chosen->contact.response.stiffness;
    std::printf("  %-11s A0 = %.4g mm^2, p = %d: k = %.4g N/m, k/A0 = %.4g Pa/m\n", "",
                1e6 * law.area, law.exponent, k, k / law.area);
  }
  for (const GainWarning& w : warnings)
    std::printf("outside: %s, %s\n", w.gain.c_str(), w.text.c_str());
  if (tuned.chosen && warnings.empty()) std::printf("the scene's gains are within the limits\n");
}

int tune(const TuneOptions& options, const Common& common) {
  if (const std::string wrong = check(options); !wrong.empty()) {
    print_error(wrong);
    return kUsage;
  }
  Tuned tuned = options.scene.empty() ? tune_body(options) : tune_scene(options, common);
  if (options.delay) tuned.task.delay = *options.delay;
  const GainProposal proposal = propose_gains(tuned.task);
  std::vector<GainWarning> warnings;
  if (tuned.chosen) {
    const PenaltyParams& contact = tuned.chosen->contact.response;
    warnings = check_gains(tuned.task, proposal, tuned.chosen->haptic.coupling, contact.stiffness,
                           contact.damping);
  }
  if (common.json) {
    print_json(to_json(tuned, proposal, warnings));
  } else {
    print_text(tuned, proposal, warnings);
  }
  return kDone;
}

}  // namespace

void add_tune(CLI::App& app, Common& common) {
  const auto options = std::make_shared<TuneOptions>();
  CLI::App* verb = add_verb(
      app, common, "tune", "propose gains of coupling and contact, and say what limits them",
      [&common, options] { return with_device([&] { return tune(*options, common); }); });
  verb->add_option("scene", options->scene, "scene file (.toml) or the name of a built-in scene");
  verb->add_option("--device", options->device,
                   "instead of the scene's (thigma devices lists them)");
  verb->add_option("--mass", options->mass, "of the object, without a scene [kg]");
  verb->add_option("--inertia", options->inertia,
                   "I, or I,I,I about its principal axes, without a scene [kg m^2]");
  verb->add_option("--response", options->response,
                   "penalty, constraint, potential or direct, otherwise the scene's");
  verb->add_option("--rate", options->rate, "haptic frames a second, otherwise the scene's");
  verb->add_option("--delay", options->delay, "of device samples [s], otherwise the device's");
  verb->add_option("--motion-scale", options->motion_scale,
                   "virtual metres per device metre, otherwise the scene's or 1");
}

}  // namespace thigma::app
