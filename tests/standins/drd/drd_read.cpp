// Pose, velocity, buttons.
#include <cmath>
#include <limits>

#include "drd.h"

namespace standin {
namespace {

constexpr int kHistory = 256;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

struct Sample {
  double time = 0.0;
  Pose pose;
};

// Poses as they were read, from which the SDK makes velocities on the host.
struct History {
  Sample sample[kHistory];
  int count = 0;
  double linear_window = 0.020;   // s
  double angular_window = 0.020;  // s
};
History histories[kUnits];

// The oldest sample of the window and the newest; false where there are not two.
bool window_of(const History& h, double window, Sample* first, Sample* last) {
  if (h.count < 2) {
    return false;
  }
  *last = h.sample[(h.count - 1) % kHistory];
  int used = 1;
  for (int i = h.count - 2; i >= 0 && h.count - i <= kHistory; --i) {
    if (now() - h.sample[i % kHistory].time > window) {
      break;
    }
    *first = h.sample[i % kHistory];
    ++used;
  }
  return used >= 2 && last->time > first->time;
}

int velocity(signed char id, const char* call, bool angular, double scale, double* out[3]) {
  const int unit = opened_unit(id, call);
  Pose pose;
  if (unit < 0 || read_pose(unit, call, &pose) < 0) {
    return -1;
  }
  Sample first, last;
  bool known = false;
  {
    const Locked lock;
    const History& h = histories[unit];
    known = window_of(h, angular ? h.angular_window : h.linear_window, &first, &last);
  }
  if (!known) {
    return fail(unit, call, kTimeout);
  }
  Vec change{};
  const Quat& q = first.pose.orientation;
  const Vec turned = turn_vector(multiply(last.pose.orientation, {q[0], -q[1], -q[2], -q[3]}));
  for (int i = 0; i < 3; ++i) {
    change[i] = angular ? turned[i] : last.pose.position[i] - first.pose.position[i];
    *out[i] = scale * change[i] / (last.time - first.time);
    if (is_on(unit, k_nan_velocity)) {
      *out[i] = kNan;
    }
  }
  return 0;
}

void put_frame(int unit, const Pose& pose, double frame[3][3]) {
  const bool wrist = type_of(unit).wrist;
  const std::array<Vec, 3> rows = matrix(wrist ? pose.orientation : Quat{1, 0, 0, 0});
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      frame[i][j] = rows[i][j];
    }
  }
}

int configure(signed char id, const char* call, int ms, int mode, bool angular) {
  const int unit = opened_unit(id, call);
  if (unit < 0) {
    return -1;
  }
  if (ms < 1 || mode != 0) {
    return fail(unit, call, kInvalid);
  }
  (angular ? histories[unit].angular_window : histories[unit].linear_window) = 1e-3 * ms;
  return 0;
}

}  // namespace

void forget_poses(int unit) {
  histories[unit].count = 0;
  histories[unit].linear_window = histories[unit].angular_window = 0.020;
}

int read_pose(int unit, const char* call, Pose* pose) {
  History& h = histories[unit];
  if (fault(unit, k_fail_read) != 0) {
    communicate(unit);
    return fail(unit, call, fault(unit, k_fail_read));
  }
  {
    const Locked lock;
    const Sample& latest = h.sample[h.count > 0 ? (h.count - 1) % kHistory : 0];
    if (h.count > 0 && now() - latest.time < 1e-6 * get(unit, k_timeguard_us)) {
      add(unit, k_timeguards);
      *pose = latest.pose;
      return kTimeGuardReturn;
    }
  }
  communicate(unit);
  if (fault(unit, k_fail_read) != 0) {
    return fail(unit, call, fault(unit, k_fail_read));
  }
  const Locked lock;
  advance(unit);
  add(unit, k_reads);
  Sample& sample = h.sample[h.count % kHistory];
  h.count = h.count + 1 < 1 << 30 ? h.count + 1 : kHistory + (h.count + 1) % kHistory;
  sample.time = now();
  sample.pose = told_pose(unit);
  *pose = sample.pose;
  return 0;
}

}  // namespace standin

using namespace standin;

STANDIN_EXPORT int dhdGetPositionAndOrientationFrame(double* px, double* py, double* pz,
                                                     double frame[3][3], signed char id) {
  const char* call = "dhdGetPositionAndOrientationFrame";
  const int unit = opened_unit(id, call);
  Pose pose;
  const int result = unit < 0 ? -1 : read_pose(unit, call, &pose);
  if (result < 0) {
    return -1;
  }
  *px = pose.position[0];
  *py = pose.position[1];
  *pz = pose.position[2];
  put_frame(unit, pose, frame);
  return result;
}

STANDIN_EXPORT int dhdGetPosition(double* px, double* py, double* pz, signed char id) {
  double frame[3][3];
  return dhdGetPositionAndOrientationFrame(px, py, pz, frame, id);
}

STANDIN_EXPORT int dhdGetOrientationFrame(double frame[3][3], signed char id) {
  double p[3];
  return dhdGetPositionAndOrientationFrame(&p[0], &p[1], &p[2], frame, id);
}

STANDIN_EXPORT int dhdGetLinearVelocity(double* vx, double* vy, double* vz, signed char id) {
  double* out[3] = {vx, vy, vz};
  return velocity(id, "dhdGetLinearVelocity", false, 1.0, out);
}

STANDIN_EXPORT int dhdGetAngularVelocityRad(double* wx, double* wy, double* wz, signed char id) {
  double* out[3] = {wx, wy, wz};
  return velocity(id, "dhdGetAngularVelocityRad", true, 1.0, out);
}

STANDIN_EXPORT int dhdGetAngularVelocityDeg(double* wx, double* wy, double* wz, signed char id) {
  double* out[3] = {wx, wy, wz};
  return velocity(id, "dhdGetAngularVelocityDeg", true, 57.29577951308232, out);
}

STANDIN_EXPORT int dhdConfigLinearVelocity(int ms, int mode, signed char id) {
  return configure(id, "dhdConfigLinearVelocity", ms, mode, false);
}

STANDIN_EXPORT int dhdConfigAngularVelocity(int ms, int mode, signed char id) {
  return configure(id, "dhdConfigAngularVelocity", ms, mode, true);
}

STANDIN_EXPORT unsigned dhdGetButtonMask(signed char id) {
  const int unit = opened_unit(id, "dhdGetButtonMask");
  if (unit < 0 || fault(unit, k_fail_read) != 0) {
    return 0;
  }
  return static_cast<unsigned>(get(unit, k_buttons));
}

STANDIN_EXPORT int dhdGetButton(int index, signed char id) {
  const int unit = opened_unit(id, "dhdGetButton");
  if (unit < 0 || fault(unit, k_fail_read) != 0) {
    return unit < 0 ? -1 : fail(unit, "dhdGetButton", fault(unit, k_fail_read));
  }
  return index < 0 || index > 15 ? fail(unit, "dhdGetButton", kInvalidIndex)
                                 : (static_cast<int>(get(unit, k_buttons)) >> index) & 1;
}

STANDIN_EXPORT int dhdGetGripperGap(double* gap, signed char id) {
  const int unit = begin_call(id, "dhdGetGripperGap", k_fail_read);
  if (unit < 0) {
    return -1;
  }
  if (!type_of(unit).gripper) {
    return fail(unit, "dhdGetGripperGap", kNotAvailable);
  }
  *gap = get(unit, k_gripper_gap);
  return 0;
}
