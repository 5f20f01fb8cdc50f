#include "experiments/common/table.h"

#include <cassert>
#include <charconv>
#include <cmath>

namespace thigma::experiments {
namespace {

std::string cell_text(const Cell& cell) {
  if (const double* number = std::get_if<double>(&cell)) {
    if (!std::isfinite(*number)) return "";
    char text[40];
    const auto end = std::to_chars(text, text + sizeof text, *number).ptr;
    return std::string(text, end);
  }
  const std::string& word = std::get<std::string>(cell);
  if (word.find_first_of(",\"\r\n") == std::string::npos) return word;
  std::string quoted = "\"";
  for (const char c : word) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

}  // namespace

void add_row(Table& table, std::vector<Cell> row) {
  assert(row.size() == table.columns.size());
  table.rows.push_back(std::move(row));
}

std::string csv_text(const Table& table) {
  std::string text;
  auto add_line = [&](const auto& cells) {
    for (std::size_t i = 0; i < cells.size(); ++i) text += (i > 0 ? "," : "") + cell_text(cells[i]);
    text += '\n';
  };
  add_line(table.columns);
  for (const std::vector<Cell>& row : table.rows) add_line(row);
  return text;
}

}  // namespace thigma::experiments
