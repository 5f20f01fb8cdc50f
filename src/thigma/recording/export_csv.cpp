#include <concepts>

#include "thigma/files/file.h"
#include "thigma/loop/sample_fields.h"
#include "thigma/recording/detail/json_text.h"
#include "thigma/recording/recording.h"

namespace thigma {
namespace {

constexpr const char* kAxes[] = {"x", "y", "z", "w"};

/// Names of the columns, of the list in sample_fields.h.
struct HeaderWriter {
  std::string& row;

  template <class Value>
  void operator()(const char* name, const Value&) const {
    if (!row.empty()) row += ',';
    row += name;
  }
  template <class Vector>
  void vector(const char* name, const char* unit, const Vector& v) const {
    for (int i = 0; i < static_cast<int>(v.size()); ++i)
      (*this)((name + std::string(kAxes[i]) + unit).c_str(), v[i]);
  }
};

/// Their values; an unknown number stays empty.
struct RowWriter {
  std::string& row;
  bool& is_first;

  void begin() const {
    if (!is_first) row += ',';
    is_first = false;
  }
  void operator()(const char*, double value) const {
    begin();
    if (value == value) detail::put_number(row, value);
  }
  void operator()(const char* name, float value) const {
    (*this)(name, static_cast<double>(value));
  }
  template <std::integral Integer>
  void operator()(const char*, Integer value) const {
    begin();
    row += std::to_string(value);
  }
  void operator()(const char*, Fault fault) const {
    begin();
    row += fault_name(fault);
  }
  template <class Vector>
  void vector(const char* name, const char*, const Vector& v) const {
    for (int i = 0; i < static_cast<int>(v.size()); ++i) (*this)(name, v[i]);
  }
};

std::string header() {
  std::string row;
  visit_columns(HapticSample{}, HeaderWriter{row});
  return row + '\n';
}

void append_row(std::string& row, const HapticSample& s) {
  bool is_first = true;
  visit_columns(s, RowWriter{row, is_first});
  row += '\n';
}

}  // namespace

CsvExport::CsvExport(const std::string& path)
    : file_(std::make_unique<FileWriter>(path)), rows_(header()) {}

CsvExport::~CsvExport() = default;

void CsvExport::add(const HapticSample& sample) {
  constexpr std::size_t kMost = 1 << 20;
  append_row(rows_, sample);
  if (rows_.size() < kMost) return;
  file_->append(rows_);
  rows_.clear();
}

void CsvExport::keep() {
  file_->append(rows_);
  rows_.clear();
  file_->keep();
}

void export_csv(const Recording& recording, const std::string& path) {
  CsvExport csv(path);
  for (const HapticSample& sample : recording.frames) csv.add(sample);
  csv.keep();
}

}  // namespace thigma
