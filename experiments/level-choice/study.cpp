#include "experiments/level-choice/study.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "experiments/common/hierarchy_bytes.h"
#include "experiments/common/statistics.h"

#include "thigma/contact/contact_node.h"
#include "thigma/core/index.h"
#include "thigma/math/quantile.h"

namespace thigma::experiments::level_choice {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
// Of least separations measured in two ways, times the radius.
constexpr double kRounding = 1e-9;
constexpr std::uint64_t kSeed = 1;  // of poses drawn again
constexpr double kNear = 0.02;      // of the radius: a contact is found where another is as near

/// Collects the poses of one setting.
struct Collector {
  std::vector<double> contacts{}, front{}, query{}, recall{}, error{}, ratio{};
  std::vector<double> bounds{}, interval{}, narrowing{}, divided{};
  double outside = 0.0;
  PoseShare below{}, difference{}, shared{};
  std::size_t levels_at_once = 0;
};

/// What all settings are compared over.
struct Comparison {
  const TouchedPair& pair;
  const ClodHierarchy &object, &scene;
  PairSurfaces surfaces;
  double radius;
};

/// Of a shell's contacts, which are of no patch, nothing is below.
void add_triangles(Collector& c, const Comparison& with, const PoseFrame& frame) {
  double sum = 0.0, count = 0.0;
  for (const Contact& contact : frame.contacts) {
    const std::int32_t a = contact_node(with.object, contact.object_patch);
    const std::int32_t b = contact_node(with.scene, contact.scene_patch);
    if (a < 0 || b < 0) continue;
    sum += 0.5 * (with.surfaces.object.triangles[idx(a)] + with.surfaces.scene.triangles[idx(b)]);
    count += 1.0;
  }
  c.below.over.push_back(sum);
  c.below.under.push_back(count);
}

/// Of exact contacts, which are not narrowed, the interval is the least separation itself.
void add_interval(Collector& c, const Comparison& with, const LeastSeparation& truth,
                  const PoseFrame& frame) {
  if (!(frame.narrowing > 0.0)) return c.interval.push_back(0.0);
  const double rounding = kRounding * with.radius;
  c.interval.push_back(frame.narrowed.high - frame.narrowed.low);
  c.narrowing.push_back(frame.narrowing);
  c.divided.push_back(static_cast<double>(frame.narrowed.expansions));
  if (truth.reported < frame.narrowed.low - rounding ||
      truth.reported > frame.narrowed.high + rounding)
    c.outside += 1.0;
}

void add_frame(Collector& c, const Comparison& with, const PoseFrame& exact,
               const PoseFrame& frame) {
  add_triangles(c, with, frame);
  std::set<std::int32_t> levels;
  for (const Contact& contact : frame.contacts)
    levels.insert({contact.object_level, contact.scene_level});
  c.levels_at_once = std::max(c.levels_at_once, levels.size());
  c.contacts.push_back(static_cast<double>(frame.contacts.size()));
  c.front.push_back(frame.front);
  c.query.insert(c.query.end(), frame.query.begin(), frame.query.end());
  c.difference.over.push_back((frame.force - exact.force).squaredNorm());
  c.difference.under.push_back(exact.force.squaredNorm());
  c.shared.over.push_back((frame.shared_force - exact.shared_force).squaredNorm());
  c.shared.under.push_back(exact.shared_force.squaredNorm());
  if (exact.contacts.empty() || frame.contacts.empty()) return;
  c.recall.push_back(recall_of(exact, frame, kNear * with.radius));
  const LeastSeparation truth = least_separation(exact), least = least_separation(frame);
  c.error.push_back(std::fabs(least.reported - truth.reported));
  c.bounds.push_back(least.high - least.low);
  add_interval(c, with, truth, frame);
  if (c.error.back() > 0.0) c.ratio.push_back(c.interval.back() / c.error.back());
}

double quotient(const PoseShare& share) {
  double over = 0.0, under = 0.0;
  for (const double x : share.over) over += x;
  for (const double x : share.under) under += x;
  return over / under;
}

Choice summarize(const Collector& c, double bytes) {
  Choice choice;
  choice.triangles = quotient(c.below);
  choice.contacts = mean(c.contacts);
  choice.front = mean(c.front);
  choice.query = sample_quantile(c.query, 0.5);
  choice.force_error = std::sqrt(quotient(c.difference));
  choice.shared_error = std::sqrt(quotient(c.shared));
  choice.recall = mean(c.recall);
  choice.separation_error = sample_quantile(c.error, 0.5);
  choice.bounds = sample_quantile(c.bounds, 0.5);
  choice.interval = sample_quantile(c.interval, 0.5);
  choice.outside = c.outside;
  choice.narrowing = sample_quantile(c.narrowing, 0.5);
  choice.divided = sample_quantile(c.divided, 0.5);
  choice.interval_ratio = sample_quantile(c.ratio, 0.5);
  choice.area_rank = kNaN;
  choice.levels_at_once = static_cast<double>(c.levels_at_once);
  choice.bytes = bytes;
  choice.below = c.below;
  choice.error = c.difference;
  choice.shared = c.shared;
  return choice;
}

/// A shell's contacts have neither levels nor bounds.
Choice summarize_shell(const Collector& c, double bytes) {
  Choice choice = summarize(c, bytes);
  choice.triangles = choice.bounds = choice.interval = choice.interval_ratio = kNaN;
  choice.levels_at_once = choice.narrowing = choice.divided = choice.outside = kNaN;
  return choice;
}

/// A pose for all of the trials but `blended`.
void add_trials(AreaTrials& trials, const Comparison& with, std::size_t sample,
                const PoseFrame& exact, const std::vector<TouchedPlace>& places, double threshold,
                QueryMemory& memory) {
  const auto add = [&](AreaSamples& to, const Resolution& resolution) {
    add_contacts(to, with.pair, with.surfaces, with.pair.touching[sample], places,
                 query_at(with.pair, sample, resolution, memory));
  };
  Resolution single = setting_at(threshold).resolution, smaller = single;
  single.interpolates = false;
  smaller.area = SupportArea::smaller;
  add(trials.single, single);
  add(trials.smaller, smaller);
  add_contacts_by_region(trials.by_region, with.pair, with.surfaces, exact, places,
                         threshold * with.radius);
}

}  // namespace

