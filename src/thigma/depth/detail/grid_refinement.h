#pragma once
// What a depth on a grid does before and after its height maps, wherever these are rendered.

#include "thigma/depth/detail/prepared_contact.h"

namespace thigma::detail {

/// Sets the steps of the moved configurations.
void choose_difference_steps(const DepthContact& contact, const MapGrid& grid,
                             const DepthRequest& request, DepthSamples& result) noexcept;

/// Whether a configuration leaves the plane, so that the object's map has to be rendered anew.
constexpr bool is_tilted(int configuration) noexcept {
  return configuration >= 5 && configuration <= 8;
}

/// The motion within the plane of any other configuration.
PlaneMotion plane_motion(const DepthContact& contact, const DepthSamples& result,
                         int configuration) noexcept;

/// The maps of both sides of a contact, as they are.
struct RenderedMaps {
  const HeightMap& object;
  const HeightMap& scene;
  const MapGrid& grid;
};

/// Sets depth[0], where it is, and whether the sides are height fields there: the best sample, or
/// if asked for the deepest place that is climbed to. The highest peak may lie between samples that
/// are not the highest: the most promising summits are sampled more finely, and climbed from while
/// they may be higher than what is found. So are places along the ends of the patches. Where the
/// sides are no height fields their sheets are searched.
///
/// maps  heights are not looked at where nothing is climbed to
/// best  sample of the sum of the maps
void climb_to_maximum(const GridDepthParams& params, PreparedContact& prepared,
                      const RenderedMaps& maps, const MapMaximum& best,
                      DepthSamples& result) noexcept;

}  // namespace thigma::detail
