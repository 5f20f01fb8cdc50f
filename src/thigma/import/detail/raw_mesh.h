#pragma once
// What the readers of the formats share: the mesh as the file says it, errors with their place,
// text lines.

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "thigma/core/error.h"
#include "thigma/import/read_mesh.h"

namespace thigma::detail {

/// Positions and fan-triangulated faces of a file, before anything is merged.
struct RawMesh {
  MeshFormat format = MeshFormat::obj;
  std::vector<Vec3> positions;
  std::vector<std::array<std::int32_t, 3>> triangles;
};

/// Texture coordinates of an OBJ and, for each triangle, which are at its corners, counted from 0.
struct ObjTexture {
  std::vector<Vec2> coordinates;  // as the file has them
  std::vector<std::array<std::int64_t, 3>> triangles;
  std::vector<std::int64_t> lines;  // of the triangles
};

/// What a file shows before it is read.
struct FileClues {
  std::string_view bytes;
  bool is_text = false;         // no control characters but blanks and ends of lines
  std::string_view first_word;  // of a text; what follows a # is a comment
};

[[noreturn]] inline void fail_input(const std::string& name, const std::string& what,
                                    const std::string& where, const std::string& expected) {
  throw InputError(name + ": " + what + ", " + where + ", expected " + expected);
}

inline std::string at_line(std::int64_t line) { return "line " + std::to_string(line); }
inline std::string at_byte(std::size_t byte) { return "byte " + std::to_string(byte); }

/// A word of the file as a message can show it: short and printable.
inline std::string quoted(std::string_view word) {
  std::string out = "'";
  for (const char c : word.substr(0, 24)) out += c >= 32 && c < 127 ? c : '?';
  return out + (word.size() > 24 ? "...'" : "'");
}

/// Throws unless value is finite and within kMaxCoordinate.
inline void check_coordinate(double value, const std::string& name, const std::string& where) {
  if (std::fabs(value) <= kMaxCoordinate) [[likely]]
    return;
  fail_input(name,
             std::isfinite(value) ? "a coordinate is out of range" : "a coordinate is not finite",
             where, "numbers of at most 1e50");
}

/// Throws unless one more position or triangle still has a 32-bit index.
inline void check_room(std::size_t used, const std::string& name, const std::string& where) {
  if (used < 0x7fffffffu) [[likely]]
    return;
  fail_input(name, "too many elements", where, "at most 2147483647 vertices and triangles");
}

/// The fan of a polygon around its first corner.
inline void add_fan(const std::vector<std::int32_t>& corners, RawMesh& mesh) {
  for (std::size_t i = 2; i < corners.size(); ++i) {
    mesh.triangles.push_back({corners[0], corners[i - 1], corners[i]});
  }
}

inline bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}

/// The words of one line.
class Words {
 public:
  explicit Words(std::string_view line) : at_(line.data()), end_(line.data() + line.size()) {}
  /// The next word; empty at the end of the line.
  std::string_view next() {
    while (at_ != end_ && is_blank(*at_)) ++at_;
    const char* first = at_;
    while (at_ != end_ && !is_blank(*at_)) ++at_;
    return {first, static_cast<std::size_t>(at_ - first)};
  }

 private:
  const char* at_;
  const char* end_;
};

/// The lines of a text, with their numbers. A line ends at \n, \r\n or \r.
class Lines {
 public:
  /// lines_before: of a header already read, so that numbers are those of the file.
  explicit Lines(std::string_view text, std::int64_t lines_before = 0)
      : rest_(text), number_(lines_before) {}
  /// False at the end of the text.
  bool next(std::string_view& line) {
    if (rest_.empty()) return false;
    const std::size_t end = rest_.find_first_of("\r\n");
    line = rest_.substr(0, end);
    if (end == std::string_view::npos) {
      rest_ = {};
    } else {
      const bool pair = rest_[end] == '\r' && end + 1 < rest_.size() && rest_[end + 1] == '\n';
      rest_.remove_prefix(end + (pair ? 2 : 1));
    }
    ++number_;
    return true;
  }
  std::int64_t number() const { return number_; }
  std::size_t rest_size() const { return rest_.size(); }

 private:
  std::string_view rest_;
  std::int64_t number_;
};

/// A whole word as a number, independent of the locale. Returns false for anything else; "nan" and
/// "inf" are numbers.
template <class T>
bool parse_number(std::string_view word, T& value) {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-' && word[1] != '+') word.remove_prefix(1);
  const std::from_chars_result r = std::from_chars(word.data(), word.data() + word.size(), value);
  // Out of range is still a number when it is too small: 1e-400 is zero.
  if (r.ec == std::errc::result_out_of_range && r.ptr == word.data() + word.size()) {
    if constexpr (std::is_floating_point_v<T>) {
      const bool tiny = word.find("e-") != word.npos || word.find("E-") != word.npos;
      value = tiny ? T(0) : std::numeric_limits<T>::infinity();
      return true;
    }
  }
  return r.ec == std::errc() && r.ptr == word.data() + word.size();
}

/// The next word of a line as a coordinate.
inline double read_coordinate(Words& words, const std::string& name, std::int64_t line) {
  const std::string_view word = words.next();
  double value = 0.0;
  if (!parse_number(word, value)) {
    fail_input(name, word.empty() ? "a coordinate is missing" : quoted(word) + " is not a number",
               at_line(line), "three coordinates");
  }
  if (!(std::fabs(value) <= kMaxCoordinate)) check_coordinate(value, name, at_line(line));
  return value;
}

}  // namespace thigma::detail
