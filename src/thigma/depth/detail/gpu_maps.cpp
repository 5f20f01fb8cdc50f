#include "thigma/depth/detail/gpu_maps.h"

#include <algorithm>
#include <cstdio>
#include <utility>

namespace thigma::detail {
namespace {

std::uint32_t index_of(GpuBinding binding) { return static_cast<std::uint32_t>(binding); }

std::ptrdiff_t bytes_of(std::int64_t count, std::size_t size) {
  return static_cast<std::ptrdiff_t>(count) * static_cast<std::ptrdiff_t>(size);
}

// Groups that OpenGL takes at least along one axis.
constexpr std::size_t kMostGroups = 65535;

// A driver may compile the programs once more when they are first used [s].
constexpr double kFirstTimeout = 20.0;

}  // namespace

GpuMaps::GpuMaps(std::unique_ptr<GlContext> context, double timeout)
    : context_(std::move(context)), timeout_(timeout) {}

GpuMaps::~GpuMaps() {
  if (!context_->enter()) return;
  const GlApi& gl = context_->api;
  gl.delete_buffers(kGpuBindings, buffers_);
  gl.delete_program(render_);
  gl.delete_program(reduce_);
  context_->leave();
}

std::unique_ptr<GpuMaps> GpuMaps::open(std::unique_ptr<GlContext> context, double timeout,
                                       std::string& why) {
  std::unique_ptr<GpuMaps> maps(new GpuMaps(std::move(context), timeout));
  GlContext& gl_context = maps->context();
  if (!gl_context.enter()) {
    why = gl_context.renderer + ": its context cannot be made current";
    return nullptr;
  }
  const GlApi& gl = gl_context.api;
  gl.get_integer(kGlMaxStorageBlock, &maps->most_bytes_);
  gl.gen_buffers(kGpuBindings, maps->buffers_);
  const bool is_ready =
      maps->compile(kRenderShader, maps->render_) && maps->compile(kReduceShader, maps->reduce_);
  gl_context.leave();
  if (is_ready) return maps;
  why = maps->why();
  return nullptr;
}

bool GpuMaps::fail(std::string why) {
  why_ = context_->renderer + ": " + std::move(why);
  return false;
}

bool GpuMaps::compile(const char* source, GlId& program) {
  const GlApi& gl = context_->api;
  char log[400] = "";
  GlInt is_done = 0;
  const GlId shader = gl.create_shader(kGlComputeShader);
  gl.shader_source(shader, 1, &source, nullptr);
  gl.compile_shader(shader);
  gl.get_shader(shader, kGlCompileStatus, &is_done);
  if (!is_done) gl.get_shader_log(shader, sizeof log, nullptr, log);
  if (is_done) {
    program = gl.create_program();
    gl.attach_shader(program, shader);
    gl.link_program(program);
    gl.get_program(program, kGlLinkStatus, &is_done);
    if (!is_done) gl.get_program_log(program, sizeof log, nullptr, log);
  }
  gl.delete_shader(shader);
  if (is_done) return true;
  std::string line(log);
  std::replace(line.begin(), line.end(), '\n', ' ');
  return fail("does not compile the depth programs: " + line);
}

std::int64_t GpuMaps::most_samples() const noexcept {
  return most_bytes_ / static_cast<std::int64_t>(sizeof(float));
}

void GpuMaps::fill(GpuBinding binding, const void* data, std::size_t bytes, GlEnum usage) {
  const GlApi& gl = context_->api;
  gl.bind_buffer(kGlStorageBuffer, buffers_[index_of(binding)]);
  gl.buffer_data(kGlStorageBuffer, static_cast<std::ptrdiff_t>(bytes), data, usage);
}

bool GpuMaps::place(std::span<const HapticTexture* const> textures,
                    std::vector<std::int32_t>& first) {
  const GlApi& gl = context_->api;
  const auto find = [&](const HapticTexture& texture) {
    return std::find_if(resident_.begin(), resident_.end(), [&](const Resident& r) {
      return r.texels == texture.texels.data() &&
             r.count == static_cast<std::int64_t>(texture.texels.size());
    });
  };
  std::int64_t used = 0, missing = 0, all = 0;
  for (const Resident& r : resident_) used += r.count;
  for (const HapticTexture* texture : textures) {
    const std::int64_t count = static_cast<std::int64_t>(texture->texels.size());
    all += count;
    if (find(*texture) == resident_.end()) missing += count;
  }
  if (used + missing > texel_capacity_) {
    if (bytes_of(all, sizeof(Texel)) > most_bytes_)
      return fail("takes no textures of " + std::to_string(all) + " texels together");
    resident_.clear();
    used = 0;
    texel_capacity_ = all;
    fill(GpuBinding::texels, nullptr, static_cast<std::size_t>(bytes_of(all, sizeof(Texel))),
         kGlStaticDraw);
  }
  first.clear();
  for (const HapticTexture* texture : textures) {
    auto there = find(*texture);
    if (there == resident_.end()) {
      const std::int64_t count = static_cast<std::int64_t>(texture->texels.size());
      gl.bind_buffer(kGlStorageBuffer, buffers_[index_of(GpuBinding::texels)]);
      gl.buffer_part(kGlStorageBuffer, bytes_of(used, sizeof(Texel)),
                     bytes_of(count, sizeof(Texel)), texture->texels.data());
      there = resident_.insert(resident_.end(), {texture->texels.data(), used, count});
      used += count;
    }
    first.push_back(static_cast<std::int32_t>(there->first));
  }
  return is_well();
}

bool GpuMaps::is_well() {
  const GlApi& gl = context_->api;
  if (gl.reset_status && gl.reset_status() != 0) return fail("was reset");
  const GlEnum error = gl.get_error();
  if (error == 0) return true;
  char text[40];
  std::snprintf(text, sizeof text, "OpenGL error 0x%x", error);
  return fail(text);
}

bool GpuMaps::wait() {
  const GlApi& gl = context_->api;
  const GlSync fence = gl.fence(kGlCommandsComplete, 0);
  if (!fence) return fail("gives no fence");
  const double timeout = frame_ == 1 ? std::max(timeout_, kFirstTimeout) : timeout_;
  const GlEnum answer =
      gl.wait_fence(fence, kGlFlushCommands, static_cast<std::uint64_t>(1e9 * timeout));
  gl.delete_fence(fence);
  if (answer == kGlAlreadySignaled || answer == kGlConditionSatisfied) return true;
  return fail("did not answer in time");
}

bool GpuMaps::render(const GpuFrame& frame, std::vector<GpuPeak>& peaks) {
  if (frame.maps.size() > kMostGroups || frame.sums.size() > kMostGroups ||
      frame.samples > most_samples())
    return fail("takes no frame of so many contacts");
  const GlApi& gl = context_->api;
  const auto send = [&](GpuBinding binding, const auto& list) {
    fill(binding, list.data(), list.size() * sizeof(list[0]), kGlStreamDraw);
  };
  send(GpuBinding::triangles, frame.triangles);
  send(GpuBinding::maps, frame.maps);
  send(GpuBinding::sums, frame.sums);
  if (frame.samples > height_capacity_) {
    height_capacity_ = frame.samples;
    fill(GpuBinding::heights, nullptr, static_cast<std::size_t>(frame.samples) * sizeof(float),
         kGlDynamicCopy);
  }
  peaks.assign(frame.sums.size(), {});
  send(GpuBinding::peaks, peaks);
  for (std::uint32_t i = 0; i < kGpuBindings; ++i)
    gl.bind_buffer_base(kGlStorageBuffer, i, buffers_[i]);
  // Never 0, which is what a buffer may hold that nobody wrote.
  frame_ = frame_ % 0x7ffffffe + 1;
  const auto dispatch = [&](GlId program, std::size_t x, std::size_t y) {
    gl.use_program(program);
    gl.uniform_3i(0, frame.resolution, frame.resolution, frame_);
    gl.dispatch(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y), 1);
  };
  dispatch(render_, static_cast<std::size_t>(frame.resolution), frame.maps.size());
  gl.memory_barrier(kGlStorageBarrier);
  dispatch(reduce_, frame.sums.size(), 1);
  gl.memory_barrier(kGlUpdateBarrier);
  if (!wait()) return false;
  gl.bind_buffer(kGlStorageBuffer, buffers_[index_of(GpuBinding::peaks)]);
  gl.read_buffer(kGlStorageBuffer, 0,
                 bytes_of(static_cast<std::int64_t>(peaks.size()), sizeof(GpuPeak)), peaks.data());
  if (!is_well()) return false;
  const bool is_whole = std::all_of(peaks.begin(), peaks.end(),
                                    [&](const GpuPeak& peak) { return peak.frame == frame_; });
  return is_whole || fail("left depths out");
}

bool GpuMaps::read_heights(std::int64_t first, std::span<float> heights) {
  const GlApi& gl = context_->api;
  gl.bind_buffer(kGlStorageBuffer, buffers_[index_of(GpuBinding::heights)]);
  gl.read_buffer(kGlStorageBuffer, bytes_of(first, sizeof(float)),
                 bytes_of(static_cast<std::int64_t>(heights.size()), sizeof(float)),
                 heights.data());
  return is_well();
}

}  // namespace thigma::detail
