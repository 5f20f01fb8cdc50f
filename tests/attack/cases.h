#pragma once
// Which of a test's numbered cases a run tries: a few as a rule, many over several runs when asked.

#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <string>

namespace thigma::test {

/// Cases [first, end). NAME=COUNT in the environment ends at COUNT and, where NAME_STATE names a
/// file, begins at the number in it.
struct Cases {
  std::uint64_t first = 0, end = 0;
  bool is_asked = false;  // by the environment: goes on after a case that failed
  std::string state;      // file; "" none

  Cases(const std::string& name, std::uint64_t usual) : end(usual) {
    if (const char* count = std::getenv(name.c_str())) {
      end = std::strtoull(count, nullptr, 10);
      is_asked = true;
    }
    if (const char* file = std::getenv((name + "_STATE").c_str())) {
      state = file;
      std::ifstream(state) >> first;
    }
  }
  std::uint64_t count() const { return end > first ? end - first : 0; }
  /// Notes that all cases below `next` are done.
  void done(std::uint64_t next) const {
    if (!state.empty()) std::ofstream(state) << next << "\n";
  }
};

}  // namespace thigma::test
