#include "thigma/recording/config_json.h"

#include <algorithm>
#include <concepts>
#include <cstring>
#include <initializer_list>
#include <optional>

#include <nlohmann/json.hpp>

#include "thigma/core/error.h"
#include "thigma/recording/detail/config_fields.h"
#include "thigma/recording/detail/json_read.h"
#include "thigma/recording/detail/json_text.h"

namespace thigma {
namespace {

using detail::JsonObject;
using Json = nlohmann::json;
using Words = std::initializer_list<const char*>;
using View = Eigen::Matrix<double, 5, 1>;

constexpr detail::NullNumber kNull = detail::NullNumber::refused;

// File names need not be UTF-8, JSON has to be.
std::string quoted(const std::string& text) {
  return Json(text).dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// Writes the fields of a list (detail/config_fields.h).
struct ConfigWriter {
  std::string& out;
  JsonObject& json;

  void operator()(const char* key, double value) const { json.number(key, value); }
  void operator()(const char* key, bool value) const { json.flag(key, value); }
  template <std::integral Integer>
  void operator()(const char* key, Integer value) const {
    json.integer(key, static_cast<long long>(value));
  }
  template <class Vector>
  void vector(const char* key, const Vector& v) const {
    json.vector(key, v);
  }
  void rows(const char* key, const Mat3& m) const {
    json.vector(key, Eigen::Matrix<double, 9, 1>(m.transpose().reshaped()));
  }
  void pose(const char* key, const Pose& pose) const {
    json.key(key);
    JsonObject inner(out);
    inner.pose(pose);
    inner.close();
  }
  template <class Enum>
  void word(const char* key, Enum value, Words words) const {
    json.word(key, words.begin()[static_cast<std::size_t>(value)]);
  }
  template <class Enum>
  void flag_for(const char* key, Enum value, Enum of_true, Enum) const {
    json.flag(key, value == of_true);
  }
  void cap(const char* key, double value) const { json.number(key, value); }
  void unless(const char* key, double value, double usual) const {
    if (value != usual) json.number(key, value);
  }
  void view(const char* key, const ViewThreshold& v) const {
    json.vector(key, View(v.pixels, v.distance, v.frustum_size, v.near_distance, v.image_size));
  }
  /// Left out where there is none.
  void frictions(const char* key, const std::vector<Friction>& list) const {
    const auto is_any = [](const Friction& f) { return f.at_rest > 0.0; };
    if (std::none_of(list.begin(), list.end(), is_any)) return;
    json.key(key);
    const char* separator = "[";
    for (const Friction& f : list) {
      out += separator;
      JsonObject inner(out);
      for (const FrictionNumber& n : kFrictionNumbers) inner.number(n.key, f.*n.number);
      inner.close();
      separator = ",";
    }
    out += ']';
  }
  /// Left out where there is none.
  void impacts(const char* key, const std::vector<ImpactPair>& list) const {
    if (list.empty()) return;
    json.key(key);
    const char* separator = "[";
    for (const ImpactPair& pair : list) {
      out += separator;
      JsonObject inner(out);
      inner.number("restitution", pair.restitution);
      inner.number("tap_amplitude", pair.tap.amplitude);
      inner.number("tap_frequency", pair.tap.frequency);
      inner.number("tap_decay", pair.tap.decay);
      inner.close();
      separator = ",";
    }
    out += ']';
  }
  void digits(const char* key, std::uint64_t value) const { json.word(key, std::to_string(value)); }
  void text(const char* key, const std::string& text) const {
    json.key(key);
    out += quoted(text);
  }
  template <class Part, class Fields>
  void object(const char* key, const Part& part, Fields fields) const {
    json.key(key);
    JsonObject inner(out);
    const ConfigWriter writer{out, inner};
    fields(part, writer);
    inner.close();
  }
  template <class Part, class Fields>
  void object_if(const char* key, bool is_there, const Part& part, Fields fields) const {
    if (is_there) object(key, part, fields);
  }
  template <class Part, class Fields>
  void optional(const char* key, const std::optional<Part>& part, Fields fields) const {
    if (part) return object(key, *part, fields);
    json.key(key);
    out += "null";
  }
};

/// Reads them.
struct ConfigReader {
  const Json& json;

  template <class Value>
  requires std::is_arithmetic_v<Value>
  void operator()(const char* key, Value& value) const { value = json.at(key).get<Value>(); }
  template <class Vector>
  void vector(const char* key, Vector& v) const {
    detail::read_vector(json, key, v, kNull);
  }
  void rows(const char* key, Mat3& m) const {
    Eigen::Matrix<double, 9, 1> flat;
    vector(key, flat);
    m = Mat3(flat.reshaped(3, 3)).transpose();
  }
  void pose(const char* key, Pose& pose) const { detail::read_pose(json.at(key), pose, kNull); }
  template <class Enum>
  void word(const char* key, Enum& value, Words words) const {
    const std::string name = json.at(key).get<std::string>();
    for (std::size_t i = 0; i < words.size(); ++i) {
      if (name != words.begin()[i]) continue;
      value = static_cast<Enum>(i);
      return;
    }
    throw InputError(std::string("'") + key + "' is '" + name + "'");
  }
  template <class Enum>
  void flag_for(const char* key, Enum& value, Enum of_true, Enum of_false) const {
    value = json.at(key).get<bool>() ? of_true : of_false;
  }
  void unless(const char* key, double& value, double usual) const {
    value = json.contains(key) ? json.at(key).get<double>() : usual;
  }
  void cap(const char* key, double& value) const {
    value = json.at(key).is_null() ? kNoCap : json.at(key).get<double>();
  }
  void view(const char* key, ViewThreshold& v) const {
    View view;
    vector(key, view);
    v = {view[0], view[1], view[2], view[3], view[4]};
  }
  void frictions(const char* key, std::vector<Friction>& list) const {
    list.clear();
    if (!json.contains(key)) return;
    for (const Json& pair : json.at(key)) {
      Friction& friction = list.emplace_back();
      for (const FrictionNumber& n : kFrictionNumbers)
        friction.*n.number = pair.at(n.key).get<double>();
      if (!is_valid(list.back())) throw InputError(std::string("'") + key + "' is out of range");
    }
  }
  void impacts(const char* key, std::vector<ImpactPair>& list) const {
    list.clear();
    if (!json.contains(key)) return;
    for (const Json& pair : json.at(key)) {
      const auto number = [&](const char* name) { return pair.at(name).get<double>(); };
      list.push_back({number("restitution"),
                      {number("tap_amplitude"), number("tap_frequency"), number("tap_decay")}});
      if (!is_valid(list.back())) throw InputError(std::string("'") + key + "' is out of range");
    }
  }
  void digits(const char* key, std::uint64_t& value) const {
    value = std::stoull(json.at(key).get<std::string>());
  }
  void text(const char* key, std::string& text) const { text = json.at(key).get<std::string>(); }
  template <class Part, class Fields>
  void object(const char* key, Part& part, Fields fields) const {
    const ConfigReader reader{json.at(key)};
    fields(part, reader);
  }
  template <class Part, class Fields>
  void object_if(const char* key, bool& is_there, Part& part, Fields fields) const {
    is_there = json.contains(key);
    if (is_there) object(key, part, fields);
  }
  template <class Part, class Fields>
  void optional(const char* key, std::optional<Part>& part, Fields fields) const {
    part.reset();
    if (!json.at(key).is_null()) object(key, part.emplace(), fields);
  }
};

}  // namespace

std::string write_config(const RecordedConfig& config) {
  std::string out;
  JsonObject json(out);
  json.integer("version", 1);
  detail::visit_config(config, ConfigWriter{out, json});
  json.close();
  return out;
}

RecordedConfig read_config(const std::string& text) {
  RecordedConfig config;
  try {
    const Json json = Json::parse(text);
    const int version = json.at("version").get<int>();
    if (version != 1)
      throw InputError("recorded by a newer version (" + std::to_string(version) + "), expected 1");
    detail::visit_config(config, ConfigReader{json});
    RigidBody& body = config.params.body;
    if (!(body.mass > 0.0) || !(body.inertia.determinant() > 0.0))
      throw InputError("mass or inertia is not positive");
    body = make_body(body.mass, body.inertia, body.gravity);
  } catch (const Json::exception& error) {
    throw InputError(std::string("/config is not a configuration of thigma: ") + error.what());
  } catch (const std::logic_error& error) {
    throw InputError(std::string("/config is not a configuration of thigma: ") + error.what());
  }
  return config;
}

RecordedConfig read_config(const std::string& text, const std::string& path) {
  try {
    return read_config(text);
  } catch (const InputError& error) {
    throw InputError(path + ": " + error.what());
  }
}

}  // namespace thigma
