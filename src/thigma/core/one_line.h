#pragma once
// Messages are one line, whatever names, files and parsers put into them.

#include <string>

namespace thigma {

/// Whether a byte is an ASCII control character: a line break, say. Those of UTF-8 are none.
inline bool is_control_character(char c) noexcept {
  return static_cast<unsigned char>(c) < ' ' || c == '\x7f';
}

/// The text with `instead` for each control character. Thread [any].
inline std::string one_line(std::string text, char instead = '?') {
  for (char& c : text)
    if (is_control_character(c)) c = instead;
  return text;
}

}  // namespace thigma
