#include "reference/conformance/json_fields.h"

#include "thigma/math/infinity.h"

namespace thigma::app {
namespace {

void append_numbers(const JsonField& field, const std::vector<std::size_t>& shape,
                    std::size_t depth, std::vector<double>& values) {
  if (depth == shape.size()) {
    values.push_back(number(field));
    return;
  }
  if (list_size(field) != shape[depth])
    fail_field(field, "a list of " + std::to_string(shape[depth]));
  for (std::size_t i = 0; i < shape[depth]; ++i)
    append_numbers(element(field, i), shape, depth + 1, values);
}

}  // namespace

void fail_field(const JsonField& field, const std::string& expected) {
  throw InputError(field.place + ": expected " + expected);
}

JsonField member(const JsonField& field, const char* key) {
  if (!field.value->is_object()) fail_field(field, std::string("an object with \"") + key + "\"");
  const auto found = field.value->find(key);
  if (found == field.value->end()) fail_field(field, std::string("a field \"") + key + "\"");
  return {&*found, field.place + (field.is_root ? ": " : ".") + key};
}

JsonField element(const JsonField& field, std::size_t index) {
  if (index >= list_size(field))
    fail_field(field, "more than " + std::to_string(index) + " elements");
  return {&(*field.value)[index], field.place + "[" + std::to_string(index) + "]"};
}

std::size_t list_size(const JsonField& field) {
  if (!field.value->is_array()) fail_field(field, "a list");
  return field.value->size();
}

double number(const JsonField& field) {
  if (field.value->is_number()) return field.value->get<double>();
  if (*field.value == "inf") return kInfinity;
  if (*field.value == "-inf") return -kInfinity;
  fail_field(field, "a number, \"inf\" or \"-inf\"");
}

long whole_number(const JsonField& field) {
  if (!field.value->is_number_integer()) fail_field(field, "a whole number");
  return field.value->get<long>();
}

bool flag(const JsonField& field) {
  if (!field.value->is_boolean()) fail_field(field, "true or false");
  return field.value->get<bool>();
}

std::string text(const JsonField& field) {
  if (!field.value->is_string()) fail_field(field, "a string");
  return field.value->get<std::string>();
}

std::vector<double> numbers(const JsonField& field, const std::vector<std::size_t>& shape) {
  std::vector<double> values;
  append_numbers(field, shape, 0, values);
  return values;
}

Mat3 matrix3(const JsonField& field) {
  const std::vector<double> values = numbers(field, {3, 3});
  return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(values.data());
}

}  // namespace thigma::app
