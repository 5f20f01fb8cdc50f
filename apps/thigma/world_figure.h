#pragma once
// A recorded session of a world as panels against time.

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "experiments/common/plot.h"
#include "session_figure.h"

#include "thigma/recording/world_frames.h"

namespace thigma::app {

/// What has to be known of a recording of a world before it is drawn: a first pass over it.
struct WorldExtent {
  WorldRecordingInfo info;
  std::size_t frames = 0;
  std::vector<std::size_t> steps;  // haptic, by device, where they are apart
  double begin = 0.0, end = 0.0;   // of the frames [s]
  std::vector<Vec3> low, high;     // of each body's centre of mass [m]

  void add(const WorldRecordingInfo& of);
  void add(const RecordedWorldFrame& frame);
  void add(const HandTick& tick);
};

/// Panels, those of which there is something: force, torque and energy of each hand; height and
/// speed of the bodies that go farthest, at most eight; bodies awake; coordinates of joints, at
/// most eight. Where hands are apart from their world what is of hands is of each haptic frame,
/// against the hands' clock. Made of frames as they go by, in the memory of what is drawn.
/// Thread: one, [offline].
class WorldCurves {
 public:
  explicit WorldCurves(const WorldExtent& extent);  // of one frame at least; kept
  void add(const RecordedWorldFrame& frame);
  void add(const HandTick& tick);
  /// name: for the title
  plot::Figure figure(const WorldRecordingPass& pass, const std::string& name);

 private:
  template <class Sample>
  struct Curve {
    Thinner thinner;
    std::function<double(const Sample&)> value;
    std::size_t panel, device;
  };
  void panel(const char* title, const char* unit, const char* x = "time [s]");
  void frames(const std::string& label, std::function<double(const RecordedWorldFrame&)> value);
  void hands(const char* title, const char* unit, std::function<double(const Wrench&)> of_sent);
  void energies();
  void bodies();
  void show_noise_small(const std::vector<std::size_t>& drawn);
  void joints();

  const WorldExtent& extent_;
  std::vector<plot::Panel> panels_;
  std::vector<Curve<RecordedWorldFrame>> frame_curves_;
  std::vector<Curve<HandTick>> step_curves_;
  std::size_t frames_ = 0;
  std::vector<std::size_t> steps_;
  RecordedWorldFrame last_;  // before the one that goes by
};

}  // namespace thigma::app
