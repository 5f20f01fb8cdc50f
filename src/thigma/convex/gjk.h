#pragma once
// Two convex hulls under a relative pose: distance with witnesses, and local penetration.

#include <cstdint>
#include <span>

#include "thigma/convex/hull_view.h"
#include "thigma/math/pose.h"

namespace thigma {

/// Relative placement of hull b in the frame of hull a's body, with the rotation as a matrix:
/// computed once a query, used by every pair of the same two bodies.
struct RelativePose {
  Mat3 rotation = Mat3::Identity();  // a_from_b
  Vec3 translation = Vec3::Zero();   // [m; frame of a]
};

RelativePose relative_pose(const Pose& world_from_a, const Pose& world_from_b) noexcept;

/// Two hulls and where the second is [frame of a].
struct HullPair {
  const HullView& a;
  const HullView& b;
  const RelativePose& a_from_b;
};

/// What a pair remembers between calls. Makes calls fast; results of separation queries do not
/// depend on it (beyond rounding). Zero-initialised means "nothing known". Fronts hold one a node
/// pair.
struct alignas(4) GjkCache {
  std::uint8_t a[4] = {0, 0, 0, 0};  // support vertices of the last simplex
  std::uint8_t b[4] = {0, 0, 0, 0};
  std::uint8_t count = 0;  // of the simplex, 0..4
  // count if hull vertices that support both hulls can only combine to points of the simplex, else
  // 0: such a simplex is proven to be the answer by the vertices outside it alone.
  std::uint8_t provable = 0;
};

enum class GjkStatus : std::uint8_t {
  separated,    // distance > 0, witnesses valid
  overlapping,  // hulls intersect or touch
  gave_up,      // iteration limit: distance is a lower bound, witnesses the best known
};

/// Closest points of two hulls, in the frame of a.
struct Separation {
  GjkStatus status = GjkStatus::separated;
  double distance = 0.0;          // [m], 0 when overlapping
  Vec3 witness_a = Vec3::Zero();  // [m; frame of a]
  Vec3 witness_b = Vec3::Zero();
  // mask of the vertices of a that span the closest feature (1..3 bits)
  std::uint32_t feature_a = 0;
  std::uint32_t feature_b = 0;
  int iterations = 0;
};

/// Distance of two hulls (GJK with warm start).
///
/// a, b      1..32 vertices each
/// a_from_b  relative pose
/// stop      a caller that only needs to know "farther than stop" may end early: distance is then a
///           lower bound >= stop [m]; infinity for the exact distance
/// cache     read and written
/// returns   relative accuracy 1e-12 of the larger of distance and hull size, 1e-11 where rounding
///           in slivers ends the search
/// Thread    [contact]; no failure, no allocation.
Separation closest_points(const HullView& a, const HullView& b, const RelativePose& a_from_b,
                          double stop, GjkCache& cache) noexcept;

/// One pair of a batch. All pairs of a batch belong to the same two bodies.
struct GjkQuery {
  const HullView* a = nullptr;
  const HullView* b = nullptr;
  GjkCache* cache = nullptr;
};

/// closest_points of many pairs under one pose: out[i] is, bit for bit, what closest_points gives
/// for queries[i]. Pairs whose last answer still holds are confirmed two (SSE2) or four (AVX2,
/// where the processor has it) at a time, with the same bits; the others are searched one by one.
///
/// queries  no cache twice
/// out      as many as queries
/// Thread   [contact]; no failure, no allocation.
void closest_points_batch(std::span<const GjkQuery> queries, const RelativePose& a_from_b,
                          double stop, Separation* out) noexcept;

/// Whether the cached axis proves that a and b are farther apart than gap. Conservative: true is
/// certain, false means "not proven". Single precision over the lanes with a slack for every
/// rounding; ~10 ns.
///
/// a, b      with lanes
/// axis      about unit length (0.1..10), frame of a, roughly from a to b: the direction of an
///           earlier query
/// gap       >= 0 [m]
/// Thread    [contact]; same bits on every processor.
bool axis_separates(const HullView& a, const HullView& b, const RelativePose& a_from_b,
                    const float axis[3], double gap) noexcept;

/// Whether the bounding spheres prove that a and b are farther apart than gap. Conservative as
/// axis_separates.
inline bool spheres_separate(const HullView& a, const HullView& b, const RelativePose& a_from_b,
                             double gap) noexcept {
  const Vec3 offset = a_from_b.rotation * b.center + a_from_b.translation - a.center;
  const double reach = a.radius + b.radius + gap;
  // 1e-13: several times the rounding of offset relative to the coordinates that went into it.
  const double slack =
      1e-13 * (a.center.lpNorm<1>() + b.center.lpNorm<1>() + a_from_b.translation.lpNorm<1>());
  return offset.squaredNorm() > (reach + slack) * (reach + slack) * (1.0 + 1e-13);
}

}  // namespace thigma
