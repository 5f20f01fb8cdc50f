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
    return {seams.data() + first[at(sheet)], seams.data() + first[at(sheet) + 1]};
  }
};

void number_sheets(const DistinctFaces& faces, Sheets& s) {
  s.of_face.assign(faces.triangle.size(), -1);
  std::vector<std::int32_t> members;
  for (std::size_t seed = 0; seed < s.of_face.size(); ++seed) {
    if (faces.net[seed] != 0 || s.of_face[seed] >= 0) continue;
    const auto sheet = static_cast<std::int32_t>(s.part.size());
    s.part.push_back(Part::certain);
    s.of_face[seed] = sheet;
    members.assign(1, static_cast<std::int32_t>(seed));
    for (std::size_t i = 0; i < members.size(); ++i)
      for (const std::int32_t e : s.table.of_triangle[at(members[i])]) {
        if (s.table.edges[at(e)].use_count != 2) continue;
        for (const EdgeUse& use : s.table.uses_of(s.table.edges[at(e)])) {
          if (faces.net[at(use.triangle)] != 0 || s.of_face[at(use.triangle)] >= 0) continue;
          s.of_face[at(use.triangle)] = sheet;
          members.push_back(use.triangle);
        }
      }
  }
}

/// Lists the seams. Sheets that go on through each of theirs are there for certain; of the others
/// nothing is known yet.
void list_seams(Sheets& s) {
  std::vector<std::int32_t> here;
  for (std::size_t e = 0; e < s.table.edges.size(); ++e) {
    here.clear();
    const std::span<const EdgeUse> uses = s.table.uses_of(s.table.edges[e]);
    for (const EdgeUse& use : uses)
      if (s.of_face[at(use.triangle)] >= 0) here.push_back(s.of_face[at(use.triangle)]);
    std::sort(here.begin(), here.end());
    for (auto it = here.begin(); it != here.end();) {
      const auto end = std::upper_bound(it, here.end(), *it);
      const auto own = static_cast<std::int32_t>(end - it);
      if (own < static_cast<std::int32_t>(uses.size())) {
        s.seams.push_back({*it, static_cast<std::int32_t>(e), own});
        if (own % 2 == 1) s.part[at(*it)] = Part::unknown;
      }
      it = end;
    }
  }
  std::stable_sort(s.seams.begin(), s.seams.end(),
                   [](const Seam& a, const Seam& b) { return a.sheet < b.sheet; });
  s.first.assign(s.part.size() + 1, 0);
  s.sheets_at.resize(s.table.edges.size());
  for (const Seam& seam : s.seams) {
    ++s.first[at(seam.sheet) + 1];
    s.sheets_at[at(seam.edge)].push_back(seam.sheet);
  }
  for (std::size_t i = 1; i < s.first.size(); ++i) s.first[i] += s.first[i - 1];
  s.faces_at.assign(s.table.edges.size(), {});
  for (std::size_t e = 0; e < s.table.edges.size(); ++e)
    for (const EdgeUse& use : s.table.uses_of(s.table.edges[e])) {
      const std::int32_t sheet = s.of_face[at(use.triangle)];
      ++s.faces_at[e][static_cast<std::size_t>(sheet < 0 ? Part::certain : s.part[at(sheet)])];
    }
}

/// Faces along a seam of a sheet of which nothing is known, but its own.
struct Others {
  std::int32_t certain = 0, unknown = 0, fins = 0;
};

Others others_at(const Sheets& s, const Seam& seam) {
  const auto& faces = s.faces_at[at(seam.edge)];
  const auto of = [&](Part part) { return faces[static_cast<std::size_t>(part)]; };
  return {of(Part::certain), of(Part::unknown) - seam.own, of(Part::fin)};
}

/// Whether a surface that is there for certain would end without the sheet.
bool is_needed(const Sheets& s, std::int32_t sheet) {
  const std::span<const Seam> seams = s.seams_of(sheet);
  return std::any_of(seams.begin(), seams.end(), [&](const Seam& seam) {
    const Others others = others_at(s, seam);
    return others.unknown == 0 && others.certain % 2 == 1;
  });
}

/// Whether the surface there is for certain goes on without the sheet.
bool is_fin(const Sheets& s, std::int32_t sheet) {
  bool is_attached = false;
  for (const Seam& seam : s.seams_of(sheet)) {
    const Others others = others_at(s, seam);
    if (others.certain % 2 == 1) return false;
    is_attached = is_attached || others.certain > 0 || others.fins > 0;
  }
  return is_attached;
}

/// Gives the sheets that the rule holds for their part, until there are no more.
void decide(Sheets& s, Part part, bool (*rule)(const Sheets&, std::int32_t)) {
  std::vector<std::int32_t> waiting;
  for (std::size_t i = s.part.size(); i-- > 0;) waiting.push_back(static_cast<std::int32_t>(i));
  while (!waiting.empty()) {
    const std::int32_t sheet = waiting.back();
    waiting.pop_back();
    if (s.part[at(sheet)] != Part::unknown || !rule(s, sheet)) continue;
    s.part[at(sheet)] = part;
    for (const Seam& seam : s.seams_of(sheet)) {
      auto& faces = s.faces_at[at(seam.edge)];
      faces[static_cast<std::size_t>(Part::unknown)] -= seam.own;
      faces[static_cast<std::size_t>(part)] += seam.own;
      for (const std::int32_t other : s.sheets_at[at(seam.edge)])
        if (s.part[at(other)] == Part::unknown) waiting.push_back(other);
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
    const std::size_t face = at(place[at(first[t])]);
    ++faces.copies[face];
    faces.net[face] += turns_as(mesh.triangles[at(first[t])], mesh.triangles[t]) ? 1 : -1;
  }
  return faces;
}

std::vector<bool> find_fins(const TriangleMesh& mesh, const DistinctFaces& faces) {
  std::vector<bool> result(faces.triangle.size(), false);
  if (std::find(faces.net.begin(), faces.net.end(), 0) == faces.net.end()) return result;
  TriangleMesh distinct;
  for (const std::int32_t t : faces.triangle) distinct.triangles.push_back(mesh.triangles[at(t)]);
  Sheets s;
  s.table = build_edge_table(distinct);
  number_sheets(faces, s);
  list_seams(s);
  decide(s, Part::certain, is_needed);
  decide(s, Part::fin, is_fin);
  for (std::size_t i = 0; i < result.size(); ++i)
    result[i] = s.of_face[i] >= 0 && s.part[at(s.of_face[i])] == Part::fin;
  return result;
}

}  // namespace thigma
