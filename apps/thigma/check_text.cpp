#include "check_text.h"

#include <cstdio>

namespace thigma::app {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kMicro = 1e6, kMilli = 1e3;
constexpr double kSlow =
    1.5e-3;  // a sample of a device as fast as the haptic thread is younger [s]

Json duration_json(const DurationSummary& d) {
  if (d.count == 0) return nullptr;
  return {{"p50", kMicro * d.p50}, {"p99", kMicro * d.p99}, {"max", kMicro * d.max}};
}

Json vector_json(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

template <class... Arguments>
void add_line(std::string& text, const char* format, Arguments... arguments) {
  char line[240];
  std::snprintf(line, sizeof line, format, arguments...);
  text += line;
}

void add_axes(std::string& text, const DeviceReport& report) {
  constexpr const char* kAxes[3] = {"x, to you", "y, to your right", "z, up"};
  text += "axis              least mm    greatest mm   moved mm\n";
  for (int i = 0; i < 3; ++i) {
    add_line(text, "%-16s %9.2f %14.2f %10.2f\n", kAxes[i], kMilli * report.least[i],
             kMilli * report.greatest[i], kMilli * (report.greatest[i] - report.least[i]));
  }
}

}  // namespace

Json check_json(const std::string& uri, const DeviceLimits& limits, const DeviceReport& report) {
  Json json = {{"device", uri}, {"name", report.device}};
  json["trouble"] = report.trouble.empty() ? Json(nullptr) : Json(report.trouble);
  json["clock"] = limits.clock == DeviceClock::device ? "device" : "engine";
  json["delay"] = limits.delay;
  json["max_force"] = limits.max_force;
  json["max_torque"] = limits.actuates_rotation ? Json(limits.max_torque) : Json(nullptr);
  json["senses_rotation"] = limits.senses_rotation;
  json["frames"] = report.frames;
  json["rate_hz"] = report.rate;
  json["new_share"] = report.new_share;
  json["late_us"] = duration_json(report.late);
  json["read_us"] = duration_json(report.read);
  json["write_us"] = duration_json(report.write);
  json["noise"] = report.noise;
  json["turn_noise"] = report.turn_noise;
  json["least"] = vector_json(report.least);
  json["greatest"] = vector_json(report.greatest);
  json["speed_max"] = report.speed_max;
  json["buttons"] = report.buttons;
  json["rules"] = Json::array();
  for (const DeviceRule& rule : report.rules)
    json["rules"].push_back({{"rule", rule.rule}, {"holds", rule.holds}, {"found", rule.found}});
  return json;
}

std::string check_text(const DeviceLimits& limits, const DeviceReport& report, bool with_rules) {
  std::string text = report.device + "\n";
  if (!report.trouble.empty()) text += "trouble: " + report.trouble + "\n";
  const bool is_own = limits.clock == DeviceClock::device;
  add_line(text, "%s sets the pace; %.0f frames a second, %.0f %% with another position\n",
           is_own ? "the device" : "the engine", report.rate, 100.0 * report.new_share);
  add_line(text, "late %.0f us (p99), %.0f us (most); read %.0f us, write %.0f us (p99)\n",
           kMicro * report.late.p99, kMicro * report.late.max, kMicro * report.read.p99,
           kMicro * report.write.p99);
  if (limits.delay > 0.0)
    add_line(text, "its samples are %.1f ms old when they are read\n", kMilli * limits.delay);
  if (limits.delay > kSlow)
    text +=
        "slower than 1000 frames a second: gains = \"auto\" in a scene, or `thigma tune "
        "--device`, count with that\n";
  add_line(text, "noise at rest %.4f mm, %.5f rad\n", kMilli * report.noise, report.turn_noise);
  add_axes(text, report);
  add_line(text, "buttons seen: %#x; bit 0 takes hold of the object\n", report.buttons);
  add_line(text, "force up to %.3g N, ", limits.max_force);
  if (limits.actuates_rotation) {
    add_line(text, "torque up to %.3g N m\n", limits.max_torque);
  } else {
    text += limits.senses_rotation ? "no torque\n" : "no torque, rotation is not sensed\n";
  }
  for (const DeviceRule& rule : report.rules) {
    if (!with_rules && rule.holds) continue;
    add_line(text, "%-5s %s: %s\n", rule.holds ? "ok" : "FAILS", rule.rule, rule.found.c_str());
  }
  return text;
}

}  // namespace thigma::app
