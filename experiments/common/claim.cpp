#include "experiments/common/claim.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>
#include <string_view>

namespace thigma::experiments {
namespace {

constexpr int kLeastRows = 3;  // of a sweep: two ends and something between them

bool satisfies(Comparison comparison, double value, double bound, double low) {
  switch (comparison) {
    case Comparison::none:
      return true;
    case Comparison::at_least:
      return value >= bound;
    case Comparison::at_most:
      return value <= bound;
    case Comparison::within:
      return value >= low && value <= bound;
    case Comparison::above:
      return value > bound;
    case Comparison::below:
      return value < bound;
  }
  return false;
}

bool satisfies(const Claim& claim, const std::optional<double>& bound,
               const std::optional<double>& low) {
  return claim.value &&
         satisfies(claim.comparison, *claim.value, bound.value_or(0.0), low.value_or(0.0));
}

/// Value into claim, and what follows from it.
Claim judge(Claim claim, double value) {
  claim.value = std::isfinite(value) ? std::optional(value) : std::nullopt;
  claim.holds = satisfies(claim, claim.bound, claim.bound_low);
  const bool is_known = claim.kind == ClaimKind::not_reproduced && !claim.holds &&
                        satisfies(claim, claim.floor, claim.floor_low);
  claim.expected = !is_known;
  return claim;
}

Claim make_claim(std::string id, std::string text, Comparison comparison, double value,
                 std::optional<double> bound, std::string unit) {
  Claim claim;
  claim.id = std::move(id);
  claim.text = std::move(text);
  claim.kind = comparison == Comparison::none ? ClaimKind::stated : ClaimKind::checked;
  claim.comparison = comparison;
  claim.bound = bound;
  claim.unit = std::move(unit);
  return judge(std::move(claim), value);
}

/// What holds at the bound holds at the floor too.
bool is_further_off(const Claim& claim) {
  switch (claim.comparison) {
    case Comparison::at_least:
    case Comparison::above:
      return *claim.floor <= *claim.bound;
    case Comparison::at_most:
    case Comparison::below:
      return *claim.floor >= *claim.bound;
    case Comparison::within:
      return claim.floor_low && *claim.floor_low <= *claim.bound_low &&
             *claim.floor >= *claim.bound;
    case Comparison::none:
      return false;
  }
  return false;
}

bool is_word(const Cell& cell, std::string_view word) {
  const std::string* text = std::get_if<std::string>(&cell);
  return text != nullptr && *text == word;
}

/// Rows a sweep names, 0 where there is no such table, column or word.
int count_rows(const std::string& sweep, const std::vector<Table>& tables) {
  const std::string file = sweep.substr(0, sweep.find(':'));
  const auto table = std::find_if(tables.begin(), tables.end(),
                                  [&](const Table& t) { return t.name + ".csv" == file; });
  if (table == tables.end()) return 0;
  if (file.size() == sweep.size()) return static_cast<int>(table->rows.size());
  const std::string rows = sweep.substr(file.size() + 1);
  const std::size_t equals = std::min(rows.find('='), rows.size());
  const auto& names = table->columns;
  const auto column = std::find(names.begin(), names.end(), rows.substr(0, equals));
  if (column == names.end() || equals == rows.size()) return 0;
  const std::size_t at = static_cast<std::size_t>(column - names.begin());
  const std::string word = rows.substr(equals + 1);
  return static_cast<int>(std::count_if(table->rows.begin(), table->rows.end(),
                                        [&](const auto& row) { return is_word(row[at], word); }));
}

}  // namespace

Claim at_least(std::string id, std::string text, double value, double bound, std::string unit) {
  return make_claim(std::move(id), std::move(text), Comparison::at_least, value, bound,
                    std::move(unit));
}

Claim at_most(std::string id, std::string text, double value, double bound, std::string unit) {
  return make_claim(std::move(id), std::move(text), Comparison::at_most, value, bound,
                    std::move(unit));
}

Claim within(std::string id, std::string text, double value, double low, double high,
             std::string unit) {
  Claim claim =
      make_claim(std::move(id), std::move(text), Comparison::within, value, high, std::move(unit));
  claim.bound_low = low;
  return judge(std::move(claim), value);
}

Claim above(std::string id, std::string text, double value, double bound, std::string unit) {
  return make_claim(std::move(id), std::move(text), Comparison::above, value, bound,
                    std::move(unit));
}

Claim below(std::string id, std::string text, double value, double bound, std::string unit) {
  return make_claim(std::move(id), std::move(text), Comparison::below, value, bound,
                    std::move(unit));
}

Claim stated(std::string id, std::string text, double value, std::string unit) {
  return make_claim(std::move(id), std::move(text), Comparison::none, value, std::nullopt,
                    std::move(unit));
}

Claim known_not_to(Claim claim, Known known) {
  claim.kind = ClaimKind::not_reproduced;
  claim.floor = known.floor;
  claim.floor_low = known.floor_low;
  if (claim.comparison == Comparison::none || known.reason.empty() || known.sweep.empty() ||
      !is_further_off(claim))
    throw std::invalid_argument(
        "claim " + claim.id +
        ": what is not reproduced has a bound, a reason, a sweep and a floor outside the bound");
  claim.reason = std::move(known.reason);
  claim.sweep = std::move(known.sweep);
  const double value = claim.value.value_or(std::nan(""));
  return judge(std::move(claim), value);
}

Claim on_this_machine(Claim claim) {
  claim.is_timed = true;
  return claim;
}

Claim with_value(Claim claim, double value) { return judge(std::move(claim), value); }

bool is_broken(const Claim& claim) { return claim.expected && !claim.holds; }

bool holds_though_marked(const Claim& claim) {
  return claim.kind == ClaimKind::not_reproduced && claim.holds;
}

const char* verdict(const Claim& claim) {
  switch (claim.kind) {
    case ClaimKind::checked:
      return claim.holds ? "holds" : "DOES NOT HOLD";
    case ClaimKind::stated:
      return claim.holds ? "stated" : "NO NUMBER";
    case ClaimKind::not_reproduced:
      break;
  }
  if (claim.holds) return "holds, though marked";
  return claim.expected ? "WORSE THAN KNOWN" : "not reproduced";
}

ClaimCounts count_claims(const std::vector<Claim>& claims) {
  ClaimCounts counts;
  for (const Claim& claim : claims) {
    counts.checked += claim.kind == ClaimKind::checked ? 1 : 0;
    counts.stated += claim.kind == ClaimKind::stated ? 1 : 0;
    counts.not_reproduced += claim.kind == ClaimKind::not_reproduced ? 1 : 0;
    counts.broken += is_broken(claim) ? 1 : 0;
    counts.marked_though_held += holds_though_marked(claim) ? 1 : 0;
  }
  return counts;
}

ClaimCounts operator+(const ClaimCounts& a, const ClaimCounts& b) {
  return {a.checked + b.checked, a.stated + b.stated, a.not_reproduced + b.not_reproduced,
          a.broken + b.broken, a.marked_though_held + b.marked_though_held};
}

std::string counts_text(const ClaimCounts& counts) {
  const int all = counts.checked + counts.stated + counts.not_reproduced;
  std::string text = std::to_string(all) + (all == 1 ? " claim: " : " claims: ") +
                     std::to_string(counts.checked) + " checked, " + std::to_string(counts.stated) +
                     " stated, " + std::to_string(counts.not_reproduced) + " not reproduced; " +
                     std::to_string(counts.broken) + " broken";
  if (counts.marked_though_held > 0)
    text += ", " + std::to_string(counts.marked_though_held) + " held though marked";
  return text;
}

std::vector<std::string> faults(const std::vector<Claim>& claims,
                                const std::vector<Table>& tables) {
  std::vector<std::string> found;
  std::set<std::string> ids;
  for (const Claim& claim : claims) {
    if (!ids.insert(claim.id).second) found.push_back("claim " + claim.id + " stands there twice");
    if (claim.kind != ClaimKind::not_reproduced) continue;
    const int rows = count_rows(claim.sweep, tables);
    if (rows < kLeastRows)
      found.push_back("claim " + claim.id + " is not reproduced, and its sweep " + claim.sweep +
                      " has " + std::to_string(rows) + " rows; expected at least " +
                      std::to_string(kLeastRows));
  }
  return found;
}

}  // namespace thigma::experiments
