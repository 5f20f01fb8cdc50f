// Arrays of packed records, written and read field by field after the lists of
// detail/clod_fields.h. Nothing is followed while reading: bytes go into arrays, and then the
// arrays are checked.

#include "thigma/clod/clod_file.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <type_traits>

#include "thigma/clod/detail/clod_fields.h"
#include "thigma/clod/validate_hierarchy.h"
#include "thigma/core/error.h"
#include "thigma/files/file.h"
#include "thigma/import/read_mesh.h"

namespace thigma {
namespace {

using detail::Dimension;
using detail::Range;

/// Counts of a level's mesh.
struct MeshEntry {
  std::int32_t positions = 0, triangles = 0;
};

template <class V>
void visit_fields(detail::Like<MeshEntry> auto& m, V&& visit) {
  visit("positions", m.positions);
  visit("triangles", m.triangles);
}

template <class T, class V>
void visit_record(T& item, V&& visit) {
  if constexpr (std::is_same_v<std::remove_const_t<T>, MeshEntry>)
    visit_fields(item, visit);
  else
    detail::visit_fields(item, visit);
}

/// Bytes of a record in the file: its fields without gaps.
struct Measure {
  std::size_t bytes = 0;
  template <class T>
  void operator()(const char*, const T&, Dimension = Dimension::none, Range = Range::finite) {
    bytes += sizeof(T);
  }
};

template <class T>
std::uint32_t record_bytes() {
  Measure measure;
  const T item{};
  visit_record(item, measure);
  return static_cast<std::uint32_t>(measure.bytes);
}

/// The object record is of a hierarchy's own numbers, not of its arrays.
struct Totals {
  std::size_t chunks = 0, bytes = 0;
  template <class T>
  void record(const char*, const T&) {
    ++chunks;
    bytes += record_bytes<T>();
  }
  template <class T>
  void records(const char*, const std::vector<T>& items) {
    ++chunks;
    bytes += items.size() * record_bytes<T>();
  }
  template <class T, class A>
  void numbers(const char*, const std::vector<T, A>& items, Dimension) {
    ++chunks;
    bytes += items.size() * sizeof(T);
  }
};

// ---- writing
// ------------------------------------------------------------

struct Writer {
  ChunkWriter& file;
  bool is_required;

  template <class T>
  void operator()(const char*, const T& field, Dimension = Dimension::none, Range = Range::finite) {
    static_assert(std::is_trivially_copyable_v<std::remove_all_extents_t<T>> ||
                  std::is_same_v<T, Vec3> || std::is_same_v<T, Mat3>);
    file.out().append(reinterpret_cast<const char*>(&field), sizeof field);
  }
  template <class T>
  void record(const char* name, const T& item) {
    file.begin(name, is_required, record_bytes<T>());
    visit_record(item, *this);
  }
  template <class T>
  void records(const char* name, const std::vector<T>& items) {
    file.begin(name, is_required, record_bytes<T>());
    for (const T& item : items) visit_record(item, *this);
  }
  template <class T, class A>
  void numbers(const char* name, const std::vector<T, A>& items, Dimension) {
    file.begin(name, is_required, sizeof(T));
    file.out().append(reinterpret_cast<const char*>(items.data()), items.size() * sizeof(T));
  }
};

static_assert(sizeof(Vec3) == 24 && sizeof(Mat3) == 72,
              "vectors are their numbers and nothing else");

/// The meshes of all levels behind each other.
struct JoinedMeshes {
  std::vector<MeshEntry> entries;
  std::vector<Vec3> positions;
  std::vector<std::array<std::int32_t, 3>> triangles;
};

template <class V>
void visit_parts(detail::Like<JoinedMeshes> auto& m, V&& visit) {
  visit.records("mesh_levels", m.entries);
  visit.numbers("mesh_positions", m.positions, Dimension::length);
  visit.numbers("mesh_triangles", m.triangles, Dimension::none);
}

JoinedMeshes join(const std::vector<TriangleMesh>& meshes) {
  JoinedMeshes all;
  for (const TriangleMesh& mesh : meshes) {
    all.entries.push_back({static_cast<std::int32_t>(mesh.positions.size()),
                           static_cast<std::int32_t>(mesh.triangles.size())});
    all.positions.insert(all.positions.end(), mesh.positions.begin(), mesh.positions.end());
    all.triangles.insert(all.triangles.end(), mesh.triangles.begin(), mesh.triangles.end());
  }
  return all;
}

// ---- reading
// ------------------------------------------------------------

/// Fills what it is shown from the chunk of that name. Throws InputError.
struct Reader {
  const std::map<std::string, Chunk>& chunks;
  const std::string& file;
  const char* bytes = nullptr;
  const char* chunk = "";

