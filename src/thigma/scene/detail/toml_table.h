#pragma once
// Strict reading of one TOML table: what is not read is an error, and every error says its line.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "thigma/math/pose.h"
#include "thigma/scene/detail/parse_toml.h"

namespace thigma {

/// What a number may be.
enum class Range : std::uint8_t { any, not_negative, positive };

/// Reads keys of a table and remembers which; finish() refuses the rest.
/// Invariant: every message is one line "FILE: what, line N, what was expected".
/// Thread: [offline]; every member throws InputError.
class TomlTable {
 public:
  /// name  of the table for messages, "" for the top of the file
  TomlTable(const toml::table& table, std::string file, std::string name);

  bool has(const char* key) const { return table_.contains(key); }
  std::optional<double> number(const char* key, Range range = Range::any);
  std::optional<int> whole(const char* key, int least, int most);
  std::optional<bool> truth(const char* key);
  std::optional<std::string> text(const char* key);
  std::optional<Vec3> vector(const char* key);
  /// Keys "position" and "quat_xyzw"; a quaternion whose length is off 1 by more than 1e-6 is an
  /// error.
  Pose pose();
  /// One of `words`, by its place in the list.
  std::optional<int> choice(const char* key, const std::vector<std::string>& words);
  /// A table within; null when absent.
  std::optional<TomlTable> table(const char* key);
  /// An array of tables; empty when absent.
  std::vector<TomlTable> tables(const char* key);

  /// Refuses keys that were never asked for.
  void finish() const;
  /// Throws "FILE: what, line N, expected".
  [[noreturn]] void fail(const char* key, const std::string& what,
                         const std::string& expected) const;
  /// The same at the table itself.
  [[noreturn]] void fail_here(const std::string& what, const std::string& expected) const;

 private:
  const toml::node* find(const char* key);
  std::string full_name(std::string_view key) const;
  double finite_number(const toml::node& node, const char* key) const;

  const toml::table& table_;
  std::string file_, name_;
  std::vector<std::string> known_;  // every key asked for, in that order
};

/// "FILE: what, line N, expected".
std::string scene_message(const std::string& file, const std::string& what, std::size_t line,
                          const std::string& expected);

}  // namespace thigma
