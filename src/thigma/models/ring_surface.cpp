#include "thigma/models/ring_surface.h"

#include <algorithm>
#include <cmath>

#include "thigma/math/random.h"
#include "thigma/models/detail/rings.h"

namespace thigma::models {
namespace {

constexpr int kArcSteps = 4000;                  // of a full turn
constexpr int kLineSteps = 400;                  // of a straight piece
constexpr int kLeastInRing = 5;                  // next to a pole
const double kRowHeight = 0.5 * std::sqrt(3.0);  // of an equilateral triangle of edge 1

/// Density-weighted length of the profile up to each of its points, and the area it sweeps.
struct Lengths {
  std::vector<double> along;
  double area = 0.0;  // density squared times area
};

Lengths measure(const std::vector<ProfilePoint>& profile) {
  Lengths lengths;
  lengths.along.assign(profile.size(), 0.0);
  for (std::size_t i = 0; i + 1 < profile.size(); ++i) {
    const ProfilePoint &a = profile[i], &b = profile[i + 1];
    const double density = 0.5 * (a.density + b.density);
    const double length = density * std::sqrt((b.place - a.place).squaredNorm());
    lengths.along[i + 1] = lengths.along[i] + length;
    lengths.area += 2.0 * kPi * 0.5 * (a.place.x() + b.place.x()) * density * length;
  }
  return lengths;
}

/// bands - 1 points evenly along the density-weighted length, without the two ends.
std::vector<ProfilePoint> ring_places(const std::vector<ProfilePoint>& profile,
                                      const Lengths& lengths, int bands) {
  std::vector<ProfilePoint> places;
  std::size_t i = 0;
  for (int k = 1; k < bands; ++k) {
    const double wanted = lengths.along.back() * k / bands;
    while (i + 2 < profile.size() && lengths.along[i + 1] < wanted) ++i;
    const double step = lengths.along[i + 1] - lengths.along[i];
    const double x = step > 0.0 ? std::clamp((wanted - lengths.along[i]) / step, 0.0, 1.0) : 0.0;
    const ProfilePoint &a = profile[i], &b = profile[i + 1];
    ProfilePoint p;
    p.place = a.place + x * (b.place - a.place);
    p.normal = a.normal + x * (b.normal - a.normal);
    p.normal /= std::sqrt(p.normal.squaredNorm());
    p.density = a.density + x * (b.density - a.density);
    places.push_back(p);
  }
  return places;
}

/// Vertices of each ring, in proportion to its length, `total` in all.
std::vector<int> ring_counts(const std::vector<ProfilePoint>& places, double edge, int total) {
  std::vector<double> wished;
  double sum = 0.0;
  for (const ProfilePoint& p : places) {
    wished.push_back(std::max<double>(kLeastInRing, 2.0 * kPi * p.place.x() * p.density / edge));
    sum += wished.back();
  }
  // Rounding the running sum keeps neighbours alike and meets the total.
  std::vector<int> counts;
  double before = 0.0;
  int given = 0;
  for (const double w : wished) {
    before += w * total / sum;
    const int upto = static_cast<int>(before + 0.5);
    counts.push_back(std::max(3, upto - given));
    given = upto;
  }
  return counts;
}

/// A ring and where its first vertex stands.
struct TurnedRing {
  Ring ring;
  double phase = 0.0;  // [turns / count]
};

/// Band between rings of any counts: the vertex that comes first along the turn is taken next.
void join_any(TriangleMesh& mesh, const TurnedRing& low, const TurnedRing& high) {
  const int m = low.ring.count, n = high.ring.count;
  for (int i = 0, j = 0; i < m || j < n;) {
    const double next_low = (i + 1 + low.phase) / m;
    const double next_high = (j + 1 + high.phase) / n;
    const std::int32_t a = low.ring.first + i % m;
    const std::int32_t d = high.ring.first + j % n;
    if (j == n || (i < m && next_low <= next_high)) {
      mesh.triangles.push_back({a, low.ring.first + (i + 1) % m, d});
      ++i;
    } else {
      mesh.triangles.push_back({a, high.ring.first + (j + 1) % n, d});
      ++j;
    }
  }
}

std::int32_t add_vertex(TriangleMesh& mesh, const Vec3& p) {
  mesh.positions.push_back(p);
  return static_cast<std::int32_t>(mesh.positions.size()) - 1;
}

}  // namespace

void add_arc(std::vector<ProfilePoint>& profile, const ProfileArc& arc) {
  const double turn = arc.to - arc.from;
  const int steps = std::max(8, static_cast<int>(std::fabs(turn) / (2.0 * kPi) * kArcSteps));
  for (int i = 0; i <= steps; ++i) {
    const SinCos a = sin_cos(arc.from + turn * i / steps);
    const Vec2 out(a.cos, a.sin);
    Vec2 place = arc.centre + arc.radius * out;
    place.x() = std::max(place.x(), 0.0);
    profile.push_back({place, arc.is_outer ? out : Vec2(-out), arc.density});
  }
}

void add_line(std::vector<ProfilePoint>& profile, const Vec2& from, const Vec2& to,
              double density) {
  const Vec2 way = (to - from) / std::sqrt((to - from).squaredNorm());
  const Vec2 out(way.y(), -way.x());
  for (int i = 0; i <= kLineSteps; ++i) {
    const double x = static_cast<double>(i) / kLineSteps;
    profile.push_back({from + x * (to - from), out, density});
  }
}

TriangleMesh make_ring_surface(
    const std::vector<ProfilePoint>& profile, int triangles,
    const std::function<Vec3(const ProfilePoint& at, const SinCos& turn)>& place) {
  const Lengths lengths = measure(profile);
  const double edge = std::sqrt(lengths.area / (0.5 * kRowHeight * triangles));
  const int bands = std::max(4, static_cast<int>(lengths.along.back() / (kRowHeight * edge) + 0.5));
  const std::vector<ProfilePoint> places = ring_places(profile, lengths, bands);
  const std::vector<int> counts = ring_counts(places, edge, triangles / 2);
  TriangleMesh mesh;
  const SinCos ahead{0.0, 1.0};
  const std::int32_t south = add_vertex(mesh, place(profile.front(), ahead));
  TurnedRing last;
  for (std::size_t k = 0; k < places.size(); ++k) {
    // The golden ratio keeps the first vertices of the rings from lining up into a seam.
    const double turns = 0.6180339887498949 * static_cast<double>(k);
    TurnedRing ring;
    ring.phase = turns - std::floor(turns);
    std::vector<Vec3> points;
    for (int j = 0; j < counts[k]; ++j) {
      points.push_back(place(places[k], sin_cos(2.0 * kPi * (j + ring.phase) / counts[k])));
    }
    ring.ring = add_ring(mesh, points);
    if (k > 0) {
      join_any(mesh, last, ring);
    } else {
      for (int j = 0; j < counts[k]; ++j) {
        mesh.triangles.push_back(
            {ring.ring.first + (j + 1) % counts[k], ring.ring.first + j, south});
      }
    }
    last = ring;
  }
  const std::int32_t north = add_vertex(mesh, place(profile.back(), ahead));
  for (int j = 0; j < last.ring.count; ++j) {
    mesh.triangles.push_back(
        {last.ring.first + j, last.ring.first + (j + 1) % last.ring.count, north});
  }
  return mesh;
}

Vec3 turned_place(const ProfilePoint& at, const SinCos& turn, double outwards) {
  const Vec2 p = at.place + outwards * at.normal;
  return {p.x() * turn.cos, p.x() * turn.sin, p.y()};
}

double WaveRelief::at(const Vec3& p) const {
  double sum = 0.0;
  for (std::size_t i = 0; i < wave.size(); ++i) sum += cosine(wave[i].dot(p) + phase[i]);
  return amplitude * sum;
}

WaveRelief make_waves(std::uint64_t seed, double rms, double shortest, double longest, int count) {
  Random random(seed);
  WaveRelief relief;
  relief.amplitude = rms * std::sqrt(2.0 / count);
  for (int i = 0; i < count; ++i) {
    const Vec3 direction = random.direction();
    relief.wave.push_back(direction * (2.0 * kPi / random.uniform(shortest, longest)));
    relief.phase.push_back(random.uniform(0.0, 2.0 * kPi));
  }
  return relief;
}

}  // namespace thigma::models
