// Names, values and signatures of EGL are those of the Khronos specifications (EGL 1.5,
// EXT_platform_device, EXT_device_enumeration, MESA_platform_surfaceless, MESA_device_software).
#include "thigma/depth/detail/gl_context.h"

#include <array>
#include <cstring>
#include <vector>

#include "thigma/core/shared_library.h"

namespace thigma::detail {
namespace {

using EglInt = std::int32_t;
using EglHandle = void*;

constexpr std::uint32_t kPlatformDevice = 0x313F, kPlatformSurfaceless = 0x31DD;
constexpr std::uint32_t kOpenGlApi = 0x30A2;
constexpr EglInt kExtensions = 0x3055, kNone = 0x3038, kSurfaceType = 0x3033, kRenderable = 0x3040,
                 kOpenGlBit = 0x0008, kMajor = 0x3098, kMinor = 0x30FB, kProfile = 0x30FD,
                 kCoreProfile = 0x0001, kResetNotification = 0x31BD, kLoseOnReset = 0x31BF;
constexpr EglInt kDraw = 0x3059, kRead = 0x305A;

struct EglApi {
  void* (*get_function)(const char*) = nullptr;
  EglHandle (*platform_display)(std::uint32_t, void*, const EglInt*) = nullptr;
  std::uint32_t (*query_devices)(EglInt, EglHandle*, EglInt*) = nullptr;
  const char* (*device_string)(EglHandle, EglInt) = nullptr;
  std::uint32_t (*initialize)(EglHandle, EglInt*, EglInt*) = nullptr;
  std::uint32_t (*bind_api)(std::uint32_t) = nullptr;
  std::uint32_t (*query_api)() = nullptr;
  std::uint32_t (*choose_config)(EglHandle, const EglInt*, EglHandle*, EglInt, EglInt*) = nullptr;
  EglHandle (*create_context)(EglHandle, EglHandle, EglHandle, const EglInt*) = nullptr;
  std::uint32_t (*destroy_context)(EglHandle, EglHandle) = nullptr;
  std::uint32_t (*make_current)(EglHandle, EglHandle, EglHandle, EglHandle) = nullptr;
  EglHandle (*current_context)() = nullptr;
  EglHandle (*current_display)() = nullptr;
  EglHandle (*current_surface)(EglInt) = nullptr;
};

// Never closed: drivers leave threads and exit handlers behind.
const SharedLibrary* egl_library(std::string& why) {
  static const SharedLibrary* const library = [&]() -> const SharedLibrary* {
    const char* const names[] = {"libEGL.so.1", "libEGL.so"};
    std::optional<SharedLibrary> opened = SharedLibrary::open(names, &why);
    return opened ? new SharedLibrary(std::move(*opened)) : nullptr;
  }();
  if (!library && why.empty()) why = "libEGL.so.1 does not open";
  return library;
}

template <class Function>
void set(void* address, Function& function) {
  static_assert(sizeof(function) == sizeof(address));
  std::memcpy(&function, &address, sizeof address);
}

bool load_egl(EglApi& egl, std::string& why) {
  const SharedLibrary* const library = egl_library(why);
  if (!library) return false;
  const char* const needed[] = {
      "eglGetProcAddress",    "eglInitialize",        "eglBindAPI",          "eglQueryAPI",
      "eglChooseConfig",      "eglCreateContext",     "eglDestroyContext",   "eglMakeCurrent",
      "eglGetCurrentContext", "eglGetCurrentDisplay", "eglGetCurrentSurface"};
  if (const char* missing = library->first_missing(needed)) {
    why = library->name() + " lacks " + missing;
    return false;
  }
  set(library->symbol("eglGetProcAddress"), egl.get_function);
  set(library->symbol("eglInitialize"), egl.initialize);
  set(library->symbol("eglBindAPI"), egl.bind_api);
  set(library->symbol("eglQueryAPI"), egl.query_api);
  set(library->symbol("eglChooseConfig"), egl.choose_config);
  set(library->symbol("eglCreateContext"), egl.create_context);
  set(library->symbol("eglDestroyContext"), egl.destroy_context);
  set(library->symbol("eglMakeCurrent"), egl.make_current);
  set(library->symbol("eglGetCurrentContext"), egl.current_context);
  set(library->symbol("eglGetCurrentDisplay"), egl.current_display);
  set(library->symbol("eglGetCurrentSurface"), egl.current_surface);
  set(egl.get_function("eglGetPlatformDisplayEXT"), egl.platform_display);
  set(egl.get_function("eglQueryDevicesEXT"), egl.query_devices);
  set(egl.get_function("eglQueryDeviceStringEXT"), egl.device_string);
  if (egl.platform_display) return true;
  why = library->name() + " has no displays without a window (EGL_EXT_platform_base)";
  return false;
}

struct Display {
  EglHandle handle = nullptr;
  bool is_software = false;
};

// Graphics processors first, then what renders in software.
std::vector<Display> find_displays(const EglApi& egl) {
  std::vector<Display> hardware, software;
  std::array<EglHandle, 16> devices{};
  EglInt count = 0;
  if (egl.query_devices && egl.query_devices(devices.size(), devices.data(), &count)) {
    for (EglInt i = 0; i < count; ++i) {
      const EglHandle device = devices[static_cast<std::size_t>(i)];
      const char* const words =
          egl.device_string ? egl.device_string(device, kExtensions) : nullptr;
      const bool is_software = words && std::strstr(words, "EGL_MESA_device_software");
      (is_software ? software : hardware)
          .push_back({egl.platform_display(kPlatformDevice, device, nullptr), is_software});
    }
  }
  software.push_back({egl.platform_display(kPlatformSurfaceless, nullptr, nullptr), true});
  hardware.insert(hardware.end(), software.begin(), software.end());
  return hardware;
}

EglHandle make_context(const EglApi& egl, EglHandle display) {
  EglInt major = 0, minor = 0;
  if (!display || !egl.initialize(display, &major, &minor)) return nullptr;
  if (!egl.bind_api(kOpenGlApi)) return nullptr;
  const EglInt wanted[] = {kSurfaceType, 0, kRenderable, kOpenGlBit, kNone};
  EglHandle config = nullptr;
  EglInt count = 0;
  if (!egl.choose_config(display, wanted, &config, 1, &count) || count < 1) config = nullptr;
  // A driver that can tell of a reset is preferred; one that knows nothing of it is asked without.
  const EglInt telling[] = {
      kMajor, 4, kMinor, 3, kProfile, kCoreProfile, kResetNotification, kLoseOnReset, kNone};
  if (EglHandle context = egl.create_context(display, config, nullptr, telling)) return context;
  const EglInt plain[] = {kMajor, 4, kMinor, 3, kProfile, kCoreProfile, kNone};
  return egl.create_context(display, config, nullptr, plain);
}

bool is_software_renderer(const std::string& renderer) {
  for (const char* name : {"llvmpipe", "softpipe", "swrast", "SWR"})
    if (renderer.find(name) != std::string::npos) return true;
  return false;
}

// What EGL has current on this thread.
struct Current {
  std::uint32_t api = 0;
  EglHandle display = nullptr, draw = nullptr, read = nullptr, context = nullptr;
};

}  // namespace

struct EglState {
  EglApi egl;
  EglHandle display = nullptr, context = nullptr;
  Current before;
};

GlContext::GlContext(std::unique_ptr<EglState> egl) : egl_(std::move(egl)) {}

GlContext::~GlContext() { egl_->egl.destroy_context(egl_->display, egl_->context); }

std::unique_ptr<GlContext> GlContext::open(bool allows_hardware, bool allows_software,
                                           std::string& why) {
  why.clear();
  EglApi egl;
  if (!load_egl(egl, why)) return nullptr;
  for (const Display& display : find_displays(egl)) {
    if (!(display.is_software ? allows_software : allows_hardware)) continue;
    const std::uint32_t api = egl.query_api();
    const EglHandle handle = make_context(egl, display.handle);
    egl.bind_api(api);
    if (!handle) continue;
    auto state = std::make_unique<EglState>();
    state->egl = egl;
    state->display = display.handle;
    state->context = handle;
    std::unique_ptr<GlContext> context(new GlContext(std::move(state)));
    if (!context->enter()) continue;
    const char* missing = nullptr;
    const bool has_all = load_gl_api(egl.get_function, context->api, missing);
    if (has_all) {
      const unsigned char* const name = context->api.get_string(kGlRenderer);
      context->renderer = name ? reinterpret_cast<const char*>(name) : "unnamed";
      context->is_software = is_software_renderer(context->renderer);
    }
    context->leave();
    if (has_all && (context->is_software ? allows_software : allows_hardware)) return context;
    if (!has_all) why = std::string("the driver lacks ") + missing;
  }
  if (why.empty()) why = "no renderer offers OpenGL 4.3 without a window";
  return nullptr;
}

bool GlContext::enter() noexcept {
  const EglApi& egl = egl_->egl;
  Current& before = egl_->before;
  before.api = egl.query_api();
  egl.bind_api(kOpenGlApi);
  before.display = egl.current_display();
  before.draw = egl.current_surface(kDraw);
  before.read = egl.current_surface(kRead);
  before.context = egl.current_context();
  if (egl.make_current(egl_->display, nullptr, nullptr, egl_->context)) return true;
  egl.bind_api(before.api);
  return false;
}

void GlContext::leave() noexcept {
  const EglApi& egl = egl_->egl;
  const Current& before = egl_->before;
  if (before.context)
    egl.make_current(before.display, before.draw, before.read, before.context);
  else
    egl.make_current(egl_->display, nullptr, nullptr, nullptr);
  egl.bind_api(before.api);
}

}  // namespace thigma::detail
