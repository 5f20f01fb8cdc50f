// A device of one's own: this one presses down for a second and lets go.
#include <cstdio>

#include "thigma/thigma.h"

using namespace thigma;

class Press final : public HapticDevice {
 public:
  std::string name() const override { return "press"; }
  const DeviceLimits& limits() const override { return limits_; }
  DeviceState read(double now) noexcept override {
    DeviceState state;
    state.time = now;
    state.motion.pose.position.z() = -0.02 * std::min(now, 1.0);
    state.buttons = now < 2.0 ? kClutchButton : 0;
    return state;
  }
  void write(const Wrench& wrench) noexcept override {
    largest_ = std::max(largest_, wrench.force.norm());
  }
  double largest() const { return largest_; }

 private:
  const DeviceLimits limits_{.max_force = 8.0, .holds_person = false};
  double largest_ = 0.0;
};

int main() {
  const Scene scene = load_scene("ellipsoid");
  SceneSession session = open_session(scene, {.device = "hand:", .duration = 3.0});
  Press press;
  const SessionSummary felt = run_lockstep(session.config, press);
  std::printf("sent at most %.2f N, the summary says %.2f N\n", press.largest(), felt.force_max);
}
