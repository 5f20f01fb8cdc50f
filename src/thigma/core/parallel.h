#pragma once
// Independent pieces of offline work on several threads.

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <thread>
#include <vector>

namespace thigma {

/// Calls work(i) once for each i below count, on as many threads, the caller's among them. The
/// calls are independent, so that which thread takes a piece does not show in the result, and do
/// not throw.
/// Thread    [offline].
template <class Work>
void for_each_piece(std::size_t count, int threads, const Work& work) {
  std::atomic<std::size_t> next{0};
  const auto take = [&] {
    for (std::size_t i = next++; i < count; i = next++) work(i);
  };
  std::vector<std::thread> others;
  for (std::size_t i = 1; i < count && i < static_cast<std::size_t>(threads); ++i)
    others.emplace_back(take);
  take();
  for (std::thread& other : others) other.join();
}

/// Calls work(begin, end) for as many equal ranges below count as there are threads: what a thread
/// sets up it uses for all of its range. As for_each_piece else.
template <class Work>
void for_each_range(std::size_t count, int threads, const Work& work) {
  const auto pieces = static_cast<std::size_t>(std::max(threads, 1));
  for_each_piece(pieces, threads, [&](std::size_t piece) {
    work(count * piece / pieces, count * (piece + 1) / pieces);
  });
}

}  // namespace thigma
