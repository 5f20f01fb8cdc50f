#pragma once
// The two programs of depths on a graphics processor, and the layout of what they read and write.
// Both follow the scalar code operation by operation (height_map.cpp, height_span.h), `precise`, so
// that they differ from it by no more than the processor's own rounding.

#include <cstdint>

namespace thigma::detail {

/// One coarse triangle of one map.
struct GpuTriangle {
  double at[6] = {};  // corners u, v [m]
  // at a point s: [0] + [1] u + [2] v [texels]
  double texel_x[3] = {}, texel_y[3] = {};
  double height[3] = {};                        // coarse, likewise [m]
  double origin_x = 0.0, origin_y = 0.0;        // texel that coordinates are counted from
  float by_x = 0.0f, by_y = 0.0f, by_h = 0.0f;  // from one sample of a row to the next
  float high_x = 0.0f, high_y = 0.0f;           // the last column and row
  float m[3] = {};                              // ProjectedTriangle::carried [body frame]
  std::int32_t first_texel = 0, texel_row = 0;
};
static_assert(sizeof(GpuTriangle) == 176);

/// One height map to render.
struct GpuMap {
  double first_u = 0.0, low_v = 0.0, spacing_u = 1.0, spacing_v = 1.0;  // [m]
  std::int32_t first_triangle = 0, triangle_count = 0, heights = 0;     // index of its first sample
  std::int32_t unused = 0;
};
static_assert(sizeof(GpuMap) == 48);

/// One configuration of one contact: the object's map as it is, shifted or turned, over the
/// scene's.
struct GpuSum {
  double back[4] = {};  // MapTurn, row by row
  double centre[2] = {}, shift[2] = {}, first[2] = {}, spacing[2] = {}, low[2] = {},
         by_column[2] = {};
  std::int32_t object = 0, scene = 0;  // index of the first sample of each map
  std::int32_t kind = 0;               // 0 as it is, 1 shifted, 2 turned
  std::int32_t unused = 0;
  std::int32_t whole[2] = {}, begin[2] = {}, end[2] = {};  // MapShift
  float way[2] = {};
};
static_assert(sizeof(GpuSum) == 176);

/// What comes of it.
struct GpuPeak {
  float sum = 0.0f;         // the largest
  std::int32_t index = -1;  // of the sample; -1: the maps share nothing
  std::int32_t frame = 0;   // number of the frame that wrote this
};
static_assert(sizeof(GpuPeak) == 12);

/// Bindings of the buffers, of both programs.
enum class GpuBinding : std::uint32_t { texels, triangles, maps, heights, sums, peaks };
inline constexpr std::uint32_t kGpuBindings = 6;

/// Renders maps: a group of 64 a row and map. Uniform 0: columns, rows, frame.
extern const char* const kRenderShader;
/// Largest sums: a group of 64 a configuration. Same uniform.
extern const char* const kReduceShader;

}  // namespace thigma::detail
