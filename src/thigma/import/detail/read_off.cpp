// Object File Format: OFF, with the prefixes that only add numbers after the position (ST, C, N).

#include <algorithm>

#include "thigma/import/detail/mesh_formats.h"

namespace thigma::detail {
namespace {

// The next line with a word on it, comments cut off.
bool next_uncommented(Lines& lines, std::string_view& line) {
  while (lines.next(line)) {
    line = line.substr(0, line.find('#'));
    if (!std::all_of(line.begin(), line.end(), is_blank)) return true;
  }
  return false;
}

void check_rest_numeric(Words& words, const std::string& name, std::int64_t line) {
  for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
    double ignored = 0.0;  // colour, normal or texture coordinate
    if (!parse_number(word, ignored))
      fail_input(name, quoted(word) + " is not a number", at_line(line), "numbers");
  }
}

struct OffCounts {
  std::int64_t vertices = 0, faces = 0;
};

OffCounts read_counts(Lines& lines, std::string_view header, const std::string& name) {
  Words words(header);
  words.next();
  std::string_view word = words.next();
  if (word.empty()) {
    std::string_view line;
    if (!next_uncommented(lines, line))
      fail_input(name, "ends after its first word", "line 1", "the counts");
    words = Words(line);
    word = words.next();
  }
  OffCounts counts;
  std::int64_t edges = 0;
  const std::string_view second = words.next();
  const std::string_view third = words.next();  // edges; some writers leave it out
  if (!parse_number(word, counts.vertices) || !parse_number(second, counts.faces) ||
      !(third.empty() || parse_number(third, edges)) || counts.vertices < 0 || counts.faces < 0 ||
      !words.next().empty()) {
    fail_input(name, "the counts are not right", at_line(lines.number()),
               "vertices, faces and edges, 0 or more");
  }
  // Every vertex takes six bytes of text at least, every face two.
  const std::int64_t bytes = static_cast<std::int64_t>(lines.rest_size());
  if (counts.vertices > bytes / 5 + 1 || counts.faces > bytes / 2 + 1) {
    fail_input(name,
               "claims " + std::to_string(counts.vertices) + " vertices and " +
                   std::to_string(counts.faces) + " faces but has only " + std::to_string(bytes) +
                   " bytes left",
               at_line(lines.number()), "counts that fit the file");
  }
  return counts;
}

void read_face(std::string_view line, std::int64_t number, const std::string& name,
               std::vector<std::int32_t>& corners, RawMesh& mesh) {
  Words words(line);
  std::int64_t n = 0;
  const std::string_view word = words.next();
  if (!parse_number(word, n) || n < 3) {
    fail_input(name, "a face begins with " + quoted(word), at_line(number),
               "its number of corners, 3 or more");
  }
  corners.clear();
  for (std::int64_t i = 0; i < n; ++i) {
    const std::string_view corner = words.next();
    std::int64_t index = 0;
    if (corner.empty()) {
      fail_input(name, "a face ends after " + std::to_string(i) + " corners", at_line(number),
                 std::to_string(n));
    }
    if (!parse_number(corner, index) || index < 0 ||
        index >= static_cast<std::int64_t>(mesh.positions.size())) {
      fail_input(name, "vertex " + quoted(corner) + " does not exist", at_line(number),
                 "0 to " + std::to_string(static_cast<std::int64_t>(mesh.positions.size()) - 1));
    }
    corners.push_back(static_cast<std::int32_t>(index));
  }
  check_rest_numeric(words, name, number);
  check_room(mesh.triangles.size() + corners.size(), name, at_line(number));
  add_fan(corners, mesh);
}

}  // namespace

// "OFF" with its optional prefixes.
bool is_off(const FileClues& clues) {
  std::string_view word = clues.first_word;
  if (word.starts_with("ST")) word.remove_prefix(2);
  if (word.starts_with("C")) word.remove_prefix(1);
  if (word.starts_with("N")) word.remove_prefix(1);
  return word == "OFF";
}

RawMesh read_off(std::string_view bytes, const std::string& name) {
  RawMesh mesh;
  mesh.format = MeshFormat::off;
  Lines lines(bytes);
  std::string_view line;
  next_uncommented(lines, line);
  const OffCounts counts = read_counts(lines, line, name);
  mesh.positions.reserve(static_cast<std::size_t>(counts.vertices));
  mesh.triangles.reserve(static_cast<std::size_t>(counts.faces));
  for (std::int64_t i = 0; i < counts.vertices; ++i) {
    if (!next_uncommented(lines, line)) {
      fail_input(name, "ends after " + std::to_string(i) + " vertices", at_line(lines.number()),
                 std::to_string(counts.vertices));
    }
    Words words(line);
    const double x = read_coordinate(words, name, lines.number());
    const double y = read_coordinate(words, name, lines.number());
    const double z = read_coordinate(words, name, lines.number());
    check_rest_numeric(words, name, lines.number());
    mesh.positions.emplace_back(x, y, z);
  }
  std::vector<std::int32_t> corners;
  for (std::int64_t i = 0; i < counts.faces; ++i) {
    if (!next_uncommented(lines, line)) {
      fail_input(name, "ends after " + std::to_string(i) + " faces", at_line(lines.number()),
                 std::to_string(counts.faces));
    }
    read_face(line, lines.number(), name, corners, mesh);
  }
  if (next_uncommented(lines, line)) {
    fail_input(name, "goes on after the last face", at_line(lines.number()), "the end of the file");
  }
  return mesh;
}

}  // namespace thigma::detail
