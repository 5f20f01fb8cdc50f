#include "pose_file.h"

#include <array>
#include <charconv>
#include <cmath>
#include <string_view>

#include "thigma/core/error.h"
#include "thigma/files/file.h"

namespace thigma::app {
namespace {

constexpr const char* kHeader = "x,y,z,qx,qy,qz,qw";
constexpr double kUnitTolerance = 1e-6;  // of |q| - 1, docs/formats.md: beyond it a pose is refused

std::string_view trimmed(std::string_view text) {
  const auto blank = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
  while (!text.empty() && blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && blank(text.back())) text.remove_suffix(1);
  return text;
}

std::string without_blanks(std::string_view text) {
  std::string kept;
  for (const char c : text) {
    if (c != ' ' && c != '\t' && c != '\r') kept += c;
  }
  return kept;
}

[[noreturn]] void refuse(const std::string& path, const std::string& what, int line,
                         const std::string& expected) {
  throw InputError(path + ": " + what + ", line " + std::to_string(line) + ", expected " +
                   expected);
}

double parse_number(const std::string& path, std::string_view field, int line) {
  field = trimmed(field);
  if (!field.empty() && field.front() == '+') field.remove_prefix(1);
  double value = 0.0;
  const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
  if (error != std::errc() || end != field.data() + field.size() || !std::isfinite(value)) {
    refuse(path, "'" + std::string(field.substr(0, 40)) + "'", line, "a finite number");
  }
  return value;
}

Pose parse_pose(const std::string& path, std::string_view row, int line) {
  std::array<double, 7> v{};
  std::size_t count = 0;
  for (std::string_view rest = row;;) {
    const std::size_t comma = rest.find(',');
    if (count < v.size()) v[count] = parse_number(path, rest.substr(0, comma), line);
    ++count;
    if (comma == std::string_view::npos) break;
    rest.remove_prefix(comma + 1);
  }
  if (count != v.size())
    refuse(path, std::to_string(count) + " values", line, std::string("7: ") + kHeader);
  Pose pose;
  pose.position = Vec3(v[0], v[1], v[2]);
  const double length = std::sqrt(v[3] * v[3] + v[4] * v[4] + v[5] * v[5] + v[6] * v[6]);
  if (!(std::fabs(length - 1.0) <= kUnitTolerance)) {
    refuse(path, "quaternion of length " + std::to_string(length), line, "length 1 to 1e-6");
  }
  pose.orientation = Quat(v[6] / length, v[3] / length, v[4] / length, v[5] / length);
  return pose;
}

}  // namespace

std::vector<Pose> read_poses(const std::string& path) { return parse_poses(read_file(path), path); }

std::vector<Pose> parse_poses(std::string_view text, const std::string& path) {
  std::vector<Pose> poses;
  int line = 0;
  bool has_header = false;
  for (std::string_view rest = without_byte_order_mark(text); !rest.empty();) {
    const std::size_t end = rest.find('\n');
    const std::string_view row = trimmed(rest.substr(0, end));
    rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
    ++line;
    if (row.empty()) continue;
    if (has_header) {
      poses.push_back(parse_pose(path, row, line));
    } else if (without_blanks(row) != kHeader) {
      refuse(path, "no header", line, kHeader);
    }
    has_header = true;
  }
  if (poses.empty())
    refuse(path, has_header ? "no pose" : "no header", line,
           has_header ? "one pose a line" : kHeader);
  return poses;
}

}  // namespace thigma::app
