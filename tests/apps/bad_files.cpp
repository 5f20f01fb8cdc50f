#include "apps/bad_files.h"

#include <limits>

#include "support/mesh_file_samples.h"
#include "support/mesh_samples.h"

#include "thigma/clod/build_clod.h"
#include "thigma/clod/clod_file.h"
#include "thigma/import/write_mesh.h"
#include "thigma/math/random.h"
#include "thigma/mesh/shapes.h"

namespace thigma::test {
namespace {

using detail::kMeshFormats;
using detail::MeshFormatRow;

std::string bytes_of(const TriangleMesh& mesh, MeshFormat format = MeshFormat::obj) {
  return format_mesh(mesh, format, "sample");
}

TriangleMesh ball() { return make_ball(0.05, 3); }

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  if (at != std::string::npos) text.replace(at, from.size(), to);
  return text;
}

// Cut in the middle of the last number or record of what is kept, so that every format can notice.
void add_truncated(std::vector<BadMesh>& files) {
  for (const MeshFormatRow& f : kMeshFormats) {
    std::string bytes = mesh_file(ball(), f);
    bytes.resize(bytes.size() - 3);
    // An OBJ face of two whole corners is no face; what the last line of an ascii STL calls itself
    // is nobody's business.
    if (f.format == MeshFormat::obj) bytes.resize(bytes.rfind(' '));
    if (f.format == MeshFormat::stl_ascii) bytes.resize(bytes.rfind("endfacet") + 3);
    files.push_back({"truncated", "cut_" + mesh_file_name(f), bytes, Due::refusal, ""});
    bytes.resize(bytes.size() * 2 / 5);
    files.push_back({"truncated", "cut_early_" + mesh_file_name(f), bytes,
                     f.format == MeshFormat::obj ? Due::either : Due::refusal, ""});
  }
}

void add_flipped_bits(std::vector<BadMesh>& files) {
  Random random(2004);
  for (const MeshFormatRow& f : kMeshFormats) {
    for (int round = 0; round < 3; ++round) {
      std::string bytes = mesh_file(ball(), f);
      // Headers are short: aim at them once.
      const std::size_t range =
          round == 0 ? std::min<std::size_t>(bytes.size(), 160) : bytes.size();
      for (int i = 0; i < 3; ++i) {
        bytes[random.below(range)] ^= static_cast<char>(1u << random.below(8));
      }
      files.push_back({"bit-flipped", "flip" + std::to_string(round) + "_" + mesh_file_name(f),
                       bytes, Due::either, ""});
    }
  }
}

std::string with_count(std::string stl, std::uint32_t count) {
  for (std::size_t i = 0; i < 4; ++i) stl[80 + i] = static_cast<char>(count >> (8 * i));
  return stl;
}

void add_lying_headers(std::vector<BadMesh>& files) {
  const TriangleMesh mesh = ball();
  const std::string vertices = "element vertex " + std::to_string(mesh.positions.size());
  const std::string faces = "element face " + std::to_string(mesh.triangles.size());
  const char* kind = "lying header";
  for (const MeshFormatRow& f : kMeshFormats) {
    if (std::string_view(f.kind) != "PLY") continue;
    const std::string good = bytes_of(mesh, f.format);
    files.push_back({kind, "vertices_" + mesh_file_name(f),
                     replaced(good, vertices, "element vertex 4000000000"), Due::refusal, ""});
    files.push_back({kind, "faces_" + mesh_file_name(f),
                     replaced(good, faces, "element face 18446744073709551615"), Due::refusal, ""});
  }
  files.push_back({kind, "count_binary.stl",
                   with_count(bytes_of(mesh, MeshFormat::stl_binary), 0xffffffffu), Due::refusal,
                   ""});
  files.push_back(
      {kind, "loop_ascii.stl",
       replaced(bytes_of(mesh, MeshFormat::stl_ascii), "endloop", "vertex 0 0 0\nendloop"),
       Due::refusal, ""});
  const std::string off = bytes_of(mesh, MeshFormat::off);
  const std::size_t counts = off.find('\n') + 1;
  files.push_back(
      {kind, "counts.off",
       off.substr(0, counts) + "999999999 999999999 0" + off.substr(off.find('\n', counts)),
       Due::refusal, ""});
}

std::string with_first_vertex(const std::string& obj, const std::string& vertex) {
  const std::size_t at = obj.find("\nv ") + 1;
  return obj.substr(0, at) + vertex + obj.substr(obj.find('\n', at));
}

void add_bad_numbers(std::vector<BadMesh>& files) {
  const std::string good = bytes_of(ball());
  const auto add = [&](const char* kind, const char* name, std::string bytes) {
    files.push_back({kind, name, std::move(bytes), Due::refusal, "line "});
  };
  add("NaN coordinate", "nan.obj", with_first_vertex(good, "v 0 nan 0"));
  add("infinite coordinate", "inf.obj", with_first_vertex(good, "v 0 inf 0"));
  add("infinite coordinate", "overflow.obj", with_first_vertex(good, "v 0 1e999 0"));
  add("infinite coordinate", "huge.obj", with_first_vertex(good, "v 0 1e200 0"));
  add("index out of range", "index.obj", good + "f 1 2 99999\n");
  add("index out of range", "zero.obj", good + "f 0 1 2\n");
  add("index out of range", "negative.obj", good + "f -1 -2 -99999\n");
  add("index out of range", "index64.obj", good + "f 1 2 18446744073709551617\n");
  TriangleMesh mesh = ball();
  std::string stl = bytes_of(mesh, MeshFormat::stl_binary);
  stl.replace(84 + 12, 4, std::string("\0\0\xc0\x7f", 4));
  files.push_back({"NaN coordinate", "nan_binary.stl", stl, Due::refusal, ""});
  for (const MeshFormatRow& f : kMeshFormats) {
    // Of OBJ above; STL has no indices and gives a file of its own no infinity.
    if (f.write == nullptr || f.format == MeshFormat::obj || !f.is_exact) continue;
    TriangleMesh bad = ball();
    bad.triangles[7][1] = 1'000'000;
    files.push_back({"index out of range", "index_" + mesh_file_name(f), bytes_of(bad, f.format),
                     Due::refusal, ""});
    bad = ball();
    bad.positions[3].y() = std::numeric_limits<double>::infinity();
    files.push_back({"infinite coordinate", "inf_" + mesh_file_name(f), bytes_of(bad, f.format),
                     Due::refusal, ""});
  }
}

TriangleMesh with_fin() {
  TriangleMesh mesh = make_box(Vec3(0.06, 0.05, 0.04), {3, 3, 3});
  const auto t = mesh.triangles.front();
  mesh.positions.push_back(1.7 * mesh.positions[static_cast<std::size_t>(t[0])]);
  mesh.triangles.push_back({t[0], t[1], static_cast<std::int32_t>(mesh.positions.size()) - 1});
  return mesh;
}

// Every corner moved by a billionth: no two are equal any more.
TriangleMesh torn() {
  TriangleMesh mesh = unwelded(ball());
  Random random(5);
  for (Vec3& p : mesh.positions) {
    for (int k = 0; k < 3; ++k) p[k] += 5e-12 * (2.0 * random.uniform() - 1.0);
  }
  return mesh;
}

TriangleMesh half_flipped() {
  TriangleMesh mesh = ball();
  for (std::size_t i = 0; i < mesh.triangles.size() / 2; ++i) {
    std::swap(mesh.triangles[i][1], mesh.triangles[i][2]);
  }
  return mesh;
}

void add_bad_shapes(std::vector<BadMesh>& files) {
  const auto add = [&](const char* kind, const char* name, const TriangleMesh& mesh, Due due,
                       const char* says) {
    files.push_back({kind, name, bytes_of(mesh), due, says});
  };
  add("Moebius strip", "moebius.obj", make_moebius(0.05, 0.02, 24, 2), Due::refusal, "oriented");
  add("flat solid", "flat.obj", stretched(make_box(Vec3(0.1, 0.1, 0.1), {2, 2, 2}), Vec3(1, 1, 0)),
      Due::refusal, "");
  add("flat solid", "tilted_flat.obj",
      transformed(stretched(ball(), Vec3(1, 1, 0)),
                  {Vec3(1, 2, 3), Quat(0.5, 0.5, 0.1, 0.7).normalized()}),
      Due::refusal, "");
  TriangleMesh sheet = make_sheet(0.1, 0.1, 4, 4);
  add("zero-volume solid", "two_sided.obj", joined(sheet, flipped(sheet)), Due::either, "");
  add("zero-volume solid", "line.obj", stretched(ball(), Vec3(1, 0, 0)), Due::refusal, "");
  add("zero-volume solid", "point.obj", stretched(ball(), Vec3(0, 0, 0)), Due::refusal, "");
  add("fin", "fin.obj", with_fin(), Due::repair, "");
  add("unwelded soup", "equal_soup.obj", unwelded(ball()), Due::result, "");
  add("unwelded soup", "near_soup.obj", torn(), Due::repair, "");
  add("flipped half", "half_flipped.obj", half_flipped(), Due::repair, "");
  add("flipped half", "inside_out.obj", flipped(ball()), Due::repair, "");
  add("nanometre shape", "nanometre.obj", transformed(ball(), {}, 2e-8), Due::result, "");
  add("gigametre shape", "gigametre.obj", transformed(ball(), {}, 2e10), Due::result, "");
  add("1e6:1 shape", "needle.obj", make_box(Vec3(1e-7, 1e-7, 0.1), {2, 2, 2}), Due::result, "");
  add("1e6:1 shape", "foil.obj", make_box(Vec3(0.1, 0.1, 1e-7), {2, 2, 2}), Due::result, "");
  add("1e7 from the origin", "far.obj", moved(make_ball(1.0, 3), Vec3(1e7, -1e7, 1e7)), Due::result,
      "");
}

void add_not_meshes(std::vector<BadMesh>& files) {
  for (const MeshFormatRow& f : kMeshFormats)
    files.push_back({"empty", "empty_" + mesh_file_name(f), "", Due::refusal, ""});
  files.push_back(
      {"empty", "only_header.ply",
       "ply\nformat ascii 1.0\nelement vertex 0\nproperty float x\nproperty float y\n"
       "property float z\nelement face 0\nproperty list uchar int vertex_indices\nend_header\n",
       Due::refusal, "no triangle"});
  files.push_back(
      {"empty", "no_faces.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n", Due::refusal, "no triangle"});
  std::string noise(20'000, '\0');
  Random random(9);
  for (char& c : noise) c = static_cast<char>(random.below(256));
  files.push_back({"noise", "noise.obj", noise, Due::refusal, ""});
  files.push_back({"noise", "long_line.obj", std::string(2'000'000, 'v'), Due::refusal, ""});
  files.push_back({"noise", "zeros.stl", std::string(100'000, '\0'), Due::refusal, ""});
}

void add_damaged_levels(std::vector<BadMesh>& files) {
  ClodAsset asset = build_clod_asset(ball());
  const std::string good = format_clod(asset);
  const auto add = [&](const char* name, std::string bytes) {
    files.push_back({"damaged .clod", name, std::move(bytes), Due::refusal, ""});
  };
  add("cut.clod", good.substr(0, good.size() / 2));
  add("cut_header.clod", good.substr(0, 40));
  add("longer.clod", good + "more");
  Random random(7);
  for (int i = 0; i < 3; ++i) {
    std::string flipped = good;
    const std::size_t at = random.below(flipped.size());
    flipped[at] = static_cast<char>(flipped[at] ^ 1 << random.below(8));
    add(("flip" + std::to_string(i) + ".clod").c_str(), flipped);
  }
  std::string newer = good;
  newer[8] = 2;
  add("newer.clod", newer);
  std::string chunks = good;  // four billion of them
  for (std::size_t i = 12; i < 16; ++i) chunks[i] = '\xff';
  add("chunks.clod", chunks);
}

}  // namespace

std::vector<BadMesh> bad_meshes() {
  std::vector<BadMesh> files;
  add_not_meshes(files);
  add_truncated(files);
  add_flipped_bits(files);
  add_lying_headers(files);
  add_bad_numbers(files);
  add_bad_shapes(files);
  add_damaged_levels(files);
  return files;
}

std::vector<BadScene> bad_scenes() {
  const std::string ball = "mesh = \"procedural:ball?triangles=320\"\n";
  const std::string object = "[object]\n" + ball;
  const std::string rest = "position = [0, 0, 0.06]\n[[static]]\n" + ball;
  std::string noise(3000, '\0');
  Random random(10);
  for (char& c : noise) c = static_cast<char>(random.below(256));
  return {
      {"empty scene", "empty.toml", "", "no [object]"},
      {"wrong key", "key.toml", object + "mas = 0.01\n" + rest, "line 3"},
      {"wrong key", "table.toml", object + rest + "[cuopling]\nlinear_stiffness = 300\n",
       "coupling"},
      {"missing mesh", "no_mesh.toml", "[object]\nmass = 0.01\n[[static]]\n" + ball, "no mesh"},
      {"missing mesh", "gone.toml", "[object]\nmesh = \"gone.obj\"\nunit_scale = 1.0\n" + rest,
       "gone.obj"},
      {"missing mesh", "model.toml", "[object]\nmesh = \"procedural:bal\"\n" + rest, "ball"},
      {"no unit_scale", "unit.toml", "[object]\nmesh = \"gone.obj\"\n" + rest, "unit_scale"},
      {"negative mass", "mass.toml", object + "mass = -0.01\n" + rest, "line 3"},
      {"zero stiffness", "contact.toml", object + rest + "[contact]\nstiffness = 0\n", "line 7"},
      {"zero stiffness", "coupling.toml", object + rest + "[coupling]\nlinear_stiffness = 0\n",
       "line 7"},
      {"non-unit quaternion", "quat.toml", object + "quat_xyzw = [0, 0, 0, 1.1]\n" + rest,
       "line 3"},
      {"non-unit quaternion", "quat0.toml", object + "quat_xyzw = [0, 0, 0, 0]\n" + rest, "line 3"},
      {"wrong type", "type.toml", object + "mass = \"ten grams\"\n" + rest, "line 3"},
      {"wrong type", "vector.toml", object + "grasp_point = [0, 0]\n" + rest, "line 3"},
      {"wrong type", "array.toml", "object = [1, 2]\n" + rest, "line 1"},
      {"NaN or infinity", "nan.toml", object + "mass = nan\n" + rest, "line 3"},
      {"NaN or infinity", "inf.toml", object + rest + "[contact]\nstiffness = inf\n", "line 7"},
      {"duplicate key", "twice.toml", object + "mass = 0.01\nmass = 0.02\n" + rest, "line 4"},
      {"truncated scene", "cut.toml", object + "position = [0, 0, 0.0", "line 3"},
      {"noise", "noise.toml", noise, ""},
      {"noise", "deep.toml", "x = " + std::string(100'000, '['), "line 1"},
      {"noise", "large.toml", std::string(3'000'000, '#'), "1 MiB"},
  };
}

}  // namespace thigma::test
