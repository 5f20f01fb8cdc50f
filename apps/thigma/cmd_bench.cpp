// `thigma bench`: every figure beside its baseline, in CPU time, and what the machine itself can
// do.

#include <cstdio>
#include <regex>

#include "benchmarks/bench_rows.h"
#include "benchmarks/probe.h"
#include "json_out.h"
#include "verbs.h"
#include <nlohmann/json.hpp>

namespace thigma::app {
namespace {

using Json = nlohmann::ordered_json;

Json optional_number(const std::optional<double>& value) {
  return value ? Json(*value) : Json(nullptr);
}

Json row_json(const bench::Row& row) {
  Json json;
  json["name"] = row.name;
  json["unit"] = row.unit;
  json["ours"] = {{"p50", row.ours.p50}, {"p99", row.ours.p99}};
  json["baseline"] = nullptr;
  json["ratio"] = nullptr;
  if (row.theirs) {
    json["baseline"] = {{"name", row.baseline}, {"p50", row.theirs->p50}, {"p99", row.theirs->p99}};
    if (row.ours.p50 > 0.0) json["ratio"] = row.theirs->p50 / row.ours.p50;
  }
  json["contacts_ours"] = optional_number(row.contacts_ours);
  json["contacts_baseline"] = optional_number(row.contacts_baseline);
  json["recall_ours"] = optional_number(row.recall_ours);
  json["recall_baseline"] = optional_number(row.recall_baseline);
  json["error_ours"] = optional_number(row.error_ours);
  json["error_baseline"] = optional_number(row.error_baseline);
  json["note"] = row.note;
  return json;
}

void print_row(const bench::Row& row, bool as_json) {
  if (as_json) {
    print_json(row_json(row));
  } else {
    std::printf("%-46s %10.3f %10.3f %-9s", row.name.c_str(), row.ours.p50, row.ours.p99,
                row.unit.c_str());
    if (row.theirs)
      std::printf("  %10.3f %10.3f  %s", row.theirs->p50, row.theirs->p99, row.baseline.c_str());
    std::printf("\n");
  }
  std::fflush(stdout);
}

void print_machine(bool as_json, double seconds) {
  const double adds = bench::dependent_adds();
  const std::vector<double> late = bench::empty_loop_lateness(seconds);
  const double p50 = 1e6 * bench::percentile(late, 0.5), p99 = 1e6 * bench::percentile(late, 0.99);
  const double p999 = 1e6 * bench::percentile(late, 0.999),
               max = 1e6 * bench::percentile(late, 1.0);
  if (as_json) {
    Json json;
    json["name"] = "machine";
    json["dependent_adds_ghz"] = adds;
    json["empty_loop_late_us"] = {{"p50", p50}, {"p99", p99}, {"p999", p999}, {"max", max}};
    print_json(json);
  } else {
    std::printf(
        "machine: %.2f GHz of dependent additions; empty 1 kHz loop late by p50 %.1f, p99 %.1f, "
        "p99.9 %.1f, max %.1f us\n",
        adds, p50, p99, p999, max);
    std::printf("%-46s %10s %10s %-9s  %10s %10s  %s\n", "", "p50", "p99", "unit", "p50", "p99",
                "baseline");
  }
  std::fflush(stdout);
}

int run_bench(const std::string& filter, bool quick, const Common& common) {
  std::regex pattern;
  try {
    pattern = std::regex(filter);
  } catch (const std::regex_error&) {
    std::fprintf(stderr, "thigma: --filter: '%s' is not a regular expression\n", filter.c_str());
    return kUsage;
  }
  std::vector<bench::Measurement> wanted = bench::measurements(quick);
  std::erase_if(wanted,
                [&](const bench::Measurement& m) { return !std::regex_search(m.name, pattern); });
  if (!wanted.empty()) print_machine(common.json, quick ? 0.2 : 2.0);
  for (const bench::Measurement& measurement : wanted) {
    if (!common.quiet) std::fprintf(stderr, "measuring %s\n", measurement.name.c_str());
    for (const bench::Row& row : measurement.run()) print_row(row, common.json);
  }
  if (!wanted.empty()) return kDone;
  std::fprintf(stderr, "thigma: --filter: nothing matches '%s'; there are", filter.c_str());
  for (const bench::Measurement& measurement : bench::measurements(quick)) {
    std::fprintf(stderr, " %s", measurement.name.c_str());
  }
  std::fprintf(stderr, "\n");
  return kUsage;
}

}  // namespace

void add_bench(CLI::App& app, Common& common) {
  static std::string filter = ".";
  static bool quick = false;
  CLI::App* verb =
      add_verb(app, common, "bench", "measure, in CPU time, each figure beside its baseline",
               [&common] { return run_bench(filter, quick, common); });
  verb->add_option("--filter", filter, "regular expression on the names of the measurements");
  verb->add_flag("--quick", quick, "few frames: to see that it works, not to quote");
}

}  // namespace thigma::app
