#include "thigma/files/file.h"
#include "thigma/loop/sample_fields.h"
#include "thigma/recording/detail/csv_row.h"
#include "thigma/recording/recording.h"

namespace thigma {
namespace {

std::string header() {
  std::string row;
  visit_columns(HapticSample{}, detail::CsvNames(row));
  return row + '\n';
}

void append_row(std::string& row, const HapticSample& s) {
  visit_columns(s, detail::CsvValues(row));
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
