#pragma once
// What a depth on a grid does before and after its height maps, wherever these are rendered.

#include "thigma/depth/detail/prepared_contact.h"

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

/// Sets depth[0] and where it is: the best sample, or if asked for the deepest place that is
/// climbed to. The highest peak may lie between samples that are not the highest: the most
/// promising summits are sampled more finely, and climbed from while they may be higher than what
/// is found.
///
/// object, scene  the maps as they are; not looked at where nothing is climbed to
/// rounding       of a depth that is not climbed to
void finish_depth(const GridDepthParams& params, PreparedContact& prepared, const HeightMap& object,
                  const HeightMap& scene, const MapGrid& grid, const MapMaximum& best,
                  const DepthRounding& rounding, DepthSamples& result) noexcept;

}  // namespace thigma::detail
