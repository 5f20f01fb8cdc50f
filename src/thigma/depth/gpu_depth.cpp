#include "thigma/depth/gpu_depth.h"

#include "thigma/depth/detail/gpu_backend.h"

namespace thigma {
namespace {

/// The backend on a graphics processor; null with a reason.
std::unique_ptr<DepthBackend> open_backend(const GpuDepthParams& params, GpuDepth& result) {
  std::unique_ptr<detail::GlContext> context =
      detail::GlContext::open(params.allows_hardware, params.allows_software, result.reason);
  if (!context) return nullptr;
  result.renderer = context->renderer;
  result.is_software = context->is_software;
  std::unique_ptr<detail::GpuMaps> maps =
      detail::GpuMaps::open(std::move(context), params.timeout, result.reason);
  return maps ? detail::make_gpu_backend(std::move(maps), params) : nullptr;
}

}  // namespace

GpuDepth make_gpu_depth(const GpuDepthParams& params) {
  GpuDepth result;
  // Shared with the backend, which outlives this call.
  const auto lost = std::make_shared<std::string>();
  GpuDepthParams listening = params;
  listening.warn = [lost, warn = params.warn](const std::string& why) {
    *lost = why;
    if (warn) warn(why);
  };
  result.backend = open_backend(listening, result);
  if (result.backend) {
    const std::string difference = detail::differs_from_scalar(*result.backend, params.grid);
    result.is_on_gpu = lost->empty() && difference.empty();
    if (result.is_on_gpu) return result;
    result.reason = lost->empty() ? result.renderer + ": " + difference : *lost;
  }
  result.backend = make_grid_depth(params.grid);
  if (lost->empty()) listening.warn("textures are computed on the processor: " + result.reason);
  return result;
}

}  // namespace thigma
