// Stand-in of Force Dimension's DHD and DRD. What is here is inside; the vendor's names are in the
// sources beside it.
#pragma once

#include "../common/board.h"
#include "../common/device.h"
#include "../common/export.h"

namespace standin {

// Numbers of the errors, by the SDK's list.
enum DhdError {
  kNoError = 0,
  kError = 1,
  kCom = 2,
  kNoDeviceFound = 5,
  kNotAvailable = 6,
  kTimeout = 7,
  kExpertModeDisabled = 9,
  kDeviceNotReady = 12,
  kInvalidIndex = 15,
  kNullArgument = 17,
  kInvalid = 21
};

constexpr int kTimeGuardReturn = 1;
constexpr int kMotorSaturatedReturn = 2;

struct DeviceType {
  int number = 0;
  const char* name = "";
  bool wrist = false, active_wrist = false, gripper = false, active_gripper = false;
  bool left = false;
  double max_force = 0.0;   // N
  double max_torque = 0.0;  // N m
};

// The type that key `type` says.
const DeviceType& type_of(int unit);

// Remembers the error of this thread, counts it; -1.
int fail(int unit, const char* call, int error);
int last_error();

// The device of an ID, -1: the default one; -1 where it is not open, which counts as a call after
// closing.
int opened_unit(signed char id, const char* call);
void set_default_unit(int unit);
int default_unit();

// Waits for the device's loop as a call does that talks to it, and for ever where it hangs.
void communicate(int unit);
// 0, or the error of a call: unplugged, or what the key says.
int fault(int unit, Key failure);
// All of that for a call that changes something: its device, or -1 after fail(). `values` are
// recorded.
int begin_call(signed char id, const char* call, Key failure);

// The pose now, or that of the last communication: kTimeGuardReturn.
int read_pose(int unit, const char* call, Pose* pose);
// Forgets the poses that velocities come from.
void forget_poses(int unit);

}  // namespace standin
