#include "thigma/contact/error_metric.h"

#include <algorithm>

#include "thigma/math/infinity.h"

namespace thigma {

double weighted_deviation(const LevelError& object, const LevelError& scene,
                          SupportArea area) noexcept {
  if (object.is_free || scene.is_free) return kInfinity;
  const double feature = std::max(object.deviation / (object.resolution * object.resolution),
                                  scene.deviation / (scene.resolution * scene.resolution));
  const double support = area == SupportArea::larger
                             ? std::max(object.support_area, scene.support_area)
                             : std::min(object.support_area, scene.support_area);
  if (support > 0.0) return feature / support;
  return feature == 0.0 ? 0.0 : kInfinity;
}

double view_threshold(const ViewThreshold& view) noexcept {
  return view.pixels * view.distance * view.frustum_size / (view.near_distance * view.image_size);
}

}  // namespace thigma
