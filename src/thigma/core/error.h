#pragma once
// Errors of the offline half. Online code returns a status instead and never throws.

#include <stdexcept>
#include <string>

namespace thigma {

/// Something the user gave is wrong. what() is one line "FILE: what, where, what was expected";
/// exit code 4.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The system refused: a file that cannot be opened, read or written; exit code 1 (4 for an input
/// file).
class IoError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace thigma
