#pragma once
// Directional depth on a graphics processor, by compute shaders of OpenGL 4.3.

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "thigma/depth/depth.h"

namespace thigma {

struct GpuDepthParams {
  // as on the processor; `width` is of the processor's way, where that has to step in
  GridDepthParams grid{};
  bool allows_hardware = true;
  // a renderer that runs on the processor; only where there is no other
  bool allows_software = true;
  // a frame that takes longer counts as lost; the first one may take 20 s [s]
  double timeout = 0.1;
  // sent at once and kept there; others when they first appear
  std::vector<const HapticTexture*> textures{};
  /// Told once why the graphics processor is not used: at once, or by the thread that samples when
  /// it is given up later. May be empty.
  std::function<void(const std::string& why)> warn{};
};

/// A backend and where it computes.
struct GpuDepth {
  std::unique_ptr<DepthBackend> backend;  // always there: the processor's where there is no other
  bool is_on_gpu = false;
  bool is_software = false;  // it renders, but on the processor
  std::string renderer;      // as the driver names it
  std::string reason;        // why not on a graphics processor
};

/// Share of the summed amplitudes, and of the size of the contact, within which depths before the
/// climb agree with the scalar reference: single precision, whose last bits OpenGL leaves open.
inline constexpr double kGpuPrecision = 1e-5;

/// Depth on a grid as make_grid_depth, heights and maxima on a graphics processor: all contacts and
/// configurations of a call in one dispatch that renders (2 maps a contact, 6 with differences),
/// and one that reduces. What follows the maximum (climb, places near it) is the processor's.
///
/// A short comparison with the scalar way decides whether a driver is used at all. When it fails
/// later - an error, a reset, no answer in time, results that are no depths - the frame and all
/// that follow are computed on the processor, and `warn` is told once.
///
/// Textures are sent to the graphics processor once: those of a contact have to stay in place,
/// unchanged, as long as the backend is used.
/// Thread    [offline]; never fails: without a graphics processor the backend is the processor's
///           and `reason` tells why. The backend's sample allocates inside the driver, and whenever
///           a frame is larger than any before.
/// Source    Sec. 4.4.2.
GpuDepth make_gpu_depth(const GpuDepthParams& params);

}  // namespace thigma
