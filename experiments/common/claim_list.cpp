#include "experiments/common/claim_list.h"

#include <cstdio>

#include <nlohmann/json.hpp>

#include "thigma/core/error.h"
#include "thigma/files/file.h"

namespace thigma::experiments {
namespace {

using Json = nlohmann::ordered_json;

/// Counts and rows, as they grow.
struct Page {
  ClaimCounts all;
  std::string counts, known, others, missing;
};

std::string number_text(const Json& value) {
  if (!value.is_number()) return "none";
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value.get<double>());
  return text;
}

/// "0.5", "1 to 10", or nothing for a claim without a bound.
std::string bounds_text(const Json& claim, const char* low, const char* high) {
  if (!claim.contains(high) || claim[high].is_null()) return "";
  const std::string top = number_text(claim[high]);
  return claim.contains(low) ? number_text(claim[low]) + " to " + top : top;
}

/// A text as a cell: a bar would end it.
std::string cell(const std::string& text) {
  std::string escaped;
  for (const char c : text) escaped += c == '|' ? std::string("\\|") : std::string(1, c);
  return escaped;
}

std::string row_of(const std::vector<std::string>& cells) {
  std::string row = "|";
  for (const std::string& c : cells) row += " " + cell(c) + " |";
  return row + "\n";
}

void add_claim(const std::string& name, const Json& claim, Page& page) {
  const std::string unit = claim.at("unit"), kind = claim.at("kind");
  const std::string value = number_text(claim.at("value")) + (unit.empty() ? "" : " " + unit);
  const std::string bound = bounds_text(claim, "bound_low", "bound");
  const bool is_broken = claim.at("expected") && !claim.at("holds");
  const std::string verdict = is_broken ? kind + ", BROKEN" : kind;
  if (kind == "not reproduced")
    page.known +=
        row_of({name, claim.at("id"), value, bound, bounds_text(claim, "floor_low", "floor"),
                claim.at("sweep"), claim.at("reason")});
  else
    page.others += row_of({name, claim.at("id"), verdict, value, bound, claim.at("text")});
}

void add_experiment(const std::string& name, const std::string& file, Page& page) {
  try {
    const Json json = Json::parse(read_file(file));
    const Json& c = json.at("counts");
    const ClaimCounts counts{.checked = c.at("checked"),
                             .stated = c.at("stated"),
                             .not_reproduced = c.at("not_reproduced"),
                             .broken = c.at("broken")};
    page.all = page.all + counts;
    page.counts += row_of({name, std::to_string(counts.checked), std::to_string(counts.stated),
                           std::to_string(counts.not_reproduced), std::to_string(counts.broken)});
    for (const Json& claim : json.at("claims")) add_claim(name, claim, page);
  } catch (const Json::exception& e) {
    throw InputError(file + ": " + e.what() + ", expected the claims of an experiment");
  }
}

}  // namespace

std::string claim_list(const std::filesystem::path& folder,
                       const std::vector<Experiment>& experiments) {
  Page page;
  for (const Experiment& experiment : experiments) {
    const std::filesystem::path file = folder / experiment.name / "claims.json";
    if (std::filesystem::exists(file))
      add_experiment(experiment.name, file.string(), page);
    else
      page.missing += std::string(page.missing.empty() ? "" : ", ") + experiment.name;
  }
  std::string text = "# Claims\n\n" + counts_text(page.all) + ".";
  if (!page.missing.empty()) text += " Not run: " + page.missing + ".";
  text +=
      "\n\n| experiment | checked | stated | not reproduced | broken |\n|---|---|---|---|---|\n";
  text += page.counts + "\n## Not reproduced\n\n";
  text += "| experiment | claim | value | bound | floor | sweep | reason |\n";
  text += "|---|---|---|---|---|---|---|\n" + page.known + "\n## Checked and stated\n\n";
  text += "| experiment | claim | kind | value | bound | text |\n|---|---|---|---|---|---|\n";
  return text + page.others;
}

}  // namespace thigma::experiments
