// Protocol E13 (docs/sources.md): haptic rates from 500 Hz to 10 kHz. On a virtual clock what they
// do to the loop; on threads where the time goes, beside the empty loop of the same minute; and
// what a cold cache costs.

#include <algorithm>
#include <cmath>
#include <numeric>

#include "experiments/common/all_experiments.h"
#include "experiments/common/session_pair.h"

namespace thigma::experiments {
namespace e13_real_time {
namespace {

constexpr double kRates[] = {500.0, 1000.0, 2000.0, 5000.0, 10000.0};
constexpr int kQuickTriangles = 4000;
constexpr std::size_t kFlushed = std::size_t{64} << 20;  // [bytes]

/// The scene at a rate: contact frames stay a millisecond apart on the virtual clock, or a haptic
/// frame where that is longer.
SessionConfig at_rate(const SessionPair& session, double rate, double seconds) {
  SessionConfig config = session.config;
  config.rate = rate;
  config.duration = seconds;
  config.contact_every = std::max(1, static_cast<int>(std::lround(rate / 1000.0)));
  config.contact_latency = config.contact_every;
  return config;
}

struct Lockstep {
  SessionSummary summary;
  double rms = 0.0;  // of the force sent [N]
};

Lockstep run_virtual(const SessionPair& session, double rate, double seconds, bool is_cold) {
  static std::vector<unsigned char> waste(kFlushed);
  const std::unique_ptr<HapticDevice> hand = open_device("hand:", session.hand);
  SessionConfig config = at_rate(session, rate, seconds);
  const auto flush = [&](const HapticSample& sample) {
    for (std::size_t i = 0; i < waste.size(); i += 64)
      waste[i] = static_cast<unsigned char>(waste[i] + sample.frame);
  };
  SessionSinks sinks;
  if (is_cold) sinks.haptic = flush;
  Lockstep ran;
  ran.summary = run_lockstep(config, *hand, sinks);
  ran.rms = ran.summary.force_rms;
  return ran;
}

SessionSummary run_threads(const SessionPair& session, double rate, double seconds) {
  const std::unique_ptr<HapticDevice> hand = open_device("hand:", session.hand);
  Session running(at_rate(session, rate, seconds), *hand);
  running.start();
  while (running.is_running()) sleep_ns(10'000'000);
  return running.finish();
}

void add_quantiles(std::vector<Cell>& row, const DurationSummary& d) {
  for (const double v : {d.p50, d.p99, d.p999, d.p9999, d.max}) row.emplace_back(v);
}

std::vector<std::string> quantile_columns(const std::string& of) {
  std::vector<std::string> names;
  for (const char* q : {"p50", "p99", "p99.9", "p99.99", "max"})
    names.push_back(of + " " + q + " [s]");
  return names;
}

void add_threaded(const SessionPair& session, double rate, double seconds, Outcome& outcome) {
  const EmptyLoop floor =
      measure_empty_loop(session.config.haptic_thread, rate, seconds, session.config.spin);
  const SessionSummary s = run_threads(session, rate, seconds);
  std::vector<Cell> row = {rate, static_cast<double>(s.frames), static_cast<double>(s.missed),
                           static_cast<double>(floor.missed),
                           static_cast<double>(s.deadlines.overruns)};
  for (const std::uint64_t n : s.deadlines.late) row.emplace_back(static_cast<double>(n));
  row.emplace_back(s.deadlines.polled_share);
  row.emplace_back(floor.polled_share);
  row.emplace_back(s.end == SessionEnd::fault ? 1.0 : 0.0);
  add_quantiles(row, s.wake_late);
  add_quantiles(row, summarize(floor.wake_late));
  add_quantiles(row, s.stages.whole);
  add_quantiles(row, s.stages.compute);
  add_quantiles(row, s.step_cpu);
  add_row(outcome.tables[1], std::move(row));
  plot::Series late{.label = std::to_string(static_cast<int>(rate)) + " Hz"};
  for (const StageHistogram& stage : s.histograms) {
    if (std::string_view(stage.name) != "haptic_wake_late") continue;
    double seen = 0.0;
    for (int i = 0; i < DurationHistogram::kBuckets; ++i) {
      const auto count = static_cast<double>(stage.histogram.counts[static_cast<std::size_t>(i)]);
      if (count == 0.0) continue;
      seen += count;
      late.x.push_back(std::log10(std::max(1.0, bucket_bounds(i).to)) - 3.0);
      late.y.push_back(100.0 * seen / static_cast<double>(stage.histogram.total));
    }
  }
  outcome.figure.panels[1].series.push_back(std::move(late));
}

}  // namespace
}  // namespace e13_real_time

Outcome run_e13_real_time(const Context& context) {
  using namespace e13_real_time;
  const double seconds = context.quick ? 3.0 : 20.0;
  const double threaded = context.quick ? 0.5 : 60.0;
  SessionPair session = session_pair(*context.assets, "simple_cup_spoon", seconds,
                                     context.quick ? kQuickTriangles : 0);
  Outcome outcome;
  outcome.tables = {{.columns = {"rate [Hz]", "rms force [N]", "largest force [N]",
                                 "penetration [m]", "least energy [J]", "fault", "step CPU p50 [s]",
                                 "step CPU p99 [s]", "cold: p50 [s]", "cold: p99 [s]"}},
                    {.name = "threads",
                     .columns = {"rate [Hz]", "frames", "missed", "empty loop: missed", "overruns",
                                 "later than 0.1 ms", "later than 0.2 ms", "later than 1 ms",
                                 "polled share", "empty loop: polled share", "fault"}}};
  for (const char* of : {"late", "empty loop late", "frame", "compute", "step CPU"}) {
    for (const std::string& name : quantile_columns(of)) outcome.tables[1].columns.push_back(name);
  }
  outcome.figure = {.title = "Haptic rates from 500 Hz to 10 kHz (protocol E13)",
                    .note = "on this machine, with whatever else ran on it",
                    .panels = {{.title = "virtual clock",
                                .x = {.label = "log10 rate [Hz]"},
                                .y = {.label = "force [N]"}},
                               {.title = "threads",
                                .x = {.label = "log10 lateness [us]"},
                                .y = {.label = "frames at most so late [%]"}}}};
  plot::Series rms{.label = "rms"}, largest{.label = "largest"};
  double faults = 0.0, least_energy = 0.0, at_1000 = 0.0, low = 1e300, high = 0.0;
  for (const double rate : kRates) {
    tell(context, std::to_string(static_cast<int>(rate)) + " Hz, virtual clock");
    const Lockstep warm = run_virtual(session, rate, seconds, false);
    const Lockstep cold = run_virtual(session, rate, context.quick ? 0.05 : 1.0, true);
    const SessionSummary& s = warm.summary;
    add_row(outcome.tables[0],
            {rate, warm.rms, s.force_max, s.penetration_max, s.energy_min,
             s.end == SessionEnd::fault ? 1.0 : 0.0, s.step_cpu.p50, s.step_cpu.p99,
             cold.summary.step_cpu.p50, cold.summary.step_cpu.p99});
    faults += s.end == SessionEnd::fault ? 1.0 : 0.0;
    least_energy = std::min(least_energy, s.energy_min);
    if (rate == 1000.0) at_1000 = warm.rms;
    low = std::min(low, warm.rms);
    high = std::max(high, warm.rms);
    rms.x.push_back(std::log10(rate));
    rms.y.push_back(warm.rms);
    largest.x.push_back(rms.x.back());
    largest.y.push_back(s.force_max);
  }
  outcome.figure.panels[0].series = {rms, largest};
  const int repeats = context.quick ? 1 : 3;
  for (const double rate : kRates) {
    for (int i = 0; i < repeats; ++i) {
      tell(context, std::to_string(static_cast<int>(rate)) + " Hz, threads");
      add_threaded(session, rate, threaded, outcome);
    }
  }
  outcome.claims = {
      at_most("faults", "sessions at five rates on the virtual clock that end in a fault", faults,
              0.0),
      within("same-force", "rms force at other rates over that at 1 kHz, least and most: spread",
             (high - low) / at_1000, 0.0, 0.1),
      at_least("energy-min", "least energy at the port over the rates", least_energy, -1e-6, "J")};
  for (const double rate : kRates) {
    double missed = 0.0, floor = 0.0;
    for (const auto& row : outcome.tables[1].rows) {
      if (std::get<double>(row[0]) != rate) continue;
      missed = std::max(missed, std::get<double>(row[2]));
      floor = std::max(floor, std::get<double>(row[3]));
    }
    const std::string at = std::to_string(static_cast<int>(rate));
    outcome.claims.push_back(
        stated("missed-" + at, "frames missed on threads at " + at + " Hz, worst run", missed));
    outcome.claims.push_back(
        stated("floor-" + at, "the same of the empty loop just before", floor));
  }
  return outcome;
}

}  // namespace thigma::experiments
