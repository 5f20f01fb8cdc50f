#pragma once
// What a session was like: its numbers, and the one list that JSON and Python follow.

#include <array>
#include <cstdint>
#include <limits>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

#include "thigma/loop/samples.h"
#include "thigma/session/force_steps.h"
#include "thigma/session/histogram.h"

namespace thigma {

struct SessionEvent;  // session.h

/// How a session ended.
enum class SessionEnd : std::uint8_t { duration, device_finished, stopped, fault };

/// Name as it stands in messages to pages.
const char* end_name(SessionEnd end) noexcept;

/// What was late and ridden out (SafetyLimits::rides_out_gaps).
struct RiddenOut {
  std::uint64_t gaps = 0, stale_models = 0;
  double longest_gap = 0.0;  // from the frame before to the one that was late [s]
};

/// What the passivity controller did; nothing where it was off.
struct PassivitySummary {
  bool is_on = false;
  double delay = 0.0;        // it reckoned with [s]
  double acted_share = 0.0;  // of the frames with a wrench, those it changed
  double sent_share = 1.0;   // of the wanted wrench, mean over frames with one, before damping
  double damping_max = 0.0;  // injected [N s/m]
};

/// What the constrained response did; nothing of the others.
struct ConstraintSummary {
  bool is_on = false;
  double held_back_share = 0.0;  // of the frames with the object in the hand: its travel had ended
  double squeezed_share = 0.0;   // of these: rows contradicted each other
  std::uint64_t held_back_frames = 0;
  double active_mean = 0.0;       // rows that pressed, where any did
  std::int64_t active_max = 0;    // rows that pressed at once
  double residual_max = 0.0;      // of a solve: speed at which a row is violated [m/s]
  double wanted_speed_max = 0.0;  // of the object's fastest point [m/s]
  // least gap of a row, infinite without one: below 0 a feature has been behind a plane that it is
  // kept in front of, which beside the surface is no depth [m]
  double row_gap_min = std::numeric_limits<double>::infinity();
  DurationSummary solve;  // of the row solves of a frame, where there were rows [s]
  // in a model that has any, and found for one
  double rows_mean = 0.0;
  std::int64_t rows_p50 = 0, rows_max = 0, found_max = 0;
  // see ContactSample
  std::int64_t halvings_max = 0, left_out_max = 0;
  std::uint64_t halved_models = 0, left_out_models = 0;
  // least of models with rows, infinite without; tolerance of queries [m]
  double travel_min = std::numeric_limits<double>::infinity(), look_ahead_max = 0.0;
  std::int64_t coarse_max = 0;  // see ContactSample
};

/// How friction held over a session, of any response.
struct FrictionSummary {
  bool is_on = false;           // a contact with friction has pressed
  double sticking_share = 0.0;  // of the contacts with friction that pressed, over frames
  double slip_work = 0.0;       // that sliding has taken [J]
};

/// What adds up in the haptic frames just as the summary tells it. Thread: one writer.
struct HapticTotals {
  std::uint64_t frames = 0;
  double force_max = 0.0;    // sent [N]
  double torque_max = 0.0;   // felt about the handle, sent or not (device without it) [N m]
  double stretch_max = 0.0;  // of the coupling, while grasped [m]
  RiddenOut ridden_out;
};

/// Likewise in the contact frames: sums over updates. Thread: one writer.
struct ContactTotals {
  std::uint64_t unrefined = 0, level_changes = 0;  // contacts
  // depths by textures; of these where a surface is no height field, and of these by its sheets
  std::uint64_t texture_depths = 0, texture_folds = 0, texture_sheets = 0;
  // see ContactSample
  std::uint64_t texture_coarse = 0, texture_bent = 0, texture_left_out = 0;
  double bound_max = 0.0;                                                 // of all contacts [m]
  std::array<std::uint64_t, kLevelBins> object_levels{}, scene_levels{};  // contacts
  std::array<std::uint64_t, kLevelDeciders> decided_by{};  // contacts, by LevelDecision
};

/// What a session was like: the summary of `thigma run` is made of this.
struct SessionSummary : HapticTotals, ContactTotals {
  SessionEnd end = SessionEnd::duration;
  double seconds = 0.0;  // session clock
  double rate = 0.0;     // asked for [Hz]
  std::uint64_t missed = 0;
  DurationSummary step_cpu, wake_late;  // [s]
  StageSummary stages;
  DeadlineSummary deadlines;
  std::vector<StageHistogram> histograms;  // of every stage that was timed
  std::uint64_t contact_updates = 0;
  DurationSummary query_cpu, model_cpu, contact_step_cpu;             // [s]
  double contacts_mean = 0.0, clusters_mean = 0.0, front_mean = 0.0;  // over updates
  DurationSummary model_age;                                          // [s]
  double tests_mean = 0.0, mandatory_tests_mean = 0.0;  // pairs looked at, over updates
  // of the original below a contact, over contacts; 0 of exact queries
  double triangles_below_mean = 0.0;
  ForceSteps force_steps;
  double force_rms = 0.0, torque_rms = 0.0;  // over frames [N, N m]
  // largest depth at the poses of the contact queries; 0: never inside [m]
  double penetration_max = 0.0;
  double energy_min = 0.0;  // at the device's port, <= 0 [J]
  ConstraintSummary constraint;
  FrictionSummary friction;
  PassivitySummary passivity;
  std::uint64_t dropped_samples = 0;  // of either ring
  std::uint64_t dropped_contacts = 0;
  std::vector<SessionEvent> safety_events;
  std::uint64_t state_hash = 0;
  std::vector<std::string> notes;  // what the system refused; the texts of events
};

/// Shares of a sum, up to the last that is not 0.
template <std::size_t N>
std::vector<double> shares_of(const std::array<std::uint64_t, N>& counts) {
  std::uint64_t sum = 0, so_far = 0;
  for (const std::uint64_t n : counts) sum += n;
  std::vector<double> shares;
  for (std::size_t i = 0; i < N && so_far < sum; so_far += counts[i++])
    shares.push_back(static_cast<double>(counts[i]) / static_cast<double>(sum));
  return shares;
}

inline std::optional<double> known_if(bool is_known, double value) {
  return is_known ? std::optional(value) : std::nullopt;
}

/// Names of LevelDecision in lists.
inline constexpr std::array<const char*, kLevelDeciders> kDeciderNames = {
    "haptic", "velocity", "view", "cap", "budget", "finest"};

// The parts of visit_summary, below.
template <class Visit>
void visit_haptic(const SessionSummary& s, Visit&& visit) {
  visit("rate_hz", s.rate);
  visit("frames", s.frames);
  visit("missed", s.missed);
  visit("step_cpu_us", Quantiles{s.step_cpu, 1e-6});
  visit("wake_late_us", Quantiles{s.wake_late, 1e-6});
  visit.group("stages_us", s.stages.whole.count > 0, [&] {
    visit("device_read", Quantiles{s.stages.device_read, 1e-6});
    visit("compute", Quantiles{s.stages.compute, 1e-6});
    visit("device_write", Quantiles{s.stages.device_write, 1e-6});
    visit("whole", Quantiles{s.stages.whole, 1e-6});
  });
  visit.group("deadlines", s.wake_late.count > 0, [&] {
    visit("missed", s.missed);
    visit("overruns", s.deadlines.overruns);
    visit.group("late_over_us", true, [&] {
      for (std::size_t i = 0; i < kLateBounds.size(); ++i)
        visit(std::to_string(kLateBounds[i] / 1000), s.deadlines.late[i]);
    });
    visit("polled_share", s.deadlines.polled_share);
  });
}

template <class Visit>
void visit_contact(const SessionSummary& s, Visit&& visit) {
  const bool has_updates = s.contact_updates > 0;
  visit("updates", s.contact_updates);
  visit("rate_hz", known_if(s.seconds > 0.0, static_cast<double>(s.contact_updates) / s.seconds));
  visit("query_cpu_us", Quantiles{s.query_cpu, 1e-6});
  visit("model_cpu_us", Quantiles{s.model_cpu, 1e-6});
  visit("step_cpu_us", Quantiles{s.contact_step_cpu, 1e-6});
  visit("contacts_mean", known_if(has_updates, s.contacts_mean));
  visit("clusters_mean", known_if(has_updates, s.clusters_mean));
  visit("front_mean", known_if(has_updates, s.front_mean));
  visit("model_age_ms", Quantiles{s.model_age, 1e-3, false});
  visit("tests_mean", known_if(has_updates, s.tests_mean));
  visit("mandatory_tests_mean", known_if(has_updates, s.mandatory_tests_mean));
  visit("dropped", s.dropped_contacts);
  visit("bound_max", s.bound_max);
  visit("unrefined", s.unrefined);
  visit("level_changes", s.level_changes);
  visit.group("texture", true, [&] {
    visit("depths", s.texture_depths);
    visit("not_height_field", s.texture_folds);
    visit("by_sheets", s.texture_sheets);
    visit("coarse", s.texture_coarse);
    visit("bent", s.texture_bent);
    visit("left_out", s.texture_left_out);
  });
  visit.group("levels", true, [&] {
    visit("object", shares_of(s.object_levels));
    visit("scene", shares_of(s.scene_levels));
  });
}

template <class Visit>
void visit_levels(const SessionSummary& s, Visit&& visit) {
  const auto& counts = s.decided_by;
  const auto sum = std::accumulate(counts.begin(), counts.end(), std::uint64_t{0});
  visit.group("decided_by", sum > 0, [&] {
    for (std::size_t i = 0; i < counts.size(); ++i)
      visit(kDeciderNames[i], static_cast<double>(counts[i]) / static_cast<double>(sum));
  });
  visit("triangles_below_mean", known_if(s.triangles_below_mean > 0.0, s.triangles_below_mean));
}

template <class Visit>
void visit_force(const SessionSummary& s, Visit&& visit) {
  visit("max", s.force_max);
  visit("rms", s.force_rms);
  const auto step = [&](const char* key, const ForceStep& largest) {
    visit.group(key, true, [&] {
      const bool has_changes = s.force_steps.level_change_frames > 0;
      visit("level_change", known_if(has_changes, largest.level_change));
      visit("other", largest.other);
    });
  };
  step("step_max", s.force_steps.device);
  step("contact_step_max", s.force_steps.contact);
}

template <class Visit>
void visit_constraint(const ConstraintSummary& s, Visit&& visit) {
  visit("held_back_share", s.held_back_share);
  visit("held_back_frames", s.held_back_frames);
  visit("squeezed_share", s.squeezed_share);
  visit("active_mean", s.active_mean);
  visit("active_max", s.active_max);
  visit("residual_max", s.residual_max);
  visit("wanted_speed_max", s.wanted_speed_max);
  visit("rows_mean", s.rows_mean);
  visit("rows_p50", s.rows_p50);
  visit("rows_max", s.rows_max);
  visit("found_max", s.found_max);
  visit("halvings_max", s.halvings_max);
  visit("halved_models", s.halved_models);
  visit("left_out_max", s.left_out_max);
  visit("left_out_models", s.left_out_models);
  visit("travel_min", s.travel_min);
  visit("near_radius", s.look_ahead_max);
  visit("coarse_max", s.coarse_max);
  visit("row_gap_min", s.row_gap_min);
  visit("solve_us", Quantiles{s.solve, 1e-6, false});
}

/// Calls visit(key, value) for every number of a summary, and visit.group(key, is_known, fill) for
/// every group, which is in a list as null where it is not known; in the order of
/// `thigma run --json`. value: a number, an optional one, Quantiles, or shares.
template <class Visit>
void visit_summary(const SessionSummary& s, Visit&& visit) {
  visit("seconds", s.seconds);
  visit.group("haptic", true, [&] { visit_haptic(s, visit); });
  visit.group("contact", true, [&] { visit_contact(s, visit); });
  visit.group("levels", true, [&] { visit_levels(s, visit); });
  visit.group("force", true, [&] { visit_force(s, visit); });
  visit.group("torque", true, [&] {
    visit("max", s.torque_max);
    visit("rms", s.torque_rms);
  });
  visit("penetration_max", s.penetration_max);
  visit("coupling_stretch_max", s.stretch_max);
  visit("energy_min", s.energy_min);
  visit.group("constraint", s.constraint.is_on, [&] { visit_constraint(s.constraint, visit); });
  visit.group("friction", s.friction.is_on, [&] {
    visit("sticking_share", s.friction.sticking_share);
    visit("slip_work", s.friction.slip_work);
  });
  visit.group("passivity", s.passivity.is_on, [&] {
    visit("delay", s.passivity.delay);
    visit("acted_share", s.passivity.acted_share);
    visit("sent_share", s.passivity.sent_share);
    visit("damping_max", s.passivity.damping_max);
  });
  visit.group("ridden_out", true, [&] {
    visit("gaps", s.ridden_out.gaps);
    visit("longest_gap_ms", 1e3 * s.ridden_out.longest_gap);
    visit("stale_models", s.ridden_out.stale_models);
  });
  visit("dropped_samples", s.dropped_samples);
}

}  // namespace thigma
