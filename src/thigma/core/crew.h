#pragma once
// Threads that wait for pieces of work, for rounds too short to begin threads for each.

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace thigma {

/// A caller and the threads that help it. Who comes late to a round is not waited for: on a busy
/// machine the caller does most itself.
/// Thread    [offline]; one caller.
class Crew {
 public:
  using Work = std::function<void(std::size_t piece, std::size_t thread)>;

  /// threads  the caller's among them; 1: nobody helps
  explicit Crew(int threads);
  ~Crew();
  Crew(const Crew&) = delete;
  Crew& operator=(const Crew&) = delete;

  int threads() const noexcept { return static_cast<int>(helpers_.size()) + 1; }

  /// Calls work(i, thread) once for each i below count; thread is below threads(), and in one piece
  /// at a time. The calls are independent and do not throw.
  void for_each(std::size_t count, const Work& work);

 private:
  void help(std::size_t thread);
  void take_pieces(std::size_t thread);

  std::mutex mutex_;
  std::condition_variable begins_, ends_;
  const Work* work_ = nullptr;
  std::size_t count_ = 0, next_ = 0;
  bool is_over_ = false;
  std::atomic<std::size_t> left_{0};     // pieces that are not done
  std::atomic<std::uint32_t> round_{0};  // for who looks before it sleeps
  std::vector<std::thread> helpers_;
};

}  // namespace thigma
