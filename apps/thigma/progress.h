#pragma once
// How far long work has come, on standard error.

#include <chrono>
#include <string>

namespace thigma::app {

/// A bar with rate and time left on a terminal, a plain line every tenth and at most one in two
/// seconds elsewhere. Thread: one.
class Progress {
 public:
  /// label     what is being done, "building cup.obj"
  /// unit      the rate counts, "triangles"
  /// is_shown  false: nothing is printed
  Progress(std::string label, std::string unit, bool is_shown);
  ~Progress();  // leaves the terminal's line empty
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// share   of the work that is done, 0..1
  /// amount  of the whole work, in units
  void update(double share, double amount);

 private:
  void draw(double share, double amount, double seconds);

  std::string label_, unit_;
  bool is_shown_, is_terminal_;
  bool is_drawn_ = false;
  int tenths_ = 0;           // that were told
  double last_drawn_ = 0.0;  // [s]
  std::chrono::steady_clock::time_point start_;
};

}  // namespace thigma::app
