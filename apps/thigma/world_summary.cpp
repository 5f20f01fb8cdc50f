#include "world_summary.h"

#include <cmath>
#include <cstdio>

#include "json_out.h"

#include "thigma/core/index.h"
#include "thigma/recording/recording.h"

namespace thigma::app {
namespace {

/// Of the processor, the mean over all steps.
double step_microseconds(const WorldSummary& s, const WorldRunFacts& facts) {
  return s.frames > 0 ? 1e6 * facts.cpu_seconds / static_cast<double>(s.frames) : 0.0;
}

/// Haptic steps, where they are apart from the world's.
nlohmann::ordered_json haptic_json(const WorldHapticSummary& hand) {
  return {{"frames", hand.steps},
          {"force_max", hand.force_max},
          {"energy", hand.port_energy},
          {"energy_min", hand.port_energy_min},
          {"rows_max", hand.rows_max},
          {"bodies_max", hand.bodies_max},
          {"newton_max", hand.newton_max},
          {"cut_short", hand.cut_short},
          {"held_back", hand.held_back},
          {"corrections", hand.corrections},
          {"correction_max", hand.correction_max},
          {"model_age_max_ms", 1e3 * hand.model_age_max},
          {"state_hash", hex_text(hand.state_hash)}};
}

void print_haptic(const WorldSummary& s) {
  if (s.haptic.empty()) return;
  const DurationSummary steps = summarize(s.haptic_cpu);
  std::printf("haptic thread: %llu missed; p50 %.0f, p99 %.0f, at most %.0f us of the processor\n",
              static_cast<unsigned long long>(s.haptic_missed), 1e6 * steps.p50, 1e6 * steps.p99,
              1e6 * steps.max);
  for (const WorldHapticSummary& hand : s.haptic) {
    if (hand.steps == 0) continue;
    std::printf("haptic: %llu steps, at most %.3f N, put in %.3g mJ (least %.3g mJ)\n",
                static_cast<unsigned long long>(hand.steps), hand.force_max, 1e3 * hand.port_energy,
                1e3 * hand.port_energy_min);
  }
  if (!s.refused.empty()) std::printf("haptic thread: %s\n", s.refused.c_str());
  if (s.haptic_dropped > 0)
    std::printf("haptic steps that the world was too late to record: %llu\n",
                static_cast<unsigned long long>(s.haptic_dropped));
}

}  // namespace

void count_step(const WorldFrame& frame, WorldRunFacts& facts) {
  record(facts.steps, std::llround(1e9 * frame.step_cpu));
}

nlohmann::ordered_json world_summary_json(const WorldSummary& s, const LoadedWorld& world,
                                          const WorldRunFacts& facts) {
  const std::vector<std::string>& devices = facts.devices;
  nlohmann::ordered_json json;
  json["scene"] = world.description.file;
  json["device"] = nullptr;
  if (!devices.empty()) json["device"] = devices.front();
  json["frames"] = s.frames;
  json["rate_hz"] = world.config.rate;
  json["bodies"] = world.config.world.bodies.size();
  json["awake"] = s.awake;
  json["step_cpu_us_mean"] = nullptr;
  if (s.frames > 0) json["step_cpu_us_mean"] = step_microseconds(s, facts);
  json["step_cpu_us"] = quantiles_json(summarize(facts.steps), 1e-6);
  json["contact"] = {{"pairs_max", s.pairs_max},
                     {"queries", s.queries},
                     {"rows_max", s.rows_max},
                     {"pressing_max", s.pressing_max},
                     {"largest_island", s.largest_island},
                     {"row_gap_min", nullptr}};
  if (std::isfinite(s.gap_min)) json["contact"]["row_gap_min"] = s.gap_min;
  json["joints"] = {{"count", world.config.world.joints.size()}, {"error_max", s.joint_error}};
  json["solve"] = {{"newton", s.newton},
                   {"residual_max", s.residual_max},
                   {"parts_max", s.parts_max},
                   {"squeezed", s.not_whole},
                   {"waited", s.waited}};
  json["impacts"] = s.impacts;
  json["force"] = {{"max", s.force_max}};
  json["hands"] = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < s.hands.size(); ++i) {
    const WorldHandSummary& hand = s.hands[i];
    const std::int32_t body = world.config.hands[i].body;
    nlohmann::ordered_json one = {{"device", devices[i]},
                                  {"holds", nullptr},
                                  {"force_max", hand.force_max},
                                  {"energy", hand.port_energy},
                                  {"energy_min", hand.port_energy_min},
                                  {"fault", nullptr},
                                  {"trouble", nullptr}};
    if (body >= 0) one["holds"] = world.config.world.bodies[idx(body)].name;
    if (hand.fault != Fault::none) one["fault"] = fault_name(hand.fault);
    if (!hand.trouble.empty()) one["trouble"] = hand.trouble;
    one["haptic"] = nullptr;
    if (i < s.haptic.size() && s.haptic[i].steps > 0) one["haptic"] = haptic_json(s.haptic[i]);
    json["hands"].push_back(std::move(one));
  }
  json["haptic"] = nullptr;
  if (!s.haptic.empty())
    json["haptic"] = {{"missed", s.haptic_missed},
                      {"stopped", s.haptic_stops},
                      {"step_cpu_us", quantiles_json(summarize(s.haptic_cpu), 1e-6)}};
  json["energy"] = {{"start", s.energy_start},
                    {"end", s.energy_end},
                    {"port", s.port_energy},
                    {"energy_min", s.port_energy_min},
                    {"made", s.energy_made}};
  json["clock"] = nullptr;
  if (facts.has_clock) json["clock"] = {{"late_frames", s.late_frames}, {"lost", s.lost_time}};
  json["dropped_samples"] = s.haptic_dropped;
  json["state_hash"] = hex_text(s.state_hash);
  return json;
}

