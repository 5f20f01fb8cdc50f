#include "session_figure.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <utility>

namespace thigma::app {
namespace {

using plot::Panel;
using plot::Series;

constexpr std::size_t kMostPoints = 2400;  // some two a pixel of a panel
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t kMostEvents = 40;

/// A number of every sample against its time, a member of the sample [s].
template <class Sample, class Value>
Series over_time(const std::vector<Sample>& samples, double Sample::*time, std::string label,
                 Value value) {
  Series series{.label = std::move(label)};
  for (const Sample& s : samples) {
    series.x.push_back(s.*time);
    series.y.push_back(value(s));
  }
  return thinned(series, kMostPoints);
}

template <class Value>
Series of_frames(const Recording& recording, std::string label, Value value) {
  return over_time(recording.frames, &HapticSample::time, std::move(label), value);
}

template <class Value>
Series of_updates(const Recording& recording, std::string label, Value value) {
  return over_time(recording.contacts, &ContactSample::published, std::move(label), value);
}

/// How many of `times` fall into each window of a length, a second.
Series rate_of(std::string label, const std::vector<double>& times, double begin, double end) {
  constexpr int kWindows = 100;
  Series series{.label = std::move(label), .mark = plot::Mark::steps};
  const double length = (end - begin) / kWindows;
  if (!(length > 0.0)) return series;
  std::vector<int> counts(kWindows, 0);
  for (const double t : times) {
    const double at = (t - begin) / length;
    if (at >= 0.0 && at < kWindows) ++counts[static_cast<std::size_t>(at)];
  }
  for (int i = 0; i < kWindows; ++i) {
    series.x.push_back(begin + length * i);
    series.y.push_back(counts[static_cast<std::size_t>(i)] / length);
  }
  series.x.push_back(end);
  return series;
}

Panel panel(std::string title, std::string unit, std::vector<Series> series) {
  Panel p{.title = std::move(title), .x = {.label = "time [s]"}, .y = {.label = std::move(unit)}};
  for (Series& s : series) {
    if (!s.x.empty()) p.series.push_back(std::move(s));
  }
  return p;
}

/// Forces and torques: what was felt, and by axis what the device was sent.
Panel wrench_panel(const Recording& recording, const char* title, const char* unit,
                   Vec3 Wrench::*part, double scale) {
  std::vector<Series> series;
  series.push_back(of_frames(
      recording, "felt", [&](const HapticSample& s) { return scale * (s.feedback.*part).norm(); }));
  for (int axis = 0; axis < 3; ++axis) {
    series.push_back(
        of_frames(recording, std::string("sent ") + "xyz"[axis],
                  [&](const HapticSample& s) { return scale * (s.command.*part)[axis]; }));
    series.back().width = 1.0;
  }
  return panel(title, unit, std::move(series));
}

Panel rate_panel(const Recording& recording) {
  const double begin = recording.frames.front().time, end = recording.frames.back().time;
  std::vector<double> frames, updates;
  for (const HapticSample& s : recording.frames) frames.push_back(s.time);
  for (const ContactSample& s : recording.contacts) updates.push_back(s.published);
  Panel p = panel("Rates", "[Hz]",
                  {rate_of("haptic", frames, begin, end), rate_of("contact", updates, begin, end)});
  p.y.low = 0.0;
  return p;
}

/// Events that nearly coincide share a line and a label.
void mark_events(const Recording& recording, plot::Figure& figure) {
  const double near = 0.02 * (recording.frames.back().time - recording.frames.front().time);
  std::vector<plot::Guide> guides;
  for (const SessionEvent& event : recording.events) {
    const std::string name = event.detail.empty() ? event.kind : event.kind + ": " + event.detail;
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

std::string note_of(const Recording& recording) {
  char text[160];
  std::snprintf(text, sizeof text, "%zu frames, %zu contact models, %.3f s",
                recording.frames.size(), recording.contacts.size(),
                recording.frames.back().time - recording.frames.front().time);
  std::string note = text;
  if (!recording.has_end) note += "; cut off: the recording has no end";
  if (recording.has_end && recording.end.dropped > 0)
    note += "; " + std::to_string(recording.end.dropped) + " samples are missing";
  return note;
}

}  // namespace

plot::Series thinned(const plot::Series& series, std::size_t most) {
  const std::size_t count = series.x.size();
  if (count <= most || most < 2) return series;
  plot::Series few = series;
  few.x.clear();
  few.y.clear();
  const auto keep = [&](std::size_t i) {
    few.x.push_back(series.x[i]);
    few.y.push_back(series.y[i]);
  };
  const std::size_t stretches = most / 2;
  for (std::size_t k = 0; k < stretches; ++k) {
    const std::size_t from = count * k / stretches, to = count * (k + 1) / stretches;
    std::size_t low = to, high = to, gap = to;
    for (std::size_t i = from; i < to; ++i) {
      if (!std::isfinite(series.y[i])) {
        gap = i;
        continue;
      }
      if (low == to || series.y[i] < series.y[low]) low = i;
      if (high == to || series.y[i] > series.y[high]) high = i;
    }
    std::vector<std::size_t> kept;
    for (const std::size_t i : {low, high, gap}) {
      if (i != to) kept.push_back(i);
    }
    std::sort(kept.begin(), kept.end());
    kept.erase(std::unique(kept.begin(), kept.end()), kept.end());
    for (const std::size_t i : kept) keep(i);
  }
  return few;
}

plot::Figure session_figure(const Recording& recording, const std::string& name) {
  plot::Figure figure{.title = name, .note = note_of(recording), .columns = 2, .width = 1200};
  const auto frames = [&](const char* label, auto value) {
    return of_frames(recording, label, value);
  };
  const auto updates = [&](const char* label, auto value) {
    return of_updates(recording, label, value);
  };
  using H = HapticSample;
  using C = ContactSample;
  figure.panels = {
      wrench_panel(recording, "Force", "[N]", &Wrench::force, 1.0),
      wrench_panel(recording, "Torque about the handle", "[mN m]", &Wrench::torque, 1e3),
      panel("Penetration of the contact model (below 0: apart)", "[mm]",
            {frames("deepest",
                    [](const H& s) {
                      return std::isfinite(s.penetration) ? 1e3 * s.penetration : kNone;
                    })}),
      panel("Coupling stretch, from hand to object", "[mm]",
            {frames("", [](const H& s) { return 1e3 * s.stretch; })}),
      rate_panel(recording),
      panel("Contacts", "[count]",
            {updates("contacts", [](const C& s) { return static_cast<double>(s.contacts); }),
             updates("clusters", [](const C& s) { return static_cast<double>(s.clusters); }),
             frames("pushing", [](const H& s) { return static_cast<double>(s.touching); })}),
      panel("Age of the contact model, and its query", "[ms]",
            {frames(
                 "age",
                 [](const H& s) { return std::isfinite(s.model_age) ? 1e3 * s.model_age : kNone; }),
             updates("query, CPU time", [](const C& s) { return 1e3 * s.query_cpu; })}),
      panel("Energy the hand has put in", "[mJ]",
            {frames("", [](const H& s) { return 1e3 * s.energy; })}),
  };
  mark_events(recording, figure);
  return figure;
}

}  // namespace thigma::app