  template <class T>
  void operator()(const char* field, T& value, Dimension = Dimension::none, Range = Range::finite) {
    if constexpr (std::is_same_v<T, bool>) {
      if (*bytes != 0 && *bytes != 1)
        throw InputError(file + ": a wrong yes or no, chunk " + chunk + ", field " + field +
                         ", expected 0 or 1");
      value = *bytes == 1;
    } else {
      std::memcpy(static_cast<void*>(&value), bytes, sizeof value);
    }
    bytes += sizeof value;
  }
  template <class T>
  void record(const char* name, T& item) {
    const Chunk& c = open(name, record_bytes<T>());
    if (c.record_count != 1)
      throw InputError(file + ": " + name + " more or less than once, in that chunk, expected 1");
    visit_record(item, *this);
  }
  template <class T>
  void records(const char* name, std::vector<T>& items) {
    items.resize(open(name, record_bytes<T>()).record_count);
    for (T& item : items) visit_record(item, *this);
  }
  template <class T, class A>
  void numbers(const char* name, std::vector<T, A>& items, Dimension) {
    const Chunk& c = open(name, sizeof(T));
    items.resize(c.record_count);
    if (!items.empty())
      std::memcpy(static_cast<void*>(items.data()), c.bytes.data(), c.bytes.size());
  }

