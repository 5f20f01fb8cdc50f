#pragma once
// A context of OpenGL for computing, without a window.

#include <memory>
#include <string>

#include "thigma/depth/detail/gl_api.h"

namespace thigma::detail {

struct EglState;

/// Owns one context of OpenGL 4.3 or later, opened through libEGL, which is loaded at run time.
///
/// Thread: current on a thread only between enter and leave there, so that any one thread at a time
/// may use it. What EGL had current on the thread comes back with leave.
class GlContext {
 public:
  /// The first graphics processor that offers one; where there is none, or none is allowed, a
  /// renderer in software.
  ///
  /// allows_hardware, allows_software  which kinds to try
  /// why      when null comes back: the reason, one line
  /// Thread   [offline]
  static std::unique_ptr<GlContext> open(bool allows_hardware, bool allows_software,
                                         std::string& why);
  GlContext(const GlContext&) = delete;
  GlContext& operator=(const GlContext&) = delete;
  ~GlContext();

  /// Makes it current; false: it cannot be, and leave is not called.
  bool enter() noexcept;
  void leave() noexcept;

  GlApi api;
  std::string renderer;
  bool is_software = false;

 private:
  explicit GlContext(std::unique_ptr<EglState> egl);
  std::unique_ptr<EglState> egl_;
};

}  // namespace thigma::detail
