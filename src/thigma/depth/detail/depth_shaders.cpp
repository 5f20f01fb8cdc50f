#include "thigma/depth/detail/depth_shaders.h"

namespace thigma::detail {

const char* const kRenderShader = R"(#version 430
layout(local_size_x = 64) in;
layout(location = 0) uniform ivec3 size;  // columns, rows, frame

struct Triangle {
  double at[6], texel_x[3], texel_y[3], height[3], origin_x, origin_y;
  float by_x, by_y, by_h, high_x, high_y;
  float mx, my, mz;
  int first_texel, texel_row;
};
struct Map {
  double first_u, low_v, spacing_u, spacing_v;
  int first_triangle, triangle_count, heights, unused;
};
layout(std430, binding = 0) readonly buffer Texels { vec4 texels[]; };
layout(std430, binding = 1) readonly buffer Triangles { Triangle triangles[]; };
layout(std430, binding = 2) readonly buffer Maps { Map maps[]; };
layout(std430, binding = 3) writeonly buffer Heights { float heights[]; };

const double overlap = 1e-6LF;
const float empty = -1e30;

// The triangles that cover samples of the row, in any order: which columns, and their values at the
// row's first sample.
shared int active_count, slot_triangle[64], first_column[64], last_column[64];
shared float start_x[64], start_y[64], start_h[64];

// Columns of a triangle in a row at height v of the plane.
void find_extent(Triangle t, double v, out double low, out double high) {
  low = 1e300LF;
  high = -1e300LF;
  for (int k = 0; k < 3; ++k) {
    int n = k == 2 ? 0 : k + 1;
    double au = t.at[2 * k], av = t.at[2 * k + 1], bu = t.at[2 * n], bv = t.at[2 * n + 1];
    if (min(av, bv) > v || max(av, bv) < v) continue;
    precise double rise = bv - av;
    precise double u = rise == 0.0LF ? au : au + (v - av) * ((bu - au) / rise);
    low = min(low, min(u, rise == 0.0LF ? bu : u));
    high = max(high, max(u, rise == 0.0LF ? bu : u));
  }
}

void prepare(Map map, int index, int row) {
  if (index >= map.triangle_count) return;
  Triangle t = triangles[map.first_triangle + index];
  double bottom = min(t.at[1], min(t.at[3], t.at[5])), top = max(t.at[1], max(t.at[3], t.at[5]));
  precise double first_v = map.low_v + map.spacing_v * 0.5LF;
  precise double v = map.low_v + map.spacing_v * (double(row) + 0.5LF);
  precise double bottom_row = clamp((bottom - first_v) / map.spacing_v, -1.0LF, double(size.y));
  precise double top_row = clamp((top - first_v) / map.spacing_v, -1.0LF, double(size.y));
  if (row < int(ceil(bottom_row - overlap)) || row > int(floor(top_row + overlap))) return;
  double low, high;
  find_extent(t, clamp(v, bottom, top), low, high);
  precise double low_column = clamp((low - map.first_u) / map.spacing_u, -1.0LF, double(size.x));
  precise double high_column = clamp((high - map.first_u) / map.spacing_u, -1.0LF, double(size.x));
  int from = max(int(ceil(low_column - overlap)), 0);
  int to = min(int(floor(high_column + overlap)), size.x - 1);
  if (from > to) return;
  int slot = atomicAdd(active_count, 1);
  slot_triangle[slot] = map.first_triangle + index;
  first_column[slot] = from;
  last_column[slot] = to;
  precise double x = t.texel_x[0] + (t.texel_x[1] * map.first_u + t.texel_x[2] * v) - t.origin_x;
  precise double y = t.texel_y[0] + (t.texel_y[1] * map.first_u + t.texel_y[2] * v) - t.origin_y;
  precise double h = t.height[0] + (t.height[1] * map.first_u + t.height[2] * v);
  start_x[slot] = float(x);
  start_y[slot] = float(y);
  start_h[slot] = float(h);
}

float height_in(int slot, int column) {
  int i = slot_triangle[slot];
  float k = float(column);
  precise float x = start_x[slot] + k * triangles[i].by_x;
  precise float y = start_y[slot] + k * triangles[i].by_y;
  x = min(max(x, 0.0), triangles[i].high_x);
  y = min(max(y, 0.0), triangles[i].high_y);
  int texel_row = triangles[i].texel_row;
  precise float ax = x - float(int(x));
  precise float ay = y - float(int(y));
  int top = triangles[i].first_texel + int(y) * texel_row + int(x);
  int bottom = top + texel_row;
  precise vec3 left = texels[top].xyz + ay * (texels[bottom].xyz - texels[top].xyz);
  precise vec3 right = texels[top + 1].xyz + ay * (texels[bottom + 1].xyz - texels[top + 1].xyz);
  precise vec3 d = left + ax * (right - left);
  precise float height = (start_h[slot] + k * triangles[i].by_h) +
                         ((triangles[i].mx * d.x + triangles[i].my * d.y) + triangles[i].mz * d.z);
  return height;
}

void main() {
  int lane = int(gl_LocalInvocationID.x), row = int(gl_WorkGroupID.x);
  Map map = maps[gl_WorkGroupID.y];
  // Rows of more than 64 samples go by in parts, each with all triangles.
  for (int part = 0; part < size.x; part += 64) {
    int column = part + lane;
    float height = empty;
    for (int chunk = 0; chunk < map.triangle_count; chunk += 64) {
      barrier();
      if (lane == 0) active_count = 0;
      barrier();
      prepare(map, chunk + lane, row);
      barrier();
      if (column < size.x) {
        for (int slot = 0; slot < active_count; ++slot) {
          if (column < first_column[slot] || column > last_column[slot]) continue;
          float here = height_in(slot, column);
          height = here > height ? here : height;
        }
      }
    }
    if (column < size.x) heights[map.heights + row * size.x + column] = height;
  }
}
)";

