#include "thigma/convex/penetration.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "thigma/convex/detail/least_overlap.h"

// Local penetration of patches: directional overlap along the directions real faces and edges allow
// (contract at pair_contact). Patches are thin, so "penetrating" cannot be read off the hulls: a
// patch is through another one long before the bodies overlap noticeably. What decides is which
// sides of the surfaces face each other.

namespace thigma {
namespace {

// Sine of the angle by which both backs must face each other, and cosine of that between the line
// of the closest points and the way out, for the overlap to count fully. Smaller makes the turn
// from grazing to through faster than the motion: depth * normal then changes by more than 4
// times the step.
constexpr double kFullyThrough = 0.9;

using detail::PlacedPair;
using detail::WayOut;

// How far the direction from witness to witness lies behind every real face that holds the witness,
// and behind those of the neighbours over a convex edge that does: the least sine, > 0 when the
// back of the surface is what faces the other patch. Ends at the first face that does not.
double back_facing(const HullView& h, std::uint32_t feature, const Vec3& toward_other) {
  double least = 1.0;
  bool found = false;
  for (int i = 0; i < h.face_count; ++i) {
    if ((feature & ~h.faces[i].vertices) != 0) continue;
    least = std::min(least, -h.faces[i].normal.dot(toward_other));
    if (!(least > 0.0)) return least;
    found = true;
  }
  for (int i = 0; i < h.edge_count; ++i) {
    const RealEdge& edge = h.edges[i];
    const std::uint32_t ends = (1u << edge.tail) | (1u << edge.head);
    if ((feature & ~ends) != 0 || edge.beyond.isZero(0.0)) continue;
    least = std::min(least, -edge.beyond.dot(toward_other));
  }
  return found ? least : -1.0;
}

PairContactStatus status_of(const PlacedPair& p, double depth) {
  const double valid = 0.5 * std::min(p.a.thickness, p.b.thickness);
  return depth > valid ? PairContactStatus::deep : PairContactStatus::penetrating;
}

void report_overlap(const PlacedPair& p, const Vec3& n, const Vec3& middle, PairContact& out) {
  const detail::Extent e = extent_along(p, n);
  const double at = n.dot(middle - p.origin);
  out.normal = n;
  out.depth = e.overlap();
  out.witness_a = middle + (e.top_a - at) * n;
  out.witness_b = middle + (e.bottom_b - at) * n;
  out.status = status_of(p, out.depth);
}

// A pair whose backs face each other turns from grazing to through: from minus the separation along
// the direction between the closest points to the overlap, as far as that direction opposes the way
// out. Side by side the first is right, one above the other the second; where one took over,
// depth times normal would jump by the distance of the patches.
void report_turning(const PlacedPair& p, const PatchSeparation& gap, double back,
                    const WayOut& way_out, PairContact& out) {
  const Vec3 between = (gap.point_b - gap.point_a) / gap.distance;
  const double through =
      std::min(std::min(back, -between.dot(way_out.normal)) / kFullyThrough, 1.0);
  if (!(through > 0.0)) return;  // as separated as before
  const Vec3 turned = (1.0 - through) * between + through * way_out.normal;
  const double length = turned.norm();
  const Vec3 middle = 0.5 * (gap.point_a + gap.point_b);
  if (through == 1.0 || !(length > 1e-6)) return report_overlap(p, way_out.normal, middle, out);
  out.normal = turned / length;
  out.depth = through * way_out.overlap - (1.0 - through) * gap.distance;
  out.witness_a = middle + 0.5 * out.depth * out.normal;
  out.witness_b = middle - 0.5 * out.depth * out.normal;
  out.status = out.depth > 0.0 ? status_of(p, out.depth) : PairContactStatus::grazing;
}

void report_penetration(const HullPair& pair, const PatchSeparation& gap, double back,
                        const Vec3* last, PairContact& out) {
  const PlacedPair p(pair);
  if (gap.intersecting) return report_overlap(p, least_overlap(p, last).normal, gap.point_a, out);
  // A remembered direction is one of overlap; while turning it would drift with the closest points.
  report_turning(p, gap, back, least_overlap(p, nullptr), out);
}

}  // namespace

double backs_facing(const HullPair& pair, std::uint32_t feature_a, std::uint32_t feature_b,
                    const Vec3& direction) noexcept {
  const double of_a = back_facing(pair.a, feature_a, direction);
  if (!(of_a > 0.0)) return of_a;
  const Vec3 back = -(pair.a_from_b.rotation.transpose() * direction);
  return std::min(of_a, back_facing(pair.b, feature_b, back));
}

PairContact pair_contact(const HullPair& pair, double tolerance, GjkCache& cache,
                         const Vec3* last_normal, const SegmentProbe& probe) noexcept {
  return pair_contact(pair, tolerance, patch_separation(pair, tolerance, cache), last_normal,
                      probe);
}

PairContact pair_contact(const HullPair& pair, double tolerance, const PatchSeparation& gap,
                         const Vec3* last_normal, const SegmentProbe& probe) noexcept {
  PairContact out;
  out.triangle_pairs = static_cast<std::int16_t>(gap.triangle_pairs);
  out.separation = gap.distance;
  out.depth = -gap.distance;
  if (gap.distance > tolerance) return out;
  if (gap.intersecting) {
    report_penetration(pair, gap, 1.0, last_normal, out);
    return out;
  }
  out.status = PairContactStatus::separated;
  out.witness_a = gap.point_a;
  out.witness_b = gap.point_b;
  out.feature_a = gap.feature_a;
  out.feature_b = gap.feature_b;
  out.normal = (gap.point_b - gap.point_a) / gap.distance;
  const double back = backs_facing(pair, gap.feature_a, gap.feature_b, out.normal);
  if (!(back > 0.0)) return out;
  out.backs_facing = true;
  const ProbeSegment segment{gap.point_a, gap.point_b, std::has_single_bit(gap.feature_a),
                             std::has_single_bit(gap.feature_b)};
  if (probe.separates != nullptr && probe.separates(probe.context, segment)) return out;
  report_penetration(pair, gap, back, last_normal, out);
  return out;
}

}  // namespace thigma
