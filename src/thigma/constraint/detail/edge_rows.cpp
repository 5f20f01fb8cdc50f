// Convex edges against convex edges.

#include <algorithm>
#include <cmath>

#include "thigma/constraint/detail/feature_distance.h"
#include "thigma/constraint/detail/row_search.h"
#include "thigma/core/index.h"

namespace thigma::detail {
namespace {

using EdgePair = RowScratch::EdgePair;

// Edges more nearly parallel than this touch along a line: its ends are vertices on faces.
constexpr double kParallel = 1e-6;

/// Two edges where they are, in the frame of the scene's mesh.
struct PlacedPair {
  std::int32_t object = -1, scene = -1;  // edges
  int sign = 1;  // of the object's direction x the scene's, to point into the scene
  Vec3 object_tail, object_head, scene_tail, scene_head;
  NearestOnSegments nearest;
  double distance = 0.0;

  Vec3 on_object() const noexcept {
    return object_tail + nearest.first * (object_head - object_tail);
  }
  Vec3 on_scene() const noexcept { return scene_tail + nearest.second * (scene_head - scene_tail); }
};

/// Whether the edges may be the first to touch, by their cones of normals but for what turning may
/// do; then the sign of the object's direction x the scene's.
bool may_touch(const RowSearch& search, const ConvexEdge& e, const RowScratch::EdgeCone& f,
               int& sign) noexcept {
  const Vec3 cross = e.direction.cross(f.direction);
  const double sine = cross.norm();
  if (sine < kParallel) return false;
  // Turning by an angle turns the normal by that and by as much over the sine.
  const double slack = search.cone_slack * (1.0 + sine);
  const double out_left = cross.dot(e.into_left), out_right = cross.dot(e.into_right);
  const double in_left = cross.dot(f.into_left), in_right = cross.dot(f.into_right);
  const bool plus =
      out_left <= slack && out_right <= slack && in_left >= -slack && in_right >= -slack;
  const bool minus =
      out_left >= -slack && out_right >= -slack && in_left <= slack && in_right <= slack;
  // Where turning may make either true: the sign that points out of the one and into the other.
  const auto points_out = [&] {
    const Vec3& outward = search.scene.features->edges[idx(f.edge)].outward;
    return cross.dot(e.outward - search.object_from_scene.orientation._transformVector(outward)) >=
           0.0;
  };
  sign = plus && (!minus || points_out()) ? 1 : -1;
  return plus || minus;
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

/// One edge's ends with the planes that keep them, and the other edge in the frame of the planes.
struct Ends {
  PointsOf points_of;
  std::int32_t tail, head;
  Vec3 at_tail, at_head, other_tail, other_head;
};

bool is_kept(const RowSearch& search, const VertexSide& side, std::int32_t vertex,
             std::int32_t plane, double height) noexcept {
  return height > search.reach.travel || is_member(side, vertex, plane);
}

/// Whether a plane has the other edge behind it and keeps both ends, or may: an end that a plane
/// leaves enough of the edges' distance is given a row.
bool is_guarded(RowSearch& search, const Ends& ends, double distance, VertexSide& side,
                std::vector<FoundRow>& rows) noexcept {
  for (std::size_t i = 0; i < side.planes.size(); ++i) {
    const GuardPlane plane = side.planes[i];
    const double tail = plane.height(ends.at_tail), head = plane.height(ends.at_head);
    const auto index = static_cast<std::int32_t>(i);
    const bool keeps_tail = is_kept(search, side, ends.tail, index, tail);
    const bool keeps_head = is_kept(search, side, ends.head, index, head);
    if (!keeps_tail && !leaves_enough(search, tail, distance)) continue;
    if (!keeps_head && !leaves_enough(search, head, distance)) continue;
    if (plane.height(ends.other_tail) > search.rounding ||
        plane.height(ends.other_head) > search.rounding)
      continue;
    if (!keeps_tail) add_member(search, ends.points_of, ends.tail, index, side, rows);
    if (!keeps_head) add_member(search, ends.points_of, ends.head, index, side, rows);
    return true;
  }
  return false;
}

Ends object_ends(const RowSearch& search, const PlacedPair& pair) noexcept {
  const ConvexEdge& e = search.object.features->edges[idx(pair.object)];
  return {PointsOf::object, e.tail,          e.head,         pair.object_tail,
          pair.object_head, pair.scene_tail, pair.scene_head};
}

Ends scene_ends(const RowSearch& search, const PlacedPair& pair) noexcept {
  const ConvexEdge& e = search.object.features->edges[idx(pair.object)];
  const ConvexEdge& f = search.scene.features->edges[idx(pair.scene)];
  const std::vector<Vec3>& a = search.object.features->vertices;
  return {PointsOf::scene,
          f.tail,
          f.head,
          transform_point(search.object_from_scene, pair.scene_tail),
          transform_point(search.object_from_scene, pair.scene_head),
          a[idx(e.tail)],
          a[idx(e.head)]};
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
  const Vec3 u = search.scene_from_object.orientation._transformVector(row.object_direction);
  found.gap = u.cross(f.direction).normalized().dot(pair.scene_tail - pair.object_tail);
  return found;
}

/// Edges whose nearest points are not both inside: a plane through the nearest point of the one,
/// square to the line between them, and both ends of the other in front of it.
void add_end_plane(RowSearch& search, const PlacedPair& pair, RowScratch& scratch,
                   std::vector<FoundRow>& rows) noexcept {
  if (pair.distance <= search.rounding) return;  // a vertex on an edge: faces keep it
  const Vec3 normal = (pair.on_scene() - pair.on_object()) / pair.distance;
  const bool is_scene_end = pair.nearest.second <= 0.0 || pair.nearest.second >= 1.0;
  VertexSide& side = is_scene_end ? scratch.scene : scratch.object;
  if (side.planes.size() == side.planes.capacity()) {
    ++search.left_out;
    return;
  }
  GuardPlane plane;
  if (is_scene_end) {
    plane.normal = search.object_from_scene.orientation._transformVector(normal);
    plane.offset = plane.normal.dot(transform_point(search.object_from_scene, pair.on_object()));
    plane.feature = ~pair.object;
  } else {
    plane.normal = -normal;
    plane.offset = plane.normal.dot(pair.on_scene());
    plane.feature = ~pair.scene;
  }
  side.planes.push_back(plane);
  const auto index = static_cast<std::int32_t>(side.planes.size()) - 1;
  const Ends ends = is_scene_end ? scene_ends(search, pair) : object_ends(search, pair);
  if (plane.height(ends.at_tail) <= search.reach.travel)
    add_member(search, ends.points_of, ends.tail, index, side, rows);
  if (plane.height(ends.at_head) <= search.reach.travel)
    add_member(search, ends.points_of, ends.head, index, side, rows);
}

bool is_met(RowScratch& scratch, const EdgePair& pair) noexcept {
  const auto place = std::lower_bound(scratch.met.begin(), scratch.met.end(), pair);
  if (place != scratch.met.end() && *place == pair) return true;
  if (scratch.met.size() < scratch.met.capacity()) scratch.met.insert(place, pair);
  return false;
}

/// Rows of two edges of which `pair` has the object's where it is.
void consider(RowSearch& search, PlacedPair pair, const RowScratch::EdgeCone& f,
              RowScratch& scratch, std::vector<FoundRow>& rows) noexcept {
  const ConvexEdge& e = search.object.features->edges[idx(pair.object)];
  if (!may_touch(search, e, f, pair.sign)) return;
  pair.scene = f.edge;
  if (!place(search, pair)) return;
  if (is_guarded(search, object_ends(search, pair), pair.distance, scratch.object, rows)) return;
  if (is_guarded(search, scene_ends(search, pair), pair.distance, scratch.scene, rows)) return;
  if (is_met(scratch, {pair.object, pair.scene})) return;  // in another pair of patches
  const auto is_inside = [](double share) { return share > 0.0 && share < 1.0; };
  if (is_inside(pair.nearest.first) && is_inside(pair.nearest.second)) {
    const FoundRow row = edge_row(search, pair);
    // On the wrong side: through each other by an error of the last steps, or beside each other and
    // only able to touch once they have turned. Then what is apart stays apart.
    if (row.gap >= -kError * search.reach.travel) {
      add_row(search, rows, row);
      return;
    }
  }
  add_end_plane(search, pair, scratch, rows);
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

/// Whether an edge is within reach of a ball.
bool is_in_reach(const Vec3& middle, double half, const PatchBall& ball, double travel) noexcept {
  const double balls = half + ball.radius + travel;
  return (middle - ball.center).squaredNorm() <= balls * balls;
}

/// Whether one plane that the whole other patch lies behind keeps both ends of an edge.
bool is_guarded_from_patch(const RowSearch& search, const VertexSide& side,
                           std::span<const std::int32_t> planes, const ConvexEdge& edge,
                           const Vec3& tail, const Vec3& head) noexcept {
  for (const std::int32_t i : planes) {
    const GuardPlane& plane = side.planes[idx(i)];
    if (is_kept(search, side, edge.tail, i, plane.height(tail)) &&
        is_kept(search, side, edge.head, i, plane.height(head)))
      return true;
  }
  return false;
}

/// Edges of the scene's patch that the object's may reach.
void gather_edges(const RowSearch& search, const Contact& contact, const Slab& slab,
                  RowScratch& scratch) noexcept {
  const SurfaceFeatures& b = *search.scene.features;
  PatchBall of_a = search.object.features->patch_balls[idx(contact.object_patch)];
  of_a.center = transform_point(search.scene_from_object, of_a.center);
  const Mat3 rotation = search.object_from_scene.orientation.toRotationMatrix();
  scratch.near_edges.clear();
  scratch.near_cones.clear();
  for (const std::int32_t k : part_of(b.patch_edges, b.first_edge, contact.scene_patch)) {
    const ConvexEdge& f = b.edges[idx(k)];
    if (!is_in_reach(f.middle, f.half, of_a, search.reach.travel)) continue;
    const double least = std::min(slab.scene_axis.dot(b.vertices[idx(f.tail)]),
                                  slab.scene_axis.dot(b.vertices[idx(f.head)]));
    if (least > slab.scene_most || scratch.near_edges.size() == scratch.near_edges.capacity())
      continue;
    scratch.near_edges.push_back({f.middle, f.half, least});
    scratch.near_cones.push_back(
        {k, rotation * f.direction, rotation * f.into_left, rotation * f.into_right});
  }
}

}  // namespace

void search_edges(RowSearch& search, const Contact& contact, const Slab& slab, RowScratch& scratch,
                  std::vector<FoundRow>& rows) noexcept {
  const SurfaceFeatures& a = *search.object.features;
  gather_edges(search, contact, slab, scratch);
  if (scratch.near_edges.empty()) return;
  keep_near(a, contact.object_patch, slab.object_axis, slab.object_least, scratch.near_object);
  find_planes(search, contact.scene_patch, scratch);
  const double travel = search.reach.travel;
  const PatchBall& of_b = search.scene.features->patch_balls[idx(contact.scene_patch)];
  const Mat3 rotation = search.scene_from_object.orientation.toRotationMatrix();
  const double object_least =
      slab.object_least + slab.scene_axis.dot(search.scene_from_object.position);
  const auto placed = [&](const Vec3& point) -> Vec3 {
    return rotation * point + search.scene_from_object.position;
  };
  for (const std::int32_t i : part_of(a.patch_edges, a.first_edge, contact.object_patch)) {
    const ConvexEdge& e = a.edges[idx(i)];
    const Vec3 middle = placed(e.middle);
    if (!is_in_reach(middle, e.half, of_b, travel)) continue;
    PlacedPair pair;
    pair.object = i;
    pair.object_tail = placed(a.vertices[idx(e.tail)]);
    pair.object_head = placed(a.vertices[idx(e.head)]);
    const double front =
        std::max(slab.scene_axis.dot(pair.object_tail), slab.scene_axis.dot(pair.object_head));
    if (front < object_least) continue;
    if (is_guarded_from_patch(search, scratch.object, scratch.planes, e, pair.object_tail,
                              pair.object_head))
      continue;
    const double reach = e.half + travel;
    for (std::size_t k = 0; k < scratch.near_edges.size(); ++k) {
      const RowScratch::NearEdge& f = scratch.near_edges[k];
      const double balls = reach + f.half;
      if (f.least > front + travel || (middle - f.middle).squaredNorm() > balls * balls) continue;
      consider(search, pair, scratch.near_cones[k], scratch, rows);
    }
  }
}

}  // namespace thigma::detail
