#pragma once
// A row of a table as CSV, and the names of its columns, by the same list.

#include <concepts>
#include <string>
#include <string_view>

#include "thigma/loop/samples.h"
#include "thigma/recording/detail/json_text.h"

namespace thigma::detail {

inline constexpr const char* kAxes[] = {"x", "y", "z", "w"};

/// Appends a cell; in quotes where its text would end it, or the row.
inline void put_cell(std::string& row, std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) {
    row += text;
    return;
  }
  row += '"';
  for (const char c : text) row.append(c == '"' ? 2 : 1, c);
  row += '"';
}

/// Values; an unknown number stays empty.
class CsvValues {
 public:
  explicit CsvValues(std::string& row) : row_(row) {}
  void group(std::string_view) {}
  void operator()(const char*, double value) {
    begin();
    if (value == value) put_number(row_, value);
  }
  template <std::integral Integer>
  void operator()(const char*, Integer value) {
    begin();
    row_ += std::to_string(value);
  }
  void operator()(const char*, Fault fault) {
    begin();
    put_cell(row_, fault_name(fault));
  }
  void absent(const char*) { begin(); }
  template <class Vector>
  void vector(const char* name, const char*, const Vector& v) {
    for (int i = 0; i < static_cast<int>(v.size()); ++i) (*this)(name, v[i]);
  }
  template <class Vector>
  void absent_vector(const char* name, const char*, const Vector& v) {
    for (int i = 0; i < static_cast<int>(v.size()); ++i) absent(name);
  }

 private:
  void begin() {
    if (!is_first_) row_ += ',';
    is_first_ = false;
  }
  std::string& row_;
  bool is_first_ = true;
};

/// Names of the columns: those of a group stand behind its own.
class CsvNames {
 public:
  explicit CsvNames(std::string& row) : row_(row) {}
  void group(std::string_view name) { group_ = name; }
  template <class Value>
  void operator()(const char* name, const Value&) {
    put(name);
  }
  void absent(const char* name) { put(name); }
  template <class Vector>
  void vector(const char* name, const char* unit, const Vector& v) {
    for (int i = 0; i < static_cast<int>(v.size()); ++i) put(name + std::string(kAxes[i]) + unit);
  }
  template <class Vector>
  void absent_vector(const char* name, const char* unit, const Vector& v) {
    vector(name, unit, v);
  }

 private:
  void put(const std::string& name) {
    if (!is_first_) row_ += ',';
    is_first_ = false;
    put_cell(row_, group_.empty() ? name : group_ + " " + name);
  }
  std::string& row_;
  std::string group_;
  bool is_first_ = true;
};

}  // namespace thigma::detail
