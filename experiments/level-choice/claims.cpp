#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "experiments/level-choice/tables.h"

namespace thigma::experiments::level_choice {
namespace {

constexpr double kGrowth = 1.3, kRank = 0.5;
// Above this regions differ enough for a rank to say something: 90 % quantile of their areas over
// the 10 % quantile. The quotient leaps from 1.4 to 140 with one pose of eight at which little
// touches yet, the lower end of what drawn poses give does not.
constexpr double kSpread = 2.0;

/// Least growth from one asked threshold to the next.
struct LeastGrowth {
  double below = std::numeric_limits<double>::infinity(), error = below;
  double shared = below, shared_high = below;
};

LeastGrowth least_growth(const Studied& pair) {
  LeastGrowth least;
  for (const Step& s : steps_of(pair)) {
    least.below = std::min(least.below, s.below.value);
    least.error = std::min(least.error, s.error.value);
    least.shared = std::min(least.shared, s.shared.value);
    least.shared_high = std::min(least.shared_high, s.shared.high);
  }
  return least;
}

void add_growth(const Studied& pair, std::vector<Claim>& claims) {
  const LeastGrowth least = least_growth(pair);
  const std::string& name = pair.name;
  const Claim grows =
      at_least("grows-" + name,
               name +
                   ": original triangles below a contact, from s0 = 1 to 2.5, 5 % and "
                   "no metric at all: least growth from one to the next",
               least.below, kGrowth);
  claims.push_back(
      name != "cup_spoon"
          ? grows
          : known_not_to(grows, {.reason = "one region of one size, so one level: what the "
                                           "others average over many places is a "
                                           "staircase here, flat from 1 to 2.5 %",
                                 .sweep = "data.csv:scene=" + name,
                                 .floor = 1.0}));
  const Claim costs = at_least("costs-" + name,
                               name +
                                   ": growth of the error of the force between the same, clusters "
                                   "sharing the stiffness as in sessions, at the upper end of what "
                                   "drawing the poses again gives (95 %): the least",
                               least.shared_high, 1.0);
  claims.push_back(name != "cup_spoon" || pair.is_quick
                       ? costs
                       : known_not_to(costs, {.reason = "the same staircase: one level stands for "
                                                        "the one region at 1 and at 2.5 %, and "
                                                        "the error is what that level leaves",
                                              .sweep = "data.csv:scene=" + name,
                                              .floor = 0.8}));
  claims.push_back(stated("costs-least-" + name,
                          name + ": the same as measured, the least (goal 1)", least.shared));
  claims.push_back(
      stated("costs-alone-" + name,
             name + ": the same with each cluster as stiff as one alone, which counts the "
                    "clusters",
             least.error));
}

std::string figure(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

std::string spread_text(const Growth& spread) {
  return "90 % over 10 % quantile of the regions' areas " + figure(spread.value) + ", " +
         figure(spread.low) + " at the lower end of what drawn poses give";
}

void add_area(const Studied& pair, std::vector<Claim>& claims) {
  const std::string& name = pair.name;
  const Choice& shipped = choice_at(pair, kShipped);
  const AreaRank& without_d = pair.study.ranks.back();
  const Claim area =
      at_least("area-" + name,
               name +
                   ": rank correlation of a contact's level at 2.5 % with the area of "
                   "its region by the exact query",
               shipped.area_rank, kRank);
  const Growth& spread = pair.study.region_spread;
  if (!std::isfinite(spread.value) || !std::isfinite(spread.low)) {
    claims.push_back(with_value(area, std::nan("")));
    return;
  }
  if (!(spread.value > kSpread)) {
    claims.push_back(stated(area.id,
                            area.text + " (goal 0.5; not asked for: " + spread_text(spread) + ")",
                            shipped.area_rank));
    return;
  }
  const std::string rows = "area.csv:scene=" + name;
  claims.push_back(known_not_to(
      area, {.reason = "D is of each surface alone (Sec. 3.3.5), and not the area the two share: "
                       "with that area in its place the rank is " +
                       figure(without_d.rank) + " (area-by-region)",
             .sweep = rows,
             .floor = 0.0}));
  constexpr double kByRegion = 0.8;
  const Claim by_region =
      at_least("area-by-region-" + name,
               name + ": the same of the levels there would be with that area in place of D",
               without_d.rank, kByRegion);
  claims.push_back(spread.low > kSpread || without_d.rank >= kByRegion
                       ? by_region
                       : known_not_to(by_region, {.reason = "regions differ at single poses only, "
                                                            "among the others there is little to "
                                                            "rank: " +
                                                            spread_text(spread),
                                                  .sweep = rows,
                                                  .floor = 0.6}));
}

void add_interval(const Studied& pair, std::vector<Claim>& claims) {
  const std::string& name = pair.name;
  const Choice& shipped = choice_at(pair, kShipped);
  // Either is enough: an interval as small as 1 % of the radius says something whatever the error.
  claims.push_back(at_most(
      "interval-" + name,
      name + ": interval for the least separation at 2.5 %, median: over 20 times its "
             "error or over 1 % of the radius, the lesser",
      std::fmin(shipped.interval_ratio / 20.0, shipped.interval / pair.radius / 0.01), 1.0));
  claims.push_back(at_most("interval-outside-" + name,
                           name + ": poses whose exact least separation is not in that interval",
                           shipped.outside, 0.0));
  claims.push_back(stated("interval-bounds-" + name,
                          name + ": what the contacts' own bounds leave, median over the radius",
                          shipped.bounds / pair.radius));
  claims.push_back(
      on_this_machine(stated("interval-time-" + name,
                             name + ": CPU time p50 of narrowing them over that of the exact query",
                             shipped.narrowing / choice_at(pair, 0.0).query)));
}

}  // namespace

std::vector<Claim> claims_of(const Studied& pair) {
  const std::string& name = pair.name;
  const Choice& shipped = choice_at(pair, kShipped);
  std::vector<Claim> claims;
  add_growth(pair, claims);
  if (name == "jaws" || name == "casts") {
    const Claim at_once = at_least("at-once-" + name,
                                   name + ": levels among the contacts of one frame at 2.5 %, most",
                                   shipped.levels_at_once, 4.0);
    // On the casts three since contacts blend from 0.8 of s0 on, four when they did from 0.5.
    claims.push_back(name == "jaws"
                         ? at_once
                         : stated(at_once.id, at_once.text + " (goal 4)", shipped.levels_at_once));
  }
  add_area(pair, claims);
  claims.push_back(
      stated("shell-" + name,
             name + ": error of the force at 2.5 % over that of the point shell, stiffness "
                    "shared",
             shipped.shared_error / pair.study.shell.shared_error));
  claims.push_back(on_this_machine(
      stated("faster-" + name, name + ": CPU time p50 of the exact query over that at 2.5 %",
             choice_at(pair, 0.0).query / shipped.query)));
  add_interval(pair, claims);
  return claims;
}

}  // namespace thigma::experiments::level_choice
