#pragma once
// The batch over any width: pairs are sorted by the size of their cached simplex, confirmed in
// groups, and what is not confirmed is searched one by one. Rules of verify_cached_simplices.h
// hold.

#include "thigma/convex/detail/gjk_warm_start.h"

namespace thigma::detail {

/// The batch in two widths with the same bits; the second needs a processor with AVX2.
/// x and plain are the same pose. Else as closest_points_batch.
void closest_points_batch_sse2(const GjkQuery* queries, std::size_t count, const RelativePose& x,
                               const PlainPose& plain, double stop, Separation* out) noexcept;
void closest_points_batch_avx2(const GjkQuery* queries, std::size_t count, const RelativePose& x,
                               const PlainPose& plain, double stop, Separation* out) noexcept;

/// Size of the cached simplex if verify_cached_simplices can take it, else 0.
template <class T>
[[gnu::always_inline]] inline int is_verifiable(const GjkQuery& q) {
  // By the bytes of one word: the first `provable` indices of each hull must be those of vertices.
  // A cache may come from a front that was rebuilt.
  constexpr std::uint64_t kOnes = 0x01010101, kHigh = 0x8080808080808080;
  static constexpr std::uint64_t kUsed[4] = {0, 0xff000000ff, 0xffff0000ffff, 0xffffff00ffffff};
  const int n = q.cache->provable & 3;
  std::uint64_t index;
  __builtin_memcpy(&index, q.cache, sizeof index);
  index &= kUsed[n];
  const HullView &a = *q.a, &b = *q.b;
  const std::uint64_t last = kOnes * static_cast<std::uint64_t>(a.vertex_count - 1) |
                             kOnes * static_cast<std::uint64_t>(b.vertex_count - 1) << 32;
  const bool exist = ((((last | kHigh) - index) & ~index) & kHigh) == kHigh;
  return exist & (a.lanes != nullptr) & (b.lanes != nullptr) ? n : 0;
}

static_assert(offsetof(GjkCache, a) == 0 && offsetof(GjkCache, b) == 4);

/// Pairs of one chunk whose simplices have the same number of points.
template <class T>
struct BatchList {
  static constexpr int kMost = 64;
  std::uint8_t index[kMost + T::kLanes];
  int count;
};

template <class T, int N>
[[gnu::always_inline]] inline std::uint64_t confirm_list(BatchList<T>& list,
                                                         const GjkQuery* queries,
                                                         const PlainPose& x, Separation* out) {
  std::uint64_t confirmed = 0;
  if (list.count == 0) return 0;
  // The last group is filled up with its last pair: the same work and the same result again.
  for (int l = 0; l < T::kLanes; ++l) list.index[list.count + l] = list.index[list.count - 1];
  for (int i = 0; i < list.count; i += T::kLanes) {
    const GjkQuery* q[T::kLanes];
    Separation* s[T::kLanes];
    for (int l = 0; l < T::kLanes; ++l) {
      q[l] = queries + list.index[i + l];
      s[l] = out + list.index[i + l];
    }
    const unsigned good = verify_cached_simplices<T, N>(q, x, s);
    for (int l = 0; l < T::kLanes; ++l)
      confirmed |= static_cast<std::uint64_t>(good >> l & 1u) << list.index[i + l];
  }
  return confirmed;
}

template <class T>
inline void run_batch(const GjkQuery* queries, std::size_t count, const RelativePose& x,
                      const PlainPose& plain, double stop, Separation* out) {
  constexpr std::size_t kChunk = BatchList<T>::kMost;
  double r[9], t[3];  // copies that nothing written below can alias
  for (int i = 0; i < 9; ++i) r[i] = plain.r[i];
  for (int i = 0; i < 3; ++i) t[i] = plain.t[i];
  const PlainPose pose = {r, t, plain.far};
  BatchList<T> list[4];  // by the points of the simplex; 0: to be searched
  for (std::size_t begin = 0; begin < count; begin += kChunk) {
    const int n = static_cast<int>(count - begin < kChunk ? count - begin : kChunk);
    const GjkQuery* q = queries + begin;
    Separation* s = out + begin;
    for (int k = 0; k < 4; ++k) list[k].count = 0;
    for (int i = 0; i < n; ++i) {
      BatchList<T>& l = list[is_verifiable<T>(q[i])];
      l.index[l.count++] = static_cast<std::uint8_t>(i);
    }
    const std::uint64_t confirmed = confirm_list<T, 1>(list[1], q, pose, s) |
                                    confirm_list<T, 2>(list[2], q, pose, s) |
                                    confirm_list<T, 3>(list[3], q, pose, s);
    std::uint64_t open = ~confirmed & (~std::uint64_t{0} >> (kChunk - static_cast<std::size_t>(n)));
    for (; open != 0; open &= open - 1) {
      const int i = __builtin_ctzll(open);
      s[i] = search_closest_points(*q[i].a, *q[i].b, x, stop, *q[i].cache);
    }
  }
}

}  // namespace thigma::detail
