#include "thigma/scene/detail/parse_toml.h"

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
// (is_non_ascii_horizontal_whitespace of toml++ 3.3). So its parser sees none: this letter and the
// two digits of the byte stand for each byte of theirs, and for the letter itself.
constexpr char kMark = '~';
constexpr char kDigits[] = "0123456789ABCDEF";

bool is_coded(char c) { return c == kMark || static_cast<unsigned char>(c) > 127; }

/// The text as the parser sees it. An escape of the mark would be one of those it makes: refused.
std::string coded(std::string_view text, const std::string& file) {
  std::string out;
  std::size_t line = 1;
  const auto refuse = [&](const char* what, const char* expected) {
    throw InputError(scene_message(file, what, line, expected));
  };
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = utf8_length(text, i);
    if (length == 0) refuse("a byte that is no UTF-8", "expected a TOML scene");
    for (const char* escape : {"\\u007E", "\\u007e", "\\U0000007E", "\\U0000007e"})
      if (text.substr(i).starts_with(escape)) refuse("an escape of ~", "expected ~ itself");
    for (const char c : text.substr(i, length)) {
      line += c == '\n';
      const auto byte = static_cast<unsigned char>(c);
      out += is_coded(c) ? kMark : c;
      if (is_coded(c)) out += {kDigits[byte >> 4], kDigits[byte & 15]};
    }
    i += length;
  }
  return out;
}

std::string decoded(std::string_view text) {
  const auto digit = [](char c) { return std::string_view(kDigits).find(c); };
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    out += text[i];
    if (text[i] != kMark || i + 2 >= text.size()) continue;
    out.back() = static_cast<char>(16 * digit(text[i + 1]) + digit(text[i + 2]));
    i += 2;
  }
  return out;
}

/// What the parser says of a coded text: a mark that it does not want is a letter it does not.
std::string plain_words(std::string_view description) {
  const std::string_view seen = "saw '~'";
  const std::size_t at = description.find(seen);
  return std::string(description.substr(0, at)) +
         (at == std::string_view::npos ? "" : "saw ~ or a letter beyond ASCII outside of quotes");
}

void decode(toml::node& node) {
  if (toml::value<std::string>* text = node.as_string()) text->get() = decoded(text->get());
  if (toml::array* array = node.as_array())
    for (toml::node& item : *array) decode(item);
  if (toml::table* table = node.as_table())
    for (auto&& [key, item] : *table) decode(item);
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
  const std::string plain = coded(without_byte_order_mark(text), file);
  try {
    toml::table table = toml::parse(plain, file);
    decode(table);
    return table;
  } catch (const toml::parse_error& error) {
    throw InputError(scene_message(file, plain_words(error.description()),
                                   error.source().begin.line, "expected a TOML scene"));
  } catch (const TomlAssertion&) {
    throw InputError(scene_message(file, "something that is no TOML", line_of_assertion(plain),
                                   "expected a TOML scene"));
  }
}

}  // namespace thigma
