#pragma once
// Every number of an asset by name and dimension: files, scaling and checks all go by these lists.
// A field that is added to hierarchy.h is one line here and one in docs/formats.md.

#include <concepts>
#include <type_traits>

#include "thigma/clod/clod_asset.h"

namespace thigma::detail {

/// Power of length a number scales with.
enum class Dimension : int {
  per_length = -1,
  none = 0,
  length = 1,
  area = 2,
  volume = 3,
  inertia = 5
};

/// Whether infinity is a value of a number.
enum class Range : bool { finite, infinite };

template <class T, class Plain>
concept Like = std::same_as<std::remove_const_t<T>, Plain>;

/// Calls visit(name, field, dimension = none, range = finite) for every field of a record, in the
/// order of the file.
template <class V>
void visit_fields(Like<ClodNode> auto& n, V&& visit) {
  visit("center", n.center, Dimension::length);
  visit("radius", n.radius, Dimension::length);
  visit("hausdorff", n.hausdorff, Dimension::length);
  visit("first_child", n.first_child);
  visit("child_count", n.child_count);
  visit("level", n.level);
  visit("patch", n.patch);
  visit("contact", n.contact);
  visit("first_vertex", n.first_vertex);
  visit("vertex_count", n.vertex_count);
  visit("first_lane", n.first_lane);
  visit("lane_count", n.lane_count);
}

template <class V>
void visit_fields(Like<ClodPatch> auto& p, V&& visit) {
  visit("node", p.node);
  visit("first_triangle", p.first_triangle);
  visit("triangle_count", p.triangle_count);
  visit("first_face", p.first_face);
  visit("face_count", p.face_count);
  visit("first_edge", p.first_edge);
  visit("edge_count", p.edge_count);
  visit("thickness", p.thickness, Dimension::length, Range::infinite);
}

template <class V>
void visit_fields(Like<LevelPatch> auto& c, V&& visit) {
  visit_fields(c.patch, visit);
  visit("level", c.level);
  visit("first_vertex", c.first_vertex);
  visit("vertex_count", c.vertex_count);
  visit("first_lane", c.first_lane);
  visit("lane_count", c.lane_count);
  visit("center", c.center, Dimension::length);
  visit("radius", c.radius, Dimension::length);
  visit("deviation", c.deviation, Dimension::length);
  visit("hausdorff", c.hausdorff, Dimension::length);
  visit("from_below", c.from_below, Dimension::length);
  visit("to_below", c.to_below, Dimension::length);
}

template <class V>
void visit_fields(Like<ClodLevel> auto& l, V&& visit) {
  visit("is_free", l.is_free);
  visit("node_count", l.node_count);
  visit("hausdorff_max", l.hausdorff_max, Dimension::length);
  visit("triangle_count", l.triangle_count);
  visit("patch_count", l.patch_count);
  visit("resolution", l.resolution, Dimension::per_length, Range::infinite);
  visit("deviation_max", l.deviation_max, Dimension::length);
  visit("contact_hausdorff_max", l.contact_hausdorff_max, Dimension::length);
}

template <class V>
void visit_fields(Like<RealFace> auto& f, V&& visit) {
  visit("normal", f.normal);
  visit("offset", f.offset, Dimension::length);
  visit("vertices", f.vertices);
}

template <class V>
void visit_fields(Like<RealEdge> auto& e, V&& visit) {
  visit("tail", e.tail);
  visit("head", e.head);
  visit("face_left", e.face_left);
  visit("face_right", e.face_right);
  visit("beyond", e.beyond);
}

template <class V>
void visit_fields(Like<HullTriangle> auto& t, V&& visit) {
  visit("corner", t.corner);
  visit("mask", t.mask);
}

template <class V>
void visit_fields(Like<ClodMass> auto& m, V&& visit) {
  visit("is_closed", m.is_closed);
  visit("area", m.measure.area, Dimension::area);
  visit("volume", m.measure.volume, Dimension::volume);
  visit("center_of_mass", m.measure.center_of_mass, Dimension::length);
  visit("inertia", m.measure.inertia, Dimension::inertia);
}

template <class V>
void visit_fields(Like<ClodOrigin> auto& o, V&& visit) {
  visit("source", o.source);
  visit("key", o.key);
  visit("unit_scale", o.unit_scale, Dimension::length);
  visit("is_repaired", o.is_repaired);
  visit("contact_tolerance", o.contact_tolerance);
  visit("longest_edge", o.longest_edge);
  visit("deviation_limit", o.deviation_limit);
  visit("convexity_tolerance", o.convexity_tolerance);
  visit("protrusion_tolerance", o.protrusion_tolerance);
  visit("max_vertices", o.max_vertices);
  visit("is_reparented", o.is_reparented);
  visit("has_culling_hulls", o.has_culling_hulls);
}

/// The numbers of a hierarchy that are no arrays.
template <class V>
void visit_fields(Like<ClodHierarchy> auto& h, V&& visit) {
  visit("radius", h.radius, Dimension::length);
  visit("center", h.center, Dimension::length);
  visit("triangle_count", h.triangle_count);
}

/// Calls visit.record(chunk, record), visit.records(chunk, vector of records) or
/// visit.numbers(chunk, vector of numbers, dimension) for each part of a hierarchy, in the order of
/// the file.
template <class V>
void visit_parts(Like<ClodHierarchy> auto& h, V&& visit) {
  visit.record("object", h);
  visit.records("levels", h.levels);
  visit.records("nodes", h.nodes);
  visit.records("patches", h.patches);
  visit.records("contact_patches", h.level_patches);
  visit.numbers("vertices", h.vertices, Dimension::length);
  visit.numbers("vertex_to_below", h.vertex_to_below, Dimension::length);
  visit.numbers("support", h.support, Dimension::area);
  visit.numbers("lanes", h.lanes, Dimension::none);  // follow from vertices and centres
  visit.records("faces", h.faces);
  visit.records("edges", h.edges);
  visit.records("hull_triangles", h.hull_triangles);
  visit.numbers("tri_to_below", h.triangle_to_below, Dimension::length);
  visit.numbers("triangle_ids", h.triangle_ids, Dimension::none);
}

/// Single precision copies of hull vertices about the centres of their hulls, in the place they
/// have.
void refresh_lanes(ClodHierarchy& hierarchy);

}  // namespace thigma::detail
