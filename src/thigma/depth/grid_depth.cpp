// Directional depth on a grid (Sec. 4.4): both fine surfaces become height maps over the common
// domain, along n and against it; the depth is the largest sum of the two. Moved configurations
// reuse what they can (Sec. 4.4.2).
#include <algorithm>

#include "thigma/depth/depth.h"
#include "thigma/depth/detail/grid_refinement.h"
#include "thigma/depth/detail/near_maxima.h"

namespace thigma {
namespace {

using detail::PreparedContact;

class GridDepth final : public DepthBackend {
 public:
  explicit GridDepth(const GridDepthParams& params) : params_(params) {
    params_.resolution = std::clamp(params.resolution, 2, 4096);
  }

  void sample(std::span<const DepthContact> contacts, const DepthRequest& request,
              std::span<DepthSamples> results) noexcept override {
    for (std::size_t i = 0; i < contacts.size(); ++i)
      sample_contact(contacts[i], request, results[i]);
  }

 private:
  void sample_contact(const DepthContact& contact, const DepthRequest& request,
                      DepthSamples& result) noexcept {
    result = DepthSamples{};
    if (!detail::prepare_within_box(contact, prepared_)) return;
    result.frame = prepared_.frame;
    const MapGrid grid{prepared_.box, params_.resolution, params_.resolution};
    render_heights(prepared_.object, grid, reading_of(params_), object_);
    render_heights(prepared_.scene, grid, reading_of(params_), scene_);
    const MapMaximum best = largest_sum(object_, scene_);
    if (best.column < 0) return;
    result.is_found = true;
    detail::climb_to_maximum(params_, prepared_, {object_, scene_, grid}, best, result);
    if (request.near > 0.0) {
      detail::collect_near(object_, scene_, grid, request.near, result);
    } else {
      result.near.push_back({result.at, 1.0});
    }
    if (!request.has_differences) return;
    detail::choose_difference_steps(contact, grid, request, result);
    for (int i = 1; i < kConfigurations; ++i) {
      const float sum = moved_sum(contact, grid, i, result);
      if (sum > kEmptySample) result.depth[static_cast<std::size_t>(i)] = static_cast<double>(sum);
    }
  }

  float moved_sum(const DepthContact& contact, const MapGrid& grid, int configuration,
                  const DepthSamples& result) noexcept {
    if (detail::is_tilted(configuration)) {
      detail::project_moved(contact, configuration_motion(result, contact.centre, configuration),
                            prepared_);
      render_heights(prepared_.object, grid, reading_of(params_), moved_);
    } else {
      move_map(object_, grid, detail::plane_motion(contact, result, configuration), moved_);
    }
    const MapMaximum best = largest_sum(moved_, scene_);
    return best.column >= 0 ? best.sum : 2.0f * kEmptySample;
  }

  GridDepthParams params_;
  PreparedContact prepared_;
  HeightMap object_, scene_, moved_;
};

}  // namespace

std::unique_ptr<DepthBackend> make_grid_depth(const GridDepthParams& params) {
  return std::make_unique<GridDepth>(params);
}

}  // namespace thigma
