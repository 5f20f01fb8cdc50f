#include "thigma/depth/detail/triangle_span.h"

#include <algorithm>
#include <cmath>

#include "thigma/depth/detail/quad_rows.h"

namespace thigma::detail {

static_assert(kMixedQuad == kMixedCell);

HeightSpan start_span(const ProjectedPatch& patch, const ProjectedTriangle& t, const Vec2& step,
                      Vec2& origin) noexcept {
  const HapticTexture& texture = *patch.texture;
  Vec2 low = Vec2::Constant(std::numeric_limits<double>::infinity());
  for (const Vec2& at : t.at) low = low.cwiseMin(t.texel_origin + t.texel_by_at * at);
  const auto index = [](double at, int count) {
    return static_cast<int>(std::clamp(std::floor(at) - 1.0, 0.0, count - 1.0));
  };
  const int column = index(low.x(), texture.width), row = index(low.y(), texture.height);
  origin = Vec2(column, row);
  HeightSpan span;
  span.texels = &texel_at(texture, column, row).x;
  span.texel_row = texture.width + 1;
  span.high_x = static_cast<float>(texture.width - 1 - column);
  span.high_y = static_cast<float>(texture.height - 1 - row);
  const Vec2 by = t.texel_by_at * step;
  span.by_x = static_cast<float>(by.x());
  span.by_y = static_cast<float>(by.y());
  span.by_h = static_cast<float>(t.height_by_at.dot(step));
  for (int k = 0; k < 3; ++k) span.m[k] = static_cast<float>(t.carried[k]);
  return span;
}

bool add_quads(const ProjectedPatch& patch, const ProjectedTriangle& t, const Vec2& origin,
               QuadTriangle& to, double& low) noexcept {
  const HapticTexture& texture = *patch.texture;
  const HeightQuads& quads = texture.quads;
  const bool is_one_way = !quads.along.isZero();
  if (!is_one_way && t.height_by_at.squaredNorm() > 1.0) return false;
  const double by = is_one_way ? t.carried.dot(quads.along) : t.carried.norm();
  const std::size_t first =
      static_cast<std::size_t>(origin.y()) * static_cast<std::size_t>(texture.width) +
      static_cast<std::size_t>(origin.x());
  to.quads = quads.cells[first].steps.data();
  to.quad_row = texture.width;
  to.high_x = to.texels.high_x;
  to.high_y = to.texels.high_y;
  to.by_x = to.texels.by_x;
  to.by_y = to.texels.by_y;
  to.by_h = to.texels.by_h;
  to.by_step = static_cast<float>(quads.step * by);
  low = quads.low * by;
  return true;
}

}  // namespace thigma::detail
