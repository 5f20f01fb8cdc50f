#include "run_summary.h"

#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <optional>
#include <type_traits>
#include <utility>

#include "json_out.h"

#include "thigma/files/file.h"
#include "thigma/recording/recording.h"
#include "thigma/session/simulated_session.h"

namespace thigma::app {
namespace {

using Json = nlohmann::ordered_json;

Json finite(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

/// The empty loop of the same minute, null where it was not measured.
Json floor_json(const EmptyLoop* floor) {
  if (floor == nullptr) return nullptr;
  return {{"ticks", floor->ticks},
          {"missed", floor->missed},
          {"wake_late_us", quantiles_json(summarize(floor->wake_late), 1e-6)},
          {"polled_share", floor->polled_share}};
}

double share_of(std::uint64_t part, const std::array<std::uint64_t, kLevelDeciders>& counts) {
  std::uint64_t sum = 0;
  for (const std::uint64_t n : counts) sum += n;
  return sum > 0 ? static_cast<double>(part) / static_cast<double>(sum) : 0.0;
}

/// Fills an object with what visit_summary tells.
class ToJson {
 public:
  explicit ToJson(Json& json) : at_(&json) {}

  template <class Value>
  void operator()(const std::string& key, const Value& value) {
    if constexpr (std::is_same_v<Value, Quantiles>)
      (*at_)[key] = quantiles_json(value.durations, value.unit, value.has_tail);
    else if constexpr (std::is_same_v<Value, std::optional<double>>)
      (*at_)[key] = value ? finite(*value) : Json(nullptr);
    else if constexpr (std::is_floating_point_v<Value>)
      (*at_)[key] = finite(value);
    else
      (*at_)[key] = value;
  }
  template <class Fill>
  void group(const std::string& key, bool is_known, const Fill& fill) {
    Json group;
    Json* const outer = std::exchange(at_, &group);
    if (is_known) fill();
    at_ = outer;
    (*at_)[key] = std::move(group);
  }

 private:
  Json* at_;  // the group that is being filled
};

void append(std::string& text, const char* format, ...) __attribute__((format(printf, 2, 3)));
void append(std::string& text, const char* format, ...) {
  char line[256];
  va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(line, sizeof line, format, arguments);
  va_end(arguments);
  text += line;
}

void append_constraint(std::string& text, const ConstraintSummary& s) {
  if (!s.is_on) return;
  append(text,
         "rows             p50 %lld, at most %lld in a model; at most %lld pressed at once, solved "
         "to %.2g m/s\n",
         static_cast<long long>(s.rows_p50), static_cast<long long>(s.rows_max),
         static_cast<long long>(s.active_max), s.residual_max);
  append(text,
         "held back        %.2f %% of the frames with the object in the hand, as its model's "
         "travel had ended; squeezed %.2f %%\n",
         100.0 * s.held_back_share, 100.0 * s.squeezed_share);
  if (s.solve.count > 0)
    append(text,
           "row solve        p50 %.2f us, p99 %.2f us, max %.1f us; least gap of a row %.3g mm\n",
           1e6 * s.solve.p50, 1e6 * s.solve.p99, 1e6 * s.solve.max, 1e3 * s.row_gap_min);
  if (std::isfinite(s.travel_min))
    append(text,
           "travel           at least %.3g mm near contact; looked ahead at most %.3g mm; at most "
           "%.3g m/s wanted\n",
           1e3 * s.travel_min, 1e3 * s.look_ahead_max, s.wanted_speed_max);
  if (s.coarse_max > 0)
    append(text, "coarse           at most %lld pairs in a model, far away\n",
           static_cast<long long>(s.coarse_max));
  append(text,
         "left out         %lld contacts at most, in %llu models, which allow no motion; travel "
         "halved %lld times at most, in %llu models, for want of room for rows\n",
         static_cast<long long>(s.left_out_max), static_cast<unsigned long long>(s.left_out_models),
         static_cast<long long>(s.halvings_max), static_cast<unsigned long long>(s.halved_models));
}

}  // namespace

Json run_summary_json(const SessionSummary& s, const std::string& scene, const std::string& device,
                      const EmptyLoop* floor) {
  Json json;
  json["scene"] = scene;
  json["device"] = device;
  visit_summary(s, ToJson(json));
  json["haptic"]["floor"] = floor_json(floor);
  json["safety_events"] = Json::array();
  for (const SessionEvent& event : s.safety_events) {
    json["safety_events"].push_back(
        {{"time", event.time}, {"frame", event.frame}, {"fault", event.detail}});
  }
  json["state_hash"] = hex_text(s.state_hash);
  return json;
}

Json simulation_json(const Run& run) {
  const SimulatedSummary& s = run.simulated;
  const SimulationCounts& c = s.counts;
  Json json;
  json["at_rest"] = s.is_resting;
  json["queries"] = c.steps;
  json["events"] = c.events;
  json["impulses"] = c.impulses;
  json["supported"] = c.supported;
  json["interpolated"] = c.interpolated;
  json["doubted"] = c.doubted;
  json["unresolved"] = c.unresolved;
  json["query_cpu_us_mean"] =
      c.steps > 0 ? finite(1e6 * c.query_cpu / static_cast<double>(c.steps)) : Json(nullptr);
  json["front_mean"] = c.steps > 0 ? finite(c.front / static_cast<double>(c.steps)) : Json(nullptr);
  json["tolerance"] = run.session.simulation->world.tolerance;
  json["deepest"] = c.deepest;
  json["beyond_bound"] = c.beyond_bound;
  json["energy"] = {{"start", s.energy_start}, {"end", s.energy_end}, {"growth_max", s.growth_max}};
  json["body"] = {{"position", {s.body.position.x(), s.body.position.y(), s.body.position.z()}},
                  {"quat_xyzw",
                   {s.body.orientation.x(), s.body.orientation.y(), s.body.orientation.z(),
                    s.body.orientation.w()}}};
  return json;
}

std::string simulation_text(const Run& run) {
  const SimulatedSummary& s = run.simulated;
  std::string text;
  append(text,
         "simulation       %lld queries, %lld impacts, %lld held flights, %lld interpolated; %s\n",
         static_cast<long long>(s.counts.steps), static_cast<long long>(s.counts.events),
         static_cast<long long>(s.counts.supported), static_cast<long long>(s.counts.interpolated),
         s.is_resting ? "at rest" : "moving");
  append(text, "deepest          %.3g mm, tolerance %.3g mm; energy %.3g to %.3g J\n",
         1e3 * s.counts.deepest, 1e3 * run.session.simulation->world.tolerance, s.energy_start,
         s.energy_end);
  return text;
}

std::string run_summary_text(const SessionSummary& s) {
  std::string text;
  append(text, "%.3f s, %llu haptic frames at %g Hz, %llu missed\n", s.seconds,
         static_cast<unsigned long long>(s.frames), s.rate,
         static_cast<unsigned long long>(s.missed));
  append(text, "haptic step      p50 %.2f us, p99 %.2f us, max %.1f us of CPU\n",
         1e6 * s.step_cpu.p50, 1e6 * s.step_cpu.p99, 1e6 * s.step_cpu.max);
  if (s.wake_late.count > 0) {
    append(text, "woke late        p50 %.2f us, p99 %.1f us, max %.0f us\n", 1e6 * s.wake_late.p50,
           1e6 * s.wake_late.p99, 1e6 * s.wake_late.max);
  }
  append(text,
         "contact query    p50 %.0f us, p99 %.0f us of CPU, %llu updates, %.1f contacts, %.1f "
         "clusters\n",
         1e6 * s.query_cpu.p50, 1e6 * s.query_cpu.p99,
         static_cast<unsigned long long>(s.contact_updates), s.contacts_mean, s.clusters_mean);
  std::string deciding;
  for (std::size_t i = 0; i < kDeciderNames.size(); ++i)
    if (s.decided_by[i] > 0)
      append(deciding, "%s%s %.0f %%", deciding.empty() ? "" : ", ", kDeciderNames[i],
             100.0 * share_of(s.decided_by[i], s.decided_by));
  if (!deciding.empty() && s.triangles_below_mean > 0.0)
    append(text, "level of detail  decided by %s; %.0f original triangles below a contact\n",
           deciding.c_str(), s.triangles_below_mean);
  append(text, "contact model    p50 %.2f ms old, p99 %.2f ms, max %.2f ms\n",
         1e3 * s.model_age.p50, 1e3 * s.model_age.p99, 1e3 * s.model_age.max);
  append(text, "force            max %.3f N, rms %.3f N; torque max %.4f N m\n", s.force_max,
         s.force_rms, s.torque_max);
  if (s.force_steps.level_change_frames > 0) {
    append(text,
           "contact force    steps by at most %.4f N where a contact changes level, %.4f N "
           "elsewhere\n",
           s.force_steps.contact.level_change, s.force_steps.contact.other);
  }
  append(text, "penetration      max %.3g mm; coupling stretch max %.3g mm\n",
         1e3 * s.penetration_max, 1e3 * s.stretch_max);
  append_constraint(text, s.constraint);
  if (s.friction.is_on)
    append(text, "friction         %.1f %% of the contacts stuck; sliding has taken %.3g J\n",
           100.0 * s.friction.sticking_share, s.friction.slip_work);
  append(text, "energy           min %.3g J; samples dropped %llu\n", s.energy_min,
         static_cast<unsigned long long>(s.dropped_samples));
  if (s.passivity.is_on) {
    append(text,
           "passivity        %.1f %% of the frames changed, %.1f %% of the wanted wrench sent, "
           "damping at most %.1f N s/m\n",
           100.0 * s.passivity.acted_share, 100.0 * s.passivity.sent_share,
           s.passivity.damping_max);
  }
  if (s.ridden_out.gaps + s.ridden_out.stale_models > 0) {
    append(text,
           "late             %llu times no step for too long (%.1f ms at most), %llu times the "
           "contact "
           "model too old: zero force, then on again, as nobody is held\n",
           static_cast<unsigned long long>(s.ridden_out.gaps), 1e3 * s.ridden_out.longest_gap,
           static_cast<unsigned long long>(s.ridden_out.stale_models));
  }
  for (const SessionEvent& event : s.safety_events) {
    append(text, "FAULT            %s at %.3f s; zero force since\n", event.detail.c_str(),
           event.time);
  }
  append(text, "state hash       %s\n", hex_text(s.state_hash).c_str());
  return text;
}

void write_histograms(const std::string& path, const std::vector<StageHistogram>& histograms) {
  std::string text = "stage,from_us,to_us,count\n";
  for (const StageHistogram& stage : histograms) {
    for (int i = 0; i < DurationHistogram::kBuckets; ++i) {
      const std::uint32_t count = stage.histogram.counts[static_cast<std::size_t>(i)];
      if (count == 0) continue;
      const BucketBounds bounds = bucket_bounds(i);
      append(text, "%s,%.6g,%.6g,%u\n", stage.name, 1e-3 * bounds.from, 1e-3 * bounds.to, count);
    }
  }
  write_file(path, text);
}

}  // namespace thigma::app
