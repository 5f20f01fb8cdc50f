#include "experiments/level-choice/contact_area.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "experiments/common/statistics.h"
#include "reference/refinement.h"

#include "thigma/contact/contact_node.h"
#include "thigma/contact/error_metric.h"
#include "thigma/contact/multires/patch_at_level.h"
#include "thigma/core/index.h"

namespace thigma::experiments::level_choice {
namespace {

double sum_of(const TreeRanges& tree, const std::set<std::int32_t>& patches) {
  double area = 0.0;
  for (const std::int32_t p : patches) area += tree.area[idx(p)];
  return area;
}

/// What the exact query found below two nodes.
struct Below {
  double area = 0.0, region = 0.0;  // [m^2]
};

Below below_of(const PairSurfaces& s, const std::vector<TouchedPlace>& exact, std::int32_t a,
               std::int32_t b) {
  const auto is_before = [](const TouchedPlace& p, std::int32_t patch) { return p.object < patch; };
  const auto first =
      std::lower_bound(exact.begin(), exact.end(), s.object.first[idx(a)], is_before);
  const auto last = std::lower_bound(first, exact.end(), s.object.last[idx(a)], is_before);
  std::set<std::int32_t> on_object, on_scene;
  Below below;
  for (auto e = first; e != last; ++e) {
    if (e->scene < s.scene.first[idx(b)] || e->scene >= s.scene.last[idx(b)]) continue;
    on_object.insert(e->object);
    on_scene.insert(e->scene);
    below.region = std::max(below.region, e->region);
  }
  below.area = std::min(sum_of(s.object, on_object), sum_of(s.scene, on_scene));
  return below;
}

/// D at a place of a node's patch, as the metric finds it [m^2].
double support_at(const ClodHierarchy& h, std::int32_t node, const Pose& world_from_mesh,
                  const Vec3& point) {
  const detail::PatchAtLevel side = detail::patch_at_level(h, node);
  const Vec3 p = transform_point(inverse(world_from_mesh), point);
  return detail::support_area(side, detail::locate(side.view, 0, p), SupportReading::flood);
}

std::vector<std::int32_t> parents_of(const ClodHierarchy& h) {
  std::vector<std::int32_t> parent(h.nodes.size(), -1);
  for (std::size_t i = 0; i < h.nodes.size(); ++i)
    for (std::int32_t c = 0; c < h.nodes[i].child_count; ++c)
      parent[idx(h.nodes[i].first_child + c)] = static_cast<std::int32_t>(i);
  return parent;
}

/// One side on its way up.
struct Climber {
  const ClodHierarchy& h;
  const std::vector<std::int32_t>& parent;
  double area, threshold;  // in place of D [m^2], s0 [m]
  std::int32_t node = -1;

