#include "thigma/import/duplicates.h"

#include <algorithm>
#include <array>
#include <span>

#include "thigma/core/index.h"
#include "thigma/mesh/topology.h"

namespace thigma {
namespace {

using Triangle = std::array<std::int32_t, 3>;

/// Whether two triangles of the same vertices turn the same way.
bool turns_as(const Triangle& a, const Triangle& b) {
  const auto first = static_cast<std::size_t>(std::find(b.begin(), b.end(), a[0]) - b.begin());
  return b[(first + 1) % 3] == a[1];
}

enum class Part : std::uint8_t { unknown, certain, fin };
constexpr std::size_t kParts = 3;

/// An edge of a sheet that other faces use too.
struct Seam {
  std::int32_t sheet = -1, edge = -1, own = 0;  // own: faces of the sheet along it
};

/// Sheets of faces back to back, and what is known of each.
struct Sheets {
  EdgeTable table;                    // of the distinct faces
  std::vector<std::int32_t> of_face;  // -1 for faces that are not back to back
  std::vector<Part> part;             // of each sheet
  std::vector<Seam> seams;            // by sheet
  std::vector<std::int32_t> first;    // seams of sheet s: first[s] .. first[s + 1]
  std::vector<std::array<std::int32_t, kParts>> faces_at;  // of each edge: faces of each part
  std::vector<std::vector<std::int32_t>> sheets_at;        // of each edge: those with a seam there

