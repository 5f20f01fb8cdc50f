#pragma once
// Just enough JSON writing for recordings: fast, and every finite double comes back with the same
// bits.

#include <charconv>
#include <cmath>
#include <string>
#include <string_view>

#include "thigma/math/pose.h"

namespace thigma::detail {

/// Appends the shortest text that reads back as the same double; null for NaN and infinities, as
/// JSON has neither.
inline void put_number(std::string& out, double value) {
  if (!std::isfinite(value)) {
    out += "null";
    return;
  }
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, value).ptr;
  const std::string_view view(text, static_cast<std::size_t>(end - text));
  out += view;
  // "-0" would be read as an integer and lose its sign.
  if (view == "-0") out += ".0";
}

/// One JSON object built key by key.
class JsonObject {
 public:
  explicit JsonObject(std::string& out) : out_(out) { out_ += '{'; }
  void key(std::string_view name) {
    if (!first_) out_ += ',';
    first_ = false;
    out_ += '"';
    out_ += name;
    out_ += "\":";
  }
  void number(std::string_view name, double value) {
    key(name);
    put_number(out_, value);
  }
  void integer(std::string_view name, long long value) {
    key(name);
    out_ += std::to_string(value);
  }
  void flag(std::string_view name, bool value) {
    key(name);
    out_ += value ? "true" : "false";
  }
  /// text must need no escapes: names and hexadecimal numbers.
  void word(std::string_view name, std::string_view text) {
    key(name);
    out_ += '"';
    out_ += text;
    out_ += '"';
  }
  template <class Vector>
  void vector(std::string_view name, const Vector& v) {
    key(name);
    out_ += '[';
    for (int i = 0; i < static_cast<int>(v.size()); ++i) {
      if (i > 0) out_ += ',';
      put_number(out_, v[i]);
    }
    out_ += ']';
  }
  void pose(const Pose& pose) {
    vector("position", pose.position);
    vector("quat_xyzw", pose.orientation.coeffs());
  }
  void twist(const Twist& twist) {
    vector("linear_velocity", twist.linear);
    vector("angular_velocity", twist.angular);
  }
  void close() { out_ += '}'; }

 private:
  std::string& out_;
  bool first_ = true;
};

}  // namespace thigma::detail
