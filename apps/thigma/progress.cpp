#include "progress.h"

#include <algorithm>
#include <cstdio>
#include <utility>

#include <unistd.h>

namespace thigma::app {
namespace {

constexpr int kBarWidth = 30;
constexpr double kRedraw = 0.1, kPlainPause = 2.0;  // [s]

}  // namespace

Progress::Progress(std::string label, std::string unit, bool is_shown)
    : label_(std::move(label)),
      unit_(std::move(unit)),
      is_shown_(is_shown),
      is_terminal_(::isatty(STDERR_FILENO) == 1),
      start_(std::chrono::steady_clock::now()) {}

Progress::~Progress() {
  if (is_drawn_ && is_terminal_) std::fputs("\r\x1b[K", stderr);
}

void Progress::update(double share, double amount) {
  if (!is_shown_) return;
  share = std::clamp(share, 0.0, 1.0);
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start_;
  const double seconds = elapsed.count();
  const int tenths = static_cast<int>(10.0 * share);
  const bool is_due = is_terminal_ ? seconds - last_drawn_ >= kRedraw
                                   : tenths > tenths_ && seconds - last_drawn_ >= kPlainPause;
  if (!is_due) return;
  tenths_ = tenths;
  last_drawn_ = seconds;
  is_drawn_ = true;
  draw(share, amount, seconds);
}

void Progress::draw(double share, double amount, double seconds) {
  const double rate = amount * share / seconds;
  const double left = share > 0.0 ? seconds * (1.0 - share) / share : 0.0;
  if (!is_terminal_) {
    std::fprintf(stderr, "thigma: %s: %.0f %%, %.0f %s/s, %.0f s left\n", label_.c_str(),
                 100.0 * share, rate, unit_.c_str(), left);
    return;
  }
  const int filled = static_cast<int>(kBarWidth * share);
  const std::string bar = std::string(static_cast<std::size_t>(filled), '#') +
                          std::string(static_cast<std::size_t>(kBarWidth - filled), '.');
  std::fprintf(stderr, "\r%s [%s] %3.0f %%, %.0f %s/s, %.0f s left\x1b[K", label_.c_str(),
               bar.c_str(), 100.0 * share, rate, unit_.c_str(), left);
}

}  // namespace thigma::app
