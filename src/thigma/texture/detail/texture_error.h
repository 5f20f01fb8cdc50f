#pragma once
// How a texture that cannot be used is refused.

#include <string>

#include "thigma/core/error.h"

namespace thigma::detail {

[[noreturn]] inline void fail(const std::string& name, const std::string& what,
                              const std::string& expected) {
  throw InputError(name + ": " + what + ", expected " + expected);
}

}  // namespace thigma::detail
