#include "thigma/device/script.h"

#include <cmath>
#include <sstream>

#include <gtest/gtest.h>

#include "thigma/core/error.h"
#include "thigma/math/random.h"
#include "thigma/math/rotation.h"

namespace thigma {
namespace {

const std::string kHeader = "t,x,y,z,qx,qy,qz,qw\n";

std::vector<TimedPose> parse(const std::string& text) {
  std::istringstream stream(text);
  return parse_script(stream, "a.csv");
}

std::string reason(const std::string& text) {
  try {
    parse(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(Script, SkipsAByteOrderMark) {
  EXPECT_EQ(parse("\xEF\xBB\xBF" + kHeader + "0,1,2,3,0,0,0,1\n").size(), 1u);
  EXPECT_EQ(parse("\xEF\xBB\xBF# a comment\n" + kHeader + "0,1,2,3,0,0,0,1\n").size(), 1u);
}

TEST(Script, ReadsRowsButtonsAndComments) {
  const auto rows = parse(
      "# recorded by hand\n t, x,y,z,qx,qy,qz,qw,buttons\r\n"
      "-1,0,0,0,0,0,0,1,0\n\n1e-3, 0.1 ,-2e-2,3,0,0.6,0,-0.8,5\r\n");
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0].time, -1.0);
  EXPECT_EQ(rows[0].buttons, 0u);
  EXPECT_EQ(rows[1].pose.position, Vec3(0.1, -0.02, 3.0));
  EXPECT_NEAR(rows[1].pose.orientation.y(), 0.6, 1e-15);
  EXPECT_NEAR(rows[1].pose.orientation.w(), -0.8, 1e-15);
  EXPECT_EQ(rows[1].buttons, 5u);
  EXPECT_EQ(parse(kHeader + "0,0,0,0,0,0,0,1")[0].buttons, kClutchButton);
}

TEST(Script, ErrorsNameFileLineAndExpectation) {
  const std::string row = "0,0,0,0,0,0,0,1\n";
  EXPECT_EQ(reason(""), "a.csv: no pose, line 0, expected a header and at least one row");
  EXPECT_EQ(reason(kHeader), "a.csv: no pose, line 1, expected a header and at least one row");
  EXPECT_EQ(
      reason("time,x\n"),
      "a.csv: wrong header, line 1, expected 't,x,y,z,qx,qy,qz,qw' or the same and ',buttons'");
  EXPECT_EQ(reason(kHeader + row + "1,0,0,0,0,0,0\n"), "a.csv: 7 columns, line 3, expected 8");
  EXPECT_EQ(reason(kHeader + "0,0,0,0,0,0,0,1,1\n"), "a.csv: 9 columns, line 2, expected 8");
  EXPECT_EQ(reason(kHeader + "0,0,zero,0,0,0,0,1\n"),
            "a.csv: 'zero' in column 3, line 2, expected a finite number");
  EXPECT_EQ(reason(kHeader + "0,0,nan,0,0,0,0,1\n"),
            "a.csv: 'nan' in column 3, line 2, expected a finite number");
  EXPECT_EQ(reason(kHeader + "0,0,inf,0,0,0,0,1\n"),
            "a.csv: 'inf' in column 3, line 2, expected a finite number");
  EXPECT_EQ(reason(kHeader + "0,0,1e999,0,0,0,0,1\n"),
            "a.csv: '1e999' in column 3, line 2, expected a finite number");
  EXPECT_EQ(reason(kHeader + "0,0,,0,0,0,0,1\n"),
            "a.csv: '' in column 3, line 2, expected a finite number");
  EXPECT_EQ(
      reason(kHeader + row + row),
      "a.csv: time that does not increase, line 3, expected more than that of the row before");
  EXPECT_EQ(reason(kHeader + "0,0,0,0,0,0,0,1.00001\n"),
            "a.csv: quaternion of length 1.000010, line 2, expected 1 to 1e-6");
  EXPECT_EQ(
      reason("t,x,y,z,qx,qy,qz,qw,buttons\n0,0,0,0,0,0,0,1,0.5\n"),
      "a.csv: buttons that are no bit mask, line 2, expected an integer from 0 to 4294967295");
  // What slopes and velocities could not be made of.
  EXPECT_EQ(reason(kHeader + row + "1e308,0,0,0,0,0,0,1\n"),
            "a.csv: time of 1e+308 s, line 3, expected at most 1e9 s");
  EXPECT_EQ(reason(kHeader + row + "1e-300,0,0,0,0,0,0,1\n"),
            "a.csv: time less than a nanosecond after the row before, line 3, expected at least "
            "1e-9 s more");
  EXPECT_EQ(reason(kHeader + "0,0,1e300,0,0,0,0,1\n"),
            "a.csv: a place beyond 1000 km, line 2, expected metres");
  EXPECT_THROW(read_script("/nonexistent/poses.csv"), InputError);
}

std::vector<TimedPose> random_script(int rows) {
  Random random(23);
  std::vector<TimedPose> script;
  double time = 0.0;
  for (int i = 0; i < rows; ++i) {
    TimedPose row;
    row.time = time;
    row.pose.position = random.in_cube(0.1);
    row.pose.orientation = random.orientation();  // signs at random: q and -q must not matter
    row.buttons = static_cast<std::uint32_t>(i);
    script.push_back(row);
    time += random.uniform(0.05, 0.5);
  }
  return script;
}

double angle_between(const Quat& a, const Quat& b) {
  return vector_from_rotation(a * b.conjugate()).norm();
}

TEST(Script, PassesThroughItsRowsAndRestsOutside) {
  const auto script = random_script(20);
  ScriptCursor cursor;
  for (const TimedPose& row : script) {
    const Motion motion = script_motion(script, row.time, cursor);
    EXPECT_LT((motion.pose.position - row.pose.position).norm(), 1e-15);
    EXPECT_LT(angle_between(motion.pose.orientation, row.pose.orientation), 1e-14);
  }
  for (const double time : {-1.0, 0.0, script.back().time, script.back().time + 3.0}) {
    const Motion motion = script_motion(script, time, cursor);
    EXPECT_EQ(motion.twist.linear, Vec3::Zero());
    EXPECT_EQ(motion.twist.angular, Vec3::Zero());
  }
}

TEST(Script, TwistIsTheDerivativeAndContinuous) {
  const auto script = random_script(20);
  ScriptCursor cursor;
  const double h = 1e-6;
  for (double t = 0.01; t < script.back().time - 0.01; t += 0.0137) {
    const Motion before = script_motion(script, t - h, cursor);
    const Motion here = script_motion(script, t, cursor);
    const Motion after = script_motion(script, t + h, cursor);
    const Vec3 rate = (after.pose.position - before.pose.position) / (2 * h);
    const Vec3 turn =
        vector_from_rotation(after.pose.orientation * before.pose.orientation.conjugate()) /
        (2 * h);
    EXPECT_LT((rate - here.twist.linear).norm(), 1e-4);
    EXPECT_LT((turn - here.twist.angular).norm(), 2e-3);
    EXPECT_NEAR(here.pose.orientation.norm(), 1.0, 1e-15);
  }
  for (const TimedPose& row : script) {
    const Motion before = script_motion(script, row.time - 1e-9, cursor);
    const Motion after = script_motion(script, row.time + 1e-9, cursor);
    EXPECT_LT((after.twist.linear - before.twist.linear).norm(), 1e-5) << row.time;
    EXPECT_LT((after.twist.angular - before.twist.angular).norm(), 1e-4) << row.time;
  }
}

TEST(Script, DoesNotOvershootARest) {
  std::vector<TimedPose> script(4);
  const double z[4] = {0.0, 0.0, -0.02, -0.02};
  for (int i = 0; i < 4; ++i) {
    script[i].time = i;
    script[i].pose.position.z() = z[i];
  }
  ScriptCursor cursor;
  for (double t = 0.0; t <= 3.0; t += 0.01) {
    const double at = script_motion(script, t, cursor).pose.position.z();
    EXPECT_LE(at, 0.0);
    EXPECT_GE(at, -0.02);
    if (t <= 1.0) {
      EXPECT_EQ(at, 0.0);
    }
    if (t >= 2.0) {
      EXPECT_EQ(at, -0.02);
    }
  }
}

TEST(Script, CursorDoesNotChangeTheMotion) {
  const auto script = random_script(50);
  Random random(1);
  ScriptCursor wandering;
  for (int i = 0; i < 500; ++i) {
    const double t = random.uniform(-0.5, script.back().time + 0.5);
    ScriptCursor fresh;
    const Motion a = script_motion(script, t, wandering);
    const Motion b = script_motion(script, t, fresh);
    EXPECT_EQ(a.pose.position, b.pose.position);
    EXPECT_EQ(a.pose.orientation.coeffs(), b.pose.orientation.coeffs());
    EXPECT_EQ(wandering.row, fresh.row);
  }
}

TEST(Script, DeviceStartsAtItsFirstReadAndFinishes) {
  const auto script = random_script(3);
  const auto device = make_script_device(script);
  EXPECT_EQ(device->read(100.0).motion.pose.position, script[0].pose.position);
  const double end = 100.0 + script[2].time;
  const DeviceState middle = device->read(100.0 + script[1].time + 1e-6);
  EXPECT_EQ(middle.buttons, 1u);
  EXPECT_EQ(middle.status, DeviceStatus::ok);
  const DeviceState last = device->read(end + 1e-6);
  EXPECT_EQ(last.status, DeviceStatus::finished);
  EXPECT_EQ(last.motion.pose.position, script[2].pose.position);
  EXPECT_EQ(last.motion.twist.linear, Vec3::Zero());
}

}  // namespace
}  // namespace thigma
