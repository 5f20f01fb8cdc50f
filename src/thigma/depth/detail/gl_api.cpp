#include "thigma/depth/detail/gl_api.h"

#include <cstring>

namespace thigma::detail {

bool load_gl_api(void* (*find)(const char* name), GlApi& api, const char*& missing) {
  missing = nullptr;
  const auto set = [&](const char* name, auto& function) {
    void* const address = find(name);
    static_assert(sizeof(function) == sizeof(address));
    std::memcpy(&function, &address, sizeof address);
    if (!address && !missing) missing = name;
  };
  set("glGetString", api.get_string);
  set("glGetError", api.get_error);
  set("glGetInteger64v", api.get_integer);
  set("glCreateShader", api.create_shader);
  set("glShaderSource", api.shader_source);
  set("glCompileShader", api.compile_shader);
  set("glGetShaderiv", api.get_shader);
  set("glGetShaderInfoLog", api.get_shader_log);
  set("glDeleteShader", api.delete_shader);
  set("glCreateProgram", api.create_program);
  set("glAttachShader", api.attach_shader);
  set("glLinkProgram", api.link_program);
  set("glGetProgramiv", api.get_program);
  set("glGetProgramInfoLog", api.get_program_log);
  set("glDeleteProgram", api.delete_program);
  set("glUseProgram", api.use_program);
  set("glUniform3i", api.uniform_3i);
  set("glGenBuffers", api.gen_buffers);
  set("glDeleteBuffers", api.delete_buffers);
  set("glBindBuffer", api.bind_buffer);
  set("glBindBufferBase", api.bind_buffer_base);
  set("glBufferData", api.buffer_data);
  set("glBufferSubData", api.buffer_part);
  set("glGetBufferSubData", api.read_buffer);
  set("glDispatchCompute", api.dispatch);
  set("glMemoryBarrier", api.memory_barrier);
  set("glFenceSync", api.fence);
  set("glClientWaitSync", api.wait_fence);
  set("glDeleteSync", api.delete_fence);
  const bool has_all = missing == nullptr;
  set("glGetGraphicsResetStatusKHR", api.reset_status);
  return has_all;
}

}  // namespace thigma::detail
