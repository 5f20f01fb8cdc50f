// Errors, models, handles.
#include <algorithm>

#include "hd.h"

namespace standin {
namespace {

// Figures of forces are nominal ones that CHAI3D publishes; continuous forces are our choice where
// it has none.
constexpr DeviceModel kModels[] = {{"Touch", 3, 3.3, 0.88, 0.0, 0.4},
                                   {"Touch X", 3, 7.9, 1.75, 0.0, 0.8},
                                   {"PHANToM Premium 1.5 6DOF", 6, 8.5, 1.4, 0.188, 0.8},
                                   {"PHANToM Premium 3.0", 3, 22.0, 3.0, 0.0, 0.8}};
constexpr int kModelCount = sizeof(kModels) / sizeof(kModels[0]);

constexpr int kStack = 64;
HdErrorInfo error_stack[kStack];
int error_count = 0;
std::atomic<int> current{-1};
Frame frames[kUnits];

void own_values() {
  for (int unit = 0; unit < kUnits; ++unit) {
    put(unit, k_up_axis, 1);
    put(unit, k_watchdog, 0);            // none is documented
    put(unit, k_velocity_threshold, 0);  // what is documented is checked by the library
    put(unit, k_sdk_minor, 4);
    put(unit, k_sdk_release, 0);
    frames[unit] = Frame();
  }
  current.store(-1);
  error_count = 0;
}

struct Load {
  Load() { load("HD", own_values); }
  ~Load();
};
const Load load_at_start;

struct Text {
  int error = 0;
  const char* text = "";
};
constexpr Text kTexts[] = {{0, "no error"},
                           {kInvalidEnum, "invalid enum"},
                           {kInvalidValue, "invalid value"},
                           {kInvalidOperation, "invalid operation"},
                           {kInvalidInputType, "invalid input type"},
                           {kBadHandle, "bad handle"},
                           {kWarmMotors, "warm motors"},
                           {kExceededMaxForce, "exceeded maximum force"},
                           {kExceededMaxForceImpulse, "exceeded maximum force impulse"},
                           {kExceededMaxVelocity, "exceeded maximum velocity"},
                           {kForceError, "force error"},
                           {kDeviceFault, "device fault"},
                           {kAlreadyInitiated, "device already initiated"},
                           {kCommError, "communication error"},
                           {0x0303, "communication configuration error"},
                           {kTimerError, "timer error"},
                           {kIllegalBegin, "illegal begin of a frame"},
                           {kIllegalEnd, "illegal end of a frame"},
                           {kFrameError, "frame error"},
                           {0x0500, "invalid priority"},
                           {kSchedulerFull, "scheduler full"},
                           {0x0600, "invalid licence"}};

}  // namespace

const DeviceModel& model_of(int unit) {
  return kModels[std::clamp(static_cast<int>(get(unit, k_model)), 0, kModelCount - 1)];
}

double max_force_of(int unit) {
  return is_on(unit, k_max_force) ? get(unit, k_max_force) : model_of(unit).max_force;
}

Frame& frame_of(int unit) { return frames[unit]; }

void push_error(int unit, const char* call, int error) {
  const int known = unit >= 0 && unit < kUnits ? unit : 0;
  const Locked lock;
  add(known, k_errors);
  note(known, call, error);
  if (error_count == kStack) {  // the oldest goes
    std::copy(error_stack + 1, error_stack + kStack, error_stack);
    --error_count;
  }
  error_stack[error_count++] = {static_cast<unsigned>(error), 0,
                                unit >= 0 ? static_cast<unsigned>(unit) : kNoHandle};
}

int current_unit(const char* call) {
  const int unit = current.load();
  if (unit >= 0 && is_on(unit, k_opened)) {
    return unit;
  }
  {
    const Locked lock;
    add(unit >= 0 ? unit : 0, k_after_close);
  }
  push_error(-1, call, kBadHandle);
  return -1;
}

void make_current(int unit) { current.store(unit); }

int unit_of(unsigned handle, const char* call) {
  if (handle < static_cast<unsigned>(kUnits) && is_on(static_cast<int>(handle), k_opened)) {
    return static_cast<int>(handle);
  }
  {
    const Locked lock;
    add(handle < static_cast<unsigned>(kUnits) ? static_cast<int>(handle) : 0, k_after_close);
  }
  push_error(-1, call, kBadHandle);
  return -1;
}

bool is_unplugged(int unit) { return is_on(unit, k_unplug) || !is_on(unit, k_plugged); }

}  // namespace standin

using namespace standin;

STANDIN_EXPORT HdErrorInfo hdGetError() {
  const Locked lock;
  return error_count > 0 ? error_stack[--error_count] : HdErrorInfo{0, 0, kNoHandle};
}

STANDIN_EXPORT const char* hdGetErrorString(unsigned error) {
  for (const Text& text : kTexts) {
    if (static_cast<unsigned>(text.error) == error) {
      return text.text;
    }
  }
  return "unknown error";
}

STANDIN_EXPORT void hdStopScheduler();

standin::Load::~Load() {
  hdStopScheduler();
  stop_device();
}
