#pragma once
// Every parameter that levels of detail are built with: the key of a kept asset follows this list.
// The bindings name all members of a struct, so that a new one does not compile until it is here.

#include "thigma/scene/asset_cache.h"

namespace thigma::detail {

template <class Visit>
void visit_decomposition(const DecompositionParams& params, Visit&& visit) {
  const auto& [max_vertices, convexity_tolerance, protrusion_tolerance] = params;
  visit("max_vertices", max_vertices);
  visit("convexity_tolerance", convexity_tolerance);
  visit("protrusion_tolerance", protrusion_tolerance);
}

template <class Visit>
void visit_collapse(const CollapseParams& params, Visit&& visit) {
  const auto& [bisections, least_quality, free_to_turn, is_relaxed, keeps_volume,
               seeks_convex_start, guards_original] = params;
  visit("bisections", bisections);
  visit("least_quality", least_quality);
  visit("free_to_turn", free_to_turn);
  visit("is_relaxed", is_relaxed);
  visit("keeps_volume", keeps_volume);
  visit("seeks_convex_start", seeks_convex_start);
  visit("guards_original", guards_original);
}

template <class Visit>
void visit_simplify(const SimplifyParams& params, Visit&& visit) {
  const auto& [longest_edge, coarsest_share, longest_edge_ever, deviation_limit, deviation_early,
               deviation_share, deviation_ever, volume_limit, convexity_tolerance,
               protrusion_tolerance, last_level, flips_edges, collapse, progress] = params;
  static_cast<void>(progress);  // changes nothing of what is built
  visit("longest_edge", longest_edge);
  visit("coarsest_share", coarsest_share);
  visit("longest_edge_ever", longest_edge_ever);
  visit("deviation_limit", deviation_limit);
  visit("deviation_early", deviation_early);
  visit("deviation_share", deviation_share);
  visit("deviation_ever", deviation_ever);
  visit("volume_limit", volume_limit);
  visit("convexity_tolerance of levels", convexity_tolerance);
  visit("protrusion_tolerance of levels", protrusion_tolerance);
  visit("last_level", last_level);
  visit("flips_edges", flips_edges);
  visit_collapse(collapse, visit);
}

/// Calls visit(name, number) for all of it.
template <class Visit>
void visit_build_fields(const ClodSource& source, Visit&& visit) {
  const auto& [decomposition, simplify, contact_tolerance, threads, is_reparented,
               has_culling_hulls] = source.params;
  static_cast<void>(threads);  // the same bits on any number
  visit("repair", source.is_repair);
  visit_decomposition(decomposition, visit);
  visit_simplify(simplify, visit);
  visit("contact_tolerance", contact_tolerance);
  visit("contact_tolerance in units",
        source.contact_tolerance ? *source.contact_tolerance / source.scale : -1.0);
  visit("is_reparented", is_reparented);
  visit("has_culling_hulls", has_culling_hulls);
}

}  // namespace thigma::detail
