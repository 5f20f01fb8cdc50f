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
  const auto& [bisections, least_quality, sliver_quality] = params;
  visit("bisections", bisections);
  visit("least_quality", least_quality);
  visit("sliver_quality", sliver_quality);
}

template <class Visit>
void visit_simplify(const SimplifyParams& params, Visit&& visit) {
  const auto& [stages, coarsest_share, deviation_limit, deviation_early, farthest_deviation,
               volume_limit, convexity_tolerance, protrusion_tolerance, last_level_share, collapse,
               threads, progress] = params;
  static_cast<void>(threads);   // the same bits on any number
  static_cast<void>(progress);  // changes nothing of what is built
  for (const SimplifyStage& stage : stages) {
    const auto& [longest_edge, deviation_share] = stage;
    visit("longest_edge", longest_edge);
    visit("deviation_share", deviation_share);
  }
  visit("coarsest_share", coarsest_share);
  visit("deviation_limit", deviation_limit);
  visit("deviation_early", deviation_early);
  visit("farthest_deviation", farthest_deviation);
  visit("volume_limit", volume_limit);
  visit("convexity_tolerance of levels", convexity_tolerance);
  visit("protrusion_tolerance of levels", protrusion_tolerance);
  visit("last_level_share", last_level_share);
  visit_collapse(collapse, visit);
}

/// Calls visit(name, number) for all of it.
template <class Visit>
void visit_build_fields(const ClodSource& source, Visit&& visit) {
  const auto& [decomposition, simplify, contact_tolerance, threads, has_culling_hulls] =
      source.params;
  static_cast<void>(threads);  // the same bits on any number
  visit("repair", source.is_repair);
  visit_decomposition(decomposition, visit);
  visit_simplify(simplify, visit);
  visit("contact_tolerance", contact_tolerance);
  visit("contact_tolerance in units",
        source.contact_tolerance ? *source.contact_tolerance / source.scale : -1.0);
  visit("has_culling_hulls", has_culling_hulls);
}

}  // namespace thigma::detail
