// Stanford PLY: ascii and both byte orders, any scalar type, elements and properties of other names
// skipped by size.

#include <array>
#include <bit>
#include <cstring>

#include "thigma/import/detail/mesh_formats.h"

namespace thigma::detail {
namespace {

enum class Scalar : std::uint8_t { none, i8, u8, i16, u16, i32, u32, f32, f64 };

struct TypeName {
  std::string_view name;
  Scalar scalar;
};
constexpr std::array<TypeName, 16> kTypes = {{{"char", Scalar::i8},
                                              {"int8", Scalar::i8},
                                              {"uchar", Scalar::u8},
                                              {"uint8", Scalar::u8},
                                              {"short", Scalar::i16},
                                              {"int16", Scalar::i16},
                                              {"ushort", Scalar::u16},
                                              {"uint16", Scalar::u16},
                                              {"int", Scalar::i32},
                                              {"int32", Scalar::i32},
                                              {"uint", Scalar::u32},
                                              {"uint32", Scalar::u32},
                                              {"float", Scalar::f32},
                                              {"float32", Scalar::f32},
                                              {"double", Scalar::f64},
                                              {"float64", Scalar::f64}}};

std::size_t size_of(Scalar s) {
  switch (s) {
    case Scalar::i8:
    case Scalar::u8:
      return 1;
    case Scalar::i16:
    case Scalar::u16:
      return 2;
    case Scalar::i32:
    case Scalar::u32:
    case Scalar::f32:
      return 4;
    case Scalar::f64:
      return 8;
    case Scalar::none:
      break;
  }
  return 0;
}

enum class Role : std::uint8_t { skip, x, y, z, corners };

struct Property {
  Scalar count = Scalar::none;  // none: not a list
  Scalar type = Scalar::none;
  Role role = Role::skip;
};

struct Element {
  std::string name;
  std::int64_t count = 0;
  std::vector<Property> properties;
  std::size_t least_bytes = 0;  // of one, in binary
};

struct Header {
  MeshFormat format = MeshFormat::ply_ascii;
  std::vector<Element> elements;
  std::size_t bytes = 0;
  std::int64_t lines = 0;
};

Scalar parse_type(std::string_view word, const std::string& name, std::int64_t line) {
  for (const TypeName& t : kTypes) {
    if (t.name == word) return t.scalar;
  }
  fail_input(name, quoted(word) + " is no type of PLY", at_line(line),
             "char, uchar, short, ... float or double");
}

Property parse_property(Words& words, const std::string& element, const std::string& name,
                        std::int64_t line) {
  Property p;
  std::string_view word = words.next();
  if (word == "list") {
    p.count = parse_type(words.next(), name, line);
    if (p.count == Scalar::f32 || p.count == Scalar::f64) {
      fail_input(name, "a list counts in floating point", at_line(line), "an integer type");
    }
    word = words.next();
  }
  p.type = parse_type(word, name, line);
  const std::string_view label = words.next();
  if (label.empty() || !words.next().empty()) {
    fail_input(name, "a property line is not complete", at_line(line), "its type and its name");
  }
  const bool list = p.count != Scalar::none;
  if (element == "vertex" && !list && label == "x") p.role = Role::x;
  if (element == "vertex" && !list && label == "y") p.role = Role::y;
  if (element == "vertex" && !list && label == "z") p.role = Role::z;
  if (element == "face" && list && (label == "vertex_indices" || label == "vertex_index"))
    p.role = Role::corners;
  return p;
}

void parse_format(Words& words, Header& header, const std::string& name, std::int64_t line) {
  const std::string_view kind = words.next();
  if (kind == "ascii")
    header.format = MeshFormat::ply_ascii;
  else if (kind == "binary_little_endian")
    header.format = MeshFormat::ply_little;
  else if (kind == "binary_big_endian")
    header.format = MeshFormat::ply_big;
  else
    fail_input(name, "format " + quoted(kind) + " is unknown", at_line(line),
               "ascii, binary_little_endian or binary_big_endian");
  const std::string_view version = words.next();
  if (version != "1.0")
    fail_input(name, "version " + quoted(version) + " is unknown", at_line(line), "1.0");
}

// Each role once, or the file says nothing about where its vertices are.
void check_roles(const Header& header, const std::string& name) {
  std::array<int, 5> seen{};
  int vertex_elements = 0;
  int face_elements = 0;
  for (const Element& e : header.elements) {
    vertex_elements += e.name == "vertex";
    face_elements += e.name == "face";
    for (const Property& p : e.properties) ++seen[static_cast<std::size_t>(p.role)];
  }
  const std::string where = "header (lines 1 to " + std::to_string(header.lines) + ")";
  if (vertex_elements != 1 || seen[1] != 1 || seen[2] != 1 || seen[3] != 1) {
    fail_input(name, "its vertices are not described", where,
               "one element vertex with x, y and z, once each");
  }
  if (face_elements != 1 || seen[4] != 1) {
    fail_input(name, "its faces are not described", where,
               "one element face with one list vertex_indices");
  }
}

Header parse_header(std::string_view bytes, const std::string& name) {
  Header header;
  bool has_format = false;
  // Binary data follows, so the header's lines are cut here and not by Lines, which would look
  // ahead.
  for (std::size_t at = 0;;) {
    const std::size_t end = bytes.find('\n', at);
    if (end == std::string_view::npos) {
      fail_input(name, "the header does not end", at_line(header.lines + 1), "'end_header'");
    }
    const std::string_view line = bytes.substr(at, end - at);
    at = end + 1;
    ++header.lines;
    Words words(line);
    const std::string_view keyword = words.next();
    if (header.lines == 1 || keyword == "comment" || keyword == "obj_info" || keyword.empty())
      continue;
    if (keyword == "end_header") {
      header.bytes = at;
      break;
    }
    if (keyword == "format") {
      parse_format(words, header, name, header.lines);
      has_format = true;
    } else if (keyword == "element") {
      Element e;
      e.name = std::string(words.next());
      const std::string_view count = words.next();
      if (e.name.empty() || !parse_number(count, e.count) || e.count < 0 || !words.next().empty()) {
        fail_input(name, "an element line is not right", at_line(header.lines),
                   "a name and a count of 0 or more");
      }
      header.elements.push_back(std::move(e));
    } else if (keyword == "property" && !header.elements.empty()) {
      Element& e = header.elements.back();
      e.properties.push_back(parse_property(words, e.name, name, header.lines));
      const Property& p = e.properties.back();
      e.least_bytes += size_of(p.count == Scalar::none ? p.type : p.count);
    } else {
      fail_input(name, quoted(keyword) + " is out of place", at_line(header.lines),
                 "element, property or end_header");
    }
  }
  if (!has_format)
    fail_input(name, "the format is missing", "line 2", "'format ascii 1.0' or a binary one");
  check_roles(header, name);
  return header;
}

// Where one value comes from; both forms hand over doubles, which hold every 32-bit integer
// exactly.
struct TextSource {
  const std::string& name;
  Lines lines;
  Words words{std::string_view()};
  std::size_t line_size = 0;

