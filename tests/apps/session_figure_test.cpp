#include "session_figure.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "recording/recording_samples.h"
#include <gtest/gtest.h>

namespace thigma::app {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

plot::Series ramp(std::size_t count) {
  plot::Series s{.label = "ramp"};
  for (std::size_t i = 0; i < count; ++i) {
    s.x.push_back(static_cast<double>(i));
    s.y.push_back(0.001 * static_cast<double>(i));
  }
  return s;
}

TEST(Thinned, keeps_a_peak_of_one_sample_and_the_order_of_time) {
  plot::Series s = ramp(100000);
  s.y[31234] = 500.0;
  s.y[77777] = -500.0;
  const plot::Series few = thinned(s, 1000);
  EXPECT_LE(few.x.size(), 1000u);
  EXPECT_GE(few.x.size(), 900u);
  EXPECT_TRUE(std::is_sorted(few.x.begin(), few.x.end()));
  const auto at = [&](double y) {
    const auto found = std::find(few.y.begin(), few.y.end(), y);
    return found == few.y.end() ? -1.0 : few.x[static_cast<std::size_t>(found - few.y.begin())];
  };
  EXPECT_EQ(at(500.0), 31234.0);
  EXPECT_EQ(at(-500.0), 77777.0);
}

TEST(Thinned, keeps_a_gap_and_leaves_short_curves_alone) {
  plot::Series s = ramp(50000);
  std::fill(s.y.begin() + 20000, s.y.begin() + 30000, kNone);
  const plot::Series few = thinned(s, 200);
  EXPECT_TRUE(std::any_of(few.y.begin(), few.y.end(), [](double y) { return std::isnan(y); }));
  for (std::size_t i = 0; i < few.x.size(); ++i) {
    const bool is_gap = few.x[i] >= 20000.0 && few.x[i] < 30000.0;
    EXPECT_EQ(std::isnan(few.y[i]), is_gap) << few.x[i];
  }
  EXPECT_EQ(thinned(ramp(150), 200).y, ramp(150).y);
}

class SessionFigure : public ::testing::Test {
 protected:
  const Recording recording = read_recording(test::write_recording("figure.mcap", 5000));
  const plot::Figure figure = session_figure(recording, "figure.mcap");

  const plot::Series& series(std::size_t panel, const std::string& label) const {
    const auto& all = figure.panels.at(panel).series;
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const auto& s) { return s.label == label; });
    EXPECT_NE(found, all.end()) << label;
    return *found;
  }
};

TEST_F(SessionFigure, shows_the_largest_force_and_torque_of_the_recording) {
  double force = 0.0, torque = 0.0;
  for (const HapticSample& s : recording.frames) {
    force = std::max(force, s.feedback.force.norm());
    torque = std::max(torque, 1e3 * s.feedback.torque.norm());
  }
  const auto largest = [](const plot::Series& s) {
    return *std::max_element(s.y.begin(), s.y.end());
  };
  EXPECT_EQ(largest(series(0, "felt")), force);
  EXPECT_EQ(largest(series(1, "felt")), torque);
}

TEST_F(SessionFigure, tells_the_rates_of_both_threads) {
  for (const double hz : series(4, "haptic").y) EXPECT_NEAR(hz, 1000.0, 25.0);
  for (const double hz : series(4, "contact").y) EXPECT_NEAR(hz, 100.0, 21.0);
}

TEST_F(SessionFigure, marks_events_in_every_panel) {
  ASSERT_EQ(figure.panels.size(), 8u);
  for (const plot::Panel& panel : figure.panels) {
    ASSERT_EQ(panel.guides.size(), 2u) << panel.title;
    EXPECT_EQ(panel.guides[1].value, 0.401);
    EXPECT_TRUE(panel.guides[1].is_vertical);
  }
  EXPECT_EQ(figure.panels[0].guides[1].label, "fault: pose_jump");
  EXPECT_NE(figure.note.find("2 samples are missing"), std::string::npos) << figure.note;
}

TEST_F(SessionFigure, is_drawn) {
  const std::string png = plot::figure_bytes(figure);
  EXPECT_EQ(png.substr(1, 3), "PNG");
}

TEST(SessionFigureOfLittle, one_frame_without_a_model_is_drawn) {
  Recording recording;
  HapticSample sample;
  sample.model_age = std::numeric_limits<double>::infinity();
  sample.penetration = -std::numeric_limits<double>::infinity();
  recording.frames.push_back(sample);
  const plot::Figure figure = session_figure(recording, "one");
  EXPECT_NE(figure.note.find("no end"), std::string::npos) << figure.note;
  EXPECT_EQ(plot::figure_bytes(figure).substr(1, 3), "PNG");
}

}  // namespace
}  // namespace thigma::app
