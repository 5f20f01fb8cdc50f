#pragma once
// What may touch of two patches, listed for somewhat more travel than is asked for, and looked at
// again until the patches have moved by as much.

#include <cstdint>
#include <span>

#include "thigma/constraint/detail/row_search.h"

namespace thigma::detail {

/// What a list holds, in this order.
enum class FeatureKind : std::uint8_t { object_vertices, scene_vertices, edges };

/// How far features are listed.
struct PairReach {
  double travel = 0.0;   // [m]
  double slack = 0.0;    // sine by which a cone of normals may be wider
  bool is_kept = false;  // the list outlives the call: all that can be told before is
};

/// Of what is asked for now.
PairReach exact_reach(const RowSearch& search) noexcept;

/// Begins a call for so many contacts. A list takes as long as some searches, so that some are made
/// in a call and the others in the next ones.
void begin_lists(std::size_t contacts, RowScratch& scratch) noexcept;

/// The list of a pair of patches, made where there is none that holds; nullptr without room, where
/// more may touch than a list has room for, where enough have been made in this call, and where the
/// object goes so fast that it would not hold for some frames. Thread [contact]; no failure.
const RowScratch::PairList* keep_list(RowSearch& search, const Contact& contact,
                                      RowScratch& scratch) noexcept;

/// The list of a pair of patches that keep_list has found in this call, unless another took its
/// place. Thread [contact]; no failure.
const RowScratch::PairList* find_list(const RowSearch& search, const Contact& contact,
                                      const RowScratch& scratch) noexcept;

/// What a list has of a kind.
std::span<const RowScratch::FeaturePair> pairs_of(const RowScratch::PairList& list,
                                                  FeatureKind kind) noexcept;

/// Appends the vertices of either patch that may touch triangles of the other, in the order of the
/// triangles. What does not fit is counted.
void list_vertices(RowSearch& search, FeatureKind kind, const Contact& contact, const Slab& slab,
                   const PairReach& reach, RowScratch& scratch) noexcept;

/// Edges of the scene's patch that the object's may reach, into near_edges and near_cones; whether
/// there are any.
bool gather_edges(const RowSearch& search, const Contact& contact, const Slab& slab,
                  const PairReach& reach, RowScratch& scratch) noexcept;

/// Appends those pairs of the object's edges and the gathered ones that may touch, in the order of
/// the object's; none of an edge that a plane keeps from the whole patch of the scene. What does
/// not fit is counted.
///
/// planes  of the object's vertices, that the scene's patch lies behind
void list_edges(RowSearch& search, const Contact& contact, const Slab& slab, const PairReach& reach,
                std::span<const std::int32_t> planes, RowScratch& scratch) noexcept;

}  // namespace thigma::detail
