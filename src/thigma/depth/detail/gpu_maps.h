#pragma once
// Height maps and their largest sums on a graphics processor.

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "thigma/depth/detail/depth_shaders.h"
#include "thigma/depth/detail/gl_context.h"
#include "thigma/texture/haptic_texture.h"

namespace thigma::detail {

/// What one dispatch works on.
struct GpuFrame {
  int resolution = 0;        // samples along each side of every map
  std::int64_t samples = 0;  // of all maps
  std::vector<GpuTriangle> triangles;
  std::vector<GpuMap> maps;
  std::vector<GpuSum> sums;
};

/// The programs, the textures and the buffers on a graphics processor. A call that returns false
/// leaves a reason.
///
/// Thread: one at a time. All calls but open lie between enter and leave of `context`.
class GpuMaps {
 public:
  /// Null, and why, where there is none. timeout: of a frame [s]
  static std::unique_ptr<GpuMaps> open(std::unique_ptr<GlContext> context, double timeout,
                                       std::string& why);
  GpuMaps(const GpuMaps&) = delete;
  GpuMaps& operator=(const GpuMaps&) = delete;
  ~GpuMaps();

  /// Sees that textures, which stay where they are and unchanged, are there. first: index of the
  /// first texel of each.
  bool place(std::span<const HapticTexture* const> textures, std::vector<std::int32_t>& first);
  /// One peak a sum.
  bool render(const GpuFrame& frame, std::vector<GpuPeak>& peaks);
  /// Heights of the last frame.
  bool read_heights(std::int64_t first, std::span<float> heights);

  /// Samples that one frame may have.
  std::int64_t most_samples() const noexcept;
  GlContext& context() noexcept { return *context_; }
  const std::string& why() const noexcept { return why_; }

 private:
  GpuMaps(std::unique_ptr<GlContext> context, double timeout);
  bool compile(const char* source, GlId& program);
  bool wait();
  bool is_well();
  void fill(GpuBinding binding, const void* data, std::size_t bytes, GlEnum usage);
  bool fail(std::string why);

  struct Resident {
    const Texel* texels = nullptr;
    std::int64_t first = 0, count = 0;  // texels
  };
  std::unique_ptr<GlContext> context_;
  double timeout_;  // [s]
  GlId render_ = 0, reduce_ = 0;
  GlId buffers_[kGpuBindings] = {};
  std::int64_t most_bytes_ = 0;       // of one buffer
  std::int64_t texel_capacity_ = 0;   // texels
  std::int64_t height_capacity_ = 0;  // samples
  std::vector<Resident> resident_;
  std::int32_t frame_ = 0;
  std::string why_;
};

}  // namespace thigma::detail
