// `thigma experiment`: the figures and tables of the text, run again, with what they claim.

#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "experiments/common/claim_list.h"
#include "experiments/common/experiment.h"
#include "json_out.h"
#include "verbs.h"
#include <nlohmann/json.hpp>

#include "thigma/models/make_model.h"
#include "thigma/scene/asset_cache.h"

namespace thigma::app {
namespace {

using experiments::Claim;
using experiments::Experiment;

struct ExperimentOptions {
  std::string name, folder;
  bool quick = false;
};

int list_experiments(bool as_json) {
  for (const Experiment& e : experiments::all_experiments()) {
    if (as_json) {
      print_json({{"name", e.name}, {"source", e.source}, {"text", e.text}});
    } else {
      std::printf("%-20s %-18s %s\n", e.name, e.source, e.text);
    }
  }
  return kDone;
}

/// Those a name means; empty for an unknown one.
std::vector<Experiment> choose(const std::string& name) {
  if (name == "all") return experiments::all_experiments();
  for (const Experiment& e : experiments::all_experiments()) {
    if (name == e.name) return {e};
  }
  return {};
}

std::string known_names(const std::string& name) {
  std::vector<std::string> names = {"list", "all", "claims"};
  for (const Experiment& e : experiments::all_experiments()) names.push_back(e.name);
  const std::string near = models::nearest_word(name, names);
  return near.empty() ? "`thigma experiment list` names them" : "nearest is '" + near + "'";
}

void print_bounds(const std::optional<double>& low, const std::optional<double>& bound) {
  if (low && bound) std::printf("%.4g to %.4g", *low, *bound);
  if (!low && bound) std::printf("%.4g", *bound);
}

void print_claim(const Claim& claim) {
  std::printf("  %-16s %-20s", claim.id.c_str(), verdict(claim));
  if (claim.value) std::printf(" %.4g %s", *claim.value, claim.unit.c_str());
  if (claim.bound) {
    std::printf(" (");
    print_bounds(claim.bound_low, claim.bound);
    if (claim.floor) {
      std::printf("; not beyond ");
      print_bounds(claim.floor_low, claim.floor);
    }
    std::printf(")");
  }
  std::printf("  %s\n", claim.text.c_str());
  if (!claim.reason.empty())
    std::printf("  %-16s because %s [%s]\n", "", claim.reason.c_str(), claim.sweep.c_str());
}

void print_claims(const Experiment& experiment, const std::vector<Claim>& claims) {
  std::printf("%s (%s)\n", experiment.name, experiment.source);
  for (const Claim& claim : claims) print_claim(claim);
  std::printf("  %s\n", counts_text(count_claims(claims)).c_str());
  std::fflush(stdout);
}

/// Runs one and says what it claims. What is wrong with the claims themselves counts as broken.
experiments::ClaimCounts run_one(const Experiment& experiment, const experiments::Context& context,
                                 const ExperimentOptions& options, const Common& common) {
  if (!common.quiet) std::fprintf(stderr, "%s: %s\n", experiment.name, experiment.text);
  const experiments::Outcome outcome = run_experiment(experiment, context, options.folder);
  if (common.json) {
    print_json(nlohmann::ordered_json::parse(claims_json(experiment, outcome.claims)));
  } else {
    print_claims(experiment, outcome.claims);
  }
  experiments::ClaimCounts counts = count_claims(outcome.claims);
  for (const std::string& fault : faults(outcome.claims, outcome.tables)) {
    print_error(std::string(experiment.name) + ": " + fault);
    ++counts.broken;
  }
  return counts;
}

/// Levels from the cache of `run`. Nobody is told what is kept where: experiments tell what they
/// do.
ClodHierarchy kept_levels(const std::string& uri) {
  ClodSource source;
  source.name = uri;
  source.role = "experiment";
  source.params.threads = 2;
  return load_clod_cached(source).hierarchy;
}

int run_experiments(const ExperimentOptions& options, const Common& common) {
  if (options.name == "list") return list_experiments(common.json);
  const std::vector<Experiment> chosen = choose(options.name);
  if (chosen.empty() && options.name != "claims") {
    print_error("experiment: no experiment '" + options.name + "', " + known_names(options.name));
    return kUsage;
  }
  if (options.folder.empty()) {
    print_error("experiment: -o DIR is missing: the folder to write to");
    return kUsage;
  }
  if (options.name == "claims") {
    std::fputs(experiments::claim_list(options.folder, experiments::all_experiments()).c_str(),
               stdout);
    return kDone;
  }
  experiments::Assets assets{.kept = kept_levels};
  experiments::Context context{.quick = options.quick, .seed = common.seed, .assets = &assets};
  if (!common.quiet) {
    context.tell = [](const std::string& line) { std::fprintf(stderr, "  %s\n", line.c_str()); };
  }
  experiments::ClaimCounts all;
  for (const Experiment& experiment : chosen)
    all = all + run_one(experiment, context, options, common);
  if (chosen.size() > 1 && !common.json)
    std::printf("%zu experiments, %s\n", chosen.size(), counts_text(all).c_str());
  return all.broken > 0 ? kClaimFails : kDone;
}

}  // namespace

void add_experiment(CLI::App& app, Common& common) {
  const auto options = std::make_shared<ExperimentOptions>();
  CLI::App* verb = add_verb(app, common, "experiment",
                            "run figures and tables of the text again and check their claims",
                            [&common, options] { return run_experiments(*options, common); });
  verb->add_option("NAME", options->name,
                   "`list`, `all`, one of the list, or `claims`: a page of all claims in DIR")
      ->required();
  verb->add_flag("--quick", options->quick, "fewer frames, smaller models");
  verb->add_option("-o,--output", options->folder,
                   "folder for DIR/NAME/{data.csv, NAME.png, claims.json}");
}

}  // namespace thigma::app