 private:
  const Chunk& open(const char* name, std::uint32_t size) {
    const auto found = chunks.find(name);
    if (found == chunks.end())
      throw InputError(file + ": no chunk " + name + ", in its table, expected one");
    if (found->second.record_bytes != size)
      throw InputError(file + ": records of " + std::to_string(found->second.record_bytes) +
                       " bytes, chunk " + name + ", expected " + std::to_string(size));
    bytes = found->second.bytes.data();
    chunk = name;
    return found->second;
  }
};

/// Names of the chunks this reader knows.
struct Names {
  std::vector<std::string> all;
  template <class T>
  void record(const char* name, const T&) {
    all.emplace_back(name);
  }
  template <class T>
  void records(const char* name, const T&) {
    all.emplace_back(name);
  }
  template <class T>
  void numbers(const char* name, const T&, Dimension) {
    all.emplace_back(name);
  }
};

std::map<std::string, Chunk> known_chunks(std::string_view bytes, const std::string& name) {
  Names names;
  const ClodHierarchy no_hierarchy;
  const JoinedMeshes no_meshes;
  detail::visit_parts(no_hierarchy, names);
  visit_parts(no_meshes, names);
  names.record("mass", 0);
  names.record("origin", 0);
  std::map<std::string, Chunk> chunks;
  for (Chunk& chunk : read_chunks(kClodKind, bytes, name)) {
    const bool is_known =
        std::find(names.all.begin(), names.all.end(), chunk.name) != names.all.end();
    if (!is_known && chunk.is_required)
      throw InputError(name + ": needs what this version does not know, chunk " + chunk.name +
                       ", expected a newer thigma");
    if (is_known) chunks.emplace(chunk.name, std::move(chunk));
  }
  return chunks;
}

/// Takes meshes apart again. returns what is wrong with them, or "".
std::string split(const JoinedMeshes& all, const ClodHierarchy& hierarchy,
                  std::vector<TriangleMesh>& meshes) {
  std::size_t position = 0, triangle = 0;
  for (std::size_t k = 0; k < all.entries.size(); ++k) {
    const MeshEntry& e = all.entries[k];
    const auto positions = static_cast<std::size_t>(e.positions),
               triangles = static_cast<std::size_t>(e.triangles);
    const bool is_level =
        k < hierarchy.levels.size() && !hierarchy.levels[k].is_free &&
        e.triangles == (k == 0 ? hierarchy.triangle_count : hierarchy.levels[k].triangle_count);
    if (!is_level || e.positions < 0 || positions > all.positions.size() - position ||
        e.triangles < 0 || triangles > all.triangles.size() - triangle)
      return "a mesh of no level, mesh " + std::to_string(k) +
             ", expected the triangles of its level";
    TriangleMesh mesh;
    const auto first_position = all.positions.begin() + static_cast<std::ptrdiff_t>(position);
    const auto first_triangle = all.triangles.begin() + static_cast<std::ptrdiff_t>(triangle);
    mesh.positions.assign(first_position, first_position + e.positions);
    mesh.triangles.assign(first_triangle, first_triangle + e.triangles);
    for (const Vec3& p : mesh.positions)
      if (!(p.cwiseAbs().maxCoeff() <= kMaxCoordinate))
        return "a position out of range, mesh " + std::to_string(k) + ", expected at most 1e50";
    for (const auto& t : mesh.triangles)
      for (const std::int32_t v : t)
        if (v < 0 || v >= e.positions)
          return "an index out of range, mesh " + std::to_string(k) + ", expected its positions";
    meshes.push_back(std::move(mesh));
    position += positions;
    triangle += triangles;
  }
  const bool is_all = position == all.positions.size() && triangle == all.triangles.size();
  return is_all ? "" : "positions or triangles of no mesh, behind the last, expected none";
}

bool is_finite(const ClodMass& m) {
  return std::isfinite(m.measure.area) && std::isfinite(m.measure.volume) &&
         m.measure.center_of_mass.allFinite() && m.measure.inertia.allFinite();
}

void refuse_flaw(const std::string& name, const std::string& flaw) {
  if (!flaw.empty()) throw InputError(name + ": " + flaw);
}

}  // namespace

std::string format_clod(const ClodAsset& asset, const std::string& name) {
  refuse_flaw(name, find_flaw(asset.hierarchy));
  const JoinedMeshes meshes = join(asset.meshes);
  Totals totals;
  detail::visit_parts(asset.hierarchy, totals);
  totals.record("mass", asset.mass);
  totals.record("origin", asset.origin);
  if (!meshes.entries.empty()) visit_parts(meshes, totals);
  ChunkWriter file(kClodKind, totals.chunks, totals.bytes);
  Writer needed{file, true};
  detail::visit_parts(asset.hierarchy, needed);
  Writer optional{file, false};
  optional.record("mass", asset.mass);
  optional.record("origin", asset.origin);
  if (!meshes.entries.empty()) visit_parts(meshes, optional);
  return file.finish();
}

ClodAsset parse_clod(std::string_view bytes, const std::string& name, double unit_scale) {
  const std::map<std::string, Chunk> chunks = known_chunks(bytes, name);
  ClodAsset asset;
  Reader reader{chunks, name};
  detail::visit_parts(asset.hierarchy, reader);
  if (chunks.contains("mass")) reader.record("mass", asset.mass);
  if (chunks.contains("origin")) reader.record("origin", asset.origin);
  refuse_flaw(name, find_flaw(asset.hierarchy));
  if (!is_finite(asset.mass))
    refuse_flaw(name, "a mass that is not finite, chunk mass, expected numbers");
  if (chunks.contains("mesh_levels")) {
    JoinedMeshes meshes;
    visit_parts(meshes, reader);
    refuse_flaw(name, split(meshes, asset.hierarchy, asset.meshes));
  }
  scale_clod(asset, unit_scale, name);
  return asset;
}

void scale_clod(ClodAsset& asset, double unit_scale, const std::string& name) {
  const ClodHierarchy& hierarchy = asset.hierarchy;
  const bool is_in_range = unit_scale > 0.0 && std::isfinite(unit_scale) &&
                           unit_scale * hierarchy.radius <= kMaxCoordinate &&
                           unit_scale * hierarchy.center.cwiseAbs().maxCoeff() <= kMaxCoordinate;
  if (!is_in_range)
    throw InputError(name + ": the scale is " + std::to_string(unit_scale) +
                     ", as given, expected a positive number of metres per unit");
  if (unit_scale != 1.0) scale_asset(asset, unit_scale);
}

ClodAsset read_clod(const std::string& path, double unit_scale) {
  return parse_clod(read_file(path), path, unit_scale);
}

bool is_clod(std::string_view bytes) { return bytes.starts_with(kClodKind.magic); }

void write_clod(const ClodAsset& asset, const std::string& path) {
  write_file(path, format_clod(asset, path));
}

}  // namespace thigma
