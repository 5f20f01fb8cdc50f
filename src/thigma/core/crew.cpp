#include "thigma/core/crew.h"

namespace thigma {
namespace {

/// Looks until it is so, but no longer than some tens of microseconds: to sleep and be woken takes
/// longer than many a piece.
template <class Condition>
void look_for(const Condition& is_so) {
  constexpr int kLooks = 3000;
  for (int i = 0; i < kLooks && !is_so(); ++i) {
#if defined(__x86_64__)
    __builtin_ia32_pause();
#elif defined(__aarch64__)
    asm volatile("yield");
#endif
  }
}

}  // namespace

Crew::Crew(int threads) {
  for (int i = 1; i < threads; ++i)
    helpers_.emplace_back([this, i] { help(static_cast<std::size_t>(i)); });
}

Crew::~Crew() {
  {
    const std::lock_guard lock(mutex_);
    is_over_ = true;
  }
  begins_.notify_all();
  for (std::thread& helper : helpers_) helper.join();
}

void Crew::take_pieces(std::size_t thread) {
  std::unique_lock lock(mutex_);
  while (next_ < count_) {
    const std::size_t piece = next_++;
    const Work& work = *work_;
    lock.unlock();
    work(piece, thread);
    lock.lock();
    if (left_.fetch_sub(1, std::memory_order_release) == 1) ends_.notify_one();
  }
}

void Crew::help(std::size_t thread) {
  for (std::uint32_t seen = 0;;) {
    look_for([&] { return round_.load(std::memory_order_relaxed) != seen; });
    {
      std::unique_lock lock(mutex_);
      begins_.wait(lock, [this] { return is_over_ || next_ < count_; });
      if (is_over_) return;
      seen = round_.load(std::memory_order_relaxed);
    }
    take_pieces(thread);
  }
}

void Crew::for_each(std::size_t count, const Work& work) {
  {
    const std::lock_guard lock(mutex_);
    work_ = &work;
    count_ = count;
    next_ = 0;
    left_.store(count, std::memory_order_relaxed);
    round_.fetch_add(1, std::memory_order_relaxed);
  }
  begins_.notify_all();
  take_pieces(0);
  const auto is_done = [this] { return left_.load(std::memory_order_acquire) == 0; };
  look_for(is_done);
  std::unique_lock lock(mutex_);
  ends_.wait(lock, is_done);
}

}  // namespace thigma
