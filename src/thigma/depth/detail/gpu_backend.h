#pragma once
// The backend behind make_gpu_depth, over any context: tests give it one that fails.

#include "thigma/depth/detail/gpu_maps.h"
#include "thigma/depth/gpu_depth.h"

namespace thigma::detail {

std::unique_ptr<DepthBackend> make_gpu_backend(std::unique_ptr<GpuMaps> maps,
                                               const GpuDepthParams& params);

/// Empty, or in what a backend's depths differ from the scalar way's on a small contact.
std::string differs_from_scalar(DepthBackend& backend, const GridDepthParams& grid);

}  // namespace thigma::detail
