#pragma once
// The real-time label of a function and of a type. docs/realtime.md says what it forbids and how it
// is checked.

#include <type_traits>

/// Marks a [haptic] function: it neither allocates, locks, throws, logs nor calls the system.
/// Stands after the parameter list, in the place of noexcept. Compilers that know function effects
/// check it (clang >= 20, preset rtsan); elsewhere it is noexcept.
#if defined(__has_cpp_attribute)
#if __has_cpp_attribute(clang::nonblocking)
#define THIGMA_RT noexcept [[clang::nonblocking]]
#endif
#endif
#ifndef THIGMA_RT
#define THIGMA_RT noexcept
#endif

namespace thigma {

/// What may cross between threads by value: owns nothing, and is small enough to copy in a tick.
template <class T>
concept RtPayload = std::is_trivially_destructible_v<T> && sizeof(T) <= 64 * 1024;

}  // namespace thigma
