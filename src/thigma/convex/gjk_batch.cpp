// closest_points_batch in two doubles a step, and the choice of the width.
#include "thigma/convex/detail/gjk_batch.h"

#include "thigma/convex/detail/lanes_sse2.h"
#include "thigma/convex/gjk.h"

namespace thigma {
namespace detail {

void closest_points_batch_sse2(const GjkQuery* queries, std::size_t count, const RelativePose& x,
                               const PlainPose& plain, double stop, Separation* out) noexcept {
  run_batch<Sse2Lanes>(queries, count, x, plain, stop, out);
}

}  // namespace detail

void closest_points_batch(std::span<const GjkQuery> queries, const RelativePose& a_from_b,
                          double stop, Separation* out) noexcept {
  const detail::PlainPose plain{a_from_b.rotation.data(), a_from_b.translation.data(),
                                a_from_b.translation.lpNorm<1>()};
  const auto batch = __builtin_cpu_supports("avx2") ? detail::closest_points_batch_avx2
                                                    : detail::closest_points_batch_sse2;
  batch(queries.data(), queries.size(), a_from_b, plain, stop, out);
}

}  // namespace thigma
