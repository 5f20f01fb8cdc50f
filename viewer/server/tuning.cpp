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

/// The same spring with another stiffness: it levels off at the same force, from the same share of it on.
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
  const Coupling& c = config.haptic.coupling;
  list_.push_back(span("contact_stiffness", "contact stiffness", "N/m",
                       "how hard the surfaces are, all contacts together",
                       config.contact.response.stiffness, 20.0, 4.0));
  list_.back().is_replayed = false;  // recordings hold the contact models themselves
  if (config.haptic.response == ResponseKind::coupled && c.linear_stiffness > 0.0) {
    list_.push_back(span("coupling_stiffness", "coupling stiffness", "N/m",
                         "how firmly the hand holds the object", c.linear_stiffness, 20.0, 4.0));
  }
  if (config.haptic.response == ResponseKind::coupled && c.angular_stiffness > 0.0) {
    list_.push_back(span("coupling_angular_stiffness", "coupling stiffness, turning", "N m/rad",
                         "how firmly the hand turns the object", c.angular_stiffness, 20.0, 4.0));
  }
  list_.push_back(span("mass", "mass", "kg", "of the object; its inertia goes with it",
                       config.haptic.body.mass, 10.0, 10.0));
  const Resolution& r = config.contact.resolution;
  if (!r.is_exact && r.metric.haptic > 0.0) {
    LiveParameter p;
    p.name = "threshold";
    p.label = "error threshold";
    p.help = "of the levels of detail, as a share of the smaller radius: larger is coarser";
    p.value = r.metric.haptic;
    p.min = std::min(0.001, r.metric.haptic);
    p.max = std::max(0.2, r.metric.haptic);
    p.is_replayed = false;
    list_.push_back(p);
  }
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
  const double stiffest =
      std::max(mass * base_.rate * base_.rate,
               std::max(base_.contact.response.stiffness, before.linear_stiffness) * mass /
                   base_.haptic.body.mass);
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
  if (!(wanted >= found->min * (1.0 - kRounding) && wanted <= found->max * (1.0 + kRounding))) {
    return found->label + " goes from " + number(found->min) + " to " + number(found->max) +
           (found->unit.empty() ? "" : " ") + found->unit;
  }
  std::string why = unsafe(name, wanted);
  if (why.empty()) found->value = wanted;
  return why;
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
  ContactTuning tuning{base_.contact.response, value("threshold")};
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
