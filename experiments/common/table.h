#pragma once
// Columns of numbers and words, for data.csv.

#include <string>
#include <variant>
#include <vector>

namespace thigma::experiments {

/// A cell: a number (not finite: written as nothing) or a word.
using Cell = std::variant<double, std::string>;

/// Rows of equal width. Column names carry their unit: "force [N]".
struct Table {
  std::string name = "data";  // file name without .csv
  std::vector<std::string> columns{};
  std::vector<std::vector<Cell>> rows{};
};

/// Adds a row. Programmer error (assert) when it has another width than the columns.
void add_row(Table& table, std::vector<Cell> row);

/// RFC 4180, numbers in the shortest form that reads back the same, lines end with \n.
std::string csv_text(const Table& table);

}  // namespace thigma::experiments
