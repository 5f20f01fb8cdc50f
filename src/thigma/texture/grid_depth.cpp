// Directional depth on a grid (Sec. 4.4): both fine surfaces become height maps over the common domain, along n and
// against it; the depth is the largest sum of the two. Moved configurations reuse what they can (Sec. 4.4.2).
#include <algorithm>
#include <cmath>

#include "thigma/texture/depth.h"
#include "thigma/texture/detail/near_maxima.h"
#include "thigma/texture/detail/prepared_contact.h"

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
    if (!detail::prepare_contact(contact, prepared_)) return;
    result.frame = prepared_.frame;
    grid_ = {prepared_.box, params_.resolution, params_.resolution};
    render_heights(prepared_.object, grid_, params_.width, object_);
    render_heights(prepared_.scene, grid_, params_.width, scene_);
    const MapMaximum best = largest_sum(object_, scene_);
    if (best.column < 0) return;
    result.is_found = true;
    find_range(best.sum);
    finish(best, result);
    result.is_height_field = prepared_.is_height_field && detail::is_upright(prepared_, result.at);
    if (request.near > 0.0) {
      detail::collect_near(object_, scene_, grid_, request.near, result);
    } else {
      result.near.push_back({result.at, 1.0});
    }
    if (request.has_differences) sample_moved(contact, request, result);
  }

  // The depths that 16 bits have to cover.
  void find_range(float largest) noexcept {
    quantum_ = 0.0;
    if (!params_.is_16_bit) return;
    float least = largest;
    for (std::size_t i = 0; i < object_.heights.size(); ++i) {
      const float sum = object_.heights[i] + scene_.heights[i];
      if (sum > kEmptySample) least = std::min(least, sum);
    }
    least_ = static_cast<double>(least);
    quantum_ = (static_cast<double>(largest) - least_) / 65535.0;
  }

  double rounded(float sum) const noexcept {
    const double depth = static_cast<double>(sum);
    return quantum_ > 0.0 ? least_ + quantum_ * std::round((depth - least_) / quantum_) : depth;
  }

  // The maximum in double precision, and off the grid if asked for.
  void finish(const MapMaximum& best, DepthSamples& result) noexcept {
    result.at = grid_.at(best.column, best.row);
    double depth = rounded(best.sum);
    if (!params_.is_16_bit) {
      const Vec2 spacing = params_.is_polished ? grid_.spacing() : Vec2(Vec2::Zero());
      const double finished = detail::climb(prepared_, spacing, result.at);
      if (finished != kNoDepth) depth = finished;
    }
    result.depth[0] = depth;
  }

  void sample_moved(const DepthContact& contact, const DepthRequest& request,
                    DepthSamples& result) noexcept {
    const Vec2 spacing = grid_.spacing();
    result.shift = request.step > 0.0 ? request.step : spacing.minCoeff();
    const double arm = std::max((contact.point - contact.centre).norm(), spacing.maxCoeff());
    result.turn = result.shift / arm;
    const Vec3 centre =
        prepared_.frame.world_from_contact.transpose() * (contact.centre - prepared_.frame.origin);
    for (int i = 1; i < kConfigurations; ++i) {
      const int pair = (i - 1) / 2;
      const double sign = i % 2 == 1 ? 1.0 : -1.0;
      PlaneMotion motion{.centre = centre.head<2>()};
      if (pair < 2) motion.shift[pair] = sign * result.shift;
      if (pair == 4) motion.turn = sign * result.turn;
      if (pair == 2 || pair == 3) {
        detail::project_moved(contact, configuration_motion(result, contact.centre, i), prepared_);
        render_heights(prepared_.object, grid_, params_.width, moved_);
      } else {
        move_map(object_, grid_, motion, moved_);
      }
      const MapMaximum best = largest_sum(moved_, scene_);
      if (best.column >= 0) result.depth[static_cast<std::size_t>(i)] = rounded(best.sum);
    }
  }

  GridDepthParams params_;
  PreparedContact prepared_;
  MapGrid grid_;
  HeightMap object_, scene_, moved_;
  double least_ = 0.0, quantum_ = 0.0;  // of 16-bit depths [m]; quantum 0: not rounded
};

}  // namespace

std::unique_ptr<DepthBackend> make_grid_depth(const GridDepthParams& params) {
  return std::make_unique<GridDepth>(params);
}

}  // namespace thigma
