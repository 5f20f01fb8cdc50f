#include "benchmarks/clod_build_bench.h"

#include <fstream>

#include "thigma/clod/build_clod.h"
#include "thigma/clod/clod_file.h"
#include "thigma/core/cpu_clock.h"
#include "thigma/models/make_model.h"

namespace thigma::bench {
namespace {

// A line "NAME:  N kB" of Linux's account of this process; 0 where there is none.
std::int64_t status_bytes(const std::string& name) {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.rfind(name + ":", 0) == 0) return 1024 * std::stoll(line.substr(name.size() + 1));
  }
  return 0;
}

// Makes the peak of resident memory the present amount.
void reset_peak() {
  std::ofstream clear("/proc/self/clear_refs");
  clear << "5";
}

}  // namespace

ClodHierarchy build_measured(const TriangleMesh& mesh, ClodBuildCost& cost) {
  ClodParams params;
  params.threads = cost.threads;
  reset_peak();
  const std::int64_t before = status_bytes("VmRSS");
  const double cpu = process_cpu_seconds(), wall = clock_seconds(CLOCK_MONOTONIC);
  ClodReport report;
  ClodAsset asset = build_clod_asset(mesh, params, &report);
  cost.cpu = process_cpu_seconds() - cpu;
  cost.wall = clock_seconds(CLOCK_MONOTONIC) - wall;
  cost.peak_bytes = before > 0 ? status_bytes("VmHWM") - before : 0;
  cost.serial = report.decompose_seconds;
  cost.triangles = static_cast<std::int64_t>(mesh.triangles.size());
  cost.patches = static_cast<std::int64_t>(asset.hierarchy.patches.size());
  cost.file_bytes = static_cast<std::int64_t>(format_clod(asset).size());
  return std::move(asset.hierarchy);
}

Row build_row(const std::string& model, const ClodBuildCost& cost) {
  Row row;
  row.name = "levels of detail of " + model + ", " + std::to_string(cost.triangles) + " triangles";
  row.unit = "s";
  row.ours = {cost.cpu, cost.cpu, std::nullopt, std::nullopt};
  const double per_triangle = 1.0 / static_cast<double>(cost.triangles);
  row.note =
      "CPU time of " + std::to_string(cost.threads) + " threads; " + number("%.2f", cost.wall) +
      " s by the clock; decomposition, " + number("%.2f", cost.serial) + " s, on one; " +
      std::to_string(cost.patches) + " patches; peak memory " +
      (cost.peak_bytes > 0 ? number("%.0f", static_cast<double>(cost.peak_bytes) * per_triangle) +
                                 " bytes a triangle"
                           : std::string("not known here")) +
      "; file " + number("%.1f", static_cast<double>(cost.file_bytes) / 1048576.0) + " MiB";
  return row;
}

std::vector<Row> clod_build_rows(bool quick) {
  const std::vector<models::ModelRequest> models = {
      {.name = "jaw_lower", .triangles = quick ? 2000 : 100'000},
      {.name = "cup", .triangles = quick ? 2000 : 100'000},
      {.name = "gear", .triangles = quick ? 2000 : 100'000},
      {.name = "joint_socket", .triangles = quick ? 2000 : 0},
      {.name = "golf_club", .triangles = quick ? 2000 : 0},
      {.name = "golf_ball", .triangles = quick ? 2000 : 0}};
  std::vector<Row> rows;
  for (const models::ModelRequest& model : models) {
    ClodBuildCost cost;
    build_measured(models::make_model(model), cost);
    rows.push_back(build_row(model.name, cost));
  }
  return rows;
}

}  // namespace thigma::bench