  std::string where() const { return at_line(lines.number()); }
  std::size_t left() const { return line_size + lines.rest_size(); }
  void begin_element() {
    std::string_view line;
    do {
      if (!lines.next(line))
        fail_input(name, "ends too early", where(), "more elements, as the header claims");
      words = Words(line);
      line_size = line.size();
    } while (Words(line).next().empty());
  }
  void end_element() {
    const std::string_view word = words.next();
    if (!word.empty())
      fail_input(name, quoted(word) + " is too much", where(), "the end of the line");
  }
  double value(Scalar) {
    const std::string_view word = words.next();
    double v = 0.0;
    if (!parse_number(word, v)) {
      fail_input(name, word.empty() ? "a number is missing" : quoted(word) + " is not a number",
                 where(), "the properties the header names");
    }
    return v;
  }
  void check_end() {
    std::string_view line;
    while (lines.next(line)) {
      if (!Words(line).next().empty())
        fail_input(name, "goes on after the last element", where(), "the end");
    }
  }
};

struct BinarySource {
  const std::string& name;
  std::string_view bytes;
  std::size_t at = 0;
  bool big = false;

  std::string where() const { return at_byte(at); }
  std::size_t left() const { return bytes.size() - at; }
  void begin_element() {}
  void end_element() {}
  template <class T>
  T take() {
    if (left() < sizeof(T))
      fail_input(name, "ends too early", where(), "more elements, as the header claims");
    char raw[sizeof(T)];
    for (std::size_t i = 0; i < sizeof(T); ++i) raw[i] = bytes[at + (big ? sizeof(T) - 1 - i : i)];
    at += sizeof(T);
    return std::bit_cast<T>(raw);
  }
  double value(Scalar type) {
    switch (type) {
      case Scalar::i8:
        return take<std::int8_t>();
      case Scalar::u8:
        return take<std::uint8_t>();
      case Scalar::i16:
        return take<std::int16_t>();
      case Scalar::u16:
        return take<std::uint16_t>();
      case Scalar::i32:
        return take<std::int32_t>();
      case Scalar::u32:
        return take<std::uint32_t>();
      case Scalar::f32:
        return static_cast<double>(take<float>());
      case Scalar::f64:
        return take<double>();
      case Scalar::none:
        break;
    }
    return 0.0;
  }
  void check_end() {
    // Some writers end binary files with a line break too.
    if (bytes.substr(at).find_first_not_of("\r\n") != std::string_view::npos) {
      fail_input(name, "goes on after the last element", where(), "the end of the file");
    }
  }
};

template <class Source>
std::int64_t integer_value(Source& source, Scalar type, double least, double most,
                           const char* what) {
  const double v = source.value(type);
  if (!(v >= least && v <= most) || v != std::floor(v)) {
    fail_input(source.name, std::string(what) + " is not right", source.where(),
               "an integer of " + std::to_string(static_cast<std::int64_t>(least)) + " to " +
                   std::to_string(static_cast<std::int64_t>(most)));
  }
  return static_cast<std::int64_t>(v);
}

template <class Source>
void read_list(Source& source, const Property& p, std::int64_t vertex_count,
               std::vector<std::int32_t>& corners) {
  const std::int64_t n = integer_value(
      source, p.count, 0.0, static_cast<double>(source.left()) + 1.0, "the length of a list");
  corners.clear();
  for (std::int64_t i = 0; i < n; ++i) {
    if (p.role != Role::corners) {
      source.value(p.type);
      continue;
    }
    const double last = static_cast<double>(vertex_count) - 1.0;
    corners.push_back(
        static_cast<std::int32_t>(integer_value(source, p.type, 0.0, last, "a vertex index")));
  }
  if (p.role == Role::corners && n < 3) {
    fail_input(source.name, "a face has " + std::to_string(n) + " corners", source.where(),
               "three or more");
  }
}

template <class Source>
void read_elements(Source source, const Header& header, bool is_text, RawMesh& mesh) {
  std::int64_t vertex_count = 0;
  for (const Element& e : header.elements) {
    if (e.name == "vertex") vertex_count = e.count;
  }
  std::vector<std::int32_t> corners;
  for (const Element& e : header.elements) {
    if (e.properties.empty()) continue;
    // Whatever the header claims, an element takes some bytes: refuse before anything is reserved.
    const std::size_t least = is_text ? 2 * e.properties.size() - 1 : e.least_bytes;
    if (static_cast<std::size_t>(e.count) > (source.left() + 1) / least || e.count > 0x7fffffff) {
      fail_input(source.name,
                 "claims " + std::to_string(e.count) + " of element " + quoted(e.name) +
                     " but has " + std::to_string(source.left()) + " bytes left",
                 source.where(), "a count that fits the file");
    }
    if (e.name == "vertex") mesh.positions.reserve(static_cast<std::size_t>(e.count));
    if (e.name == "face") mesh.triangles.reserve(static_cast<std::size_t>(e.count));
    for (std::int64_t i = 0; i < e.count; ++i) {
      source.begin_element();
      Vec3 position = Vec3::Zero();
      for (const Property& p : e.properties) {
        if (p.count != Scalar::none) {
          read_list(source, p, vertex_count, corners);
          if (p.role == Role::corners) {
            check_room(mesh.triangles.size() + corners.size(), source.name, source.where());
            add_fan(corners, mesh);
          }
          continue;
        }
        const double v = source.value(p.type);
        if (p.role == Role::skip) continue;
        if (!(std::fabs(v) <= kMaxCoordinate)) check_coordinate(v, source.name, source.where());
        position[static_cast<int>(p.role) - static_cast<int>(Role::x)] = v;
      }
      source.end_element();
      if (e.name == "vertex") mesh.positions.push_back(position);
    }
  }
  source.check_end();
}

}  // namespace

bool is_ply(const FileClues& clues) {
  return clues.bytes.starts_with("ply\n") || clues.bytes.starts_with("ply\r\n");
}

RawMesh read_ply(std::string_view bytes, const std::string& name) {
  const Header header = parse_header(bytes, name);
  RawMesh mesh;
  mesh.format = header.format;
  if (header.format == MeshFormat::ply_ascii) {
    read_elements(TextSource{name, Lines(bytes.substr(header.bytes), header.lines)}, header, true,
                  mesh);
  } else {
    const bool big = header.format == MeshFormat::ply_big;
    read_elements(BinarySource{name, bytes, header.bytes, big}, header, false, mesh);
  }
  return mesh;
}

}  // namespace thigma::detail
