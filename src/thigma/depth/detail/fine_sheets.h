#pragma once
// The depth where a fine surface is no height field: of the displaced texels themselves, whatever
// they lie on.

#include "thigma/depth/detail/prepared_contact.h"

namespace thigma::detail {

/// Height of the outermost sheet of a patch's fine surface over a point of the plane, along the
/// facing direction [m]: of the bilinear facets that face the right way, of all its triangles,
/// those seen edge-on among them, and of those around that are not. kNoSurface where neither a
/// fine point of `triangles` nor a coarse one lies over the point.
/// Thread   [contact]; no failure. A facet is found to 1e-9 of its side.
double sheet_height(const ProjectedPatch& patch, const Vec2& at) noexcept;

/// Says whether both sides are height fields at the deepest place. Where they are not, the depth
/// and its place become those of all sheets: the highest of samples within 1.5 times a spacing
/// about it, and what is climbed to from there, unless that is beyond the ends of the patches.
///
/// spacing  of the samples that found the place [m]
/// Thread   [contact]; no failure, allocates nothing.
void settle_height_field(const PreparedContact& prepared, const Vec2& spacing,
                         DepthSamples& result) noexcept;

}  // namespace thigma::detail
