// Parameters that are read: tables of the API reference.
#include <algorithm>
#include <cstdio>

#include "hd.h"

namespace standin {
namespace {

struct Value {
  int count = 0;  // 0: no such parameter
  int types = 0;
  bool of_frame = false;  // state of the device: within a frame
  double number[16] = {};
};

Value vector(const Vec& v, double scale, bool of_frame) {
  return {3, kFloat | kDouble, of_frame, {scale * v[0], scale * v[1], scale * v[2]}};
}

// Column-major; the translation in mm. Axes as sensors have them: not quite orthonormal.
Value transform(int unit, const State& state) {
  Value value{16, kFloat | kDouble, true, {}};
  const std::array<Vec, 3> rows = matrix(state.pose.orientation);
  const double skew = get(unit, k_skew);
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      value.number[4 * column + row] = rows[row][column] +
                                       (column == 1 ? skew * rows[row][0] : 0.0) +
                                       (column == 2 ? skew * rows[row][2] : 0.0);
    }
    value.number[12 + row] = 1e3 * state.pose.position[row];
  }
  value.number[15] = 1.0;
  return value;
}

Value state_value(int unit, unsigned name) {
  const Frame& frame = frame_of(unit);
  const State& s = (name & 0x0200) != 0 ? frame.last : frame.current;
  switch (name & ~0x0200u) {
    case 0x2000:
      return {1, kInt, true, {static_cast<double>(s.buttons)}};
    case 0x2001:
      return {1, kBool, true, {get(unit, k_safety_switch)}};
    case 0x2002:
      return {1, kBool, true, {get(unit, k_inkwell)}};
    case 0x2050:
      return vector(s.pose.position, 1e3, true);
    case 0x2051:
      return vector(s.velocity, 1e3, true);
    case 0x2052:
      return transform(unit, s);
    case 0x2053:
      return vector(s.turning, 1.0, true);
    default:
      return {};
  }
}

Value force_value(int unit, unsigned name) {
  const Frame& frame = frame_of(unit);
  switch (name) {
    case 0x2700:
      return vector(frame.force, 1.0, true);
    case 0x2701:
    case 0x2704:
      return vector(frame.torque, 1.0, true);
    case 0x2800:
      return vector(frame.last_force, 1.0, true);
    default:
      return {};
  }
}

Value temperature(int unit) {
  Value value{model_of(unit).output_dof, kFloat | kDouble, false, {}};
  std::fill(value.number, value.number + 6, get(unit, k_motor_temperature));
  return value;
}

Value workspace(double scale) {
  return {6,
          kFloat | kDouble,
          false,
          {-80 * scale, -60 * scale, -35 * scale, 80 * scale, 60 * scale, 35 * scale}};
}

Value one(int types, double number) { return {1, types, false, {number}}; }

Value device_value(int unit, unsigned name) {
  constexpr int kReal = kFloat | kDouble;
  switch (name) {
    case 0x2550:
      return workspace(1.5);
    case 0x2551:
      return workspace(1.0);
    case 0x2552:
      return one(kFloat, 66.0);
    case 0x2553:
      return one(kInt, 6);
    case 0x2554:
      return one(kInt, model_of(unit).output_dof);
    case 0x2555:
      return one(kInt, get(unit, k_calibration_style));
    case 0x2600:
    case 0x2601:
      return one(kInt | kReal, get(0, k_rate));
    case 0x2602:
      return one(kReal, model_of(unit).stiffness);
    case 0x2603:
      return one(kReal, max_force_of(unit));
    case 0x2604:
      return one(kReal, is_on(unit, k_max_continuous) ? get(unit, k_max_continuous)
                                                      : model_of(unit).max_continuous);
    case 0x2605:
      return temperature(unit);
    case 0x2606:
      return one(kReal, 1e3 * get(unit, k_velocity_limit));
    case 0x2607:
      return one(kReal, get(unit, k_impulse_limit));
    case 0x2608:
      return one(kReal, get(unit, k_ramp_rate));
    case 0x2609:
      return one(kReal, 0.003);
    default:
      return {};
  }
}

Value find(int unit, unsigned name) {
  Value value = device_value(unit, name);
  value = value.count == 0 ? state_value(unit, name) : value;
  return value.count == 0 ? force_value(unit, name) : value;
}

template <class Number>
void read(const char* call, unsigned name, Type type, Number* out) {
  const int unit = current_unit(call);
  if (unit < 0) {
    return;
  }
  const Value value = find(unit, name);
  if (value.count == 0) {
    push_error(unit, call, kInvalidEnum);
    return;
  }
  if ((value.types & type) == 0) {
    push_error(unit, call, kInvalidInputType);
    return;
  }
  if (value.of_frame && frame_of(unit).depth == 0) {
    {
      const Locked lock;
      add(unit, k_outside_frame);
    }
    if (is_on(unit, k_strict_frames)) {
      push_error(unit, call, kFrameError);
      return;
    }
  }
  for (int i = 0; i < value.count; ++i) {
    out[i] = static_cast<Number>(value.number[i]);
  }
}

}  // namespace
}  // namespace standin

using namespace standin;

STANDIN_EXPORT void hdGetBooleanv(unsigned name, unsigned char* out) {
  read("hdGetBooleanv", name, kBool, out);
}
STANDIN_EXPORT void hdGetIntegerv(unsigned name, int* out) {
  read("hdGetIntegerv", name, kInt, out);
}
STANDIN_EXPORT void hdGetLongv(unsigned name, long* out) { read("hdGetLongv", name, kLong, out); }
STANDIN_EXPORT void hdGetFloatv(unsigned name, float* out) {
  read("hdGetFloatv", name, kFloat, out);
}
STANDIN_EXPORT void hdGetDoublev(unsigned name, double* out) {
  read("hdGetDoublev", name, kDouble, out);
}

STANDIN_EXPORT const char* hdGetString(unsigned name) {
  static char version[32];
  static char serial[32];
  if (name == 0x2500) {
    std::snprintf(version, sizeof(version), "%d.%d.%d", static_cast<int>(get(0, k_sdk_major)),
                  static_cast<int>(get(0, k_sdk_minor)), static_cast<int>(get(0, k_sdk_release)));
    return version;
  }
  const int unit = current_unit("hdGetString");
  if (unit < 0) {
    return "";
  }
  switch (name) {
    case 0x2501:
      return model_of(unit).name;
    case 0x2502:
      return "stand-in";
    case 0x2503:
      return "Thigma stand-in";
    case 0x2504:
      std::snprintf(serial, sizeof(serial), "%d", static_cast<int>(get(unit, k_serial)) + unit);
      return serial;
    default:
      push_error(unit, "hdGetString", kInvalidEnum);
      return "";
  }
}
