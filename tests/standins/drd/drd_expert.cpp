// The expert part: closed until dhdEnableExpertMode; each call is counted.
#include "drd.h"

namespace standin {
namespace {

bool expert_mode = false;

int expert(signed char id, const char* call, double value) {
  const int unit = opened_unit(id, call);
  if (unit < 0) {
    return -1;
  }
  {
    const Locked lock;
    add(unit, k_expert_calls);
    note(unit, call, expert_mode ? 0 : -kExpertModeDisabled, &value, 1);
  }
  return expert_mode ? unit : fail(unit, call, kExpertModeDisabled);
}

int set_mode(const char* call, bool on) {
  const Locked lock;
  expert_mode = on;
  for (int unit = 0; unit < kUnits; ++unit) {
    put(unit, k_expert, on ? 1.0 : 0.0);
  }
  note(0, call, 0);
  return 0;
}

int set_key(signed char id, const char* call, Key key, double value) {
  const int unit = expert(id, call, value);
  if (unit >= 0) {
    put(unit, key, value);
  }
  return unit >= 0 ? 0 : -1;
}

template <class Number>
int get_key(signed char id, const char* call, Key key, Number* out) {
  const int unit = expert(id, call, 0.0);
  if (unit >= 0) {
    *out = static_cast<Number>(get(unit, key));
  }
  return unit >= 0 ? 0 : -1;
}

}  // namespace
}  // namespace standin

using namespace standin;

STANDIN_EXPORT int dhdEnableExpertMode() { return set_mode("dhdEnableExpertMode", true); }
STANDIN_EXPORT int dhdDisableExpertMode() { return set_mode("dhdDisableExpertMode", false); }

STANDIN_EXPORT int dhdSetWatchdog(unsigned char units, signed char id) {
  return set_key(id, "dhdSetWatchdog", k_watchdog, units);
}
STANDIN_EXPORT int dhdGetWatchdog(unsigned char* units, signed char id) {
  return get_key(id, "dhdGetWatchdog", k_watchdog, units);
}
STANDIN_EXPORT int dhdSetVelocityThreshold(unsigned value, signed char id) {
  return set_key(id, "dhdSetVelocityThreshold", k_velocity_threshold, value);
}
STANDIN_EXPORT int dhdGetVelocityThreshold(unsigned* value, signed char id) {
  return get_key(id, "dhdGetVelocityThreshold", k_velocity_threshold, value);
}
STANDIN_EXPORT int dhdSetTimeGuard(int us, signed char id) {
  return set_key(id, "dhdSetTimeGuard", k_timeguard_us, us < 0 ? 250 : us);
}

STANDIN_EXPORT double dhdGetTime() { return now(); }
STANDIN_EXPORT void dhdSleep(double seconds) { sleep_until(now() + seconds); }
STANDIN_EXPORT double dhdGetComFreq(signed char id) {
  const int unit = opened_unit(id, "dhdGetComFreq");
  const double seconds = unit < 0 ? 0.0 : now() - get(unit, k_start_time);
  return seconds > 0.0 ? 1e-3 * get(unit, k_sets) / seconds : 0.0;
}
