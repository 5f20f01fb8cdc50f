#include "thigma/convex/clip.h"

#include <algorithm>

#include "thigma/convex/quickhull.h"

namespace thigma {

void list_half_spaces(const Quickhull& hull, double inset, std::vector<HalfSpace>& half_spaces) {
  half_spaces.clear();
  for (const GrowingFace& face : hull.faces) {
    if (!face.is_alive || face.normal.isZero(0.0)) continue;
    // The normal of a sliver is inexact: pushed out to the last vertex its plane still bounds the
    // hull.
    double offset = face.offset;
    for (const std::int32_t v : hull.vertices)
      offset = std::max(offset, face.normal.dot(hull.points[static_cast<std::size_t>(v)]));
    half_spaces.push_back({face.normal, offset - inset * hull.scale});
  }
}

bool reaches_into(const std::array<Vec3, 3>& triangle, const std::vector<HalfSpace>& half_spaces) {
  for (const HalfSpace& h : half_spaces)
    if (h.normal.dot(triangle[0]) > h.offset && h.normal.dot(triangle[1]) > h.offset &&
        h.normal.dot(triangle[2]) > h.offset)
      return false;
  // Kept from call to call: millions of them a model.
  thread_local std::vector<Vec3> polygon, cut;
  thread_local std::vector<double> over;
  polygon.assign(triangle.begin(), triangle.end());
  for (const HalfSpace& h : half_spaces) {
    const std::size_t count = polygon.size();
    over.resize(count);
    bool is_cut = false;
    for (std::size_t i = 0; i < count; ++i) {
      over[i] = h.normal.dot(polygon[i]) - h.offset;
      is_cut |= !(over[i] <= 0.0);
    }
    if (!is_cut) continue;
    cut.clear();
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t j = i + 1 < count ? i + 1 : 0;
      const Vec3 &p = polygon[i], &q = polygon[j];
      const double over_p = over[i], over_q = over[j];
      if (over_p <= 0.0) cut.push_back(p);
      if ((over_p < 0.0 && over_q > 0.0) || (over_p > 0.0 && over_q < 0.0))
        cut.push_back(p + (over_p / (over_p - over_q)) * (q - p));
    }
    polygon.swap(cut);
    if (polygon.empty()) return false;
  }
  return true;
}

}  // namespace thigma
