#include "thigma/scene/detail/parse_toml.h"

#include <filesystem>
#include <vector>

#include "thigma/core/error.h"
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
  const std::string_view plain = without_byte_order_mark(text);
  try {
    return toml::parse(plain, file);
  } catch (const toml::parse_error& error) {
    throw InputError(scene_message(file, std::string(error.description()),
                                   error.source().begin.line, "expected a TOML scene"));
  } catch (const TomlAssertion&) {
    throw InputError(scene_message(file, "something that is no TOML", line_of_assertion(plain),
                                   "expected a TOML scene"));
  }
}

}  // namespace thigma
