#include "session_figure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <utility>

namespace thigma::app {
namespace {

using plot::Series;

constexpr std::size_t kMostPoints = 2400;  // some two a pixel of a panel
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t kMostEvents = 40;

constexpr std::size_t kWindows = 100;  // of the rates

plot::Panel panel_of(std::string title, std::string unit) {
  return {.title = std::move(title), .x = {.label = "time [s]"}, .y = {.label = std::move(unit)}};
}

/// Counts a time in the window of the rates it falls into.
void count(const SessionExtent& extent, double time, std::vector<int>& counts) {
  const double length = (extent.end - extent.begin) / kWindows;
  if (!(length > 0.0)) return;
  const double at = (time - extent.begin) / length;
  if (at >= 0.0 && at < kWindows) ++counts[static_cast<std::size_t>(at)];
}

Series rate_of(std::string label, const SessionExtent& extent, const std::vector<int>& counts) {
  Series series{.label = std::move(label), .mark = plot::Mark::steps};
  const double length = (extent.end - extent.begin) / kWindows;
  if (!(length > 0.0)) return series;
  for (std::size_t i = 0; i < kWindows; ++i) {
    series.x.push_back(extent.begin + length * static_cast<double>(i));
    series.y.push_back(counts[i] / length);
  }
  series.x.push_back(extent.end);
  return series;
}

/// Events that nearly coincide share a line and a label.
void mark_events(const RecordingInfo& recording, const SessionExtent& extent,
                 plot::Figure& figure) {
  const double near = 0.02 * (extent.end - extent.begin);
  std::vector<plot::Guide> guides;
  for (const SessionEvent& event : recording.events) {
    std::string name = event_name(event.kind);
    if (!event.detail.empty()) name += ": " + event.detail;
    if (!guides.empty() && event.time - guides.back().value <= near) {
      guides.back().label += ", " + name;
    } else if (guides.size() < kMostEvents) {
      guides.push_back({name, event.time, true});
    }
  }
  for (std::size_t i = 0; i < figure.panels.size(); ++i) {
    for (plot::Guide guide : guides) {
      if (i > 0) guide.label.clear();
      figure.panels[i].guides.push_back(std::move(guide));
    }
  }
}

std::string note_of(const RecordingInfo& recording, const SessionExtent& extent) {
  char text[160];
  std::snprintf(text, sizeof text, "%zu frames, %zu contact models, %.3f s", extent.frames,
                extent.contacts, extent.end - extent.begin);
  std::string note = text;
  if (!recording.has_end) note += "; cut off: the recording has no end";
  if (recording.has_end && recording.end.dropped > 0)
    note += "; " + std::to_string(recording.end.dropped) + " samples are missing";
  return note;
}

}  // namespace

Thinner::Thinner(std::string label, std::size_t count, std::size_t most)
    : series_{.label = std::move(label)},
      count_(count),
      stretches_(count <= most || most < 2 ? 0 : most / 2) {}

void Thinner::end_stretch() {
  std::array<Point, 3> kept = {low_, high_, gap_};
  std::sort(kept.begin(), kept.end(),
            [](const Point& a, const Point& b) { return a.index < b.index; });
  std::size_t last = count_;
  for (const Point& p : kept) {
    if (!p.is_there || p.index == last) continue;
    series_.x.push_back(p.x);
    series_.y.push_back(p.y);
    last = p.index;
  }
  low_ = high_ = gap_ = Point{};
}

void Thinner::add(double x, double y) {
  const std::size_t i = next_++;
  if (stretches_ == 0) {
    series_.x.push_back(x);
    series_.y.push_back(y);
    return;
  }
  const Point point{i, x, y, true};
  if (!std::isfinite(y)) {
    gap_ = point;
  } else {
    if (!low_.is_there || y < low_.y) low_ = point;
    if (!high_.is_there || y > high_.y) high_ = point;
  }
  if (i + 1 < count_ * (stretch_ + 1) / stretches_) return;
  end_stretch();
  ++stretch_;
}

plot::Series Thinner::take() { return std::move(series_); }

plot::Series thinned(const plot::Series& series, std::size_t most) {
  Thinner thinner(series.label, series.x.size(), most);
  for (std::size_t i = 0; i < series.x.size(); ++i) thinner.add(series.x[i], series.y[i]);
  plot::Series few = series;
  plot::Series points = thinner.take();
  few.x = std::move(points.x);
  few.y = std::move(points.y);
  return few;
}

void SessionCurves::panel(std::string title, std::string unit) {
  plans_.push_back({std::move(title), std::move(unit), {}});
}

void SessionCurves::frames(std::string label, std::function<double(const HapticSample&)> value) {
  plans_.back().curves.push_back({false, frame_curves_.size()});
  frame_curves_.push_back({Thinner(std::move(label), extent_.frames, kMostPoints), std::move(value),
                           plot::Series{}.width});
}

void SessionCurves::updates(std::string label, std::function<double(const ContactSample&)> value) {
  plans_.back().curves.push_back({true, update_curves_.size()});
  update_curves_.push_back(
      {Thinner(std::move(label), extent_.contacts, kMostPoints), std::move(value)});
}

/// Forces and torques: what was felt, and by axis what the device was sent.
void SessionCurves::wrenches(const char* title, const char* unit, Vec3 Wrench::*part,
                             double scale) {
  panel(title, unit);
  frames("felt",
         [part, scale](const HapticSample& s) { return scale * (s.feedback.*part).norm(); });
  for (int axis = 0; axis < 3; ++axis) {
    frames(std::string("sent ") + "xyz"[axis],
           [part, scale, axis](const HapticSample& s) { return scale * (s.command.*part)[axis]; });
    frame_curves_.back().width = 1.0;
  }
}

SessionCurves::SessionCurves(const SessionExtent& extent)
    : extent_(extent), frame_counts_(kWindows, 0), update_counts_(kWindows, 0) {
  using H = HapticSample;
  using C = ContactSample;
  const auto finite = [](double value) { return std::isfinite(value) ? 1e3 * value : kNone; };
  wrenches("Force", "[N]", &Wrench::force, 1.0);
  wrenches("Torque about the handle", "[mN m]", &Wrench::torque, 1e3);
  panel("Penetration of the contact model (below 0: apart)", "[mm]");
  frames("deepest", [finite](const H& s) { return finite(s.penetration); });
  panel("Coupling stretch, from hand to object", "[mm]");
  frames("", [](const H& s) { return 1e3 * s.stretch; });
  panel("Rates", "[Hz]");
  panel("Contacts", "[count]");
  updates("contacts", [](const C& s) { return static_cast<double>(s.contacts); });
  updates("clusters", [](const C& s) { return static_cast<double>(s.clusters); });
  frames("pushing", [](const H& s) { return static_cast<double>(s.touching); });
  panel("Age of the contact model, and its query", "[ms]");
  frames("age", [finite](const H& s) { return finite(s.model_age); });
  updates("query, CPU time", [](const C& s) { return 1e3 * s.query_cpu; });
  panel("Energy the hand has put in", "[mJ]");
  frames("", [](const H& s) { return 1e3 * s.energy; });
}

void SessionCurves::add(const HapticSample& sample) {
  for (FrameCurve& c : frame_curves_) c.curve.add(sample.time, c.value(sample));
  count(extent_, sample.time, frame_counts_);
}

void SessionCurves::add(const ContactSample& sample) {
  for (UpdateCurve& c : update_curves_) c.curve.add(sample.published, c.value(sample));
  count(extent_, sample.published, update_counts_);
}

plot::Figure SessionCurves::figure(const RecordingInfo& recording, const std::string& name) {
  plot::Figure figure{
      .title = name, .note = note_of(recording, extent_), .columns = 2, .width = 1200};
  for (const Plan& plan : plans_) {
    plot::Panel drawn = panel_of(plan.title, plan.unit);
    const auto put = [&drawn](plot::Series series) {
      if (!series.x.empty()) drawn.series.push_back(std::move(series));
    };
    if (plan.title == "Rates") {
      put(rate_of("haptic", extent_, frame_counts_));
      put(rate_of("contact", extent_, update_counts_));
      drawn.y.low = 0.0;
    }
    for (const Curve& curve : plan.curves) {
      plot::Series series = curve.is_update ? update_curves_[curve.index].curve.take()
                                            : frame_curves_[curve.index].curve.take();
      if (!curve.is_update) series.width = frame_curves_[curve.index].width;
      put(std::move(series));
    }
    figure.panels.push_back(std::move(drawn));
  }
  mark_events(recording, extent_, figure);
  return figure;
}

plot::Figure session_figure(const Recording& recording, const std::string& name) {
  SessionExtent extent;
  for (const HapticSample& sample : recording.frames) extent.add(sample);
  extent.contacts = recording.contacts.size();
  SessionCurves curves(extent);
  for (const HapticSample& sample : recording.frames) curves.add(sample);
  for (const ContactSample& sample : recording.contacts) curves.add(sample);
  return curves.figure(recording, name);
}

}  // namespace thigma::app
