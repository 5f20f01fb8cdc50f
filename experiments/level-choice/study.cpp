#include "experiments/level-choice/study.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "benchmarks/point_cells.h"
#include "benchmarks/probe.h"
#include "experiments/common/statistics.h"
#include "experiments/level-choice/tree_ranges.h"

#include "thigma/contact/clustering.h"
#include "thigma/contact/contact_node.h"
#include "thigma/contact/query_contacts.h"
#include "thigma/core/index.h"
#include "thigma/math/quantile.h"

namespace thigma::experiments::level_choice {
namespace {

constexpr std::size_t kRoom = 400'000;
constexpr int kBurst = 4;              // frames before a sample is taken, the last three timed
constexpr int kClusters = 16;          // of the force that is compared
constexpr double kNear = 0.02;         // of the radius: a contact is found where another is as near
constexpr std::size_t kCompared = 2000;  // exact contacts of a pose that recall is taken over, at most

/// Contacts of one pose.
struct Frame {
  std::vector<Contact> contacts;
  Vec3 force = Vec3::Zero();  // per unit of stiffness [m]
  double front = 0.0;
  std::vector<double> query;  // CPU times of the burst [s]
};

Vec3 force_of(const std::vector<Contact>& contacts, double tolerance) {
  ContactClusters clusters;
  ClusterScratch scratch;
  cluster_contacts(contacts, {}, {.max_clusters = kClusters, .tolerance = tolerance}, scratch, clusters);
  Vec3 force = Vec3::Zero();
  for (const ContactCluster& c : clusters.clusters) force -= std::max(c.depth + tolerance, 0.0) * c.normal;
  return force;
}

Frame query_at(const TouchedPair& pair, std::size_t sample, const Setting& setting, ContactFront& front,
               ContactSet& set) {
  const ContactWorld& world = pair.session.config.contact;
  ContactQuery query{.tolerance = world.tolerance};
  query.resolution = setting.resolution;
  Frame frame;
  clear_front(front);
  for (std::size_t i = sample - std::min<std::size_t>(sample, kBurst - 1); i <= sample; ++i) {
    clear(set);
    const double start = bench::thread_cpu();
    query_contacts(*world.object, pair.touching[i], *world.scene.front().hierarchy,
                   world.scene.front().world_from_body, query, front, set);
    frame.query.push_back(bench::thread_cpu() - start);
  }
  if (frame.query.size() > 1) frame.query.erase(frame.query.begin());  // from the root
  frame.contacts = set.contacts;
  frame.front = static_cast<double>(set.stats.front);
  frame.force = force_of(frame.contacts, world.tolerance);
  return frame;
}

std::vector<Vec3> middles_of(const std::vector<Contact>& contacts, std::size_t step = 1) {
  std::vector<Vec3> middles;
  for (std::size_t i = 0; i < contacts.size(); i += step)
    middles.push_back(0.5 * (contacts[i].point + contacts[i].scene_point));
  return middles;
}

/// Neither frame without a contact.
double recall_of(const Frame& exact, const Frame& frame, double near) {
  const std::vector<Vec3> asked = middles_of(exact.contacts, exact.contacts.size() / kCompared + 1);
  const bench::PointCells cells = bench::sort_into_cells(middles_of(frame.contacts), near);
  const auto found = std::count_if(asked.begin(), asked.end(),
                                   [&](const Vec3& p) { return bench::has_point_within(cells, p); });
  return static_cast<double>(found) / static_cast<double>(asked.size());
}

/// Largest of minus depth minus bound, and the same plus bound: between them lies the least separation.
struct Interval {
  double low = std::numeric_limits<double>::infinity(), high = low, reported = low;
};

Interval least_separation(const Frame& frame) {
  Interval least;
  for (const Contact& c : frame.contacts) {
    least.low = std::min(least.low, -c.depth - c.bound);
    least.high = std::min(least.high, -c.depth + c.bound);
    least.reported = std::min(least.reported, -c.depth);
  }
  return least;
}

/// Area of the finest patches on one side of a contact that the exact query found near the other side.
double touched_area(const TreeRanges& tree, std::set<std::int32_t>& patches) {
  double area = 0.0;
  for (const std::int32_t p : patches) area += tree.area[at(p)];
  return area;
}

/// Collects the samples of one setting.
struct Collector {
  const ClodHierarchy &object, &scene;
  const TreeRanges &object_tree, &scene_tree;
  double radius;
  std::vector<double> triangles{}, contacts{}, front{}, query{}, recall{}, error{}, interval{}, ratio{};
  std::vector<double> level{}, area{};  // of every contact that has something of the exact query below it
  double difference2 = 0.0, force2 = 0.0;
  int levels_at_once = 0;
};

struct Place {
  std::int32_t object, scene;  // counts of finest patches
};

void add_contact(Collector& c, const std::vector<Place>& exact, const Contact& contact) {
  const std::int32_t a = contact_node(c.object, contact.object_patch), b = contact_node(c.scene, contact.scene_patch);
  if (a < 0 || b < 0) return;
  c.triangles.push_back(0.5 * (c.object_tree.triangles[at(a)] + c.scene_tree.triangles[at(b)]));
  std::set<std::int32_t> on_object, on_scene;
  for (const Place& e : exact) {
    if (e.object < c.object_tree.first[at(a)] || e.object >= c.object_tree.last[at(a)]) continue;
    if (e.scene < c.scene_tree.first[at(b)] || e.scene >= c.scene_tree.last[at(b)]) continue;
    on_object.insert(e.object);
    on_scene.insert(e.scene);
  }
  if (on_object.empty()) return;
  c.level.push_back(0.5 * (contact.object_level + contact.scene_level));
  c.area.push_back(std::min(touched_area(c.object_tree, on_object), touched_area(c.scene_tree, on_scene)));
}

void add_frame(Collector& c, const Frame& exact, const std::vector<Place>& places, const Frame& frame) {
  for (const Contact& contact : frame.contacts) add_contact(c, places, contact);
  std::set<std::int32_t> levels;
  for (const Contact& contact : frame.contacts) levels.insert({contact.object_level, contact.scene_level});
  c.levels_at_once = std::max(c.levels_at_once, static_cast<int>(levels.size()));
  c.contacts.push_back(static_cast<double>(frame.contacts.size()));
  c.front.push_back(frame.front);
  c.query.insert(c.query.end(), frame.query.begin(), frame.query.end());
  c.difference2 += (frame.force - exact.force).squaredNorm();
  c.force2 += exact.force.squaredNorm();
  if (exact.contacts.empty() || frame.contacts.empty()) return;
  c.recall.push_back(recall_of(exact, frame, kNear * c.radius));
  const Interval truth = least_separation(exact), least = least_separation(frame);
  c.error.push_back(std::fabs(least.reported - truth.reported));
  c.interval.push_back(least.high - least.low);
  if (c.error.back() > 0.0) c.ratio.push_back(c.interval.back() / c.error.back());
}

double median(const std::vector<double>& x) {
  return x.empty() ? std::numeric_limits<double>::quiet_NaN() : sample_quantile(x, 0.5);
}

Choice summarize(const Collector& c) {
  Choice choice;
  choice.triangles = mean(c.triangles);
  choice.contacts = mean(c.contacts);
  choice.front = mean(c.front);
  choice.query = median(c.query);
  choice.force_error = std::sqrt(c.difference2 / c.force2);
  choice.recall = mean(c.recall);
  choice.separation_error = median(c.error);
  choice.interval = median(c.interval);
  choice.interval_ratio = median(c.ratio);
  choice.area_rank = rank_correlation(c.area, c.level);
  choice.levels_at_once = c.levels_at_once;
  return choice;
}

std::vector<Place> places_of(const Frame& exact, const Collector& c) {
  std::vector<Place> places;
  for (const Contact& e : exact.contacts)
    places.push_back({c.object_tree.first[at(contact_node(c.object, e.object_patch))],
                      c.scene_tree.first[at(contact_node(c.scene, e.scene_patch))]});
  return places;
}

}  // namespace

TouchedPair touch(SessionPair session, double threshold) {
  Resolution& resolution = session.config.contact.resolution;
  resolution = setting_at(threshold).resolution;
  const std::unique_ptr<HapticDevice> hand = open_device("hand:", session.hand);
  session.config.haptic.device = hand->limits();
  TouchedPair pair{session, {}};
  const auto look = [&](const ContactSample& sample) {
    const BodyState& state = sample.model.state;
    if (sample.contacts > 0)
      pair.touching.push_back(Pose{state.position, state.orientation} * session.config.contact.body_from_mesh);
  };
  run_lockstep(session.config, *hand, {.haptic = {}, .contact = look, .event = {}});
  return pair;
}

Setting setting_at(double threshold) {
  Setting setting{"exact", threshold, {}};
  if (!(threshold > 0.0)) return setting;
  setting.resolution.is_exact = false;
  setting.resolution.metric.haptic = std::isfinite(threshold) ? threshold : 1e9;
  char name[32];
  std::snprintf(name, sizeof name, "%g %%", 100.0 * threshold);
  setting.name = std::isfinite(threshold) ? name : "no metric";
  return setting;
}

std::vector<Choice> measure(const TouchedPair& pair, const std::vector<Setting>& settings, int samples) {
  const ContactWorld& world = pair.session.config.contact;
  const ClodHierarchy &object = *world.object, &scene = *world.scene.front().hierarchy;
  const TreeRanges object_tree = tree_ranges(object), scene_tree = tree_ranges(scene);
  const double radius = std::min(object.radius, scene.radius);
  std::vector<Collector> collectors(settings.size(), Collector{object, scene, object_tree, scene_tree, radius});
  ContactFront front;
  reserve_front(front, object, scene);
  ContactSet set;
  set.contacts.reserve(kRoom);
  const auto count = static_cast<std::size_t>(samples);
  for (std::size_t i = 0; i < count && !pair.touching.empty(); ++i) {
    const std::size_t sample = (2 * i + 1) * pair.touching.size() / (2 * count);
    const Frame exact = query_at(pair, sample, setting_at(0.0), front, set);
    const std::vector<Place> places = places_of(exact, collectors.front());
    for (std::size_t k = 0; k < settings.size(); ++k)
      add_frame(collectors[k], exact, places,
                settings[k].threshold > 0.0 ? query_at(pair, sample, settings[k], front, set) : exact);
  }
  std::vector<Choice> choices;
  for (const Collector& c : collectors) choices.push_back(summarize(c));
  return choices;
}

}  // namespace thigma::experiments::level_choice
