// Wavefront OBJ: v and f, vt where it is asked for; everything else the format knows is skipped,
// everything it does not know refused.

#include <algorithm>
#include <array>

#include "thigma/import/detail/mesh_formats.h"

namespace thigma::detail {
namespace {

constexpr std::array<std::string_view, 38> kIgnored = {
    "vt",        "vn",    "vp",       "o",        "g",    "s",      "mg",     "usemtl",
    "mtllib",    "l",     "p",        "deg",      "bmat", "step",   "cstype", "curv",
    "curv2",     "surf",  "parm",     "trim",     "hole", "scrv",   "sp",     "end",
    "con",       "bevel", "c_interp", "d_interp", "lod",  "maplib", "usemap", "shadow_obj",
    "trace_obj", "ctech", "stech",    "call",     "csh",  "maxlod"};

struct ObjReader {
  const std::string& name;
  ObjTexture* texture = nullptr;
  RawMesh mesh;
  std::vector<std::int32_t> corners;
  std::vector<std::int64_t> texture_corners;
  std::int32_t largest = -1;  // index used so far: faces may come before their vertices
  std::int64_t largest_line = 0;
};

void read_vertex(ObjReader& obj, Words& words, std::int64_t line) {
  check_room(obj.mesh.positions.size(), obj.name, at_line(line));
  const double x = read_coordinate(words, obj.name, line);
  const double y = read_coordinate(words, obj.name, line);
  const double z = read_coordinate(words, obj.name, line);
  int extra = 0;
  for (std::string_view word = words.next(); !word.empty(); word = words.next(), ++extra) {
    double ignored = 0.0;  // a weight, or a colour
    if (extra == 4 || !parse_number(word, ignored)) {
      fail_input(obj.name, quoted(word) + " after the coordinates", at_line(line),
                 "at most four more numbers");
    }
  }
  obj.mesh.positions.emplace_back(x, y, z);
}

void read_texture_vertex(ObjReader& obj, Words& words, std::int64_t line) {
  double u = 0.0, v = 0.0;
  const std::string_view first = words.next(), second = words.next();
  const bool is_read = parse_number(first, u) && (second.empty() || parse_number(second, v)) &&
                       std::isfinite(u) && std::isfinite(v);
  if (!is_read) fail_input(obj.name, "no texture coordinates", at_line(line), "u and v");
  obj.texture->coordinates.emplace_back(u, v);
}

/// Index from 0 of what a file counts from 1, or back from what has been read so far.
std::int64_t index_of(std::int64_t given, std::size_t count) {
  return given < 0 ? static_cast<std::int64_t>(count) + given : given - 1;
}

// One corner, "i", "i/t", "i//n" or "i/t/n": the vertex counts, and t where textures are asked for;
// the rest must be well formed.
std::int32_t read_corner(ObjReader& obj, std::string_view word, std::int64_t line) {
  const auto fail = [&] {
    fail_input(obj.name, quoted(word) + " is not a corner", at_line(line), "i, i/t, i//n or i/t/n");
  };
  std::string_view rest = word;
  std::int64_t vertex = 0, texture = 0;
  for (int field = 0; field < 3; ++field) {
    const std::size_t slash = rest.find('/');
    const std::string_view part = rest.substr(0, slash);
    const bool last = slash == std::string_view::npos;
    const bool may_be_empty = field == 1 && !last;
    std::int64_t value = 0;
    if (!(part.empty() && may_be_empty) && (!parse_number(part, value) || value == 0)) fail();
    if (field == 0) vertex = value;
    if (field == 1) texture = value;
    if (last) break;
    if (field == 2) fail();
    rest.remove_prefix(slash + 1);
  }
  const std::size_t count = obj.mesh.positions.size();
  const std::int64_t index = index_of(vertex, count);
  if (index < 0 || index >= 0x7fffffff) {
    fail_input(obj.name, "vertex " + std::to_string(vertex) + " does not exist", at_line(line),
               "1 to " + std::to_string(count) + " or the same negative, counted back");
  }
  if (obj.texture != nullptr) {
    if (texture == 0)
      fail_input(obj.name, "a corner without texture coordinates", at_line(line),
                 "i/t or i/t/n for every corner");
    obj.texture_corners.push_back(index_of(texture, obj.texture->coordinates.size()));
  }
  return static_cast<std::int32_t>(index);
}

void read_face(ObjReader& obj, Words& words, std::int64_t line) {
  obj.corners.clear();
  obj.texture_corners.clear();
  for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
    const std::int32_t index = read_corner(obj, word, line);
    if (index > obj.largest) {
      obj.largest = index;
      obj.largest_line = line;
    }
    obj.corners.push_back(index);
  }
  if (obj.corners.size() < 3) {
    fail_input(obj.name, "a face has " + std::to_string(obj.corners.size()) + " corners",
               at_line(line), "three or more");
  }
  check_room(obj.mesh.triangles.size() + obj.corners.size(), obj.name, at_line(line));
  add_fan(obj.corners, obj.mesh);
  const std::vector<std::int64_t>& t = obj.texture_corners;
  for (std::size_t i = 2; i < t.size(); ++i) {
    obj.texture->triangles.push_back({t[0], t[i - 1], t[i]});
    obj.texture->lines.push_back(line);
  }
}

// A backslash at the end of a line continues it on the next.
std::string_view join_continued(std::string_view line, Lines& lines, std::string& joined) {
  if (line.empty() || line.back() != '\\') return line;
  joined.clear();
  for (;;) {
    const bool more = !line.empty() && line.back() == '\\';
    joined.append(line.substr(0, line.size() - (more ? 1 : 0)));
    joined += ' ';
    if (!more || !lines.next(line)) return joined;
  }
}

}  // namespace

RawMesh read_obj_texture(std::string_view bytes, const std::string& name, ObjTexture* texture) {
  ObjReader obj{name, texture, {}, {}, {}};
  obj.mesh.format = MeshFormat::obj;
  Lines lines(bytes);
  std::string_view line;
  std::string joined;
  while (lines.next(line)) {
    line = join_continued(line, lines, joined);
    line = line.substr(0, line.find('#'));
    Words words(line);
    const std::string_view keyword = words.next();
    if (keyword == "v") {
      read_vertex(obj, words, lines.number());
    } else if (keyword == "vt" && texture != nullptr) {
      read_texture_vertex(obj, words, lines.number());
    } else if (keyword == "f" || keyword == "fo") {
      read_face(obj, words, lines.number());
    } else if (!keyword.empty() &&
               std::find(kIgnored.begin(), kIgnored.end(), keyword) == kIgnored.end()) {
      fail_input(name, quoted(keyword) + " is no keyword of OBJ", at_line(lines.number()),
                 "v, f, or another keyword of the format");
    }
  }
  if (obj.largest >= static_cast<std::int64_t>(obj.mesh.positions.size())) {
    fail_input(name, "vertex " + std::to_string(std::int64_t{obj.largest} + 1) + " does not exist",
               at_line(obj.largest_line), "1 to " + std::to_string(obj.mesh.positions.size()));
  }
  if (obj.mesh.positions.empty()) {
    fail_input(name, "has no vertices", at_line(lines.number()), "a mesh: " + mesh_kind_names());
  }
  return std::move(obj.mesh);
}

RawMesh read_obj(std::string_view bytes, const std::string& name) {
  return read_obj_texture(bytes, name, nullptr);
}

}  // namespace thigma::detail
