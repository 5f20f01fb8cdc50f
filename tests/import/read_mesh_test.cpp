#include "thigma/import/read_mesh.h"

#include <clocale>
#include <cstring>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "thigma/core/error.h"

namespace thigma {
namespace {

// The message of what parsing throws; fails the test when it does not.
std::string error_of(std::string_view bytes) {
  try {
    parse_mesh(bytes, "part.x");
  } catch (const InputError& error) {
    return error.what();
  }
  ADD_FAILURE() << "accepted: " << bytes;
  return {};
}

bool has(const std::string& text, const char* part) { return text.find(part) != std::string::npos; }

// One line, the file first, and the place.
void expect_error(std::string_view bytes, const char* what, const char* where) {
  const std::string message = error_of(bytes);
  EXPECT_EQ(message.rfind("part.x: ", 0), 0u) << message;
  EXPECT_TRUE(has(message, what)) << message;
  EXPECT_TRUE(has(message, where)) << message;
  EXPECT_TRUE(has(message, "expected")) << message;
  EXPECT_FALSE(has(message, "\n")) << message;
}

template <class T>
void put(std::string& out, T value, bool big = false) {
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  for (std::size_t i = 0; i < sizeof(T); ++i) out += raw[big ? sizeof(T) - 1 - i : i];
}

const Vec3 kA(0.1, 0.25, -3.0), kB(1e-9, 2.0, 1e9), kC(0.0, -7.5, 1.0 / 3.0), kD(5.0, 5.0, 5.0);

// Through memory: g++ 12 drops the rounding of a vectorised double to float and back.
Vec3 in_single(const Vec3& p) {
  Vec3 rounded;
  for (int k = 0; k < 3; ++k) {
    const volatile float single = static_cast<float>(p[k]);
    rounded[k] = single;
  }
  return rounded;
}

void expect_quad(const MeshFile& file) {
  ASSERT_EQ(file.mesh.positions.size(), 4u);
  EXPECT_EQ(file.mesh.positions[0], kA);
  EXPECT_EQ(file.mesh.positions[1], kB);
  EXPECT_EQ(file.mesh.positions[2], kC);
  EXPECT_EQ(file.mesh.positions[3], kD);
  ASSERT_EQ(file.mesh.triangles.size(), 2u);
  EXPECT_EQ(file.mesh.triangles[0], (std::array<std::int32_t, 3>{0, 1, 2}));
  EXPECT_EQ(file.mesh.triangles[1], (std::array<std::int32_t, 3>{0, 2, 3}));
}

const char* const kVertices =
    "0.1 0.25 -3\n"
    "1e-9 +2.0 1E9\n"
    "0 -7.5 0.3333333333333333148\n"
    "5 5 5\n";

std::string prefixed(const char* prefix) {
  std::string out;
  for (const char* p = kVertices; *p != 0;) {
    const char* end = std::strchr(p, '\n') + 1;
    out += prefix + std::string(p, end);
    p = end;
  }
  return out;
}

TEST(ReadObj, reads_every_way_to_name_a_corner) {
  for (const char* face :
       {"f 1 2 3 4", "f 1/9 2/9 3/9 4/9", "f 1//7 2//7 3//7 4//7", "f 1/9/7 2/9/7 3/9/7 4/9/7",
        "f -4 -3 -2 -1", "f -4/-1/-1 -3/-1/-1 -2/-1/-1 -1/-1/-1", "f 1 2 \\\n 3 4",
        "f 1 2 3 4 # quad"}) {
    const MeshFile file = parse_mesh("# a comment\nmtllib x.mtl\no part\n" + prefixed("v ") +
                                         "vn nan 0 1\ns off\n" + face + "\n",
                                     "x");
    expect_quad(file);
    EXPECT_EQ(file.format, MeshFormat::obj);
  }
}

TEST(ReadMesh, a_byte_order_mark_before_a_text_is_skipped) {
  const std::string triangle = "0 0 0\n1 0 0\n0 1 0\n";
  const std::string facet =
      " facet normal 0 0 1\n  outer loop\n   vertex 0 0 0\n   vertex 1 0 0\n   vertex 0 1 0\n"
      "  endloop\n endfacet\n";
  for (const std::string& text :
       {std::string("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"),
        "OFF\n3 1 0\n" + triangle + "3 0 1 2\n",
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
        "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n" +
            triangle + "3 0 1 2\n",
        "solid a\n" + facet + "endsolid a\n"}) {
    const MeshFile plain = parse_mesh(text, "x"), marked = parse_mesh("\xEF\xBB\xBF" + text, "x");
    EXPECT_EQ(marked.format, plain.format);
    EXPECT_EQ(marked.mesh.positions, plain.mesh.positions);
    EXPECT_EQ(marked.mesh.triangles, plain.mesh.triangles);
  }
  expect_error("\xEF\xBB\xBF", "empty", "byte 0");
}

TEST(ReadMesh, a_binary_stl_may_begin_with_the_bytes_of_a_mark) {
  std::string bytes = "\xEF\xBB\xBF" + std::string(77, ' ');
  put(bytes, std::uint32_t{1});
  for (const float x : {0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f}) put(bytes, x);
  put(bytes, std::uint16_t{0});
  EXPECT_EQ(parse_mesh(bytes, "x").format, MeshFormat::stl_binary);
}

TEST(ReadObj, takes_weights_colours_line_ends_and_faces_before_vertices) {
  expect_quad(parse_mesh("f 1 2 3 4\r\n" + prefixed("v "), "x"));
  expect_quad(
      parse_mesh("v 0.1 .25 -3 1\nv 1e-9 2 1e9 0.5 0.5 0.5\nv 0 -7.5 0.33333333333333331 1 1 1 "
                 "1\rv 5 5 5\rf 1 2 3 4",
                 "x"));
}

TEST(ReadObj, names_the_line_of_what_is_wrong) {
  expect_error("v 0 0\n", "missing", "line 1");
  expect_error("v 0 0 zero\n", "'zero'", "line 1");
  expect_error("v 0 0 0,5\n", "'0,5'", "line 1");
  expect_error("v 0 0 nan\n", "not finite", "line 1");
  expect_error("\nv 0 -inf 0\n", "not finite", "line 2");
  expect_error("v 0 0 1e51\n", "out of range", "line 1");
  expect_error("v 0 0 1e999\n", "not finite", "line 1");
  expect_error("v 0 0 0\nf 1 1\n", "2 corners", "line 2");
  expect_error("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n", "vertex 4", "line 4");
  expect_error("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 0 1 2\n", "'0'", "line 4");
  expect_error("v 0 0 0\nv 1 0 0\nv 0 1 0\nf -4 1 2\n", "vertex -4", "line 4");
  expect_error("v 0 0 0\nf 1/2/3/4 1 1\n", "'1/2/3/4'", "line 2");
  expect_error("v 0 0 0\nf 1/ 1 1\n", "'1/'", "line 2");
  expect_error("v 0 0 0\nf 99999999999999999999 1 1\n", "99999", "line 2");
  expect_error("v 0 0 0\nhello world\n", "'hello'", "line 2");
  expect_error("", "empty", "byte 0");
  expect_error(std::string_view("v 0 0 0\n\0\0", 10), "no mesh", "byte 0");
}

TEST(ReadOff, reads_plain_and_prefixed_files) {
  const std::string body = "# counts\n4 1 0\n\n" + prefixed("") + "4 0 1 2 3 255 0 0\n";
  expect_quad(parse_mesh("OFF\n" + body, "x"));
  expect_quad(parse_mesh("OFF 4 1 0 # on one line\n" + prefixed("") + "4  0 1 2 3\n\n", "x"));
  expect_quad(parse_mesh("OFF\n4 1\n" + prefixed("") + "4 0 1 2 3", "x"));
  EXPECT_EQ(
      parse_mesh("COFF\n3 1 3\n0 0 0 255 0 0\n1 0 0 255 0 0\n0 1 0 1 1 1\n3 0 1 2\n", "x").format,
      MeshFormat::off);
}

TEST(ReadOff, refuses_counts_that_lie_and_names_the_line) {
  expect_error("OFF\n4 1 0\n0 0 0\n", "4 vertices", "line 2");
  expect_error("OFF\n2000000000 1 0\n0 0 0\n", "2000000000", "line 2");
  expect_error("OFF\n1 2000000000 0\n0 0 0\n", "2000000000", "line 2");
  expect_error("OFF\n-1 1 0\n", "counts", "line 2");
  expect_error("OFF\n", "first word", "line 1");
  expect_error("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", "'3'", "line 6");
  expect_error("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n2 0 1\n", "'2'", "line 6");
  expect_error("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1\n", "ends after 2", "line 6");
  expect_error("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 0 1 2\n", "goes on", "line 7");
  expect_error("OFF\n3 1 0\n0 0 0\n1 0 0\n0 nan 0\n3 0 1 2\n", "not finite", "line 5");
}

const char* const kAsciiStl =
    "solid part\n"
    " facet normal 0 0 0\n  outer loop\n   vertex 0.1 0.25 -3\n   vertex 1e-9 2 1e9\n   vertex 0 "
    "-7.5 0.33333333333333331\n"
    "  endloop\n endfacet\n"
    " facet normal 0 0 0\n  outer loop\n   vertex 0.1 0.25 -3\n   vertex 0 -7.5 "
    "0.33333333333333331\n   vertex 5 5 5\n"
    "  endloop\n endfacet\n"
    "endsolid part\n";

TEST(ReadStl, reads_text_and_merges_corners) {
  const MeshFile file = parse_mesh(kAsciiStl, "x");
  expect_quad(file);
  EXPECT_EQ(file.format, MeshFormat::stl_ascii);
  EXPECT_EQ(file.vertices_in_file, 6);
  EXPECT_EQ(file.vertices_merged, 2);
}

TEST(ReadStl, refuses_text_that_is_out_of_order) {
  const std::string good = kAsciiStl;
  expect_error(good.substr(0, 100), "", "line");
  expect_error(good.substr(0, good.find("endsolid")), "within a solid", "line 15");
  std::string bad = good;
  bad.replace(bad.find("outer loop"), 10, "outer lopo");
  expect_error(bad, "out of place", "line 3");
  bad = good;
  bad.replace(bad.find("vertex 5 5 5"), 12, "vertex 5 5 5 5");
  expect_error(bad, "more than three", "line 13");
}

std::string binary_stl(const char* header) {
  std::string out = header;
  out.resize(80, ' ');
  put(out, std::uint32_t{2});
  for (const auto& t : {std::array{kA, kB, kC}, std::array{kA, kC, kD}}) {
    for (int i = 0; i < 3; ++i) put(out, 0.0f);
    for (const Vec3& p : t) {
      for (int k = 0; k < 3; ++k) put(out, static_cast<float>(p[k]));
    }
    put(out, std::uint16_t{0});
  }
  return out;
}

TEST(ReadStl, reads_binary_even_when_it_says_solid) {
  for (const char* header : {"made by hand", "solid part"}) {
    const MeshFile file = parse_mesh(binary_stl(header), "x");
    EXPECT_EQ(file.format, MeshFormat::stl_binary);
    ASSERT_EQ(file.mesh.positions.size(), 4u);
    EXPECT_EQ(file.mesh.positions[1], in_single(kB));
    EXPECT_EQ(file.mesh.triangles[1], (std::array<std::int32_t, 3>{0, 2, 3}));
  }
}

TEST(ReadStl, refuses_binary_whose_count_does_not_fit) {
  std::string bytes = binary_stl("x");
  bytes[80] = 3;
  expect_error(bytes, "claims 3 triangles", "byte 80");
  bytes[83] = '\x7f';
  expect_error(bytes, "claims", "byte 80");
  bytes = binary_stl("x");
  expect_error(bytes.substr(0, bytes.size() - 1), "claims 2", "byte 80");
  const float nan = std::nanf("");
  std::memcpy(bytes.data() + 84 + 12 + 8, &nan, 4);
  expect_error(bytes, "not finite", "byte 104");
}

template <class Coordinate, class Count, class Index>
std::string binary_ply(bool big, const char* coordinate, const char* count, const char* index) {
  const std::string c = coordinate;
  std::string out =
      std::string("ply\nformat ") + (big ? "binary_big_endian" : "binary_little_endian") +
      " 1.0\ncomment hand made\nelement camera 2\nproperty list uchar double weights\nproperty "
      "short id\n"
      "element vertex 4\nproperty " +
      c + " x\nproperty uchar red\nproperty " + c + " y\nproperty " + c +
      " z\nproperty list int float extra\nelement face 1\nproperty int8 flag\nproperty list " +
      count + " " + index + " vertex_indices\nelement nothing 1000000000\nend_header\n";
  for (int i = 0; i < 2; ++i) {
    put(out, std::uint8_t{2});
    put(out, 1.5, big);
    put(out, 2.5, big);
    put(out, std::int16_t{7}, big);
  }
  for (const Vec3& p : {kA, kB, kC, kD}) {
    put(out, static_cast<Coordinate>(p.x()), big);
    put(out, std::uint8_t{200});
    put(out, static_cast<Coordinate>(p.y()), big);
    put(out, static_cast<Coordinate>(p.z()), big);
    put(out, std::int32_t{1}, big);
    put(out, 0.5f, big);
  }
  put(out, std::int8_t{-1});
  put(out, static_cast<Count>(4), big);
  for (int i = 0; i < 4; ++i) put(out, static_cast<Index>(i), big);
  return out;
}

TEST(ReadPly, reads_both_byte_orders_and_every_type) {
  for (const bool big : {false, true}) {
    expect_quad(parse_mesh(
        binary_ply<double, std::uint8_t, std::int32_t>(big, "double", "uchar", "int"), "x"));
    expect_quad(parse_mesh(
        binary_ply<double, std::int8_t, std::uint32_t>(big, "float64", "int8", "uint32"), "x"));
    expect_quad(parse_mesh(
        binary_ply<double, std::uint16_t, std::int16_t>(big, "double", "ushort", "int16"), "x"));
    expect_quad(parse_mesh(
        binary_ply<double, std::int16_t, std::uint16_t>(big, "double", "short", "uint16"), "x"));
    expect_quad(parse_mesh(
        binary_ply<double, std::int32_t, std::uint8_t>(big, "double", "int32", "uint8"), "x"));
    expect_quad(parse_mesh(
        binary_ply<double, std::uint32_t, std::int8_t>(big, "double", "uint", "char"), "x"));
    const MeshFile file = parse_mesh(
        binary_ply<float, std::uint8_t, std::int32_t>(big, "float", "uchar", "int"), "x");
    EXPECT_EQ(file.mesh.positions[2], in_single(kC));
    EXPECT_EQ(file.format, big ? MeshFormat::ply_big : MeshFormat::ply_little);
  }
}

const std::string kAsciiPly =
    "ply\nformat ascii 1.0\nobj_info none\nelement vertex 4\nproperty float x\nproperty float "
    "y\nproperty float z\n"
    "element face 1\nproperty list uchar int vertex_index\nelement edge 1\nproperty int "
    "a\nproperty int b\nend_header\n" +
    prefixed("") + "4 0 1 2 3\n0 1\n";

TEST(ReadPly, reads_text) {
  const MeshFile file = parse_mesh(kAsciiPly, "x");
  expect_quad(file);
  EXPECT_EQ(file.format, MeshFormat::ply_ascii);
}

std::string replaced(std::string text, const std::string& what, const std::string& with) {
  const std::size_t at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return text.replace(at, what.size(), with);
}

TEST(ReadPly, names_the_place_of_what_is_wrong) {
  expect_error("ply\nformat ascii 1.0\n", "does not end", "line 3");
  expect_error(replaced(kAsciiPly, "ascii 1.0", "ascii 2.0"), "version", "line 2");
  expect_error(replaced(kAsciiPly, "ascii", "asci"), "'asci'", "line 2");
  expect_error(replaced(kAsciiPly, "format ascii 1.0\n", ""), "format is missing", "line 2");
  expect_error(replaced(kAsciiPly, "property float z\n", ""), "vertices are not described",
               "header");
  expect_error(replaced(kAsciiPly, "vertex_index\n", "corners\n"), "faces are not described",
               "header");
  expect_error(replaced(kAsciiPly, "property float y", "property flaot y"), "'flaot'", "line 6");
  expect_error(replaced(kAsciiPly, "list uchar int", "list float int"), "floating point", "line 9");
  expect_error(replaced(kAsciiPly, "vertex 4", "vertex 2000000000"), "2000000000", "line 13");
  expect_error(replaced(kAsciiPly, "vertex 4", "vertex -4"), "element line", "line 4");
  expect_error(replaced(kAsciiPly, "4 0 1 2 3", "4 0 1 2 4"), "vertex index", "line 18");
  expect_error(replaced(kAsciiPly, "4 0 1 2 3", "4 0 1 2 1.5"), "vertex index", "line 18");
  expect_error(replaced(kAsciiPly, "4 0 1 2 3", "-1 0 1 2 3"), "length of a list", "line 18");
  expect_error(replaced(kAsciiPly, "4 0 1 2 3", "2 0 1"), "2 corners", "line 18");
  expect_error(replaced(kAsciiPly, "4 0 1 2 3", "3 0 1 2 3"), "'3'", "line 18");
  expect_error(replaced(kAsciiPly, "5 5 5", "5 nan 5"), "not finite", "line 17");
  expect_error(replaced(kAsciiPly, "0 1\n", ""), "", "line");
  expect_error(kAsciiPly + "1 2\n", "goes on", "line 20");
}

TEST(ReadPly, refuses_binary_data_that_ends_early_or_late) {
  const std::string good =
      binary_ply<double, std::uint8_t, std::int32_t>(false, "double", "uchar", "int");
  expect_error(good.substr(0, good.size() - 1), "ends too early", "byte");
  expect_error(good + "x", "goes on", "byte");
  std::string lying = good;
  lying[lying.size() - 17] = '\xff';  // 255 corners
  expect_error(lying, "length of a list", "byte");
}

TEST(ReadMesh, merges_equal_positions_and_counts_what_it_leaves_out) {
  const MeshFile file = parse_mesh(
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nv -0 0 -0\nv 9 9 9\nv 2 0 0\n"
      "f 1 2 3\nf 4 3 2\nf 1 4 2\nf 1 2 6\n",
      "x");
  EXPECT_EQ(file.vertices_in_file, 6);
  EXPECT_EQ(file.triangles_in_file, 4);
  EXPECT_EQ(file.vertices_merged, 1);  // -0 equals 0
  EXPECT_EQ(file.vertices_unused, 1);
  EXPECT_EQ(file.triangles_left_out, 1);  // 1 4 2 repeats a vertex; the collinear 1 2 6 stays
  EXPECT_EQ(file.mesh.positions.size(), 4u);
  EXPECT_EQ(file.mesh.triangles.size(), 3u);
}

TEST(ReadMesh, a_decimal_comma_locale_changes_nothing) {
  const std::string before = std::setlocale(LC_ALL, nullptr);
  for (const char* name : {"de_DE.UTF-8", "fr_FR.UTF-8", "C.UTF-8"}) {
    if (std::setlocale(LC_ALL, name) == nullptr) continue;
    expect_quad(parse_mesh(prefixed("v ") + "f 1 2 3 4\n", "x"));
  }
  std::setlocale(LC_ALL, before.c_str());
}

TEST(ReadMesh, a_refusal_names_every_kind_of_mesh_once) {
  const std::string names = mesh_kind_names();
  std::set<std::string> endings;
  for (const MeshKind& kind : mesh_kinds()) {
    EXPECT_NE(names.find(kind.name), names.npos) << names;
    EXPECT_TRUE(endings.insert(kind.ending).second) << kind.ending;
    EXPECT_EQ(kind.ending[0], '.');
  }
  for (const std::string& bytes : {std::string(), std::string("\1\2\3")}) {
    try {
      parse_mesh(bytes, "x");
      ADD_FAILURE() << "no mesh is read";
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(names), std::string::npos) << error.what();
    }
  }
}

TEST(ReadMesh, files_that_people_take_for_meshes_are_named_with_the_way_on) {
  const std::string iges = std::string(72, ' ') + "S      1\n";
  const std::string archive("PK\x03\x04", 4);
  const std::string recording("\x89MCAP0\r\n", 8);
  const std::pair<std::string, const char*> files[] = {
      {"ISO-10303-21;\nHEADER;\n", "is a STEP file, byte 0, expected triangles"},
      {iges, "is an IGES file"},
      {std::string("glTF\2\0\0\0", 8), "is a glTF file"},
      {"\n{\"asset\": {\"version\": \"2.0\"}}", "is a glTF file"},
      {"Kaydara FBX Binary", "is an FBX file"},
      {archive + std::string(200, 'x'), "is an archive"},
      {"<?xml version=\"1.0\"?>\n<COLLADA>", "is an XML file"},
      {recording + std::string(200, '\0'), "is a recording or a packed scene"}};
  for (const auto& [bytes, what] : files) {
    try {
      parse_mesh(bytes, "part");
      ADD_FAILURE() << what;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(what), std::string::npos) << error.what();
    }
  }
  // A binary STL of the right size is one, whatever its header says.
  for (const std::string& header : {iges.substr(0, 80), std::string("<?xml"), std::string("glTF")})
    EXPECT_EQ(parse_mesh(binary_stl(header.c_str()), "part").format, MeshFormat::stl_binary);
  // Not by a part of it: these begin alike and are read as what they are.
  for (const char* bytes : {"ISO", "{", "", "<x"}) {
    try {
      parse_mesh(bytes, "part");
      ADD_FAILURE() << bytes;
    } catch (const InputError& error) {
      EXPECT_EQ(std::string(error.what()).find("part: is a"), std::string::npos) << error.what();
    }
  }
}

TEST(ReadMesh, a_missing_file_is_bad_input) {
  EXPECT_THROW(read_mesh("/no/such/mesh.obj"), InputError);
}

}  // namespace
}  // namespace thigma
