#pragma once
// The few functions of OpenGL 4.3 that computing depths needs, found at run time. Names, values and
// signatures are those of the Khronos specifications (OpenGL 4.3 core, KHR_robustness).

#include <cstddef>
#include <cstdint>

namespace thigma::detail {

using GlEnum = std::uint32_t;
using GlId = std::uint32_t;
using GlInt = std::int32_t;
struct GlSyncObject;
using GlSync = GlSyncObject*;

inline constexpr GlEnum kGlRenderer = 0x1F01, kGlVersion = 0x1F02;
inline constexpr GlEnum kGlComputeShader = 0x91B9, kGlCompileStatus = 0x8B81,
                        kGlLinkStatus = 0x8B82;
inline constexpr GlEnum kGlStorageBuffer = 0x90D2, kGlMaxStorageBlock = 0x90DE;
inline constexpr GlEnum kGlStreamDraw = 0x88E0, kGlStreamRead = 0x88E1, kGlStaticDraw = 0x88E4,
                        kGlDynamicCopy = 0x88EA;
inline constexpr std::uint32_t kGlStorageBarrier = 0x2000, kGlUpdateBarrier = 0x200;
inline constexpr GlEnum kGlCommandsComplete = 0x9117;
inline constexpr std::uint32_t kGlFlushCommands = 0x1;
inline constexpr GlEnum kGlAlreadySignaled = 0x911A, kGlConditionSatisfied = 0x911C;

/// One entry a function; set by load_gl_api. A test may put another in its place.
struct GlApi {
  const unsigned char* (*get_string)(GlEnum) = nullptr;
  GlEnum (*get_error)() = nullptr;
  void (*get_integer)(GlEnum, std::int64_t*) = nullptr;
  GlId (*create_shader)(GlEnum) = nullptr;
  void (*shader_source)(GlId, GlInt, const char* const*, const GlInt*) = nullptr;
  void (*compile_shader)(GlId) = nullptr;
  void (*get_shader)(GlId, GlEnum, GlInt*) = nullptr;
  void (*get_shader_log)(GlId, GlInt, GlInt*, char*) = nullptr;
  void (*delete_shader)(GlId) = nullptr;
  GlId (*create_program)() = nullptr;
  void (*attach_shader)(GlId, GlId) = nullptr;
  void (*link_program)(GlId) = nullptr;
  void (*get_program)(GlId, GlEnum, GlInt*) = nullptr;
  void (*get_program_log)(GlId, GlInt, GlInt*, char*) = nullptr;
  void (*delete_program)(GlId) = nullptr;
  void (*use_program)(GlId) = nullptr;
  void (*uniform_3i)(GlInt, GlInt, GlInt, GlInt) = nullptr;
  void (*gen_buffers)(GlInt, GlId*) = nullptr;
  void (*delete_buffers)(GlInt, const GlId*) = nullptr;
  void (*bind_buffer)(GlEnum, GlId) = nullptr;
  void (*bind_buffer_base)(GlEnum, GlId, GlId) = nullptr;
  void (*buffer_data)(GlEnum, std::ptrdiff_t, const void*, GlEnum) = nullptr;
  void (*buffer_part)(GlEnum, std::ptrdiff_t, std::ptrdiff_t, const void*) = nullptr;
  void (*read_buffer)(GlEnum, std::ptrdiff_t, std::ptrdiff_t, void*) = nullptr;
  void (*dispatch)(std::uint32_t, std::uint32_t, std::uint32_t) = nullptr;
  void (*memory_barrier)(std::uint32_t) = nullptr;
  GlSync (*fence)(GlEnum, std::uint32_t) = nullptr;
  GlEnum (*wait_fence)(GlSync, std::uint32_t, std::uint64_t) = nullptr;
  void (*delete_fence)(GlSync) = nullptr;
  GlEnum (*reset_status)() = nullptr;  // null where the driver cannot tell
};

/// Looks every function up.
///
/// find     address of a function by its name, or null; a context that offers OpenGL 4.3 is current
/// missing  the first name that was not found
/// returns  whether all are there but reset_status
bool load_gl_api(void* (*find)(const char* name), GlApi& api, const char*& missing);

}  // namespace thigma::detail
