// The device behind the library: it moves, watches and cuts its own force. A thread of the client,
// or a process of its own.
#pragma once

#include "handle.h"

namespace standin {

enum Mode { kIdle = 0, kForce = 1, kBrake = 2 };
Mode mode_of(int unit);

// Causes of forces being off, numbered as Force Dimension's status has them.
enum Cause { kNone = 0, kButton = 1, kVelocity = 2, kWatchdog = 3, kSoftware = 4, kUnplugged = 5 };

// What was sent in one call: the numbers as they came.
struct Sent {
  const char* call = "";
  Vec force{};
  Vec torque{};
  double gripper = 0.0;
  int code = 0;  // what the call returned
};

// Maps the board of the library ("HD", "DRD"), reads its keys from the environment. Once, when the
// library is loaded.
// `own_values` puts what this vendor's devices have otherwise.
void load(const char* library, void (*own_values)());

// Starts the device where it does not run yet; by key `process` beside the library's file or as a
// thread.
void start_device();
// Ends the thread, tells the process to end.
void stop_device();
// Back to the values of the start and of the environment, everything closed, nothing recorded.
void reset_device();
// The loop of the device until the board says quit; in a process of its own also until its client
// is gone.
void run_device(bool own_process);

// Under the lock.
void open_unit(int unit);
void close_unit(int unit);
void advance(int unit);
void record(int unit, const Sent& sent);
// Lets motors do that; nothing where forces are off or a number is not finite.
void apply(int unit, const Vec& force, const Vec& torque);
void forces_off(int unit, Mode mode, Cause cause, const char* why);

}  // namespace standin
