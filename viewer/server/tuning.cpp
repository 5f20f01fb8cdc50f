#include "viewer/server/tuning.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace thigma::live {
namespace {

std::string number(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

LiveParameter span(const char* name, const char* label, const char* unit, const char* help,
                   double value, double factor_down, double factor_up) {
  LiveParameter p;
  p.name = name;
  p.label = label;
  p.unit = unit;
  p.help = help;
  p.value = value;
  p.min = value / factor_down;
  p.max = value * factor_up;
  return p;
}

/// A number that may be off. off_value: what stands for off in a session.
LiveParameter switchable(const char* name, const char* label, const char* unit, const char* help,
                         double value, double least, double most) {
  LiveParameter p;
  p.name = name;
  p.label = label;
  p.unit = unit;
  p.help = help;
  p.kind = ParameterKind::optional;
  p.value = value;
  p.min = value > 0.0 ? std::min(least, value) : least;
  p.max = std::max(most, value);
  p.is_replayed = false;  // recordings hold the contact models themselves
  return p;
}

/// The same spring with another stiffness: it levels off at the same force, from the same share of
/// it on.
Saturation restiffened(const Saturation& s, double stiffness) {
  if (stiffness == s.stiffness) return s;  // to the last bit
  return make_saturation(stiffness, s.linear_range * s.stiffness / stiffness, s.max_force);
}

void restiffen(double stiffness, double damping_scale, std::optional<Saturation>& saturation,
               double& gain, double& damping) {
  gain = stiffness;
  damping *= damping_scale;
  if (saturation) saturation = restiffened(*saturation, stiffness);
}

}  // namespace

Tuner::Tuner(const SessionConfig& config) {
  base_.haptic = config.haptic;
  base_.rate = config.rate;
  base_.contact.response = config.contact.response;
  base_.contact.resolution = config.contact.resolution;
  base_.contact.most_friction = config.contact.most_friction;
  most_friction_ = config.contact.most_friction.value_or(0.0);
  if (!config.contact.most_friction)
    for (const Friction& f : config.contact.friction)
      most_friction_ = std::max(most_friction_, f.kinetic);
  const Coupling& c = config.haptic.coupling;
  if (config.haptic.response != ResponseKind::constrained) {  // which has none
    list_.push_back(span("contact_stiffness", "contact stiffness", "N/m",
                         "how hard the surfaces are, all contacts together",
                         config.contact.response.stiffness, 20.0, 4.0));
    list_.back().is_replayed = false;  // recordings hold the contact models themselves
  }
  const bool has_coupling = config.haptic.response != ResponseKind::direct;
  if (has_coupling && c.linear_stiffness > 0.0) {
    list_.push_back(span("coupling_stiffness", "coupling stiffness", "N/m",
                         "how firmly the hand holds the object", c.linear_stiffness, 20.0, 4.0));
  }
  if (has_coupling && c.angular_stiffness > 0.0) {
    list_.push_back(span("coupling_angular_stiffness", "coupling stiffness, turning", "N m/rad",
                         "how firmly the hand turns the object", c.angular_stiffness, 20.0, 4.0));
  }
  list_.push_back(switchable("friction", "friction", "",
                             "Coulomb's coefficient of sliding, where it is largest; the others "
                             "keep their share of it",
                             most_friction_, 0.01, 2.0));
  list_.push_back(span("mass", "mass", "kg", "of the object; its inertia goes with it",
                       config.haptic.body.mass, 10.0, 10.0));
  if (!config.contact.resolution.is_exact) add_resolution(config);
}

void Tuner::add_resolution(const SessionConfig& config) {
  const Resolution& r = config.contact.resolution;
  // Where the page first looks from: an opening of 30 degrees, 720 pixels.
  constexpr double kRadii = 4.0, kHeight = 0.536, kPixels = 720.0;
  const double radius = config.contact.object != nullptr ? config.contact.object->radius : 1.0;
  from_afar_ = {0.0, kRadii * radius, kHeight, 1.0, kPixels};
  list_.push_back(
      switchable("threshold", "error threshold", "",
                 "of the levels of detail, as a share of the smaller radius: larger is coarser",
                 r.metric.haptic, 0.001, 0.2));
  // Under constraints the others do not count.
  const bool has_all = config.contact.constraints == nullptr;
  if (has_all) {
    list_.push_back(switchable("velocity_metric", "speed metric", "s",
                               "coarser where surfaces pass fast: error allowed for each m/s",
                               r.metric.velocity, 0.001, 0.2));
    list_.push_back(switchable("view_metric", "view metric", "px",
                               "errors no larger than this on a picture 720 pixels high from some "
                               "four radii away are allowed",
                               r.metric.view.pixels, 0.25, 50.0));
  }
  list_.push_back(switchable("deviation_cap", "deviation cap", "",
                             "most surface deviation of a contact, as a share of the smaller "
                             "radius, whatever the metrics allow",
                             std::isfinite(r.deviation_cap) ? r.deviation_cap : 0.0, 0.002, 0.2));
  if (has_all)
    list_.push_back(
        switchable("budget_us", "time budget", "\u00b5s",
                   "CPU time of a contact query; what is left coarse for it shows in the bounds",
                   1e6 * r.budget_cpu, 20.0, 20000.0));
}

const LiveParameter* Tuner::find(const std::string& name) const {
  const auto found = std::find_if(list_.begin(), list_.end(),
                                  [&](const LiveParameter& p) { return p.name == name; });
  return found == list_.end() ? nullptr : &*found;
}

double Tuner::value(const char* name) const {
  const LiveParameter* p = find(name);
  return p != nullptr ? p->value : 0.0;
}

void Tuner::lock(const std::string& replayed, const std::string& all) {
  for (LiveParameter& p : list_) p.locked = !all.empty() ? all : p.is_replayed ? replayed : "";
}

std::string Tuner::unsafe(const std::string& name, double wanted) const {
  const auto with = [&](const char* other) { return name == other ? wanted : value(other); };
  const Workspace& w = base_.haptic.workspace;
  const DeviceLimits& device = base_.haptic.device;
  const Coupling& before = base_.haptic.coupling;
  const double mass = with("mass");
  // Above a radian a frame the spring of a contact swings faster than the frames can follow.
  const double contact =
      find("contact_stiffness") != nullptr ? base_.contact.response.stiffness : 0.0;
  const double stiffest =
      std::max(mass * base_.rate * base_.rate,
               std::max(contact, before.linear_stiffness) * mass / base_.haptic.body.mass);
  for (const char* spring : {"contact_stiffness", "coupling_stiffness"}) {
    const double k = with(spring);
    if (k <= stiffest * (1.0 + 1e-9)) continue;
    if (name == "mass") {
      return "a mass of " + number(mass) + " kg would swing on the " + find(spring)->label +
             " of " + number(k) + " N/m faster than the haptic frames can follow; at least " +
             number(mass * k / stiffest) + " kg, or a softer spring first";
    }
    return number(k) + " N/m would let " + number(mass) +
           " kg swing faster than the haptic frames can follow; at most " + number(stiffest) +
           " N/m, or a larger mass first";
  }
  const double linear_scale = w.force_scale * w.motion_scale;
  const double linear_limit =
      std::max(device.max_stiffness, before.linear_stiffness * linear_scale) / linear_scale;
  if (name == "coupling_stiffness" && wanted > linear_limit * (1.0 + 1e-9)) {
    return number(wanted) + " N/m is stiffer than the device can hold without ringing; at most " +
           number(linear_limit) + " N/m";
  }
  const double angular_limit =
      std::max(device.max_angular_stiffness, before.angular_stiffness * torque_scale(w)) /
      torque_scale(w);
  if (name == "coupling_angular_stiffness" && wanted > angular_limit * (1.0 + 1e-9)) {
    return number(wanted) +
           " N m/rad is stiffer than the device can hold without ringing; at most " +
           number(angular_limit) + " N m/rad";
  }
  return {};
}

std::string Tuner::set(const std::string& name, double wanted) {
  const auto found = std::find_if(list_.begin(), list_.end(),
                                  [&](const LiveParameter& p) { return p.name == name; });
  if (found == list_.end()) return "there is no parameter '" + name + "' here";
  if (!found->locked.empty()) return found->locked;
  // Sliders come to their ends by rounding.
  constexpr double kRounding = 1e-6;
  const bool is_off = found->kind == ParameterKind::optional && wanted == 0.0;
  if (!is_off &&
      !(wanted >= found->min * (1.0 - kRounding) && wanted <= found->max * (1.0 + kRounding))) {
    return found->label + " goes from " + number(found->min) + " to " + number(found->max) +
           (found->unit.empty() ? "" : " ") + found->unit +
           (found->kind == ParameterKind::optional ? ", or is off" : "");
  }
  std::string why = unsafe(name, wanted);
  if (!why.empty()) return why;
  found->value = wanted;
  warn();
  return {};
}

void Tuner::judge_for(const std::optional<GainTask>& task) {
  task_ = task;
  warn();
}

void Tuner::warn() {
  for (LiveParameter& p : list_) p.warning.clear();
  if (!task_) return;
  const HapticTuning h = haptic();
  task_->body = h.body;
  const PenaltyParams response = contact().response;
  // Gains by the names of docs/gains.md; dampings follow stiffness and mass here.
  const auto of = [](const std::string& gain) {
    return gain == "linear_stiffness"    ? "coupling_stiffness"
           : gain == "angular_stiffness" ? "coupling_angular_stiffness"
           : gain == "stiffness"         ? "contact_stiffness"
                                         : "";
  };
  for (const GainWarning& w : check_gains(*task_, propose_gains(*task_), h.coupling,
                                          response.stiffness, response.damping)) {
    for (LiveParameter& p : list_) {
      if (p.name == of(w.gain)) p.warning = w.text;
    }
  }
}

HapticTuning Tuner::haptic() const {
  HapticTuning tuning{base_.haptic.body, base_.haptic.coupling};
  const double m0 = base_.haptic.body.mass, m = value("mass");
  if (m != m0)
    tuning.body = make_body(m, base_.haptic.body.inertia * (m / m0), base_.haptic.body.gravity);
  Coupling& c = tuning.coupling;
  // b = 2 ratio sqrt(k m): the ratio stays.
  if (find("coupling_stiffness") != nullptr) {
    const double k = value("coupling_stiffness");
    restiffen(k, std::sqrt(k * m / (c.linear_stiffness * m0)), c.linear_saturation,
              c.linear_stiffness, c.linear_damping);
  }
  if (find("coupling_angular_stiffness") != nullptr) {
    const double k = value("coupling_angular_stiffness");
    restiffen(k, std::sqrt(k * m / (c.angular_stiffness * m0)), c.angular_saturation,
              c.angular_stiffness, c.angular_damping);
  }
  return tuning;
}

ContactTuning Tuner::contact() const {
  ContactTuning tuning{base_.contact.response, base_.contact.resolution,
                       base_.contact.most_friction};
  if (value("friction") != most_friction_) tuning.most_friction = value("friction");
  Resolution& r = tuning.resolution;
  if (!r.is_exact) {
    r.metric.haptic = value("threshold");
    r.metric.velocity = value("velocity_metric");
    if (value("view_metric") > 0.0 && r.metric.view.pixels == 0.0) r.metric.view = from_afar_;
    r.metric.view.pixels = value("view_metric");
    r.deviation_cap = value("deviation_cap") > 0.0 ? value("deviation_cap") : kNoCap;
    if (value("budget_us") != 1e6 * r.budget_cpu) r.budget_cpu = 1e-6 * value("budget_us");
  }
  if (find("contact_stiffness") == nullptr) return tuning;
  const double k = value("contact_stiffness");
  tuning.response.damping *=
      std::sqrt(k * value("mass") / (tuning.response.stiffness * base_.haptic.body.mass));
  tuning.response.stiffness = k;
  return tuning;
}

void Tuner::apply_to(SessionConfig& config) const {
  const HapticTuning h = haptic();
  config.haptic.body = h.body;
  config.haptic.coupling = h.coupling;
  apply_tuning(contact(), config.contact);
}

}  // namespace thigma::live
