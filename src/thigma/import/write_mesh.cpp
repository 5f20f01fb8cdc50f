#include "thigma/import/write_mesh.h"

#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>

#include "thigma/core/error.h"
#include "thigma/files/file.h"
#include "thigma/import/detail/mesh_formats.h"

namespace thigma {
namespace {

static_assert(std::endian::native == std::endian::little, "binary files are written in place");

using Triangle = std::array<std::int32_t, 3>;

template <class T>
void put_number(std::string& out, T value) {
  char text[32];
  const std::to_chars_result r = std::to_chars(text, text + sizeof text, value);
  out.append(text, r.ptr);
}

template <class T>
void put_bytes(std::string& out, const T& value) {
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  out.append(raw, sizeof(T));
}

void put_position(std::string& out, const Vec3& p) {
  for (int k = 0; k < 3; ++k) {
    if (k > 0) out += ' ';
    put_number(out, p[k]);
  }
  out += '\n';
}

std::string ply_header(const TriangleMesh& mesh, const char* encoding) {
  return std::string("ply\nformat ") + encoding + " 1.0\nelement vertex " +
         std::to_string(mesh.positions.size()) +
         "\nproperty double x\nproperty double y\nproperty double z\nelement face " +
         std::to_string(mesh.triangles.size()) +
         "\nproperty list uchar int vertex_indices\nend_header\n";
}

// The bytes of a value in the byte order of the format.
template <class T>
void put_ordered(std::string& out, T value, bool big) {
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  for (std::size_t i = 0; i < sizeof(T); ++i) out += raw[big ? sizeof(T) - 1 - i : i];
}

// Normal for the file's normal field, which readers ignore: zero without area, as the format asks
// for.
Vec3 facet_normal(const TriangleMesh& mesh, const Triangle& t) {
  const Vec3& a = mesh.positions[static_cast<std::size_t>(t[0])];
  const Vec3 u = mesh.positions[static_cast<std::size_t>(t[1])] - a;
  const Vec3 v = mesh.positions[static_cast<std::size_t>(t[2])] - a;
  return u.cross(v).stableNormalized();
}

std::string ply_binary(const TriangleMesh& mesh, bool big) {
  std::string out = ply_header(mesh, big ? "binary_big_endian" : "binary_little_endian");
  for (const Vec3& p : mesh.positions) {
    for (int k = 0; k < 3; ++k) put_ordered(out, p[k], big);
  }
  for (const Triangle& t : mesh.triangles) {
    out += '\3';
    for (const std::int32_t v : t) put_ordered(out, v, big);
  }
  return out;
}

void check_single_precision(const TriangleMesh& mesh, const std::string& name) {
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    if (mesh.positions[i].cwiseAbs().maxCoeff() <= 3e38) continue;
    throw InputError(name + ": a coordinate does not fit STL, vertex " + std::to_string(i) +
                     ", expected at most 3e38");
  }
}

}  // namespace

namespace detail {

std::string write_obj(const TriangleMesh& mesh, const std::string&) {
  std::string out;
  for (const Vec3& p : mesh.positions) {
    out += "v ";
    put_position(out, p);
  }
  for (const Triangle& t : mesh.triangles) {
    out += 'f';
    for (const std::int32_t v : t) {
      out += ' ';
      put_number(out, std::int64_t{v} + 1);
    }
    out += '\n';
  }
  return out;
}

std::string write_off(const TriangleMesh& mesh, const std::string&) {
  std::string out = "OFF\n";
  put_number(out, mesh.positions.size());
  out += ' ';
  put_number(out, mesh.triangles.size());
  out += " 0\n";
  for (const Vec3& p : mesh.positions) put_position(out, p);
  for (const Triangle& t : mesh.triangles) {
    out += '3';
    for (const std::int32_t v : t) {
      out += ' ';
      put_number(out, v);
    }
    out += '\n';
  }
  return out;
}

std::string write_ply_ascii(const TriangleMesh& mesh, const std::string& name) {
  const std::string off = write_off(mesh, name);
  // Vertices and faces of OFF are those of an ascii PLY; only the header differs.
  return ply_header(mesh, "ascii") + off.substr(off.find('\n', 4) + 1);
}

std::string write_ply_little(const TriangleMesh& mesh, const std::string&) {
  return ply_binary(mesh, false);
}
std::string write_ply_big(const TriangleMesh& mesh, const std::string&) {
  return ply_binary(mesh, true);
}

std::string write_stl_binary(const TriangleMesh& mesh, const std::string& name) {
  check_single_precision(mesh, name);
  std::string out = "binary STL written by thigma";
  out.resize(80, ' ');
  put_bytes(out, static_cast<std::uint32_t>(mesh.triangles.size()));
  for (const Triangle& t : mesh.triangles) {
    const Vec3 n = facet_normal(mesh, t);
    for (int k = 0; k < 3; ++k) put_bytes(out, static_cast<float>(n[k]));
    for (const std::int32_t v : t) {
      for (int k = 0; k < 3; ++k)
        put_bytes(out, static_cast<float>(mesh.positions[static_cast<std::size_t>(v)][k]));
    }
    out.append(2, '\0');
  }
  return out;
}

std::string write_stl_ascii(const TriangleMesh& mesh, const std::string&) {
  std::string out = "solid thigma\n";
  for (const Triangle& t : mesh.triangles) {
    out += "facet normal ";
    put_position(out, facet_normal(mesh, t));
    out += "outer loop\n";
    for (const std::int32_t v : t) {
      out += "vertex ";
      put_position(out, mesh.positions[static_cast<std::size_t>(v)]);
    }
    out += "endloop\nendfacet\n";
  }
  return out + "endsolid thigma\n";
}

}  // namespace detail

MeshFormat format_for_name(const std::string& path) {
  const std::size_t dot = path.find_last_of("./");
  std::string ending = dot == std::string::npos || path[dot] == '/' ? "" : path.substr(dot);
  for (char& c : ending) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  for (const detail::MeshFormatRow& row : detail::kMeshFormats)
    if (row.is_chosen_by_ending && ending == row.ending) return row.format;
  return detail::kMeshFormats[0].format;
}

std::string written_mesh_endings() {
  std::string endings;
  for (const detail::MeshFormatRow& row : detail::kMeshFormats)
    if (row.is_chosen_by_ending && &row != detail::kMeshFormats)
      endings += std::string(row.ending) + ", ";
  return endings + "else " + detail::kMeshFormats[0].kind;
}

std::string format_mesh(const TriangleMesh& mesh, MeshFormat format, const std::string& name) {
  const detail::MeshFormatRow* row = detail::row_of(format);
  if (row == nullptr || row->write == nullptr)
    throw InputError(name + ": meshes of this format are read, not written");
  return row->write(mesh, name);
}

void write_mesh(const TriangleMesh& mesh, const std::string& path) {
  write_file(path, format_mesh(mesh, format_for_name(path), path));
}

}  // namespace thigma
