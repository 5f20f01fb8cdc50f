#pragma once
// The device a person holds. One of the two virtual interfaces of the project.

#include <cstdint>
#include <stdexcept>
#include <string>

#include "thigma/core/rt.h"
#include "thigma/math/pose.h"

namespace thigma {

/// Who ticks: our thread, or the device's own.
enum class DeviceClock : std::uint8_t { engine, device };

/// What a device can do. Constant after opening.
struct DeviceLimits {
  double max_force = 3.3;              // [N], norm
  double max_torque = 0.1;             // [N m], norm; 0 without actuated rotation
  double max_stiffness = 1000.0;       // [N/m] at 1 kHz
  double max_angular_stiffness = 0.3;  // [N m/rad] at 1 kHz
  double workspace_radius = 0.1;       // [m]
  bool senses_translation = true, senses_rotation = true;
  bool actuates_translation = true, actuates_rotation = true;
  double delay = 0.0;  // age of what a read returns, as far as known [s]
  DeviceClock clock = DeviceClock::engine;
  // what it is sent may push a person; false: simulated, or nothing is pushed
  bool holds_person = true;
};

enum class DeviceStatus : std::uint8_t {
  ok,
  not_ready,  // no sample yet; the last one is repeated
  lost,       // unplugged, closed or answering nonsense: a fault
  finished,   // a script or a replay has come to its end
};

/// One sample of a device.
struct DeviceState {
  // when the driver got it [s; session clock]; transport delay is not known to a driver
  double time = 0.0;
  Motion motion;              // handle pose and velocity [device frame: right-handed, z up]
  std::uint32_t buttons = 0;  // bits below
  DeviceStatus status = DeviceStatus::ok;
  // How much the handle counts, 1 to 0: less where what is known of it is old and held, as of a
  // page that is late. The springs to the hand and the wrench on it fade by this. Drivers of
  // devices with motors leave it at 1: what is late there is lost.
  double weight = 1.0;
  // Simulated devices only: where the handle is now, without encoders and delay. Nothing but the
  // account of energy looks at it: the port's energy is that of the motion, not of what is known of
  // it.
  bool has_true_handle = false;
  Pose true_handle;  // [device frame]
  // Of a second device that moves the view ("camera=ADDRESS"): where its handle is. The haptic step
  // passes it on to what is recorded and shown, and takes nothing from it.
  bool has_camera = false;
  Pose camera;  // [frame of the second device, as ours: x to the person, y right, z up]
};

/// Bit of DeviceState::buttons that means "the hand is on the object".
inline constexpr std::uint32_t kClutchButton = 1u;

/// Bits that turn the object where the device senses no rotation: about +x, -x, +y, -y, +z, -z of
/// the device frame.
inline constexpr std::uint32_t kTurnButtons[6] = {1u << 1, 1u << 2, 1u << 3,
                                                  1u << 4, 1u << 5, 1u << 6};

/// What a device that owns the clock calls once a frame of its servo loop.
/// Thread [haptic]: the device's own.
struct DeviceTick {
  void (*call)(void* context) noexcept = nullptr;
  void* context = nullptr;
};

/// A device or something that stands for one.
/// Thread: open and close are [offline]; read and write are [haptic], called in turn from one
/// thread. A device that owns the clock (DeviceLimits::clock) is read and written within a tick of
/// its own thread. Outside of ticks, and never at the same time as one, read says lost and write
/// turns its forces off, whatever the wrench.
class HapticDevice {
 public:
  virtual ~HapticDevice() = default;

  virtual const DeviceLimits& limits() const = 0;
  virtual std::string name() const = 0;

  /// State at `now` [s; session clock, or the device's own when it owns the clock].
  virtual DeviceState read(double now) THIGMA_RT = 0;

  /// Applies a wrench to the hand, about the handle [N, N m; device frame], until the next call.
  /// What the device cannot actuate (limits) is left out, what is too much is cut at the limits by
  /// norm.
  virtual void write(const Wrench& wrench) THIGMA_RT = 0;

  /// Lets a device that owns the clock call `tick` once a frame, until stop_ticks.
  ///
  /// rate     frames wanted [Hz]
  /// errors   DeviceUnavailable where the device cannot keep that rate; std::logic_error from a
  ///          device whose clock is the engine's
  /// Thread   [offline].
  virtual void start_ticks(double rate, DeviceTick tick) {
    static_cast<void>(rate), static_cast<void>(tick);
    throw std::logic_error(name() + ": does not own the clock");
  }

  /// Ends what start_ticks began: forces off in the vendor's order, and no call of the tick from
  /// here on. Does nothing where nothing was started.
  /// Thread   [offline].
  virtual void stop_ticks() noexcept {}

  /// Why the device is lost, or what it warns of (hot motors): one line for a person; "" is
  /// nothing. Lives as long as the device.
  /// Thread   [any].
  virtual const char* trouble() const THIGMA_RT { return ""; }
};

}  // namespace thigma
