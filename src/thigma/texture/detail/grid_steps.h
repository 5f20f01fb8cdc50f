#pragma once
// What a depth on a grid does before and after its height maps, wherever these are rendered.

#include "thigma/texture/detail/prepared_contact.h"

namespace thigma::detail {

/// Depths rounded to 16 bits over their range, or not at all.
struct DepthRounding {
  double least = 0.0, quantum = 0.0;  // [m]; quantum 0: not rounded
  double rounded(float sum) const noexcept;
};

/// The rounding of depths between the least and the largest sum of a contact's maps.
DepthRounding depth_rounding(const GridDepthParams& params, float least, float largest) noexcept;

/// Sets the steps of the moved configurations.
void choose_steps(const DepthContact& contact, const MapGrid& grid, const DepthRequest& request,
                  DepthSamples& result) noexcept;

/// Whether a configuration leaves the plane, so that the object's map has to be rendered anew.
constexpr bool is_tilted(int configuration) noexcept {
  return configuration >= 5 && configuration <= 8;
}

/// The motion within the plane of any other configuration.
PlaneMotion plane_motion(const DepthContact& contact, const DepthSamples& result,
                         int configuration) noexcept;

/// Sets depth[0] and where it is from the best sample: climbed from if asked for.
void finish_depth(const GridDepthParams& params, const PreparedContact& prepared,
                  const MapGrid& grid, const MapMaximum& best, const DepthRounding& rounding,
                  DepthSamples& result) noexcept;

/// Climbs from summits of other parts of the grid, too, as the highest peak may lie between samples that are not the
/// highest; when one is higher than depth[0] it takes its place. object, scene: the maps as they are
void try_rivals(const PreparedContact& prepared, const HeightMap& object, const HeightMap& scene,
               const MapGrid& grid, const MapMaximum& best, DepthSamples& result) noexcept;

}  // namespace thigma::detail
