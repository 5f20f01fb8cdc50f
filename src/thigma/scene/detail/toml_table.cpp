#include "thigma/scene/detail/toml_table.h"

#include <algorithm>
#include <cmath>

#include "thigma/core/error.h"
#include "thigma/core/one_line.h"
#include "thigma/models/make_model.h"

namespace thigma {
namespace {

constexpr double kQuaternionSlack = 1e-6;  // of |q| - 1: beyond it a pose is refused

std::string type_name(const toml::node& node) {
  switch (node.type()) {
    case toml::node_type::table:
      return "a table";
    case toml::node_type::array:
      return "an array";
    case toml::node_type::string:
      return "text";
    case toml::node_type::integer:
      return "a whole number";
    case toml::node_type::floating_point:
      return "a number";
    case toml::node_type::boolean:
      return "true or false";
    case toml::node_type::none:
      return "nothing";
    case toml::node_type::date:
    case toml::node_type::time:
    case toml::node_type::date_time:
      return "a date";
  }
  return "something else";
}

std::string printable(std::string_view text) {
  std::string out;
  for (const char c : text.substr(0, 80)) out += (c >= ' ' && c < 127) ? c : '?';
  return out;
}

std::string one_of(const std::vector<std::string>& words) {
  std::string text = "expected one of";
  for (const std::string& w : words) text += " " + w;
  return text;
}

std::string as_text(double x) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.9g", x);
  return buffer;
}

}  // namespace

std::string scene_message(const std::string& file, const std::string& what, std::size_t line,
                          const std::string& expected) {
  // The parser tells of characters as they stand.
  return one_line(file + ": " + what + ", line " + std::to_string(line) + ", " + expected, ' ');
}

TomlTable::TomlTable(const toml::table& table, std::string file, std::string name)
    : table_(table), file_(std::move(file)), name_(std::move(name)) {}

std::string TomlTable::full_name(std::string_view key) const {
  return (name_.empty() ? "" : name_ + ".") + printable(key);
}

void TomlTable::fail(const char* key, const std::string& what, const std::string& expected) const {
  const toml::node* node = table_.get(key);
  throw InputError(scene_message(file_, full_name(key) + " " + what,
                                 (node ? node->source() : table_.source()).begin.line, expected));
}

void TomlTable::fail_here(const std::string& what, const std::string& expected) const {
  throw InputError(
      scene_message(file_, what, std::max<std::size_t>(1, table_.source().begin.line), expected));
}

const toml::node* TomlTable::find(const char* key) {
  if (std::find(known_.begin(), known_.end(), key) == known_.end()) known_.push_back(key);
  return table_.get(key);
}

double TomlTable::finite_number(const toml::node& node, const char* key) const {
  // An integer is a number too; 9007199254740993 would lose its last digit without anyone noticing.
  const std::optional<double> value = node.is_number() ? node.value<double>() : std::nullopt;
  if (!value) fail(key, "is " + type_name(node), "expected a number");
  if (!std::isfinite(*value)) fail(key, "is not finite", "expected a finite number");
  return *value;
}

std::optional<double> TomlTable::number(const char* key, Range range) {
  const toml::node* node = find(key);
  if (!node) return std::nullopt;
  const double value = finite_number(*node, key);
  if (range == Range::positive && !(value > 0.0))
    fail(key, "= " + as_text(value), "expected a number above 0");
  if (range == Range::not_negative && value < 0.0)
    fail(key, "= " + as_text(value), "expected 0 or more");
  return value;
}

std::optional<int> TomlTable::whole(const char* key, int least, int most) {
  const toml::node* node = find(key);
  if (!node) return std::nullopt;
  const std::string expected =
      "expected a whole number from " + std::to_string(least) + " to " + std::to_string(most);
  if (!node->is_integer()) fail(key, "is " + type_name(*node), expected);
  const std::int64_t value = node->as_integer()->get();
  if (value < least || value > most) fail(key, "= " + std::to_string(value), expected);
  return static_cast<int>(value);
}

