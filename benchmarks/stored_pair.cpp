#include "benchmarks/stored_pair.h"

#include <algorithm>
#include <cstring>

#include "benchmarks/bench_pair.h"

#include "thigma/clod/clod_file.h"
#include "thigma/core/error.h"
#include "thigma/files/file.h"

namespace thigma::bench {
namespace {

struct Storable {
  PairRequest request;
  int frames = 1000;
};

/// Those of the levels' rows, and two discs of 100,000 triangles.
std::vector<Storable> storables() {
  std::vector<Storable> all;
  for (const PairRequest& request : level_pairs()) all.push_back({request});
  all.push_back({{.name = "discs",
                  .scene = "conforming",
                  .object_triangles = 100'000,
                  .scene_triangles = 100'000,
                  .path = {.turn = 1e-4, .slide = 5e-4, .swing = 5e-4, .is_solved = false}}});
  return all;
}

constexpr std::size_t kNumbers = 7;  // of a pose

std::string format_path(double radius, double tolerance, const std::vector<Pose>& path) {
  std::vector<double> numbers = {radius, tolerance};
  for (const Pose& p : path) {
    numbers.insert(numbers.end(),
                   {p.position.x(), p.position.y(), p.position.z(), p.orientation.x(),
                    p.orientation.y(), p.orientation.z(), p.orientation.w()});
  }
  return {reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(double)};
}

}  // namespace

std::vector<std::string> storable_pairs() {
  std::vector<std::string> names;
  for (const Storable& s : storables()) names.push_back(s.request.name);
  return names;
}

void store_pair(const std::string& folder, const std::string& name, int triangles) {
  const std::vector<Storable> all = storables();
  const auto found = std::find_if(all.begin(), all.end(),
                                  [&](const Storable& s) { return s.request.name == name; });
  if (found == all.end()) throw InputError(name + ": pair, expected one of those of --list");
  PairRequest request = found->request;
  if (triangles > 0) request.object_triangles = request.scene_triangles = triangles;
  BenchPair pair = make_pair(request);
  const std::string stem = folder + "/" + name;
  const auto write_path = [&](const std::string& kind) {
    write_file(stem + "." + kind + ".path",
               format_path(pair.radius, pair.tolerance, make_path(pair, found->frames)));
  };
  write_path("meeting");
  PathShape& path = pair.request.path;
  if (path.is_solved) path.height = path.swing = 0.5 * path.swing;
  write_path("apart");
  const auto write_levels = [&](ClodHierarchy& hierarchy, const std::string& kind) {
    ClodAsset asset;
    asset.hierarchy = std::move(hierarchy);
    write_clod(asset, stem + "." + kind + ".clod");
  };
  write_levels(pair.object, "object");
  write_levels(pair.scene, "scene");
}

StoredPair load_pair(const std::string& folder, const std::string& name, const std::string& path) {
  const std::string stem = folder + "/" + name, file = stem + "." + path + ".path";
  const std::string bytes = read_file(file);
  std::vector<double> numbers(bytes.size() / sizeof(double));
  std::memcpy(numbers.data(), bytes.data(), numbers.size() * sizeof(double));
  if (numbers.size() < 2 || (numbers.size() - 2) % kNumbers != 0)
    throw InputError(file + ": " + std::to_string(bytes.size()) +
                     " bytes, expected a path as `prepare` writes it");
  StoredPair pair;
  pair.object = read_clod(stem + ".object.clod").hierarchy;
  pair.scene = read_clod(stem + ".scene.clod").hierarchy;
  pair.radius = numbers[0];
  pair.tolerance = numbers[1];
  for (std::size_t i = 2; i < numbers.size(); i += kNumbers) {
    const double* v = numbers.data() + i;
    pair.path.push_back({Vec3(v[0], v[1], v[2]), Quat(v[6], v[3], v[4], v[5])});
  }
  return pair;
}

}  // namespace thigma::bench
