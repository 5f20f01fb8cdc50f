#pragma once
// Typed reading of a JSON document: every mistake is an InputError that says where it is.

#include <cstddef>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "thigma/core/error.h"
#include "thigma/math/types.h"

namespace thigma::app {

/// A value of a document and its place in it. Lives as long as the document.
struct JsonField {
  const nlohmann::json* value = nullptr;
  std::string place;     // "FILE: cases[3].in.y"; of a document itself "FILE"
  bool is_root = false;  // the document itself

  /// Whether this is an object with the key.
  bool has(const char* key) const { return value->is_object() && value->contains(key); }
  bool is_null() const { return value->is_null(); }
};

/// Throws InputError "PLACE: expected WHAT".
[[noreturn]] void fail_field(const JsonField& field, const std::string& expected);

/// Member of an object, element of a list. Throw InputError when there is none.
JsonField member(const JsonField& field, const char* key);
JsonField element(const JsonField& field, std::size_t index);
std::size_t list_size(const JsonField& field);

/// A number; the strings "inf" and "-inf" stand for infinities.
double number(const JsonField& field);
long whole_number(const JsonField& field);
bool flag(const JsonField& field);
std::string text(const JsonField& field);

/// All numbers of a nested list, row by row. Throws InputError unless its shape is this one.
std::vector<double> numbers(const JsonField& field, const std::vector<std::size_t>& shape);

/// A list of N numbers; a 3 x 3 nested list.
template <int N>
Eigen::Matrix<double, N, 1> vector(const JsonField& field) {
  const std::vector<double> values = numbers(field, {N});
  return Eigen::Map<const Eigen::Matrix<double, N, 1>>(values.data());
}
Mat3 matrix3(const JsonField& field);

}  // namespace thigma::app
