#include "thigma/scene/detail/parse_toml.h"

#include <charconv>
#include <filesystem>
#include <vector>

#include "thigma/core/error.h"
#include "thigma/core/utf8.h"
#include "thigma/files/file.h"
#include "thigma/scene/detail/toml_table.h"

namespace fs = std::filesystem;

namespace thigma {
namespace {

constexpr std::uintmax_t kMostBytes = 1 << 20;  // a scene file is a page of text

void check_size(std::uintmax_t bytes, const std::string& file) {
  if (bytes > kMostBytes) {
    throw InputError(file + ": " + std::to_string(bytes) +
                     " bytes, expected a scene of at most 1 MiB");
  }
}

// The library asks of each letter beyond ASCII, outside a text and after a backslash at the end of
// a line, whether it is a blank, and for most the answer is undefined behaviour
// (is_non_ascii_horizontal_whitespace of toml++ 3.3). So its parser sees none: a mark and the two
// digits of the byte stand for each byte of theirs, and for the mark itself. Outside a text none of
// these marks is TOML.
constexpr std::string_view kMarks = "~^|$%&`@";
constexpr std::string_view kDigits = "0123456789ABCDEF";

/// A mark that no escape of the text makes.
char mark_for(std::string_view text) {
  const auto has_escape = [&](char mark) {
    for (const std::string_view begin : {"\\u00", "\\U000000"})
      for (std::size_t at = text.find(begin); at != text.npos; at = text.find(begin, at + 1)) {
        const std::string_view digits = text.substr(at + begin.size(), 2);
        unsigned code = 0;
        std::from_chars(digits.data(), digits.data() + digits.size(), code, 16);
        if (code == static_cast<unsigned>(mark)) return true;
      }
    return false;
  };
  for (const char mark : kMarks)
    if (!has_escape(mark)) return mark;
  return '\0';
}

// The parser looks back over a date by 127 letters at most, in a function that may not throw, and
// skips underscores; it makes a table for each part of a dotted key, one in another.
constexpr int kMostUnderscores = 20;  // of a number, two of which may make a date
constexpr int kMostDots = 200;        // of a line, after words

/// Counts what the parser has no limit for, letter by letter.
struct TomlLimits {
  bool is_number = false, in_word = false, after_word = false;
  int underscores = 0, dots = 0;

  /// What there is too much of with this letter, or null.
  const char* take(char c) {
    const bool is_digit = c >= '0' && c <= '9';
    if (c == '\n') dots = 0;
    if (c == '.' && after_word && ++dots > kMostDots) return "more than 200 dots in a line";
    const bool was_in_word = in_word;
    in_word = std::string_view(" \t\r\n,=[]{}\"'#").find(c) == std::string_view::npos;
    if (in_word && !was_in_word) {
      is_number = is_digit || c == '+' || c == '-';
      underscores = 0;
    }
    if (c == '_' && is_number && ++underscores > kMostUnderscores)
      return "a number of more than 20 underscores";
    if (c != ' ' && c != '\t') after_word = c != '.' && c != '\n';
    return nullptr;
  }
};

/// The text as the parser sees it.
std::string coded(std::string_view text, char mark, const std::string& file) {
  std::string out;
  std::size_t line = 1;
  const auto refuse = [&](const char* what) {
    throw InputError(scene_message(file, what, line, "expected a TOML scene"));
  };
  if (mark == '\0') refuse("escapes of each of ~^|$%&`@");
  TomlLimits limits;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = utf8_length(text, i);
    if (length == 0) refuse("a byte that is no UTF-8");
    for (const char c : text.substr(i, length)) {
      if (const char* what = limits.take(c)) refuse(what);
      line += c == '\n';
      const auto byte = static_cast<unsigned char>(c);
      if (c == mark || byte > 127)
        out += {mark, kDigits[byte >> 4], kDigits[byte & 15]};
      else
        out += c;
    }
    i += length;
  }
  return out;
}

std::string decoded(std::string_view text, char mark) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    out += text[i];
    if (text[i] != mark || i + 2 >= text.size()) continue;
    out.back() = static_cast<char>(16 * kDigits.find(text[i + 1]) + kDigits.find(text[i + 2]));
    i += 2;
  }
  return out;
}

/// What the parser says of a coded text: a mark that it does not want is a letter it does not.
std::string plain_words(std::string_view description, char mark) {
  const std::string seen = std::string("saw '") + mark;
  const std::size_t at = description.find(seen);
  return std::string(description.substr(0, at)) +
         (at == std::string_view::npos
              ? ""
              : "saw a letter beyond ASCII, or " + std::string(1, mark) + ", outside of quotes");
}

void decode(toml::node& node, char mark) {
  if (toml::value<std::string>* text = node.as_string()) text->get() = decoded(text->get(), mark);
  if (toml::array* array = node.as_array())
    for (toml::node& item : *array) decode(item, mark);
  if (toml::table* table = node.as_table())
    for (auto&& [key, item] : *table) decode(item, mark);
}

bool gives_up(std::string_view text) {
  try {
    static_cast<void>(toml::parse(text));
  } catch (const TomlAssertion&) {
    return true;
  } catch (const toml::parse_error&) {
  }
  return false;
}

/// The line at which the parser gives up: the first lines without it do not make it do so. It reads
/// forward only, and never beyond its first mistake.
std::size_t line_of_assertion(std::string_view text) {
  std::vector<std::size_t> ends;  // of lines
  for (std::size_t i = 0; i < text.size(); ++i)
    if (text[i] == '\n') ends.push_back(i + 1);
  std::size_t low = 0, high = ends.size();  // lines before the one looked for
  while (low < high) {
    const std::size_t middle = low + (high - low) / 2;
    if (gives_up(text.substr(0, ends[middle]))) {
      high = middle;
    } else {
      low = middle + 1;
    }
  }
  return low + 1;
}

}  // namespace

void toml_assertion_failed(const char* what) { throw TomlAssertion(what); }

std::string read_scene_text(const std::string& path) {
  std::error_code error;
  if (fs::is_regular_file(path, error)) check_size(fs::file_size(path, error), path);
  return read_file(path);
}

toml::table parse_toml(std::string_view text, const std::string& file) {
  check_size(text.size(), file);
  const std::string_view given = without_byte_order_mark(text);
  const char mark = mark_for(given);
  const std::string plain = coded(given, mark, file);
  try {
    toml::table table = toml::parse(plain, file);
    decode(table, mark);
    return table;
  } catch (const toml::parse_error& error) {
    throw InputError(scene_message(file, plain_words(error.description(), mark),
                                   error.source().begin.line, "expected a TOML scene"));
  } catch (const TomlAssertion&) {
    throw InputError(scene_message(file, "something that is no TOML", line_of_assertion(plain),
                                   "expected a TOML scene"));
  }
}

}  // namespace thigma
