#include "thigma/import/read_mesh.h"

#include <algorithm>
#include <bit>

#include "thigma/files/file.h"
#include "thigma/import/detail/foreign_formats.h"
#include "thigma/import/detail/mesh_formats.h"

namespace thigma {
namespace {

using detail::kMeshFormats;
using detail::RawMesh;

detail::FileClues clues_of(std::string_view bytes) {
  detail::FileClues clues;
  clues.bytes = bytes;
  // Comments may hold any letters; control characters no text format has.
  clues.is_text = std::none_of(bytes.begin(), bytes.end(), [](char c) {
    const unsigned char u = static_cast<unsigned char>(c);
    return u < 32 && !detail::is_blank(c) && c != '\n';
  });
  if (!clues.is_text) return clues;
  detail::Lines lines(bytes);
  std::string_view line;
  while (clues.first_word.empty() && lines.next(line))
    clues.first_word = detail::Words(line.substr(0, line.find('#'))).next();
  return clues;
}

RawMesh parse_raw(std::string_view bytes, const std::string& name) {
  if (!detail::has_binary_stl_size(bytes)) bytes = without_byte_order_mark(bytes);
  if (bytes.empty()) detail::fail_input(name, "is empty", "byte 0", "a mesh: " + mesh_kind_names());
  const bool is_stl = detail::has_binary_stl_size(bytes);  // whose header may hold anything
  if (const detail::ForeignFormat* foreign = is_stl ? nullptr : detail::foreign_format(bytes))
    detail::fail_input(name, std::string("is ") + foreign->what, "byte 0", foreign->expected);
  const detail::FileClues clues = clues_of(bytes);
  for (const detail::MeshFormatRow& row : kMeshFormats)
    if (row.is != nullptr && row.is(clues)) return row.read(bytes, name);
  if (clues.is_text) return detail::read_obj(bytes, name);
  if (bytes.size() >= 84) return detail::read_stl_binary(bytes, name);  // throws, with both sizes
  detail::fail_input(name, "is no mesh", "byte 0", mesh_kind_names());
}

// Positions by their bits. Open addressing over indices: bounded, and the order is that of first
// appearance.
class PositionTable {
 public:
  explicit PositionTable(std::size_t count)
      : mask_(std::bit_ceil(std::max<std::size_t>(16, 2 * count)) - 1), slots_(mask_ + 1, -1) {}

  /// Index of an equal position in `positions`, or `candidate`, which is then the one for its
  /// value.
  std::int32_t find_or_insert(const Vec3& p, std::int32_t candidate,
                              const std::vector<Vec3>& positions) {
    for (std::size_t slot = hash(p) & mask_;; slot = (slot + 1) & mask_) {
      if (slots_[slot] < 0) {
        slots_[slot] = candidate;
        return candidate;
      }
      if (positions[static_cast<std::size_t>(slots_[slot])] == p) return slots_[slot];
    }
  }

 private:
  static std::size_t hash(const Vec3& p) {
    std::uint64_t h = 0;
    for (int i = 0; i < 3; ++i) {
      h ^= std::bit_cast<std::uint64_t>(p[i]);
      h *= 0x9e3779b97f4a7c15ull;
      h ^= h >> 32;
    }
    return static_cast<std::size_t>(h);
  }
  std::size_t mask_;
  std::vector<std::int32_t> slots_;
};

}  // namespace

MeshFile merge_equal_positions(TriangleMesh raw) {
  MeshFile file;
  file.vertices_in_file = static_cast<std::int64_t>(raw.positions.size());
  file.triangles_in_file = static_cast<std::int64_t>(raw.triangles.size());
  for (Vec3& p : raw.positions) p += Vec3::Zero();  // -0 becomes 0
  PositionTable table(raw.positions.size());
  std::vector<std::int32_t> merged(raw.positions.size());
  for (std::size_t i = 0; i < merged.size(); ++i) {
    merged[i] = table.find_or_insert(raw.positions[i], static_cast<std::int32_t>(i), raw.positions);
    file.vertices_merged += merged[i] != static_cast<std::int32_t>(i);
  }
  std::vector<bool> used(merged.size());
  std::vector<std::array<std::int32_t, 3>>& triangles = file.mesh.triangles;
  triangles.reserve(raw.triangles.size());
  for (const std::array<std::int32_t, 3>& t : raw.triangles) {
    std::array<std::int32_t, 3> m{};
    for (std::size_t k = 0; k < 3; ++k) m[k] = merged[static_cast<std::size_t>(t[k])];
    if (m[0] == m[1] || m[1] == m[2] || m[2] == m[0]) continue;
    triangles.push_back(m);
    for (const std::int32_t v : m) used[static_cast<std::size_t>(v)] = true;
  }
  file.triangles_left_out = file.triangles_in_file - static_cast<std::int64_t>(triangles.size());
  std::vector<std::int32_t> compact(merged.size(), -1);
  for (std::size_t i = 0; i < merged.size(); ++i) {
    if (!used[i]) continue;
    compact[i] = static_cast<std::int32_t>(file.mesh.positions.size());
    file.mesh.positions.push_back(raw.positions[i]);
  }
  file.vertices_unused = file.vertices_in_file - file.vertices_merged -
                         static_cast<std::int64_t>(file.mesh.positions.size());
  for (std::array<std::int32_t, 3>& t : triangles) {
    for (std::int32_t& v : t) v = compact[static_cast<std::size_t>(v)];
  }
  return file;
}

std::vector<MeshKind> mesh_kinds() {
  std::vector<MeshKind> kinds;
  for (const detail::MeshFormatRow& row : kMeshFormats) {
    if (kinds.empty() || std::string_view(kinds.back().name) != row.kind)
      kinds.push_back({row.kind, row.ending});
  }
  return kinds;
}

std::string mesh_kind_names() {
  const std::vector<MeshKind> kinds = mesh_kinds();
  std::string names;
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    if (i > 0) names += i + 1 < kinds.size() ? ", " : " or ";
    names += kinds[i].name;
  }
  return names;
}

const char* format_name(MeshFormat format) {
  const detail::MeshFormatRow* row = detail::row_of(format);
  return row != nullptr ? row->name : "unknown";
}

MeshFile parse_mesh(std::string_view bytes, const std::string& name) {
  RawMesh raw = parse_raw(bytes, name);
  MeshFile file = merge_equal_positions({std::move(raw.positions), std::move(raw.triangles)});
  file.format = raw.format;
  return file;
}

MeshFile read_mesh(const std::string& path) { return parse_mesh(read_file(path), path); }

}  // namespace thigma
