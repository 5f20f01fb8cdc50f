// Parameters that are set: tables of the API reference.
#include <cmath>

#include "hd.h"

namespace standin {
namespace {

struct Parameter {
  unsigned name = 0;
  int types = 0;
  int count = 0;
  Key key = kKeyCount;  // of a number that is kept
  double scale = 1.0;
};
constexpr Parameter kParameters[] = {{0x2606, kFloat | kDouble, 1, k_velocity_limit, 1e-3},
                                     {0x2607, kFloat | kDouble, 1, k_impulse_limit, 1.0},
                                     {0x2608, kFloat | kDouble, 1, k_ramp_rate, 1.0},
                                     {0x2700, kFloat | kDouble, 3, kKeyCount, 1.0},
                                     {0x2701, kFloat | kDouble, 3, kKeyCount, 1.0},
                                     {0x2704, kFloat | kDouble, 3, kKeyCount, 1.0},
                                     {0x2900, kInt, 1, k_status_light, 1.0}};

// The number is kept as it came: what unit a torque has is disputed.
void put_wrench(int unit, const char* call, unsigned name, const Vec& v) {
  Frame& frame = frame_of(unit);
  if (frame.depth == 0) {
    {
      const Locked lock;
      add(unit, k_outside_frame);
      note(unit, call, kFrameError, v.data(), 3);
    }
    push_error(unit, call, kFrameError);
    return;
  }
  const Locked lock;
  if (name == 0x2700) {
    frame.force = v;
    frame.force_set = true;
    return;
  }
  frame.torque = v;
  frame.torque_set = true;
  put(unit, k_torque_pname, name);
  add(unit, k_torque_sets);
  note(unit, name == 0x2701 ? "hdSet HD_CURRENT_TORQUE" : "hdSet HD_CURRENT_GIMBAL_TORQUE", 0,
       v.data(), 3);
  if (model_of(unit).output_dof != 6 && norm(v) != 0.0) {
    add(unit, k_torque_ignored);
  }
}

template <class Number>
void write(const char* call, unsigned name, Type type, const Number* values) {
  const int unit = current_unit(call);
  if (unit < 0) {
    return;
  }
  for (const Parameter& parameter : kParameters) {
    if (parameter.name != name) {
      continue;
    }
    if ((parameter.types & type) == 0) {
      push_error(unit, call, kInvalidInputType);
    } else if (parameter.count == 3) {
      put_wrench(unit, call, name,
                 {static_cast<double>(values[0]), static_cast<double>(values[1]),
                  static_cast<double>(values[2])});
    } else {
      put(unit, parameter.key, parameter.scale * static_cast<double>(values[0]));
    }
    return;
  }
  push_error(unit, call, kInvalidEnum);
}

}  // namespace
}  // namespace standin

using namespace standin;

STANDIN_EXPORT void hdSetBooleanv(unsigned name, const unsigned char* values) {
  write("hdSetBooleanv", name, kBool, values);
}
STANDIN_EXPORT void hdSetIntegerv(unsigned name, const int* values) {
  write("hdSetIntegerv", name, kInt, values);
}
STANDIN_EXPORT void hdSetLongv(unsigned name, const long* values) {
  write("hdSetLongv", name, kLong, values);
}
STANDIN_EXPORT void hdSetFloatv(unsigned name, const float* values) {
  write("hdSetFloatv", name, kFloat, values);
}
#ifndef STANDIN_MISSING_SYMBOL
STANDIN_EXPORT void hdSetDoublev(unsigned name, const double* values) {
  write("hdSetDoublev", name, kDouble, values);
}
#endif
