#pragma once
// What every function of the C door does: exceptions become codes and a line, NULL is refused.

#include <cstdint>
#include <stdexcept>
#include <string>
#include <type_traits>

#include "thigma/math/pose.h"
#include "thigma/thigma_c.h"

namespace thigma::c {

/// Keeps the line of the exception that is being handled, and returns its code.
/// Thread  any, each has a line of its own
thigma_result take_error() noexcept;

/// Runs the work of a function; its value, where it has one, is the code.
template <class Work>
thigma_result guarded(Work work) noexcept {
  try {
    if constexpr (std::is_void_v<decltype(work())>) {
      work();
      return THIGMA_OK;
    } else {
      return work();
    }
  } catch (...) {
    return take_error();
  }
}

/// Throws std::invalid_argument for NULL.
template <class T>
T& needed(T* pointer, const char* name) {
  if (pointer == nullptr) throw std::invalid_argument(std::string(name) + ": NULL");
  return *pointer;
}

/// Throws std::invalid_argument for a struct of another size.
template <class T>
T& sized(T* pointer, const char* name) {
  T& value = needed(pointer, name);
  if (value.struct_size != sizeof(T)) {
    throw std::invalid_argument(std::string(name) + ": struct_size " +
                                std::to_string(value.struct_size) + ", expected " +
                                std::to_string(sizeof(T)));
  }
  return value;
}

/// Pose of seven numbers; throws InputError.
Pose pose_from(const double* row, const char* name);
void put(const Pose& pose, double* row) noexcept;
void put(const Wrench& wrench, double* row) noexcept;

}  // namespace thigma::c