std::string fault_reason(const WorldSummary& s, const std::vector<std::string>& devices) {
  for (std::size_t i = 0; i < s.hands.size(); ++i) {
    const WorldHandSummary& hand = s.hands[i];
    if (hand.fault != s.fault) continue;
    std::string reason = "hand " + std::to_string(i + 1) + " (" + devices[i] + ")";
    char hung[64];
    std::snprintf(hung, sizeof hung, ": %.1f ms without a haptic step", 1e3 * hand.hung);
    if (hand.hung > 0.0) reason += hung;
    if (!hand.trouble.empty()) reason += ": " + hand.trouble;
    return reason;
  }
  return "";
}

std::string fault_line(const WorldSummary& s, const LoadedWorld& world,
                       const std::vector<std::string>& devices) {
  const std::string reason = fault_reason(s, devices);
  char line[96];
  std::snprintf(line, sizeof line, "safety fault %s at %.3f s: zero force since",
                fault_name(s.fault), static_cast<double>(s.frames) / world.config.rate);
  return line + (reason.empty() ? "" : "; " + reason);
}

void print_world_summary(const WorldSummary& s, const LoadedWorld& world,
                         const WorldRunFacts& facts) {
  std::printf("%s: %llu frames of %zu bodies, %d awake at the end, %.0f us a step\n",
              world.description.title.c_str(), static_cast<unsigned long long>(s.frames),
              world.config.world.bodies.size(), s.awake, step_microseconds(s, facts));
  const DurationSummary steps = summarize(facts.steps);
  std::printf("steps: p50 %.0f, p99 %.0f, p99.9 %.0f, at most %.0f us of the processor\n",
              1e6 * steps.p50, 1e6 * steps.p99, 1e6 * steps.p999, 1e6 * steps.max);
  print_haptic(s);
  std::printf("contacts: at most %lld rows, %d pairs, islands of %d; residual %.2g m/s\n",
              static_cast<long long>(s.rows_max), s.pairs_max, s.largest_island, s.residual_max);
  std::printf("hand: at most %.3f N, put in %.3g mJ (least %.3g mJ)\n", s.force_max,
              1e3 * s.port_energy, 1e3 * s.port_energy_min);
  if (const std::size_t joints = world.config.world.joints.size(); joints > 0)
    std::printf("joints: %zu, met to %.2g um\n", joints, 1e6 * s.joint_error);
  if (s.waited > 0.0) std::printf("bodies waited for %.3g ms\n", 1e3 * s.waited);
  if (facts.has_clock && s.late_frames > 0)
    std::printf("late: %llu frames, by %.3g s in all, which the world is behind the clock\n",
                static_cast<unsigned long long>(s.late_frames), s.lost_time);
  std::printf("state hash %s\n", hex_text(s.state_hash).c_str());
}

}  // namespace thigma::app
