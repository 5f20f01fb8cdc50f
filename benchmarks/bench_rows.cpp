#include "benchmarks/bench_rows.h"

#include <cstdio>

#include "benchmarks/baselines/fcl_baseline.h"
#include "benchmarks/clod_build_bench.h"
#include "benchmarks/drop_bench.h"
#include "benchmarks/growth_bench.h"
#include "benchmarks/haptic_bench.h"
#include "benchmarks/level_rows.h"
#include "benchmarks/pair_bench.h"
#include "benchmarks/probe.h"
#include "benchmarks/proxy_bench.h"
#include "benchmarks/query_bench.h"
#include "benchmarks/row_solve_bench.h"
#include "benchmarks/texture_rows.h"
#include "benchmarks/world_bench.h"

#include "thigma/clod/build_hierarchy.h"
#include "thigma/math/quantile.h"
#include "thigma/models/make_model.h"

namespace thigma::bench {
namespace {

std::vector<Row> haptic_rows(bool quick) {
  const HapticTiming timing = time_haptic_step(5, quick ? 1600 : 160000);
  Row row;
  row.name = "haptic step, coupling and 5 clusters";
  row.unit = "us";
  row.ours = figure_of(timing.step, 1e6);
  row.baseline = "coupling, planes and the 13 x 13 solve alone";
  row.theirs = figure_of(timing.dense, 1e6);
  row.note =
      "block means of 16 ticks; ours is the whole tick with device, limits, observer, telemetry "
      "sample";
  return {row};
}

std::vector<Row> solve_rows_of(bool quick) {
  const RowSolveTiming timing = time_row_solve(8, quick ? 600 : 20000);
  Row solve;
  solve.name = "row solve, 64 rows that press, friction 0.3";
  solve.unit = "us";
  solve.ours = figure_of(timing.solve, 1e6);
  solve.baseline = "reading the clock of the thread";
  solve.theirs = figure_of(timing.clock, 1e6);
  solve.note = number("%.0f rows pressed at the beginning of a solve, ", timing.rows_pressed) +
               number("%.0f %% slid at its end; ", 100.0 * timing.sliding_share) +
               number("residual at most %.2g m/s", timing.residual_max);
  Row step = solve;
  step.name = "haptic step around it";
  step.ours = figure_of(timing.step, 1e6);
  const HapticTiming penalty = time_haptic_step(5, quick ? 1600 : 160000);
  step.baseline = "haptic step, coupling and 5 clusters of the penalty, block means of 16 ticks";
  step.theirs = figure_of(penalty.step, 1e6);
  return {solve, step};
}

std::vector<Row> pair_rows(bool quick) {
  PairTimingParams params;
  if (quick) params = {.pairs = 64, .frames = 8, .repetitions = 2};
  const std::vector<ConvexBaseline> baseline = time_convex_baseline(params);
  std::vector<Row> rows;
  for (const PairTiming& timing : time_pairs(params)) {
    Row row;
    row.name = "convex pair " + timing.name + ", " + std::to_string(timing.vertices_low) + "-" +
               std::to_string(timing.vertices_high) + " vertices";
    row.unit = "ns";
    row.ours = {timing.median, timing.p99};
    for (const ConvexBaseline& other : baseline) {
      if (other.vertices_low != timing.vertices_low || other.vertices_high != timing.vertices_high)
        continue;
      if (timing.name != "single" && timing.name != "batched") continue;
      row.baseline = "FCL 0.7 convex distance";
      row.theirs = Figure{other.median, other.p99};
      row.note = "largest difference of the two distances: " + std::to_string(other.disagreement) +
                 " of the hull size";
    }
    rows.push_back(row);
  }
  return rows;
}

// Of the radius a frame: 18 mm/s for jaws of 36 mm and a contact step every millisecond.
constexpr double kFrontStep = 0.0005;

Row front_row(const char* name, double nodes, int frames) {
  const QueryTiming timing = measure_jaws_query(frames, 0.01, kFrontStep, nodes);
  Row row;
  row.name = name;
  row.unit = "ns a node";
  row.ours = {timing.ns_per_node, timing.ns_per_node};
  row.baseline = "the same query from the root, per node of its front";
  row.theirs = Figure{1e3 * timing.cold_us / timing.front, 1e3 * timing.cold_us / timing.front};
  row.contacts_ours = timing.contacts;
  row.contacts_baseline = timing.contacts;
  row.note = "traversal alone, moving 0.05 % of the radius a frame; mean front " +
             std::to_string(static_cast<long long>(timing.front)) + " nodes";
  return row;
}

std::vector<Row> query_rows(bool quick) {
  const JawsComparison both = compare_jaws_query(quick ? 20 : 1000, quick ? 2 : 40, 0.01, 0.002);
  Row row;
  row.name = "exact query, jaws, d = 1 % of the radius";
  row.unit = "us";
  row.ours = both.ours.us;
  row.contacts_ours = both.ours.contacts;
  row.found_ours.recall = both.recall_ours;
  row.found_ours.error_max = both.error_ours;
  if (both.has_baseline) {
    row.baseline = "FCL 0.7 distance (one closest pair)";
    row.theirs = both.baseline_us;
    row.contacts_baseline = 1.0;
    row.found_baseline.recall = both.recall_baseline;
    row.found_baseline.error_max = both.error_baseline;
  }
  row.note =
      "the upper jaw comes down, then grinds pressed in by up to 0.5 % of the radius; ours finds "
      "every region, the "
      "baseline one point; recall and error against an independent search on some of the frames";
  return {row};
}

std::vector<Row> build_rows(bool quick) {
  const TriangleMesh mesh =
      models::make_model({.name = "jaw_lower", .triangles = quick ? 10000 : 100000});
  std::vector<double> seconds;
  for (int i = 0; i < (quick ? 1 : 3); ++i) {
    const double start = thread_cpu();
    build_exact_hierarchy(mesh);
    seconds.push_back(thread_cpu() - start);
  }
  Row row;
  row.name = "decomposition and hierarchy, " + std::to_string(mesh.triangles.size()) + " triangles";
  row.unit = "s";
  row.ours = {sample_quantile(seconds, 0.5), sample_quantile(seconds, 0.99)};
  if (has_fcl()) {
    const double start = thread_cpu();
    make_fcl_pair(mesh, mesh);
    const double spent = 0.5 * (thread_cpu() - start);  // of two trees
    row.baseline = "FCL 0.7 OBBRSS tree (no convex patches)";
    row.theirs = Figure{spent, spent};
  }
  return {row};
}

}  // namespace

std::string number(const char* format, double value) {
  char text[64];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

std::vector<Measurement> measurements(bool quick) {
  std::vector<Measurement> all = {
      {"haptic-step", [=] { return haptic_rows(quick); }},
      {"row-solve", [=] { return solve_rows_of(quick); }},
      {"convex-pair", [=] { return pair_rows(quick); }},
      {"build", [=] { return build_rows(quick); }},
      {"front-small",
       [=] {
         return std::vector<Row>{front_row("front tracking, small front", 1250, quick ? 20 : 400)};
       }},
      {"front-large",
       [=] {
         return std::vector<Row>{front_row("front tracking, large front", 30000, quick ? 10 : 200)};
       }},
      {"exact-query", [=] { return query_rows(quick); }},
      {"texture-depth", [=] { return texture_rows(quick); }},
      {"texture-memory", [=] { return texture_memory_rows(quick); }},
      {"texture-gpu", [=] { return gpu_texture_rows(quick); }},
      {"spoon-drop", [=] { return drop_rows(quick); }},
      {"worlds", [=] { return world_rows(quick); }},
      {"growth", [=] { return growth_rows(quick); }, true},
      {"build-levels", [=] { return clod_build_rows(quick); }},
  };
  const std::vector<Measurement> with_levels = level_measurements(quick);
  all.insert(all.end(), with_levels.begin(), with_levels.end());
  const std::vector<Measurement> of_proxies = proxy_measurements(quick);
  all.insert(all.end(), of_proxies.begin(), of_proxies.end());
  return all;
}

}  // namespace thigma::bench