PairStudy measure(const TouchedPair& pair, const ShellPair& shells,
                  const std::vector<Setting>& settings, int samples, double threshold) {
  const ContactWorld& world = pair.session.config.contact;
  const ClodHierarchy &object = *world.object, &scene = *world.scene.front().hierarchy;
  const Comparison with{pair, object, scene, pair_surfaces(object, scene),
                        std::min(object.radius, scene.radius)};
  std::vector<Collector> collectors(settings.size());
  std::vector<AreaSamples> areas(settings.size());
  Collector of_shell;
  AreaTrials trials;
  QueryMemory memory = make_memory(pair);
  const auto count = static_cast<std::size_t>(samples);
  for (std::size_t i = 0; i < count && !pair.touching.empty(); ++i) {
    const std::size_t sample = (2 * i + 1) * pair.touching.size() / (2 * count);
    const PoseFrame exact = query_at(pair, sample, Resolution{}, memory);
    const std::vector<TouchedPlace> places = touched_places(with.surfaces, object, scene, exact);
    for (std::size_t k = 0; k < settings.size(); ++k) {
      const bool is_exact = !(settings[k].threshold > 0.0);
      const PoseFrame frame =
          is_exact ? exact : query_at(pair, sample, settings[k].resolution, memory);
      add_frame(collectors[k], with, exact, frame);
      if (!is_exact)
        add_contacts(areas[k], pair, with.surfaces, pair.touching[sample], places, frame);
    }
    add_frame(of_shell, with, exact, query_at(pair, sample, shells, memory));
    add_trials(trials, with, sample, exact, places, threshold, memory);
  }
  PairStudy study;
  for (std::size_t k = 0; k < settings.size(); ++k) {
    study.choices.push_back(
        summarize(collectors[k], hierarchy_bytes(object) + hierarchy_bytes(scene)));
    study.choices.back().area_rank =
        rank_correlation(areas[k].level, areas[k].region, areas[k].weight);
    if (settings[k].threshold == threshold) trials.blended = areas[k];
  }
  study.ranks = area_ranks(trials);
  study.commonest_level = commonest_level(trials.blended);
  study.region_spread = spread_of(trials.blended.region_by_pose, kSeed);
  study.shell = summarize_shell(of_shell, shells.bytes);
  return study;
}

}  // namespace thigma::experiments::level_choice
