// Convex edges against convex edges.

#include <algorithm>
#include <cmath>

#include "thigma/constraint/detail/edge_cones.h"
#include "thigma/constraint/detail/edge_planes.h"
#include "thigma/constraint/detail/feature_distance.h"
#include "thigma/constraint/detail/pair_lists.h"
#include "thigma/constraint/detail/plane_choice.h"
#include "thigma/constraint/detail/row_search.h"
#include "thigma/core/index.h"

namespace thigma::detail {
namespace {

using EdgePair = RowScratch::EdgePair;

// Edges more nearly parallel than this have no normal of their own. They touch along a line, whose
// ends are vertices on faces; but the object may turn before, and then they cross: planes keep them
// apart, not these two vertices alone.
constexpr double kParallel = 1e-6;

/// Two edges where they are, in the frame of the scene's mesh.
struct PlacedPair {
  std::int32_t object = -1, scene = -1;  // edges
  int sign = 1;  // of the object's direction x the scene's, to point into the scene; 0: parallel
  Vec3 object_tail = Vec3::Zero(), object_head = Vec3::Zero();
  Vec3 scene_tail = Vec3::Zero(), scene_head = Vec3::Zero();
  NearestOnSegments nearest;
  double distance = 0.0;

  Vec3 on_object() const noexcept {
    return object_tail + nearest.first * (object_head - object_tail);
  }
  Vec3 on_scene() const noexcept { return scene_tail + nearest.second * (scene_head - scene_tail); }
};

/// Whether one of two parallel edges lies in front of the other, by their cones of normals but for
/// what turning may do.
bool are_facing(const RowSearch& search, const ConvexEdge& e,
                const RowScratch::EdgeCone& f) noexcept {
  const SurfaceFeatures &a = *search.object.features, &b = *search.scene.features;
  const Vec3 from =
      transform_point(search.object_from_scene, b.vertices[idx(b.edges[idx(f.edge)].tail)]) -
      a.vertices[idx(e.tail)];
  const Vec3 way = from - e.direction.dot(from) * e.direction;
  const double most = (search.cone_slack + kParallel) * way.norm() + search.rounding;
  return way.dot(e.into_left) <= most && way.dot(e.into_right) <= most &&
         way.dot(f.into_left) >= -most && way.dot(f.into_right) >= -most;
}

/// Whether the edges may be the first to touch, by their cones of normals but for what turning may
/// do; then the sign of the object's direction x the scene's.
bool may_touch(const RowSearch& search, const ConvexEdge& e, const RowScratch::EdgeCone& f,
               int& sign) noexcept {
  const Vec3 cross = e.direction.cross(f.direction);
  const ConesMeet cones = meet(cross, e, f, search.cone_slack);
  sign = 0;
  if (cones.sine < kParallel) return are_facing(search, e, f);
  // Where turning may make either true: the sign that points out of the one and into the other.
  const auto points_out = [&] {
    const Vec3& outward = search.scene.features->edges[idx(f.edge)].outward;
    return cross.dot(e.outward - search.object_from_scene.orientation._transformVector(outward)) >=
           0.0;
  };
  sign = cones.plus && (!cones.minus || points_out()) ? 1 : -1;
  return cones.plus || cones.minus;
}

/// Places the edges; whether they are within reach of each other.
bool place(const RowSearch& search, PlacedPair& pair) noexcept {
  const SurfaceFeatures& b = *search.scene.features;
  const ConvexEdge& f = b.edges[idx(pair.scene)];
  pair.scene_tail = b.vertices[idx(f.tail)];
  pair.scene_head = b.vertices[idx(f.head)];
  pair.nearest = nearest_on_segments(pair.object_tail, pair.object_head - pair.object_tail,
                                     pair.scene_tail, pair.scene_head - pair.scene_tail);
  pair.distance = (pair.on_scene() - pair.on_object()).norm();
  return pair.distance <= search.reach.travel;
}

EdgeEnds object_ends(const RowSearch& search, const PlacedPair& pair) noexcept {
  const ConvexEdge& e = search.object.features->edges[idx(pair.object)];
  return {.points_of = PointsOf::object,
          .tail = e.tail,
          .head = e.head,
          .at_tail = pair.object_tail,
          .at_head = pair.object_head,
          .other_tail = pair.scene_tail,
          .other_head = pair.scene_head,
          .nearest = pair.on_object(),
          .other_nearest = pair.on_scene(),
          .other = &search.scene.features->edges[idx(pair.scene)],
          .other_index = pair.scene};
}

EdgeEnds scene_ends(const RowSearch& search, const PlacedPair& pair) noexcept {
  const ConvexEdge& e = search.object.features->edges[idx(pair.object)];
  const ConvexEdge& f = search.scene.features->edges[idx(pair.scene)];
  const std::vector<Vec3>& a = search.object.features->vertices;
  const Pose& object_from_scene = search.object_from_scene;
  return {.points_of = PointsOf::scene,
          .tail = f.tail,
          .head = f.head,
          .at_tail = transform_point(object_from_scene, pair.scene_tail),
          .at_head = transform_point(object_from_scene, pair.scene_head),
          .other_tail = a[idx(e.tail)],
          .other_head = a[idx(e.head)],
          .nearest = transform_point(object_from_scene, pair.on_scene()),
          .other_nearest = transform_point(object_from_scene, pair.on_object()),
          .other = &e,
          .other_index = pair.object};
}

/// Of the lines of two edges, out of the object, into the scene [scene's mesh frame].
Vec3 normal_of(const RowSearch& search, const PlacedPair& pair) noexcept {
  const ConvexEdge& e = search.object.features->edges[idx(pair.object)];
  const ConvexEdge& f = search.scene.features->edges[idx(pair.scene)];
  const Vec3 u = search.scene_from_object.orientation._transformVector(pair.sign * e.direction);
  return u.cross(f.direction).normalized();
}

FoundRow edge_row(const RowSearch& search, const PlacedPair& pair) noexcept {
  const ConvexEdge& e = search.object.features->edges[idx(pair.object)];
  const ConvexEdge& f = search.scene.features->edges[idx(pair.scene)];
  FoundRow found;
  ContactRow& row = found.row;
  row.kind = RowKind::edges;
  row.body = search.body;
  row.object_point = search.object.features->vertices[idx(e.tail)];
  row.object_direction = pair.sign * e.direction;
  row.scene_point = transform_point(search.scene.world_from_mesh, pair.scene_tail);
  row.scene_direction = search.scene.world_from_mesh.orientation._transformVector(f.direction);
  row.id = id_of(search, row.kind, pair.object, pair.scene);
  found.gap = normal_of(search, pair).dot(pair.scene_tail - pair.object_tail);
  return found;
}

bool is_met(RowScratch& scratch, const EdgePair& pair) noexcept {
  const auto place = std::lower_bound(scratch.met.begin(), scratch.met.end(), pair);
  if (place != scratch.met.end() && *place == pair) return true;
  if (scratch.met.size() < scratch.met.capacity()) scratch.met.insert(place, pair);
  return false;
}

/// A row of the two lines, where they are nearest inside of both edges.
bool has_edge_row(const RowSearch& search, const PlacedPair& pair, FoundRow& row) noexcept {
  const auto is_inside = [](double share) { return share > 0.0 && share < 1.0; };
  if (pair.sign == 0 || !is_inside(pair.nearest.first) || !is_inside(pair.nearest.second))
    return false;
  row = edge_row(search, pair);
  // On the wrong side: through each other by an error of the last steps, or beside each other and
  // only able to touch once they have turned. Then what is apart stays apart.
  return row.gap >= -kError * search.reach.travel;
}

/// Whether the lines are nearest where the edges may come over each other within the travel, though
/// they are not yet, and turning does not make them parallel, where they would change sides.
bool comes_over(const RowSearch& search, const PlacedPair& pair) noexcept {
  const Vec3 object = pair.object_head - pair.object_tail,
             scene = pair.scene_head - pair.scene_tail;
  const double of_object = object.norm(), of_scene = scene.norm();
  if (object.cross(scene).norm() <= search.cone_slack * of_object * of_scene) return false;
  const NearestOnSegments at = nearest_on_lines(pair.object_tail, object, pair.scene_tail, scene);
  const auto is_near = [&](double share, double length) {
    return std::max(-share, share - 1.0) * length <= search.reach.travel;
  };
  return is_near(at.first, of_object) && is_near(at.second, of_scene);
}

/// The same of edges that are not over each other yet, where their lines pass on the side on which
/// the edges may touch: while the lines do, the edges stay apart. Farther edges have planes, which
/// others share: each pair with a row of its own, there would be no room.
bool has_line_row(const RowSearch& search, const PlacedPair& pair, FoundRow& row) noexcept {
  if (pair.distance > kInTheAir * search.reach.travel || !comes_over(search, pair)) return false;
  row = edge_row(search, pair);
  return row.gap > 0.0 && may_keep(search, row.gap, pair.distance);
}

/// Rows of two edges that may touch, where they are.
void consider(RowSearch& search, const PlacedPair& pair, RowScratch& scratch,
              std::vector<FoundRow>& rows) noexcept {
  const EdgeEnds of_object = object_ends(search, pair), of_scene = scene_ends(search, pair);
  if (is_kept_apart(search, of_object, pair.distance, scratch.object, rows)) return;
  if (is_kept_apart(search, of_scene, pair.distance, scratch.scene, rows)) return;
  if (is_met(scratch, {pair.object, pair.scene})) return;  // in another pair of patches
  FoundRow row;
  const bool are_over = has_edge_row(search, pair, row);
  // What presses has a row of its own, which lets the edges roll over each other.
  const bool may_press = are_over && is_known(search, normal_of(search, pair));
  const bool has_row = are_over || has_line_row(search, pair, row);
  const double by_row =
      has_row ? forbidden(search, pair.on_scene(), normal_of(search, pair), row.gap) : kInfinity;
  EdgeGuard best;
  if (!may_press && pair.distance > search.rounding) {
    choose_plane(search, of_object, pair.distance, scratch.object, best);
    choose_plane(search, of_scene, pair.distance, scratch.scene, best);
  }
  // A plane square to the way between edges that are not over each other stands upright beside
  // them, where nothing is: the lines come first, but where that plane is not met.
  const bool is_upright = is_between(best) && best.forbids >= kEqual * search.reach.travel;
  if (has_row && (may_press || by_row < best.forbids || is_upright)) {
    add_row(search, rows, row);
  } else if (best.ends != nullptr) {  // else a vertex on an edge: faces keep it
    const bool is_of_object = best.ends->points_of == PointsOf::object;
    keep_ends(search, best, is_of_object ? scratch.object : scratch.scene, rows);
  }
}

/// Planes that near vertices of the object are kept in front of and the scene's patch lies behind.
void find_planes(const RowSearch& search, std::int32_t patch, RowScratch& scratch) noexcept {
  const SurfaceFeatures& features = *search.scene.features;
  const VertexSide& side = scratch.object;
  const auto vertices = part_of(features.patch_vertices, features.first_vertex, patch);
  auto& planes = scratch.planes;
  planes.clear();
  for (const std::int32_t near : scratch.near_object) {
    for (std::int32_t m = side.first_member[idx(near)]; m >= 0; m = side.members[idx(m)].next) {
      const std::int32_t i = side.members[idx(m)].plane;
      if (std::find(planes.begin(), planes.end(), i) != planes.end()) continue;
      const GuardPlane& plane = side.planes[idx(i)];
      const bool is_behind = std::all_of(vertices.begin(), vertices.end(), [&](std::int32_t v) {
        return plane.height(features.vertices[idx(v)]) <= search.rounding;
      });
      if (is_behind && planes.size() < planes.capacity()) planes.push_back(i);
    }
  }
}

/// One contact's edges.
struct EdgeSearch {
  const Contact& contact;
  Slab slab;  // none: of no axis
  bool has_planes = false;
  std::int32_t object = -1;                   // edge that was looked at last
  bool is_asked = false, is_guarded = false;  // of it, by those planes
};

const Slab& slab_of(const RowSearch& search, EdgeSearch& edges) noexcept {
  if (edges.slab.object_axis.isZero(0.0))
    edges.slab = find_slab(search, edges.contact, search.reach.travel);
  return edges.slab;
}

void find_patch_planes(const RowSearch& search, EdgeSearch& edges, RowScratch& scratch) noexcept {
  if (edges.has_planes) return;
  const Slab& slab = slab_of(search, edges);
  keep_near(*search.object.features, edges.contact.object_patch, slab.object_axis,
            slab.object_least, scratch.near_object);
  find_planes(search, edges.contact.scene_patch, scratch);
  edges.has_planes = true;
}

/// What planes keep from the whole patch. With a list it is asked where two edges are within reach,
/// which few are.
bool is_guarded(const RowSearch& search, const PlacedPair& pair, EdgeSearch& edges,
                RowScratch& scratch) noexcept {
  if (edges.is_asked) return edges.is_guarded;
  find_patch_planes(search, edges, scratch);
  edges.is_asked = true;
  edges.is_guarded = is_guarded_from_patch(search, scratch.object, scratch.planes,
                                           search.object.features->edges[idx(pair.object)],
                                           pair.object_tail, pair.object_head);
  return edges.is_guarded;
}

/// The pairs that may touch: listed, or looked for now.
std::span<const RowScratch::FeaturePair> find_pairs(RowSearch& search, EdgeSearch& edges,
                                                    RowScratch& scratch) noexcept {
  if (const RowScratch::PairList* list = find_list(search, edges.contact, scratch))
    return pairs_of(*list, FeatureKind::edges);
  const Slab& slab = slab_of(search, edges);
  scratch.listed.clear();
  const PairReach reach = exact_reach(search);
  if (!gather_edges(search, edges.contact, slab, reach, scratch)) return {};
  find_patch_planes(search, edges, scratch);
  list_edges(search, edges.contact, slab, reach, scratch.planes, scratch);
  return scratch.listed;
}

void search_pair(RowSearch& search, const RowScratch::FeaturePair& listed, EdgeSearch& edges,
                 RowScratch& scratch, std::vector<FoundRow>& rows) noexcept {
  const SurfaceFeatures &a = *search.object.features, &b = *search.scene.features;
  if (edges.object != listed.of_object) {
    edges.object = listed.of_object;
    edges.is_asked = false;
  } else if (edges.is_asked && edges.is_guarded) {
    return;
  }
  const ConvexEdge &e = a.edges[idx(listed.of_object)], &f = b.edges[idx(listed.of_scene)];
  PlacedPair pair;
  pair.object = listed.of_object;
  pair.scene = listed.of_scene;
  if (!may_touch(search, e, cone_of(f, pair.scene, search.to_object), pair.sign)) return;
  const Vec3& position = search.scene_from_object.position;
  pair.object_tail = search.to_scene * a.vertices[idx(e.tail)] + position;
  pair.object_head = search.to_scene * a.vertices[idx(e.head)] + position;
  if (!place(search, pair) || is_guarded(search, pair, edges, scratch)) return;
  consider(search, pair, scratch, rows);
}

}  // namespace

void search_edges(RowSearch& search, const Contact& contact, const Slab& slab, RowScratch& scratch,
                  std::vector<FoundRow>& rows) noexcept {
  EdgeSearch edges{.contact = contact, .slab = slab};
  const auto pairs = find_pairs(search, edges, scratch);
  if (pairs.empty()) return;
  for (const RowScratch::FeaturePair& pair : pairs) search_pair(search, pair, edges, scratch, rows);
}

}  // namespace thigma::detail
