// Timed poses. A monotone cubic through each coordinate: at a row the slope is the weighted
// harmonic mean of the neighbouring slopes, or 0 where they differ in sign, so that a script that
// rests does not swing (Fritsch, Butland 1984). The quaternion goes through the same cubic and is
// normalised; its exact derivative gives the angular velocity.
#include "thigma/device/script.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>
#include <string_view>
#include <utility>

#include "thigma/core/error.h"
#include "thigma/device/detail/address.h"
#include "thigma/files/file.h"
#include "thigma/math/rotation.h"

namespace thigma {
namespace {

// 2.8 hours at 1 kHz; beyond it a file is not a script
constexpr std::size_t kMaxRows = 10'000'000;
// Differences and slopes of what is within these are finite.
constexpr double kMostTime = 1e9, kLeastStep = 1e-9;  // [s]
constexpr double kMostPlace = 1e6;                    // [m]
constexpr std::size_t kPoseColumns = 8;
constexpr std::string_view kHeader = "t,x,y,z,qx,qy,qz,qw";

std::string_view trimmed(std::string_view s) {
  const std::string_view space = " \t\r";
  const std::size_t first = s.find_first_not_of(space);
  if (first == std::string_view::npos) return {};
  return s.substr(first, s.find_last_not_of(space) - first + 1);
}

[[noreturn]] void fail(const std::string& name, std::size_t line, const std::string& what,
                       const std::string& expected) {
  throw InputError(name + ": " + what + ", line " + std::to_string(line) + ", expected " +
                   expected);
}

std::size_t columns_of_header(std::string_view line, const std::string& name, std::size_t number) {
  std::string header;
  for (const char c : line) {
    if (c != ' ' && c != '\t') header += c;
  }
  if (header == kHeader) return kPoseColumns;
  if (header == std::string(kHeader) + ",buttons") return kPoseColumns + 1;
  fail(name, number, "wrong header", detail::quoted(kHeader) + " or the same and ',buttons'");
}

double parse_number(std::string_view text, const std::string& name, std::size_t line,
                    std::size_t column) {
  double value = 0.0;
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || rest != end || !std::isfinite(value)) {
    fail(name, line, detail::quoted(text) + " in column " + std::to_string(column + 1),
         "a finite number");
  }
  return value;
}

TimedPose parse_row(std::string_view line, std::size_t columns, const std::string& name,
                    std::size_t number) {
  double values[kPoseColumns + 1] = {};
  std::size_t column = 0;
  for (std::size_t begin = 0; begin <= line.size(); ++column) {
    const std::size_t comma = std::min(line.find(',', begin), line.size());
    if (column < columns) {
      values[column] =
          parse_number(trimmed(line.substr(begin, comma - begin)), name, number, column);
    }
    begin = comma + 1;
  }
  if (column != columns) {
    fail(name, number, std::to_string(column) + " columns", std::to_string(columns));
  }
  TimedPose row;
  row.time = values[0];
  row.pose.position = {values[1], values[2], values[3]};
  if (!(std::fabs(row.time) <= kMostTime))
    fail(name, number, "time of " + detail::shortest(row.time) + " s", "at most 1e9 s");
  if (!(row.pose.position.cwiseAbs().maxCoeff() <= kMostPlace))
    fail(name, number, "a place beyond 1000 km", "metres");
  const Quat q(values[7], values[4], values[5], values[6]);
  const double length = std::sqrt(q.coeffs().squaredNorm());
  if (!(std::fabs(length - 1.0) <= 1e-6)) {
    fail(name, number, "quaternion of length " + std::to_string(length), "1 to 1e-6");
  }
  row.pose.orientation = unit(q);
  if (columns > kPoseColumns) {
    const double buttons = values[kPoseColumns];
    if (buttons < 0.0 || buttons > 4294967295.0 || buttons != std::floor(buttons)) {
      fail(name, number, "buttons that are no bit mask", "an integer from 0 to 4294967295");
    }
    row.buttons = static_cast<std::uint32_t>(buttons);
  }
  return row;
}

using Vec7 = Eigen::Matrix<double, 7, 1>;

Vec7 coordinates(const Pose& pose, const Quat& near) THIGMA_RT {
  Vec7 y;
  y.head<3>() = pose.position;
  // q and -q are the same rotation; the cubic must not take the long way round.
  const double sign = pose.orientation.coeffs().dot(near.coeffs()) < 0.0 ? -1.0 : 1.0;
  y.tail<4>() = sign * pose.orientation.coeffs();
  return y;
}

// Slope at the middle one of three rows.
double inner_slope(double h0, double d0, double h1, double d1) THIGMA_RT {
  if (!(d0 * d1 > 0.0)) return 0.0;
  const double w0 = 2.0 * h1 + h0;
  const double w1 = h1 + 2.0 * h0;
  return (w0 + w1) / (w0 / d0 + w1 / d1);
}

Vec7 slope_at(const std::vector<TimedPose>& rows, std::size_t i, const Quat& near) THIGMA_RT {
  if (i == 0 || i + 1 == rows.size()) return Vec7::Zero();
  const Vec7 before = coordinates(rows[i - 1].pose, near);
  const Vec7 here = coordinates(rows[i].pose, near);
  const Vec7 after = coordinates(rows[i + 1].pose, near);
  const double h0 = rows[i].time - rows[i - 1].time;
  const double h1 = rows[i + 1].time - rows[i].time;
  Vec7 slope;
  for (int k = 0; k < 7; ++k) {
    slope[k] = inner_slope(h0, (here[k] - before[k]) / h0, h1, (after[k] - here[k]) / h1);
  }
  return slope;
}

Motion motion_of(const Vec7& y, const Vec7& rate) THIGMA_RT {
  const Vec4 p = y.tail<4>();
  const Vec4 dp = rate.tail<4>();
  const double n = std::sqrt(p.squaredNorm());
  const Vec4 q = p / n;
  const Vec4 dq = (dp - q.dot(dp) * q) / n;
  Motion motion;
  motion.pose.position = y.head<3>();
  motion.pose.orientation = Quat(q[3], q[0], q[1], q[2]);
  motion.twist.linear = rate.head<3>();
  const Quat twice_spin = Quat(dq[3], dq[0], dq[1], dq[2]) * motion.pose.orientation.conjugate();
  motion.twist.angular = 2.0 * twice_spin.vec();
  return motion;
}

// Last row with time <= `time`, 0 if there is none; starts at the cursor.
std::size_t find_row(const std::vector<TimedPose>& rows, double time, std::size_t row) THIGMA_RT {
  if (row >= rows.size() || rows[row].time > time) row = 0;
  if (row + 1 < rows.size() && rows[row + 1].time <= time) ++row;
  if (row + 1 >= rows.size() || rows[row + 1].time > time) return row;
  const auto after =
      std::upper_bound(rows.begin() + static_cast<std::ptrdiff_t>(row), rows.end(), time,
                       [](double t, const TimedPose& r) { return t < r.time; });
  return static_cast<std::size_t>(after - rows.begin()) - 1;
}

class ScriptDevice final : public HapticDevice {
 public:
  ScriptDevice(std::vector<TimedPose> script, const DeviceLimits& limits)
      : script_(std::move(script)), limits_(limits) {
    limits_.holds_person = false;
  }