std::optional<bool> TomlTable::truth(const char* key) {
  const toml::node* node = find(key);
  if (!node) return std::nullopt;
  if (!node->is_boolean()) fail(key, "is " + type_name(*node), "expected true or false");
  return node->as_boolean()->get();
}

std::optional<std::string> TomlTable::text(const char* key) {
  const toml::node* node = find(key);
  if (!node) return std::nullopt;
  if (!node->is_string()) fail(key, "is " + type_name(*node), "expected text in quotes");
  const std::string value = node->as_string()->get();
  if (value.empty()) fail(key, "is empty", "expected text");
  // File names and titles end up in messages and reports, a line each.
  if (std::any_of(value.begin(), value.end(), is_control_character))
    fail(key, "holds a control character", "expected one line of text");
  return value;
}

std::optional<Vec3> TomlTable::vector(const char* key) {
  const toml::node* node = find(key);
  if (!node) return std::nullopt;
  const toml::array* array = node->as_array();
  if (!array || array->size() != 3)
    fail(key, array ? "has another length" : "is " + type_name(*node), "expected [x, y, z]");
  Vec3 value;
  for (int i = 0; i < 3; ++i) value[i] = finite_number(*array->get(i), key);
  return value;
}

Pose TomlTable::pose() {
  Pose pose;
  if (const std::optional<Vec3> p = vector("position")) pose.position = *p;
  const toml::node* node = find("quat_xyzw");
  if (!node) return pose;
  const toml::array* array = node->as_array();
  if (!array || array->size() != 4) {
    fail("quat_xyzw", array ? "has another length" : "is " + type_name(*node),
         "expected [x, y, z, w]");
  }
  Vec4 q;
  for (int i = 0; i < 4; ++i) q[i] = finite_number(*array->get(i), "quat_xyzw");
  const double length = std::sqrt(q.squaredNorm());
  if (!(std::fabs(length - 1.0) <= kQuaternionSlack)) {
    fail("quat_xyzw", "has length " + as_text(length), "expected a unit quaternion (1 to 1e-6)");
  }
  pose.orientation.coeffs() = q / length;
  return pose;
}

std::optional<int> TomlTable::choice(const char* key, const std::vector<std::string>& words) {
  const std::optional<std::string> word = text(key);
  if (!word) return std::nullopt;
  const auto found = std::find(words.begin(), words.end(), *word);
  if (found == words.end()) fail(key, "= '" + printable(*word) + "'", one_of(words));
  return static_cast<int>(found - words.begin());
}

std::optional<TomlTable> TomlTable::table(const char* key) {
  const toml::node* node = find(key);
  if (!node) return std::nullopt;
  if (!node->is_table())
    fail(key, "is " + type_name(*node), "expected a table [" + full_name(key) + "]");
  return TomlTable(*node->as_table(), file_, full_name(key));
}

std::vector<TomlTable> TomlTable::tables(const char* key) {
  std::vector<TomlTable> all;
  const toml::node* node = find(key);
  if (!node) return all;
  const std::string expected = "expected tables [[" + full_name(key) + "]]";
  if (!node->is_array()) fail(key, "is " + type_name(*node), expected);
  for (const toml::node& item : *node->as_array()) {
    if (!item.is_table()) fail(key, "holds " + type_name(item), expected);
    all.emplace_back(*item.as_table(), file_, full_name(key));
  }
  return all;
}

void TomlTable::finish() const {
  for (const auto& [key, node] : table_) {
    const std::string name(key.str());
    if (std::find(known_.begin(), known_.end(), name) != known_.end()) continue;
    const std::string nearest = models::nearest_word(name, known_);
    throw InputError(
        scene_message(file_, "unknown key " + full_name(name), key.source().begin.line,
                      nearest.empty() ? one_of(known_) : "expected '" + nearest + "'"));
  }
}

}  // namespace thigma
