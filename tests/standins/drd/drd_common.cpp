// Errors, types and the way to the device.
#include <array>
#include <cmath>

#include "drd.h"

namespace standin {

namespace {

// Numbers: the SDK's list of devices; figures of forces are nominal ones that CHAI3D publishes.
constexpr DeviceType kTypes[] = {
    {104, "sigma.7", true, true, true, true, false, 12.0, 0.2},
    {105, "sigma.7", true, true, true, true, true, 12.0, 0.2},
    {33, "omega.3", false, false, false, false, false, 12.0, 0.0},
    {34, "omega.6", true, false, false, false, false, 12.0, 0.0},
    {36, "omega.6", true, false, false, false, true, 12.0, 0.0},
    {35, "omega.7", true, false, true, true, false, 12.0, 0.0},
    {37, "omega.7", true, false, true, true, true, 12.0, 0.0},
    {108, "lambda.7", true, true, true, true, false, 20.0, 0.2},
    {109, "lambda.7", true, true, true, true, true, 20.0, 0.2},
    {63, "delta.3", false, false, false, false, false, 20.0, 0.0},
    {60, "Falcon", false, false, false, false, false, 8.0, 0.0},
};

thread_local int error_of_thread = 0;
std::atomic<int> chosen_unit{0};

struct Load {
  Load() {
    load("DRD", [] {});
  }
  ~Load() { stop_device(); }
};
const Load load_at_start;

double random_part() {
  thread_local unsigned state = 12345;
  state = state * 1664525u + 1013904223u;
  return static_cast<double>(state >> 8) / 16777216.0;
}

constexpr const char* kTexts[] = {"no error",
                                  "undocumented error",
                                  "communication error",
                                  "device controller is busy",
                                  "no driver found",
                                  "no device found",
                                  "feature not available",
                                  "timeout",
                                  "geometry error",
                                  "expert mode disabled",
                                  "feature not implemented",
                                  "out of memory",
                                  "device not ready",
                                  "file not found",
                                  "configuration error",
                                  "invalid index",
                                  "deprecated function",
                                  "null argument",
                                  "redundant integrity test failed",
                                  "feature not enabled",
                                  "device in use",
                                  "invalid argument",
                                  "no regulation"};

}  // namespace

const DeviceType& type_of(int unit) {
  for (const DeviceType& type : kTypes) {
    if (type.number == static_cast<int>(get(unit, k_type))) {
      return type;
    }
  }
  return kTypes[0];
}

int fail(int unit, const char* call, int error) {
  error_of_thread = error;
  const int known = unit >= 0 && unit < kUnits ? unit : 0;
  const Locked lock;
  add(known, k_errors);
  if (error != kTimeout) {
    note(known, call, -error);
  }
  return -1;
}

int last_error() { return error_of_thread; }
void set_default_unit(int unit) { chosen_unit.store(unit); }
int default_unit() { return chosen_unit.load(); }

int opened_unit(signed char id, const char* call) {
  const int unit = id < 0 ? default_unit() : id;
  const bool known = unit >= 0 && unit < kUnits;
  if (known && is_on(unit, k_opened)) {
    const Locked lock;
    add(unit, k_sdk_calls);
    return unit;
  }
  {
    const Locked lock;
    add(known ? unit : 0, k_after_close);
  }
  return fail(unit, call, known ? kNoDeviceFound : kInvalidIndex);
}

void communicate(int unit) {
  while (is_on(unit, k_hang)) {
    sleep_until(now() + 0.001);
  }
  const double loop = 1e-6 * get(unit, k_loop_us);
  if (is_on(unit, k_blocking) && loop > 0.0) {
    const double next = (std::floor(now() / loop) + 1.0) * loop;
    sleep_until(next + 1e-6 * get(unit, k_jitter_us) * random_part());
  }
}

int fault(int unit, Key failure) {
  return is_on(unit, k_unplug) || !is_on(unit, k_plugged) ? kCom
                                                          : static_cast<int>(get(unit, failure));
}

int begin_call(signed char id, const char* call, Key failure) {
  const int unit = opened_unit(id, call);
  if (unit < 0) {
    return -1;
  }
  communicate(unit);
  const int error = fault(unit, failure);
  return error == 0 ? unit : fail(unit, call, error);
}

}  // namespace standin

STANDIN_EXPORT int dhdErrorGetLast() { return standin::last_error(); }

STANDIN_EXPORT const char* dhdErrorGetStr(int error) {
  constexpr int kCount = sizeof(standin::kTexts) / sizeof(standin::kTexts[0]);
  return error >= 0 && error < kCount ? standin::kTexts[error] : standin::kTexts[1];
}

STANDIN_EXPORT const char* dhdErrorGetLastStr() { return dhdErrorGetStr(standin::last_error()); }
