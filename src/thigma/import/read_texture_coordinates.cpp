// A second look at the file: reading a mesh merges positions and leaves triangles out, so faces are
// read here once more, with what parse_mesh has checked taken for granted.
#include "thigma/import/read_texture_coordinates.h"

#include "thigma/files/file.h"
#include "thigma/import/detail/raw_mesh.h"

namespace thigma {
namespace {

using detail::at_line;
using detail::fail_input;

struct Corner {
  std::int64_t position = 0, coordinates = 0;  // counted from 1, or back from what was read so far
};

struct CoordinateReader {
  const std::string& name;
  std::vector<Vec3> positions;
  std::vector<Vec2> coordinates;
  struct Face {
    std::array<std::size_t, 3> position, coordinates;
    std::int64_t line = 0;
  };
  std::vector<Face> faces;  // triangles of fans
};

void read_coordinates(CoordinateReader& obj, detail::Words& words, std::int64_t line) {
  double u = 0.0, v = 0.0;
  const std::string_view first = words.next(), second = words.next();
  const bool is_read = detail::parse_number(first, u) &&
                       (second.empty() || detail::parse_number(second, v)) && std::isfinite(u) &&
                       std::isfinite(v);
  if (!is_read) fail_input(obj.name, "no texture coordinates", at_line(line), "u and v");
  obj.coordinates.emplace_back(u, v);
}

std::size_t index_of(std::int64_t given, std::size_t count) {
  return static_cast<std::size_t>(given < 0 ? static_cast<std::int64_t>(count) + given : given - 1);
}

void read_face(CoordinateReader& obj, detail::Words& words, std::int64_t line) {
  std::vector<std::array<std::size_t, 2>> corners;
  for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
    const std::size_t slash = word.find('/');
    Corner corner;
    detail::parse_number(word.substr(0, slash), corner.position);
    if (slash != std::string_view::npos) {
      const std::string_view rest = word.substr(slash + 1);
      detail::parse_number(rest.substr(0, rest.find('/')), corner.coordinates);
    }
    if (corner.coordinates == 0)
      fail_input(obj.name, "a corner without texture coordinates", at_line(line),
                 "i/t or i/t/n for every corner");
    corners.push_back({index_of(corner.position, obj.positions.size()),
                       index_of(corner.coordinates, obj.coordinates.size())});
  }
  for (std::size_t i = 2; i < corners.size(); ++i) {
    obj.faces.push_back({{corners[0][0], corners[i - 1][0], corners[i][0]},
                         {corners[0][1], corners[i - 1][1], corners[i][1]},
                         line});
  }
}

}  // namespace

std::vector<std::array<Vec2, 3>> read_texture_coordinates(std::string_view bytes,
                                                          const std::string& name) {
  CoordinateReader obj{name, {}, {}, {}};
  detail::Lines lines(without_byte_order_mark(bytes));
  std::string_view line;
  std::string joined;
  while (lines.next(line)) {
    joined.clear();
    while (!line.empty() && line.back() == '\\') {
      joined.append(line.substr(0, line.size() - 1)) += ' ';
      if (!lines.next(line)) line = {};
    }
    if (!joined.empty()) line = joined.append(line);
    detail::Words words(line.substr(0, line.find('#')));
    const std::string_view keyword = words.next();
    if (keyword == "v") {
      const double x = detail::read_coordinate(words, name, lines.number());
      const double y = detail::read_coordinate(words, name, lines.number());
      obj.positions.emplace_back(x, y, detail::read_coordinate(words, name, lines.number()));
    } else if (keyword == "vt") {
      read_coordinates(obj, words, lines.number());
    } else if (keyword == "f" || keyword == "fo") {
      read_face(obj, words, lines.number());
    }
  }
  if (obj.faces.empty())
    fail_input(name, "no texture coordinates", "in the file", "an OBJ with vt");
  std::vector<std::array<Vec2, 3>> found;
  for (const CoordinateReader::Face& face : obj.faces) {
    std::array<Vec3, 3> p;
    std::array<Vec2, 3> t;
    for (std::size_t k = 0; k < 3; ++k) {
      if (face.coordinates[k] >= obj.coordinates.size() || face.position[k] >= obj.positions.size())
        fail_input(name, "texture coordinates that do not exist", at_line(face.line),
                   "1 to " + std::to_string(obj.coordinates.size()));
      p[k] = obj.positions[face.position[k]];
      t[k] = obj.coordinates[face.coordinates[k]];
    }
    // Bit-equal positions are one vertex: what then repeats an index is no triangle of the mesh.
    if (p[0] != p[1] && p[1] != p[2] && p[2] != p[0]) found.push_back(t);
  }
  return found;
}

}  // namespace thigma
