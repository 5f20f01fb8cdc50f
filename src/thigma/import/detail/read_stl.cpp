// STL, text and binary: triangles without shared vertices, single precision in the binary form.

#include <bit>
#include <cstring>

#include "thigma/import/detail/mesh_formats.h"

namespace thigma::detail {
namespace {

static_assert(std::endian::native == std::endian::little,
              "files are little-endian and read in place");

constexpr std::size_t kHeaderBytes = 84;    // 80 of free text, the count
constexpr std::size_t kTriangleBytes = 50;  // normal, three corners, attribute

// One line of the text form must begin with these words.
Words expect_words(Lines& lines, std::string_view line, std::string_view first,
                   std::string_view second, const std::string& name) {
  Words words(line);
  if (words.next() == first && (second.empty() || words.next() == second)) return words;
  std::string expected = "'";
  expected.append(first);
  if (!second.empty()) expected.append(1, ' ').append(second);
  expected.append(1, '\'');
  fail_input(name, quoted(line) + " is out of place", at_line(lines.number()), expected);
}

bool next_content(Lines& lines, std::string_view& line) {
  while (lines.next(line)) {
    Words words(line);
    if (!words.next().empty()) return true;
  }
  return false;
}

void require_content(Lines& lines, std::string_view& line, const std::string& name) {
  if (!next_content(lines, line)) {
    fail_input(name, "ends within a facet", at_line(lines.number()), "'endfacet' and 'endsolid'");
  }
}

void read_facet(Lines& lines, std::string_view line, const std::string& name, RawMesh& mesh) {
  expect_words(lines, line, "facet", "", name);
  require_content(lines, line, name);
  expect_words(lines, line, "outer", "loop", name);
  check_room(mesh.positions.size() + 2, name, at_line(lines.number()));
  const std::int32_t first = static_cast<std::int32_t>(mesh.positions.size());
  for (int corner = 0; corner < 3; ++corner) {
    require_content(lines, line, name);
    Words words = expect_words(lines, line, "vertex", "", name);
    const double x = read_coordinate(words, name, lines.number());
    const double y = read_coordinate(words, name, lines.number());
    const double z = read_coordinate(words, name, lines.number());
    if (!words.next().empty()) {
      fail_input(name, "a vertex has more than three numbers", at_line(lines.number()),
                 "three coordinates");
    }
    mesh.positions.emplace_back(x, y, z);
  }
  require_content(lines, line, name);
  expect_words(lines, line, "endloop", "", name);
  require_content(lines, line, name);
  expect_words(lines, line, "endfacet", "", name);
  mesh.triangles.push_back({first, first + 1, first + 2});
}

}  // namespace

bool has_binary_stl_size(std::string_view bytes) {
  if (bytes.size() < kHeaderBytes) return false;
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + 80, sizeof count);
  return bytes.size() == kHeaderBytes + kTriangleBytes * std::size_t{count};
}

bool is_stl_binary(const FileClues& clues) { return has_binary_stl_size(clues.bytes); }
bool is_stl_ascii(const FileClues& clues) { return clues.first_word == "solid"; }

RawMesh read_stl_ascii(std::string_view bytes, const std::string& name) {
  RawMesh mesh;
  mesh.format = MeshFormat::stl_ascii;
  Lines lines(bytes);
  std::string_view line;
  bool open = false;  // between solid and endsolid; a file may hold several solids
  while (next_content(lines, line)) {
    const std::string_view keyword = Words(line).next();
    if (!open) {
      expect_words(lines, line, "solid", "", name);
      open = true;
    } else if (keyword == "endsolid") {
      open = false;
    } else {
      read_facet(lines, line, name, mesh);
    }
  }
  if (open) fail_input(name, "ends within a solid", at_line(lines.number()), "'endsolid'");
  return mesh;
}

RawMesh read_stl_binary(std::string_view bytes, const std::string& name) {
  RawMesh mesh;
  mesh.format = MeshFormat::stl_binary;
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + 80, sizeof count);
  const std::size_t needed = kHeaderBytes + kTriangleBytes * std::size_t{count};
  if (needed != bytes.size()) {
    fail_input(name,
               "claims " + std::to_string(count) + " triangles in " + std::to_string(needed) +
                   " bytes but has " + std::to_string(bytes.size()),
               "byte 80", "a count that fits the file");
  }
  check_room(std::size_t{count} * 3, name, "byte 80");
  mesh.positions.reserve(std::size_t{count} * 3);
  mesh.triangles.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t at = kHeaderBytes + kTriangleBytes * i + 12;  // the normal is not used
    float corner[9];
    std::memcpy(corner, bytes.data() + at, sizeof corner);
    for (int k = 0; k < 9; ++k) {
      if (!(std::fabs(corner[k]) <= kMaxCoordinate)) {
        check_coordinate(corner[k], name, at_byte(at + 4 * static_cast<std::size_t>(k)));
      }
    }
    const std::int32_t first = static_cast<std::int32_t>(mesh.positions.size());
    for (int k = 0; k < 9; k += 3)
      mesh.positions.emplace_back(corner[k], corner[k + 1], corner[k + 2]);
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  return mesh;
}

}  // namespace thigma::detail
