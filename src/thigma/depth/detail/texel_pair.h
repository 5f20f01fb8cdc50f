#pragma once
// Two projected triangles of the two sides of a contact, and the texels of one of them as places to
// look for the depth.

#include <array>

#include "thigma/depth/detail/prepared_contact.h"

namespace thigma::detail {

/// Cells of a pyramid level of the driver's texture.
struct TexelCell {
  int level = 1;  // cells of 2^level texels
  int column = 0, row = 0;
};

/// Everything affine between a triangle whose texels are tried, the driver, and one of the other
/// side.
struct TexelPair {
  const ProjectedPatch* driver = nullptr;
  const ProjectedPatch* other = nullptr;
  std::int32_t driver_triangle = -1, other_triangle = -1;  // of the coarse surfaces
  const ProjectedTriangle* under = nullptr;                // the other side's
  // what displacements add to the sum of heights, times them, where the other side's coarse point
  // is the one below the fine point
  Vec3 own_by = Vec3::Zero(), others_by = Vec3::Zero();
  // coarse point of the plane at driver texel t: at_origin + at_by_texel t [m]
  Vec2 at_origin = Vec2::Zero();
  Mat2 at_by_texel = Mat2::Zero();
  Vec2 other_origin = Vec2::Zero();  // texture coordinates of the other side there
  Mat2 other_by_texel = Mat2::Zero();
  Vec2 other_reach = Vec2::Zero();  // a step of up to a texel along both axes moves them by no more
  // by which both displacements may move them sideways
  Vec2 other_low = Vec2::Zero(), other_high = Vec2::Zero();
  double height_origin = 0.0;  // coarse heights of both, summed [m]
  Vec2 height_by_texel = Vec2::Zero();
  double height_reach = 0.0;  // of such a step [m]
  // texels t with normal . t + offset >= 0 lie inside; of the other side and the box at most so
  // much before displacements move them
  struct Limit {
    double slack = 0.0;
    Vec2 normal = Vec2::Zero();
    double offset = 0.0;
    double reach = 0.0;  // of such a step
  };
  std::array<Limit, 10> limits;  // of both triangles, as barycentric coordinates, and of the box
  int limit_count = 0;
  int own_count = 0;                             // the first of them, of the driver's own triangle
  PlaneBox box;                                  // of the contact, of fine points
  Vec2 low = Vec2::Zero(), high = Vec2::Zero();  // box of texels [texels]; empty when low > high
};

/// A triangle of a patch.
struct PatchTriangle {
  const ProjectedPatch& patch;
  const ProjectedTriangle& triangle;
};

/// Couples two triangles. is_bounded: the box of the contact cuts the patches.
TexelPair make_texel_pair(const PatchTriangle& driver, const PatchTriangle& other,
                          const PlaneBox& box, bool is_bounded) noexcept;

/// Bound of the depths in a cell [m].
struct CellBound {
  double depth = kNoDepth;  // no depth at a texel of the cell is larger
  double others =
      // no displacement of the other side under the cell is larger along its facing direction
      kNoDepth;
};

/// Bounds a cell.
///
/// others   of a cell around it, or infinite
/// floor    depths up to this do not matter [m]
/// returns  kNoDepth when no texel of the cell lies in the domain, or none can be above the floor
CellBound upper_bound(const TexelPair& pair, const TexelCell& cell, double others,
                      double floor) noexcept;

/// Depth at the fine point of a texel of the driver [m], and where that lies; heights of the other
/// side interpolated, what it displaces sideways followed back. kNoDepth outside the domain.
struct TexelDepth {
  double depth = kNoDepth;
  Vec2 at = Vec2::Zero();  // [m; contact plane]
};
TexelDepth depth_at_texel(const TexelPair& pair, int column, int row) noexcept;

/// The texels that a cell is answerable for: its own, without those of the next cells.
struct TexelRange {
  int first_column = 0, last_column = -1, first_row = 0, last_row = -1;
};
TexelRange texels_of(const HapticTexture& texture, const TexelCell& cell) noexcept;

}  // namespace thigma::detail
