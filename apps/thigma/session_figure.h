#pragma once
// A recorded session as panels against time.

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "experiments/common/plot.h"

#include "thigma/recording/recording.h"

namespace thigma::app {

/// At most about `most` points of a curve: of every stretch of equal length the lowest and the
/// highest stay, in their order, so that a peak of one frame is still seen. A value that is not
/// finite interrupts the curve; of such neighbours one stays.
plot::Series thinned(const plot::Series& series, std::size_t most);

/// thinned() of a curve of so many points whose points come one by one.
class Thinner {
 public:
  Thinner(std::string label, std::size_t count, std::size_t most);
  void add(double x, double y);
  plot::Series take();  // after the last

 private:
  struct Point {
    std::size_t index = 0;
    double x = 0.0, y = 0.0;
    bool is_there = false;
  };
  void end_stretch();

  plot::Series series_;
  std::size_t count_, stretches_, next_ = 0, stretch_ = 0;
  Point low_, high_, gap_;
};

/// What has to be known of a recording before it is drawn: a first pass over it.
struct SessionExtent {
  std::size_t frames = 0, contacts = 0;
  double begin = 0.0, end = 0.0;  // of the frames [s]
  void add(const HapticSample& sample) {
    if (frames++ == 0) begin = sample.time;
    end = sample.time;
  }
};

/// Eight panels: force, torque, penetration, coupling stretch, rates, contacts, age of the contact
/// model, energy; faults and other events are lines across all of them. Penetration is shown where
/// the object is in touch or near. Units in the labels, millimetres and milliseconds where SI would
/// be small. Made of samples as they go by, in the memory of what is drawn.
/// Thread: one, [offline].
class SessionCurves {
 public:
  explicit SessionCurves(const SessionExtent& extent);  // of one frame at least
  void add(const HapticSample& sample);
  void add(const ContactSample& sample);
  /// recording  of those samples; name: for the title
  plot::Figure figure(const RecordingInfo& recording, const std::string& name);

 private:
  struct FrameCurve {
    Thinner curve;
    std::function<double(const HapticSample&)> value;
    double width;  // [px]
  };
  struct UpdateCurve {
    Thinner curve;
    std::function<double(const ContactSample&)> value;
  };
  struct Curve {
    bool is_update;
    std::size_t index;
  };
  struct Plan {  // of a panel
    std::string title, unit;
    std::vector<Curve> curves;
  };

  void panel(std::string title, std::string unit);
  void frames(std::string label, std::function<double(const HapticSample&)> value);
  void updates(std::string label, std::function<double(const ContactSample&)> value);
  void wrenches(const char* title, const char* unit, Vec3 Wrench::*part, double scale);

  SessionExtent extent_;
  std::vector<FrameCurve> frame_curves_;
  std::vector<UpdateCurve> update_curves_;
  std::vector<Plan> plans_;
  std::vector<int> frame_counts_, update_counts_;  // by window of the rates
};

/// The same of a recording in memory, of at least one frame.
plot::Figure session_figure(const Recording& recording, const std::string& name);

}  // namespace thigma::app