  std::span<const Seam> seams_of(std::int32_t sheet) const {
    return {seams.data() + first[idx(sheet)], seams.data() + first[idx(sheet) + 1]};
  }
};

void number_sheets(const DistinctFaces& faces, Sheets& sheets) {
  sheets.of_face.assign(faces.triangle.size(), -1);
  std::vector<std::int32_t> members;
  for (std::size_t seed = 0; seed < sheets.of_face.size(); ++seed) {
    if (faces.net[seed] != 0 || sheets.of_face[seed] >= 0) continue;
    const auto sheet = static_cast<std::int32_t>(sheets.part.size());
    sheets.part.push_back(Part::certain);
    sheets.of_face[seed] = sheet;
    members.assign(1, static_cast<std::int32_t>(seed));
    for (std::size_t i = 0; i < members.size(); ++i)
      for (const std::int32_t e : sheets.table.of_triangle[idx(members[i])]) {
        if (sheets.table.edges[idx(e)].use_count != 2) continue;
        for (const EdgeUse& use : sheets.table.uses_of(sheets.table.edges[idx(e)])) {
          if (faces.net[idx(use.triangle)] != 0 || sheets.of_face[idx(use.triangle)] >= 0) continue;
          sheets.of_face[idx(use.triangle)] = sheet;
          members.push_back(use.triangle);
        }
      }
  }
}

/// Lists the seams. Sheets that go on through each of theirs are there for certain; of the others
/// nothing is known yet.
void list_seams(Sheets& sheets) {
  std::vector<std::int32_t> here;
  for (std::size_t e = 0; e < sheets.table.edges.size(); ++e) {
    here.clear();
    const std::span<const EdgeUse> uses = sheets.table.uses_of(sheets.table.edges[e]);
    for (const EdgeUse& use : uses)
      if (sheets.of_face[idx(use.triangle)] >= 0) here.push_back(sheets.of_face[idx(use.triangle)]);
    std::sort(here.begin(), here.end());
    for (auto it = here.begin(); it != here.end();) {
      const auto end = std::upper_bound(it, here.end(), *it);
      const auto own = static_cast<std::int32_t>(end - it);
      if (own < static_cast<std::int32_t>(uses.size())) {
        sheets.seams.push_back({*it, static_cast<std::int32_t>(e), own});
        if (own % 2 == 1) sheets.part[idx(*it)] = Part::unknown;
      }
      it = end;
    }
  }
  std::stable_sort(sheets.seams.begin(), sheets.seams.end(),
                   [](const Seam& a, const Seam& b) { return a.sheet < b.sheet; });
  sheets.first.assign(sheets.part.size() + 1, 0);
  sheets.sheets_at.resize(sheets.table.edges.size());
  for (const Seam& seam : sheets.seams) {
    ++sheets.first[idx(seam.sheet) + 1];
    sheets.sheets_at[idx(seam.edge)].push_back(seam.sheet);
  }
  for (std::size_t i = 1; i < sheets.first.size(); ++i) sheets.first[i] += sheets.first[i - 1];
  sheets.faces_at.assign(sheets.table.edges.size(), {});
  for (std::size_t e = 0; e < sheets.table.edges.size(); ++e)
    for (const EdgeUse& use : sheets.table.uses_of(sheets.table.edges[e])) {
      const std::int32_t sheet = sheets.of_face[idx(use.triangle)];
      ++sheets.faces_at[e][static_cast<std::size_t>(sheet < 0 ? Part::certain
                                                              : sheets.part[idx(sheet)])];
    }
}

/// Faces along a seam of a sheet of which nothing is known, but its own.
struct Others {
  std::int32_t certain = 0, unknown = 0, fins = 0;
};

Others others_at(const Sheets& sheets, const Seam& seam) {
  const auto& faces = sheets.faces_at[idx(seam.edge)];
  const auto of = [&](Part part) { return faces[static_cast<std::size_t>(part)]; };
  return {of(Part::certain), of(Part::unknown) - seam.own, of(Part::fin)};
}

/// Whether a surface that is there for certain would end without the sheet.
bool is_needed(const Sheets& sheets, std::int32_t sheet) {
  const std::span<const Seam> seams = sheets.seams_of(sheet);
  return std::any_of(seams.begin(), seams.end(), [&](const Seam& seam) {
    const Others others = others_at(sheets, seam);
    return others.unknown == 0 && others.certain % 2 == 1;
  });
}

/// Whether the surface there is for certain goes on without the sheet.
bool is_fin(const Sheets& sheets, std::int32_t sheet) {
  bool is_attached = false;
  for (const Seam& seam : sheets.seams_of(sheet)) {
    const Others others = others_at(sheets, seam);
    if (others.certain % 2 == 1) return false;
    is_attached = is_attached || others.certain > 0 || others.fins > 0;
  }
  return is_attached;
}

/// Gives the sheets that the rule holds for their part, until there are no more.
void decide(Sheets& sheets, Part part, bool (*rule)(const Sheets&, std::int32_t)) {
  std::vector<std::int32_t> waiting;
  for (std::size_t i = sheets.part.size(); i-- > 0;)
    waiting.push_back(static_cast<std::int32_t>(i));
  while (!waiting.empty()) {
    const std::int32_t sheet = waiting.back();
    waiting.pop_back();
    if (sheets.part[idx(sheet)] != Part::unknown || !rule(sheets, sheet)) continue;
    sheets.part[idx(sheet)] = part;
    for (const Seam& seam : sheets.seams_of(sheet)) {
      auto& faces = sheets.faces_at[idx(seam.edge)];
      faces[static_cast<std::size_t>(Part::unknown)] -= seam.own;
      faces[static_cast<std::size_t>(part)] += seam.own;
      for (const std::int32_t other : sheets.sheets_at[idx(seam.edge)])
        if (sheets.part[idx(other)] == Part::unknown) waiting.push_back(other);
    }
  }
}

}  // namespace

DistinctFaces list_distinct_faces(const TriangleMesh& mesh) {
  const std::vector<std::int32_t> first = find_duplicates(mesh);
  DistinctFaces faces;
  std::vector<std::int32_t> place(first.size(), -1);
  for (std::size_t t = 0; t < first.size(); ++t) {
    if (first[t] < 0) {
      place[t] = static_cast<std::int32_t>(faces.triangle.size());
      faces.triangle.push_back(static_cast<std::int32_t>(t));
      faces.copies.push_back(1);
      faces.net.push_back(1);
      continue;
    }
    const std::size_t face = idx(place[idx(first[t])]);
    ++faces.copies[face];
    faces.net[face] += turns_as(mesh.triangles[idx(first[t])], mesh.triangles[t]) ? 1 : -1;
  }
  return faces;
}

std::vector<bool> find_fins(const TriangleMesh& mesh, const DistinctFaces& faces) {
  std::vector<bool> result(faces.triangle.size(), false);
  if (std::find(faces.net.begin(), faces.net.end(), 0) == faces.net.end()) return result;
  TriangleMesh distinct;
  for (const std::int32_t t : faces.triangle) distinct.triangles.push_back(mesh.triangles[idx(t)]);
  Sheets sheets;
  sheets.table = build_edge_table(distinct);
  number_sheets(faces, sheets);
  list_seams(sheets);
  decide(sheets, Part::certain, is_needed);
  decide(sheets, Part::fin, is_fin);
  for (std::size_t i = 0; i < result.size(); ++i)
    result[i] = sheets.of_face[i] >= 0 && sheets.part[idx(sheets.of_face[i])] == Part::fin;
  return result;
}

}  // namespace thigma