  /// Whether the node above may stand for a contact of this area.
  bool may_rise() const {
    const std::int32_t up = parent[idx(node)];
    if (up < 0 || h.nodes[idx(up)].contact < 0) return false;
    const detail::PatchAtLevel patch = detail::patch_at_level(h, up);
    const LevelError error{patch.deviation(), patch.resolution(), area, false};
    return !needs_refinement(weighted_deviation(error, error), threshold);
  }
  double resolution() const { return h.levels[idx(h.nodes[idx(node)].level)].resolution; }
  void rise() { node = parent[idx(node)]; }
};

void climb(Climber& a, Climber& b) {
  while (true) {
    const bool is_a = a.may_rise(), is_b = b.may_rise();
    if (!is_a && !is_b) return;
    (is_a && (!is_b || a.resolution() >= b.resolution()) ? a : b).rise();
  }
}

}  // namespace

PairSurfaces pair_surfaces(const ClodHierarchy& object, const ClodHierarchy& scene) {
  PairSurfaces s{tree_ranges(object), tree_ranges(scene), {}, {}};
  s.object_corners = patch_corners(object, s.object);
  s.scene_corners = patch_corners(scene, s.scene);
  return s;
}

std::vector<TouchedPlace> touched_places(const PairSurfaces& surfaces, const ClodHierarchy& object,
                                         const ClodHierarchy& scene, const PoseFrame& exact) {
  std::vector<std::int32_t> on_object, on_scene;
  for (const Contact& e : exact.contacts) {
    on_object.push_back(surfaces.object.first[idx(contact_node(object, e.object_patch))]);
    on_scene.push_back(surfaces.scene.first[idx(contact_node(scene, e.scene_patch))]);
  }
  const std::vector<double> a = region_areas(surfaces.object_corners, surfaces.object, on_object);
  const std::vector<double> b = region_areas(surfaces.scene_corners, surfaces.scene, on_scene);
  std::vector<TouchedPlace> places;
  for (std::size_t i = 0; i < a.size(); ++i)
    places.push_back({on_object[i], on_scene[i], std::min(a[i], b[i])});
  std::stable_sort(places.begin(), places.end(), [](const TouchedPlace& x, const TouchedPlace& y) {
    return x.object < y.object;
  });
  return places;
}

void add_contacts(AreaSamples& samples, const TouchedPair& pair, const PairSurfaces& surfaces,
                  const Pose& pose, const std::vector<TouchedPlace>& exact,
                  const PoseFrame& frame) {
  const ContactWorld& world = pair.session.config.contact;
  const SceneBody& body = world.scene.front();
  std::vector<double>& of_pose = samples.region_by_pose.emplace_back();
  for (const Contact& c : frame.contacts) {
    const std::int32_t a = contact_node(*world.object, c.object_patch),
                       b = contact_node(*body.hierarchy, c.scene_patch);
    if (a < 0 || b < 0) continue;
    const Below below = below_of(surfaces, exact, a, b);
    if (!(below.area > 0.0)) continue;
    samples.level.push_back(0.5 * (c.object_level + c.scene_level));
    samples.weight.push_back(c.weight);
    samples.below.push_back(below.area);
    samples.region.push_back(below.region);
    of_pose.push_back(below.region);
    samples.support.push_back(
        std::max(support_at(*world.object, a, pose, c.point),
                 support_at(*body.hierarchy, b, body.world_from_body, c.scene_point)));
  }
}

void add_contacts_by_region(AreaSamples& samples, const TouchedPair& pair,
                            const PairSurfaces& surfaces, const PoseFrame& exact,
                            const std::vector<TouchedPlace>& places, double threshold) {
  const ClodHierarchy& object = *pair.session.config.contact.object;
  const ClodHierarchy& scene = *pair.session.config.contact.scene.front().hierarchy;
  const std::vector<std::int32_t> object_parents = parents_of(object),
                                  scene_parents = parents_of(scene);
  std::map<std::pair<std::int32_t, std::int32_t>, double> region;  // by finest patches
  for (const TouchedPlace& p : places) region[{p.object, p.scene}] = p.region;
  std::set<std::pair<std::int32_t, std::int32_t>> reported;
  for (const Contact& e : exact.contacts) {
    const std::int32_t a = contact_node(object, e.object_patch),
                       b = contact_node(scene, e.scene_patch);
    const double area = region.at({surfaces.object.first[idx(a)], surfaces.scene.first[idx(b)]});
    Climber up_a{object, object_parents, area, threshold, a},
        up_b{scene, scene_parents, area, threshold, b};
    climb(up_a, up_b);
    if (!reported.insert({up_a.node, up_b.node}).second) continue;
    samples.level.push_back(
        0.5 * (object.nodes[idx(up_a.node)].level + scene.nodes[idx(up_b.node)].level));
    samples.weight.push_back(1.0);
    samples.region.push_back(area);
  }
}

std::vector<AreaRank> area_ranks(const AreaTrials& trials) {
  const AreaSamples &x = trials.blended, &y = trials.single;
  const AreaSamples &s = trials.smaller, &z = trials.by_region;
  const auto count = [](const AreaSamples& a) { return static_cast<double>(a.level.size()); };
  return {
      {"level and area below", rank_correlation(x.level, x.below), count(x)},
      {"the same by weight", rank_correlation(x.level, x.below, x.weight), count(x)},
      {"level and area below, no interpolation", rank_correlation(y.level, y.below), count(y)},
      {"level and region by weight", rank_correlation(x.level, x.region, x.weight), count(x)},
      {"level and region, no interpolation", rank_correlation(y.level, y.region), count(y)},
      {"level and region by weight, the smaller D", rank_correlation(s.level, s.region, s.weight),
       count(s)},
      {"level and D by weight", rank_correlation(x.level, x.support, x.weight), count(x)},
      {"D and region by weight", rank_correlation(x.support, x.region, x.weight), count(x)},
      {"level and region, region in place of D", rank_correlation(z.level, z.region), count(z)}};
}

double commonest_level(const AreaSamples& samples) {
  std::map<double, double> weight;
  double total = 0.0, most = 0.0;
  for (std::size_t i = 0; i < samples.level.size(); ++i) {
    total += samples.weight[i];
    most = std::max(most, weight[samples.level[i]] += samples.weight[i]);
  }
  return most / total;
}

}  // namespace thigma::experiments::level_choice