  const DeviceLimits& limits() const override { return limits_; }
  std::string name() const override { return "script"; }
  DeviceState read(double now) THIGMA_RT override {
    if (!started_) {
      start_ = now;
      started_ = true;
    }
    const double time = now - start_;
    DeviceState state;
    state.time = now;
    state.motion = script_motion(script_, time, cursor_);
    state.buttons = script_[cursor_.row].buttons;
    if (time > script_.back().time) state.status = DeviceStatus::finished;
    return state;
  }
  void write(const Wrench&) THIGMA_RT override {}

 private:
  std::vector<TimedPose> script_;
  DeviceLimits limits_;
  ScriptCursor cursor_;
  double start_ = 0.0;
  bool started_ = false;
};

}  // namespace

std::vector<TimedPose> parse_script(std::istream& text, const std::string& name) {
  std::vector<TimedPose> rows;
  std::string line;
  std::size_t columns = 0;
  std::size_t number = 0;
  while (std::getline(text, line)) {
    ++number;
    const std::string_view content = trimmed(number == 1 ? without_byte_order_mark(line) : line);
    if (content.empty() || content.front() == '#') continue;
    if (columns == 0) {
      columns = columns_of_header(content, name, number);
      continue;
    }
    const TimedPose row = parse_row(content, columns, name, number);
    if (!rows.empty() && row.time > rows.back().time && row.time - rows.back().time < kLeastStep)
      fail(name, number, "time less than a nanosecond after the row before",
           "at least 1e-9 s more");
    if (!rows.empty() && !(row.time > rows.back().time)) {
      fail(name, number, "time that does not increase", "more than that of the row before");
    }
    if (rows.size() == kMaxRows) fail(name, number, "too many rows", "at most ten million");
    rows.push_back(row);
  }
  if (rows.empty()) fail(name, number, "no pose", "a header and at least one row");
  return rows;
}

std::vector<TimedPose> read_script(const std::string& path) {
  std::istringstream text(read_file(path));
  return parse_script(text, path);
}

Motion script_motion(const std::vector<TimedPose>& script, double time,
                     ScriptCursor& cursor) THIGMA_RT {
  cursor.row = find_row(script, time, cursor.row);
  const std::size_t i = cursor.row;
  if (time <= script.front().time || i + 1 >= script.size()) return {script[i].pose, Twist{}};
  const TimedPose& a = script[i];
  const TimedPose& b = script[i + 1];
  const Quat& near = a.pose.orientation;
  const Vec7 ya = coordinates(a.pose, near);
  const Vec7 yb = coordinates(b.pose, near);
  // Slopes at b seen from b's own sign, turned into a's: neighbours agree on them, so the motion is
  // smooth at rows.
  const double flip =
      a.pose.orientation.coeffs().dot(b.pose.orientation.coeffs()) < 0.0 ? -1.0 : 1.0;
  const Vec7 ma = slope_at(script, i, a.pose.orientation);
  Vec7 mb = slope_at(script, i + 1, b.pose.orientation);
  mb.tail<4>() *= flip;
  const double h = b.time - a.time;
  const double u = (time - a.time) / h;
  const Vec7 rise = yb - ya;
  const Vec7 c2 = 3.0 * rise - h * (2.0 * ma + mb);
  const Vec7 c3 = h * (ma + mb) - 2.0 * rise;
  const Vec7 y = ya + u * (h * ma + u * (c2 + u * c3));
  const Vec7 rate = ma + (u / h) * (2.0 * c2 + 3.0 * u * c3);
  return motion_of(y, rate);
}

std::unique_ptr<HapticDevice> make_script_device(std::vector<TimedPose> script,
                                                 const DeviceLimits& limits) {
  if (script.empty()) script.push_back({});
  return std::make_unique<ScriptDevice>(std::move(script), limits);
}

}  // namespace thigma
