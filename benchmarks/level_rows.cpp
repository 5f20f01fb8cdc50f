#include "benchmarks/level_rows.h"

#include <algorithm>
#include <optional>
#include <string>

#include "benchmarks/bench_pair.h"
#include "benchmarks/clod_build_bench.h"
#include "benchmarks/measure_pair.h"
#include "benchmarks/query_way.h"

#include "thigma/contact/resolution.h"

namespace thigma::bench {
namespace {

struct LevelCase {
  PairRequest request;
  int frames = 1000;
  bool is_heavy = false;
  bool has_exact = true;  // false: exact queries of this pair take far too long
};

/// A row of the table and the way that it measures, in words that scripts/results has too. One D a
/// patch at the s0 whose force on the jaws is as near as by default.
struct Way {
  const char* name;
  const char* words;  // of query_way
};
constexpr Way kWays[] = {
    {"levels s0 = 2.5 %, no cap", "levels"},
    {"levels s0 = 2.5 %, cap 2 %", "levels,cap=0.02"},
    {"levels s0 = 5 %, one D a patch", "levels,s0=0.05,d=patch"},
    {"levels s0 = 5 %, one D a patch, carried", "levels,s0=0.05,d=patch,carry=0.1"},
};
constexpr Way kOnBudget[] = {
    {"levels s0 = 2.5 %, no cap, budget 500 us", "levels"},
    {"levels s0 = 2.5 %, cap 2 %, budget 500 us", "levels,cap=0.02"},
};

Row level_row(const BenchPair& pair, const LevelTiming& ours,
              const std::optional<LevelTiming>& exact) {
  Row row;
  row.name = pair.request.name + ", " + ours.method.name;
  row.unit = "us";
  row.ours = ours.method.us;
  row.contacts_ours = ours.method.contacts;
  row.found_ours = ours.method.quality;
  row.front = ours.front;
  if (exact) {
    row.front_exact = exact->front;
    row.speedup = exact->method.us.p50 / ours.method.us.p50;
  }
  row.note = "medians apart " + number("%.0f", ours.apart_us) + " us, meeting " +
             number("%.0f", ours.meeting_us) + " us; first query, from the root, " +
             number("%.0f", ours.cold_us) + " us; " + number("%.0f", ours.tests) +
             " pairs looked at a query";
  if (ours.dropped > 0)
    row.note += "; " + std::to_string(ours.dropped) + " contacts beyond the room";
  if (ours.unrefined > 0)
    row.note += "; " + std::to_string(ours.unrefined) + " contacts left coarser for want of budget";
  return row;
}

Row against(Row row, const MethodTiming& baseline) {
  row.baseline = baseline.name;
  row.theirs = baseline.us;
  row.contacts_baseline = baseline.contacts;
  row.found_baseline = baseline.quality;
  row.note += "; baseline on " + std::to_string(baseline.poses) + " poses";
  if (!baseline.note.empty()) row.note += ", " + baseline.note;
  return row;
}

// Where recall and errors are taken: evenly, off the knots of the path.
std::vector<std::size_t> checked_poses(const LevelCase& c, bool quick) {
  if (!c.has_exact) return {};
  const int count = quick ? 2 : c.is_heavy ? 4 : 12;
  std::vector<std::size_t> checked;
  for (int i = 0; i < count; ++i)
    checked.push_back(static_cast<std::size_t>((2 * i + 1) * c.frames / (2 * count)));
  return checked;
}

std::string shell_note(const BenchPair& pair) {
  const double bytes =
      static_cast<double>(shell_bytes(pair.object_shell) + shell_bytes(pair.scene_shell));
  return "both shells " + number("%.0f", bytes / 1048576.0) + " MiB, built in " +
         number("%.1f", pair.shell_seconds) + " s";
}

std::vector<Row> measure_case(LevelCase c, bool quick) {
  if (quick) {
    c.request.object_triangles = c.request.scene_triangles = 3000;
    c.frames = 40;
  }
  const BenchPair pair = make_pair(c.request);
  const std::vector<Pose> path = make_path(pair, c.frames);
  const std::vector<std::size_t> checked = checked_poses(c, quick);
  std::vector<Truth> truths;
  for (const std::size_t i : checked) truths.push_back(find_truth(pair, path[i]));
  std::vector<LevelTiming> ours;
  auto measure = [&](const std::string& name, const Resolution& resolution, int runs) {
    ours.push_back(measure_levels(pair, path, resolution, runs, checked, truths));
    ours.back().method.name = name;
  };
  for (const Way& way : kWays) measure(way.name, query_way(way.words), 3);
  if (c.is_heavy) {
    for (const Way& way : kOnBudget) {
      Resolution resolution = query_way(way.words);
      resolution.budget_cpu = 500e-6;
      measure(way.name, resolution, 3);
    }
  }
  std::optional<LevelTiming> exact;
  if (c.has_exact) {
    measure("exact on the same asset", Resolution{}, c.is_heavy ? 1 : 2);
    exact = ours.back();
  }
  MethodTiming shell = measure_shell(pair, path, checked, truths);
  shell.note = shell_note(pair);
  std::vector<Row> rows;
  for (const LevelTiming& timing : ours)
    rows.push_back(against(level_row(pair, timing, exact), shell));
  if (c.is_heavy) {
    rows.push_back(build_row(pair.request.name + ", object", pair.object_cost));
    rows.push_back(build_row(pair.request.name + ", scene", pair.scene_cost));
    return rows;
  }
  const double seconds = quick ? 0.2 : 4.0;
  const Row levels_row = level_row(pair, ours.front(), exact);
  const auto bullet = measure_bullet(pair, path, seconds, checked, truths);
  const auto fcl = measure_fcl(pair, path, seconds, checked, truths);
  if (bullet) rows.push_back(against(levels_row, *bullet));
  if (fcl) rows.push_back(against(levels_row, *fcl));
  if (!bullet) rows.front().note += "; no row for Bullet: built without libbullet-dev";
  if (!fcl) rows.front().note += "; no row for FCL: built without libfcl-dev";
  return rows;
}

std::vector<LevelCase> level_cases() {
  std::vector<LevelCase> cases;
  for (const PairRequest& request : level_pairs()) cases.push_back({.request = request});
  // 0.1 mm apart on average, over 100 mm radius, moving by half of that.
  cases.push_back(
      {.request = {.name = "conforming-1m",
                   .scene = "conforming",
                   .object_triangles = 1'000'000,
                   .scene_triangles = 1'000'000,
                   .path = {.turn = 1e-4, .slide = 5e-4, .swing = 5e-4, .is_solved = false}},
       .frames = 10'000,
       .is_heavy = true,
       .has_exact = false});
  cases.push_back({.request = {.name = "jaws-1m",
                               .scene = "jaws",
                               .object_triangles = 1'000'000,
                               .scene_triangles = 1'000'000,
                               .path = {.turn = 0.004, .slide = 0.005}},
                   .frames = 10'000,
                   .is_heavy = true});
  return cases;
}

}  // namespace

std::vector<Measurement> level_measurements(bool quick) {
  std::vector<Measurement> out;
  for (const LevelCase& c : level_cases()) {
    out.push_back({"levels-" + c.request.name, [=] { return measure_case(c, quick); }, c.is_heavy});
  }
  return out;
}

}  // namespace thigma::bench