const char* const kReduceShader = R"(#version 430
layout(local_size_x = 64) in;
layout(location = 0) uniform ivec3 size;  // columns, rows, frame

struct Sum {
  double back[4], centre[2], shift[2], first[2], spacing[2], low[2], by_column[2];
  int object, scene, kind, unused, whole[2], begin[2], end[2];
  float way[2];
};
struct Peak { float sum; int index; int frame; };
layout(std430, binding = 3) readonly buffer Heights { float heights[]; };
layout(std430, binding = 4) readonly buffer Sums { Sum sums[]; };
layout(std430, binding = 5) writeonly buffer Peaks { Peak peaks[]; };

const float empty = -1e30, mixed_sample = -1e20, nothing = -2e30;

shared float best_sum[64];
shared int best_index[64];

float interpolate(int at, int next, int next_row, float x, float y) {
  float h00 = heights[at], h10 = heights[at + next_row];
  float h01 = heights[at + next], h11 = heights[at + next_row + next];
  precise float left = h00 + y * (h10 - h00);
  precise float right = h01 + y * (h11 - h01);
  precise float height = left + x * (right - left);
  return height < mixed_sample ? empty : height;
}

// The object's height at a moved sample of a row.
struct Line { int low, high; float x, by_x, y, by_y; };

void narrow(double start, double by, double last, inout double low, inout double high) {
  if (by == 0.0LF) {
    if (start < 0.0LF || start > last) high = low - 1.0LF;
    return;
  }
  precise double a = -start / by;
  precise double b = (last - start) / by;
  low = max(low, min(a, b));
  high = min(high, max(a, b));
}

Line line_of(Sum s, int row) {
  Line line = Line(0, size.x - 1, 0.0, 0.0, 0.0, 0.0);
  if (s.kind == 1) {
    line.low = s.begin[0];
    line.high = row < s.begin[1] || row >= s.end[1] ? -1 : s.end[0] - 1;
  }
  if (s.kind == 2) {
    precise double u = s.low[0] + s.spacing[0] * 0.5LF;
    precise double v = s.low[1] + s.spacing[1] * (double(row) + 0.5LF);
    precise double du = u - s.shift[0] - s.centre[0];
    precise double dv = v - s.shift[1] - s.centre[1];
    precise double fu = (s.back[0] * du + s.back[1] * dv) + s.centre[0];
    precise double fv = (s.back[2] * du + s.back[3] * dv) + s.centre[1];
    precise double x = (fu - s.first[0]) / s.spacing[0];
    precise double y = (fv - s.first[1]) / s.spacing[1];
    double low = 0.0LF, high = double(size.x - 1);
    narrow(x, s.by_column[0], double(size.x - 1), low, high);
    narrow(y, s.by_column[1], double(size.y - 1), low, high);
    line = Line(int(ceil(low)), int(floor(high)), float(x), float(s.by_column[0]), float(y),
                float(s.by_column[1]));
  }
  return line;
}

float object_height(Sum s, Line line, int row, int column) {
  if (s.kind == 0) return heights[s.object + row * size.x + column];
  if (s.kind == 1) {
    int at = s.object + (row + s.whole[1]) * size.x + column + s.whole[0];
    return interpolate(at, s.way[0] > 0.0 ? 1 : 0, s.way[1] > 0.0 ? size.x : 0, s.way[0], s.way[1]);
  }
  float k = float(column);
  precise float x = line.x + k * line.by_x;
  precise float y = line.y + k * line.by_y;
  x = min(max(x, 0.0), float(size.x - 1));
  y = min(max(y, 0.0), float(size.y - 1));
  int i = min(int(x), size.x - 2), j = min(int(y), size.y - 2);
  precise float ax = x - float(i);
  precise float ay = y - float(j);
  return interpolate(s.object + j * size.x + i, 1, size.x, ax, ay);
}

void main() {
  int lane = int(gl_LocalInvocationID.x);
  Sum s = sums[gl_WorkGroupID.x];
  float best = nothing;
  int index = -1;
  for (int row = lane; row < size.y; row += 64) {
    Line line = line_of(s, row);
    for (int column = line.low; column <= line.high; ++column) {
      int at = row * size.x + column;
      precise float sum = object_height(s, line, row, column) + heights[s.scene + at];
      if (sum > best) { best = sum; index = at; }
    }
  }
  best_sum[lane] = best;
  best_index[lane] = index;
  barrier();
  for (int half_way = 32; half_way > 0; half_way /= 2) {
    if (lane < half_way) {
      int other = lane + half_way;
      bool is_better = best_sum[other] > best_sum[lane];
      bool is_tie = best_sum[other] == best_sum[lane] && best_index[other] < best_index[lane];
      if (is_better || is_tie) {
        best_sum[lane] = best_sum[other];
        best_index[lane] = best_index[other];
      }
    }
    barrier();
  }
  if (lane == 0) {
    bool is_found = best_sum[0] > 0.5 * empty;
    peaks[gl_WorkGroupID.x] = Peak(best_sum[0], is_found ? best_index[0] : -1, size.z);
  }
}
)";

}  // namespace thigma::detail
