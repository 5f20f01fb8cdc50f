// `thigma bench`: every figure beside its baseline, in CPU time, and what the machine itself can
// do.

#include <cstdio>
#include <regex>

#include "benchmarks/bench_rows.h"
#include "benchmarks/probe.h"
#include "benchmarks/proxy_bench.h"
#include "json_out.h"
#include "verbs.h"
#include <nlohmann/json.hpp>

#include "thigma/math/quantile.h"

namespace thigma::app {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kEverything = ".";

Json optional_number(const std::optional<double>& value) {
  return value ? Json(*value) : Json(nullptr);
}

// Figures here are scaled to this rate of dependent additions, for comparison with those taken at
// it.
constexpr double kReferenceGhz = 3.56;

Json figure_json(const bench::Figure& figure, double factor = 1.0) {
  auto scaled = [&](const std::optional<double>& v) {
    return v ? Json(*v * factor) : Json(nullptr);
  };
  return {{"p50", figure.p50 * factor},
          {"p99", figure.p99 * factor},
          {"p999", scaled(figure.p999)},
          {"max", scaled(figure.max)}};
}

void add_quality(Json& json, const bench::Quality& found, const std::string& whose) {
  json["recall_" + whose] = optional_number(found.recall);
  json["error_" + whose] = optional_number(found.error_max);
  json["error_mean_" + whose] = optional_number(found.error_mean);
  json["depth_error_" + whose] = optional_number(found.depth_error);
  json["regions_" + whose] = optional_number(found.regions);
  json["force_error_" + whose] = optional_number(found.force_error);
  json["entered_" + whose] = optional_number(found.entered);
}

// ghz: of dependent additions while the row was measured.
Json row_json(const bench::Row& row, const std::string& measurement, double ghz) {
  const double factor = ghz / kReferenceGhz;
  Json json;
  json["name"] = row.name;
  json["measurement"] = measurement;
  json["unit"] = row.unit;
  json["ours"] = figure_json(row.ours);
  json["baseline"] = nullptr;
  json["ratio"] = nullptr;
  json["dependent_adds_ghz"] = ghz;
  json["ours_at_3_56_ghz"] = figure_json(row.ours, factor);
  json["baseline_at_3_56_ghz"] = nullptr;
  if (row.theirs) {
    json["baseline"] = {{"name", row.baseline}};
    json["baseline"].update(figure_json(*row.theirs));
    json["baseline_at_3_56_ghz"] = figure_json(*row.theirs, factor);
    if (row.ours.p50 > 0.0) json["ratio"] = row.theirs->p50 / row.ours.p50;
  }
  json["contacts_ours"] = optional_number(row.contacts_ours);
  json["contacts_baseline"] = optional_number(row.contacts_baseline);
  add_quality(json, row.found_ours, "ours");
  add_quality(json, row.found_baseline, "baseline");
  json["front"] = optional_number(row.front);
  json["front_exact"] = optional_number(row.front_exact);
  json["speedup_over_exact"] = optional_number(row.speedup);
  json["note"] = row.note;
  return json;
}

std::string share(const std::optional<double>& value) {
  if (!value) return "-";
  char text[32];
  std::snprintf(text, sizeof text, "%.4f", *value);
  return text;
}

void print_row(const bench::Row& row, const std::string& measurement, double ghz, bool as_json) {
  if (as_json) {
    print_json(row_json(row, measurement, ghz));
  } else {
    std::printf("%-46s %10.3f %10.3f %10.3f %-9s", row.name.c_str(), row.ours.p50, row.ours.p99,
                row.ours.p50 * ghz / kReferenceGhz, row.unit.c_str());
    if (row.theirs)
      std::printf("  %10.3f %10.3f  %s", row.theirs->p50, row.theirs->p99, row.baseline.c_str());
    std::printf("\n");
    if (row.found_ours.recall) {
      std::printf("    recall %s, error %s of the radius; baseline %s, %s\n",
                  share(row.found_ours.recall).c_str(), share(row.found_ours.error_max).c_str(),
                  share(row.found_baseline.recall).c_str(),
                  share(row.found_baseline.error_max).c_str());
    }
  }
  std::fflush(stdout);
}

void print_machine(bool as_json, double seconds) {
  const double adds = bench::dependent_adds();
  const std::vector<double> late = bench::empty_loop_lateness(seconds);
  const double p50 = 1e6 * sample_quantile(late, 0.5), p99 = 1e6 * sample_quantile(late, 0.99);
  const double p999 = 1e6 * sample_quantile(late, 0.999), max = 1e6 * sample_quantile(late, 1.0);
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
    std::printf("%-46s %10s %10s %10s %-9s  %10s %10s  %s\n", "", "p50", "p99", "at 3.56", "unit",
                "p50", "p99", "baseline");
  }
  std::fflush(stdout);
}

/// What the command line asks for.
struct Asked {
  std::string filter = kEverything;
  std::vector<std::string> scenes;
  bool quick = false, full = false;
};

/// Those whose names match.
std::vector<bench::Measurement> choose(const Asked& asked, const std::regex& pattern, bool quiet) {
  std::vector<bench::Measurement> wanted = bench::measurements(asked.quick);
  std::erase_if(wanted,
                [&](const bench::Measurement& m) { return !std::regex_search(m.name, pattern); });
  // What takes many minutes runs when it is asked for.
  if (asked.full || asked.filter != kEverything) return wanted;
  std::erase_if(wanted, [&](const bench::Measurement& m) {
    if (m.is_heavy && !quiet)
      std::fprintf(stderr, "left out, takes long: %s (--full, or --filter)\n", m.name.c_str());
    return m.is_heavy;
  });
  return wanted;
}

int run_bench(const Asked& asked, const Common& common) {
  const std::string& filter = asked.filter;
  const bool quick = asked.quick;
  std::regex pattern;
  try {
    pattern = std::regex(filter);
  } catch (const std::regex_error&) {
    std::fprintf(stderr, "thigma: --filter: '%s' is not a regular expression\n", filter.c_str());
    return kUsage;
  }
  std::vector<bench::Measurement> wanted;
  if (asked.scenes.empty()) wanted = choose(asked, pattern, common.quiet);
  for (const std::string& scene : asked.scenes)
    wanted.push_back(bench::proxy_measurement(scene, quick));
  if (!wanted.empty()) print_machine(common.json, quick ? 0.2 : 2.0);
  for (const bench::Measurement& measurement : wanted) {
    if (!common.quiet) std::fprintf(stderr, "measuring %s\n", measurement.name.c_str());
    double ghz = bench::dependent_adds();
    const std::vector<bench::Row> rows = measurement.run();
    ghz = 0.5 * (ghz + bench::dependent_adds());
    for (const bench::Row& row : rows) print_row(row, measurement.name, ghz, common.json);
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
  static Asked asked;
  CLI::App* verb =
      add_verb(app, common, "bench", "measure, in CPU time, each figure beside its baseline",
               [&common] { return run_bench(asked, common); });
  CLI::Option* filter = verb->add_option("--filter", asked.filter,
                                         "regular expression on the names of the measurements");
  verb->add_flag("--quick", asked.quick, "few frames: to see that it works, not to quote");
  CLI::Option* full = verb->add_flag(
      "--full", asked.full, "also what takes many minutes: pairs of a million triangles each");
  verb->add_option(
          "--scene", asked.scenes,
          "instead: contact queries of a constrained session of this scene in the simulated "
          "hand, a contact frame a millisecond, beside a point shell; once a scene")
      ->allow_extra_args(false)
      ->excludes(filter)
      ->excludes(full);
}

}  // namespace thigma::app
