#include "viewer/server/relief.h"

#include <algorithm>
#include <cmath>

#include "viewer/server/protocol.h"

#include "thigma/texture/texel_lookup.h"

namespace thigma::live {
namespace {

// A page splits and draws them, perhaps without graphics hardware.
constexpr std::size_t kMostTriangles = 40'000;

double longest_edge(const TriangleMesh& mesh) {
  double longest = 0.0;
  for (const auto& triangle : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 way = mesh.positions[static_cast<std::size_t>(triangle[k])] -
                       mesh.positions[static_cast<std::size_t>(triangle[(k + 1) % 3])];
      longest = std::max(longest, way.norm());
    }
  }
  return longest;
}

/// The points of one divided triangle, row by row from its first edge to its last corner.
void add_points(const HapticTexture& texture, std::size_t number, int n, TriangleMesh& fine) {
  const auto& corner = texture.coarse.triangles[number];
  const auto& uv = texture.corners[number];
  const auto at = [&](std::size_t k) -> const Vec3& {
    return texture.coarse.positions[static_cast<std::size_t>(corner[k])];
  };
  for (int j = 0; j <= n; ++j) {
    for (int i = 0; i <= n - j; ++i) {
      const double b = static_cast<double>(i) / n, c = static_cast<double>(j) / n;
      const double a = 1.0 - b - c;
      const Vec2 where = a * uv[0] + b * uv[1] + c * uv[2];
      fine.positions.push_back(a * at(0) + b * at(1) + c * at(2) + displacement_at(texture, where));
    }
  }
}

void add_triangles(std::int32_t first, int n, TriangleMesh& fine) {
  std::int32_t row = first;
  for (int j = 0; j < n; ++j) {
    const std::int32_t next = row + n - j + 1;
    for (std::int32_t i = 0; i < n - j; ++i) {
      fine.triangles.push_back({row + i, row + i + 1, next + i});
      if (i + 1 < n - j) fine.triangles.push_back({row + i + 1, next + i + 1, next + i});
    }
    row = next;
  }
}

}  // namespace

ReliefSurface make_relief_surface(const HapticTexture& texture, std::size_t most) {
  const std::size_t coarse = texture.coarse.triangles.size();
  const double allowed = std::sqrt(static_cast<double>(most) / static_cast<double>(coarse));
  const double wanted = std::ceil(longest_edge(texture.coarse) / texture.texel_size);
  ReliefSurface relief;
  relief.divisions = static_cast<int>(std::max(1.0, std::min(std::floor(allowed), wanted)));
  const int n = relief.divisions;
  const auto points = static_cast<std::size_t>((n + 1) * (n + 2) / 2);
  relief.mesh.positions.reserve(coarse * points);
  relief.mesh.triangles.reserve(coarse * static_cast<std::size_t>(n) * static_cast<std::size_t>(n));
  for (std::size_t t = 0; t < coarse; ++t) {
    const auto first = static_cast<std::int32_t>(relief.mesh.positions.size());
    add_points(texture, t, n, relief.mesh);
    add_triangles(first, n, relief.mesh);
  }
  return relief;
}

std::string encode_relief(std::uint32_t mesh_number, const HapticTexture& texture,
                          const ClodHierarchy& hierarchy) {
  const ReliefSurface relief = make_relief_surface(texture, kMostTriangles);
  return encode_divided(mesh_number, relief.mesh, texture.coarse, relief.divisions, hierarchy);
}

}  // namespace thigma::live
