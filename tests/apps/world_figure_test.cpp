#include "world_figure.h"

#include <algorithm>

#include "recording/written_worlds.h"
#include <gtest/gtest.h>

namespace thigma::app {
namespace {

plot::Figure figure_of(const std::string& path) {
  WorldExtent extent;
  const WorldRecordingPass pass =
      stream_world_recording(path, {[&](const WorldRecordingInfo& info) { extent.add(info); },
                                    [&](const RecordedWorldFrame& frame) { extent.add(frame); },
                                    [&](const HandTick& tick) { extent.add(tick); }});
  WorldCurves curves(extent);
  stream_world_recording(path, {{},
                                [&](const RecordedWorldFrame& frame) { curves.add(frame); },
                                [&](const HandTick& tick) { curves.add(tick); }});
  return curves.figure(pass, "world.mcap");
}

const plot::Panel& panel_of(const plot::Figure& figure, const std::string& title) {
  const auto found = std::find_if(figure.panels.begin(), figure.panels.end(),
                                  [&](const plot::Panel& p) { return p.title == title; });
  if (found != figure.panels.end()) return *found;
  ADD_FAILURE() << title << " is not drawn";
  static const plot::Panel none;
  return none;
}

TEST(WorldFigure, shows_hands_bodies_and_joints) {
  const std::string path = test::path_of("drawn.mcap");
  test::write_world(path, false);
  const plot::Figure figure = figure_of(path);
  const plot::Panel& force = panel_of(figure, "Force sent");
  ASSERT_EQ(force.series.size(), 2u);
  EXPECT_EQ(force.series[1].label, "hand 2");
  EXPECT_EQ(force.series[0].x.size(), test::kFrames);
  EXPECT_EQ(force.series[0].y[7], Vec3(1.0, 2.0, 3.0).norm());
  EXPECT_EQ(force.x.label, "time [s]");
  // The second hand's energy was not recorded.
  ASSERT_EQ(panel_of(figure, "Energy the hand has put in").series.size(), 1u);
  EXPECT_NEAR(panel_of(figure, "Energy the hand has put in").series[0].y[7], 7.0, 1e-9);
  const plot::Panel& speed = panel_of(figure, "Speed of the centre of mass");
  ASSERT_EQ(speed.series.size(), 2u);
  EXPECT_NEAR(speed.series[1].y[7], 1e5, 1e-3) << "0.1 m in 1 ms";
  const plot::Panel& awake = panel_of(figure, "Bodies awake, of those that go anywhere");
  EXPECT_EQ(awake.series.at(0).y[9], 2.0);
  EXPECT_EQ(awake.series.at(0).y[10], 1.0);
  EXPECT_EQ(panel_of(figure, "Coordinate of the joints").series.at(0).y[4], 1.0);
}

TEST(WorldFigure, shows_each_haptic_frame_of_hands_that_are_apart) {
  const std::string path = test::path_of("drawn_apart.mcap");
  test::write_world(path, true);
  const plot::Figure figure = figure_of(path);
  const plot::Panel& force = panel_of(figure, "Force sent");
  EXPECT_EQ(force.x.label, "time of the hands [s]");
  ASSERT_EQ(force.series.size(), 2u);
  EXPECT_EQ(force.series[1].x.size(), test::kSteps * test::kFrames);
  EXPECT_EQ(force.series[1].y[0], 1.0);
  EXPECT_EQ(force.series[1].y[1], 3.0);
}

}  // namespace
}  // namespace thigma::app
