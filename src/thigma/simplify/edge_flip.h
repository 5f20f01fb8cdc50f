#pragma once
// Flips of reflex edges, where no more can collapse: patches merge over the convex diagonal.

#include <array>
#include <cstdint>
#include <vector>

#include "thigma/simplify/filtered_edge_collapse.h"

namespace thigma {

/// Why an edge stayed, in the order in which it is asked.
enum class FlipOutcome : std::uint8_t {
  flipped,
  topology,      // the surface would change its kind, or a seam runs along the edge
  quality,       // a triangle would turn over, become a sliver or be folded
  deviation,     // too far from the original surface
  volume,        // the object would gain too much
  intersection,  // the surface would cross itself
  protrusion,    // a hull would be entered
  // neither fewer patches nor, with as many, fewer reflex edges or a volume nearer to the
  // original's
  gain,
  convex,  // nothing to flip: not a reflex edge between two patches
};
inline constexpr std::size_t kFlipOutcomes = 9;

/// Tries to flip the reflex edge between two patches; a refused attempt leaves everything as it
/// was.
///
/// Two triangles about a reflex edge are always of two patches; about the other diagonal, which is
/// convex, they are one. What is left of the two patches, and the new one, merge with each other
/// and with their neighbours as far as unions are convex. The tests are those of a collapse.
///
/// context.scratch.search.limit  deviation the new triangles may have [m]
/// successor            of each patch: entries of patches that vanish are set to one that took
///                      their place
/// returns              flipped, or why not
/// Thread               [offline]; deterministic.
FlipOutcome flip_reflex_edge(PatchedSurface& surface, CollapseContext& context,
                             std::int32_t halfedge, std::vector<std::int32_t>& successor);

/// Goes over all edges, a few times at most, until none flips any more.
///
/// limit      of the deviation, by the length of an edge
/// outcomes   counts are added
/// returns    how many edges flipped
/// Thread     [offline]; deterministic. Source: none (docs/deviations.md).
std::int64_t flip_reflex_edges(PatchedSurface& surface, CollapseContext& context,
                               const detail::DeviationLimit& limit,
                               std::vector<std::int32_t>& successor,
                               std::array<std::int64_t, kFlipOutcomes>& outcomes);

}  // namespace thigma
