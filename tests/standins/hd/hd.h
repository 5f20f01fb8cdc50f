// Stand-in of OpenHaptics' HD API. What is here is inside; the vendor's names are in the sources
// beside it.
#pragma once

#include "../common/board.h"
#include "../common/device.h"
#include "../common/export.h"

// Given back by value, as the vendor's is; a struct of C.
struct HdErrorInfo {
  unsigned error;
  int internal_error;
  unsigned device;
};

namespace standin {

constexpr unsigned kNoHandle = 0xFFFFFFFFu;

// Numbers of the errors, by table A-15 of the API reference.
enum HdError {
  kInvalidEnum = 0x0100,
  kInvalidValue = 0x0101,
  kInvalidOperation = 0x0102,
  kInvalidInputType = 0x0103,
  kBadHandle = 0x0104,
  kWarmMotors = 0x0200,
  kExceededMaxForce = 0x0201,
  kExceededMaxForceImpulse = 0x0202,
  kExceededMaxVelocity = 0x0203,
  kForceError = 0x0204,
  kDeviceFault = 0x0300,
  kAlreadyInitiated = 0x0301,
  kCommError = 0x0302,
  kTimerError = 0x0304,
  kIllegalBegin = 0x0400,
  kIllegalEnd = 0x0401,
  kFrameError = 0x0402,
  kSchedulerFull = 0x0501
};

// Types of parameters, bits.
enum Type { kBool = 1, kInt = 2, kFloat = 4, kDouble = 8, kLong = 16 };

struct DeviceModel {
  const char* name = "";
  int output_dof = 0;
  double max_force = 0.0;       // N
  double max_continuous = 0.0;  // N
  double max_torque = 0.0;      // N m
  double stiffness = 0.0;       // N/mm
};
const DeviceModel& model_of(int unit);
double max_force_of(int unit);

// What a frame holds: read at its beginning, written at its end.
struct State {
  Pose pose;
  Vec velocity{};  // m/s
  Vec turning{};   // rad/s
  int buttons = 0;
};
struct Frame {
  int depth = 0;
  unsigned long done_tick = 0;  // the servo tick in which a frame was finished
  State current, last;
  Vec force{}, torque{};  // as they were set, N and the number that came
  bool force_set = false, torque_set = false;
  Vec last_force{};
  double end_time = 0.0;    // s, of the frame before
  double ramp_start = 0.0;  // s
};
Frame& frame_of(int unit);

// Adds to the stack of errors.
void push_error(int unit, const char* call, int error);

// The current device, -1 with an error where none is open.
int current_unit(const char* call);
void make_current(int unit);
// That of a handle, -1 with an error where it is not open.
int unit_of(unsigned handle, const char* call);

bool is_unplugged(int unit);
// Motors are on when output is enabled and the scheduler runs.
void update_mode(int unit);

bool scheduler_runs();
bool on_scheduler_thread();
unsigned long servo_tick();

}  // namespace standin
