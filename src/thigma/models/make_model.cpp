#include "thigma/models/make_model.h"

#include <algorithm>
#include <charconv>

#include "thigma/core/edit_distance.h"
#include "thigma/core/error.h"
#include "thigma/models/conforming.h"
#include "thigma/models/detail/castings.h"
#include "thigma/models/detail/jaw.h"
#include "thigma/models/detail/parts.h"
#include "thigma/models/detail/tableware.h"
#include "thigma/models/golf.h"

namespace thigma::models {
namespace {

constexpr std::string_view kPrefix = "procedural:";
constexpr int kMostTriangles = 20'000'000;

std::string quoted(std::string_view text) {
  // A URI may hold anything: no control characters reach a message, and no more than a line of it.
  std::string out = "'";
  for (const char c : text.substr(0, 60)) out += (c >= ' ' && c < 127) ? c : '?';
  return out + "'";
}

std::string meant(std::string_view word, const std::vector<std::string>& known) {
  const std::string nearest = nearest_word(word, known);
  std::string all = nearest.empty() ? "expected one of" : "expected '" + nearest + "', one of";
  for (const std::string& k : known) all += " " + k;
  return all;
}

std::vector<std::string> model_names() {
  std::vector<std::string> names;
  for (const ModelInfo& m : models()) names.push_back(m.name);
  return names;
}

const ModelInfo& find_model(std::string_view name, const std::string& where) {
  for (const ModelInfo& m : models()) {
    if (name == m.name) return m;
  }
  throw InputError(where + ": no procedural model " + quoted(name) + ", " +
                   meant(name, model_names()));
}

void check_count(const ModelInfo& model, int triangles, const std::string& where) {
  if (triangles < model.least_triangles || triangles > kMostTriangles) {
    throw InputError(where + ": " + std::to_string(triangles) + " triangles for " + model.name +
                     ", expected " + std::to_string(model.least_triangles) + " to " +
                     std::to_string(kMostTriangles));
  }
}

template <class Number>
Number parse_number(std::string_view text, std::string_view key, const std::string& where) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) {
    throw InputError(where + ": " + std::string(key) + "=" + quoted(text) +
                     ", expected a whole number");
  }
  return value;
}

}  // namespace

const std::vector<ModelInfo>& models() {
  static const std::vector<ModelInfo> list = {
      {"jaw_lower", 40'180, 400,
       "lower jaw, 66 mm arch with 14 teeth; fits jaw_upper of the same seed"},
      {"jaw_upper", 47'340, 400, "upper jaw"},
      {"cup", 64'000, 1'500, "cup with a handle, 11 cm high"},
      {"spoon", 86'016, 200, "spoon, 20 cm long"},
      {"ellipsoid", 2'000, 20, "ellipsoid, semi-axes 10, 6 and 4 mm"},
      {"ball", 20'000, 20, "ball of 50 mm radius"},
      {"box", 1'200, 12, "box of 100 x 60 x 40 mm"},
      {"plate", 2'000, 12, "plate of 350 x 350 x 10 mm"},
      {"cylinder", 2'000, 20, "cylinder of 20 mm radius, 100 mm high"},
      {"cone", 2'000, 16, "cone of 30 mm radius, 80 mm high"},
      {"torus", 8'000, 32, "torus, radii 40 and 15 mm"},
      {"ring", 2'000, 32, "ring of 40 mm radius, 12 mm thick"},
      {"gear", 20'000, 1'000, "spur gear with 20 teeth, 50 mm across"},
      {"probe", 2'000, 400, "probe with a round tip of 10 mm radius, 100 mm long"},
      {"peg", 4'000, 40, "round peg, 16 mm thick and 50 mm long"},
      {"hole", 8'000, 100, "block with a hole of 16.4 mm for the peg"},
      {"flange_spigot", 4'000, 400, "cast flange of 60 mm with a spigot; fits flange_socket"},
      {"flange_socket", 4'000, 400,
       "cast flange of 60 mm with the socket, 0.3 mm around the spigot"},
      {"joint_ball", 137'060, 1'000, "ball joint: ball of 25 mm radius with a stem"},
      {"joint_socket", 137'060, 1'000, "ball joint: the socket, 0.5 mm around the ball"},
      {"golf_club", 104'888, 1'000, "head of a driver, 120 mm from heel to toe"},
      {"golf_ball", 177'876, 1'000, "golf ball with 392 dimples"},
      {"conforming_lower", 100'000, 1'000, "wavy disc of 100 mm radius"},
      {"conforming_upper", 100'000, 1'000, "the disc that follows it 0.1 mm above"},
  };
  return list;
}

TriangleMesh make_model(const ModelRequest& request) {
  const ModelInfo& model = find_model(request.name, "model");
  const int n = request.triangles == 0 ? model.triangles : request.triangles;
  check_count(model, n, "model");
  const std::string& name = request.name;
  if (name == "jaw_lower") return make_lower_jaw(n, request.seed);
  if (name == "jaw_upper") return make_upper_jaw(n, request.seed);
  if (name == "cup") return make_cup(n);
  if (name == "spoon") return make_spoon(n);
  if (name == "ellipsoid") return make_ellipsoid_near({0.010, 0.006, 0.004}, n);
  if (name == "ball") return make_ellipsoid_near(Vec3::Constant(0.050), n);
  if (name == "box") return make_box_near({0.100, 0.060, 0.040}, n);
  if (name == "plate") return make_box_near({0.350, 0.350, 0.010}, n);
  if (name == "cylinder") return make_cylinder_near(0.020, 0.100, n);
  if (name == "cone") return make_cone_near(0.030, 0.080, n);
  if (name == "torus") return make_torus_near(0.040, 0.015, n);
  if (name == "ring") return make_torus_near(0.040, 0.006, n);
  if (name == "gear") return make_gear(n);
  if (name == "probe") return make_probe(n);
  if (name == "peg") return make_peg(n);
  if (name == "flange_spigot") return make_flange_spigot(n);
  if (name == "flange_socket") return make_flange_socket(n);
  if (name == "joint_ball") return make_joint_ball(n, request.seed);
  if (name == "joint_socket") return make_joint_socket(n, request.seed);
  if (name == "golf_club") return make_golf_club(n, request.seed);
  if (name == "golf_ball") return make_golf_ball(n);
  if (name == "conforming_lower") return make_conforming_lower(n, request.seed);
  if (name == "conforming_upper") return make_conforming_upper(n, request.seed);
  return make_hole(n);
}

bool is_model_uri(std::string_view text) { return text.substr(0, kPrefix.size()) == kPrefix; }

ModelRequest parse_model_uri(std::string_view uri, const std::string& where) {
  if (!is_model_uri(uri)) {
    throw InputError(where + ": " + quoted(uri) + ", expected procedural:NAME?triangles=N&seed=S");
  }
  std::string_view rest = uri.substr(kPrefix.size());
  const std::size_t mark = rest.find('?');
  ModelRequest request;
  const ModelInfo& model = find_model(rest.substr(0, mark), where);
  request.name = model.name;
  if (mark == std::string_view::npos) return request;
  rest = rest.substr(mark + 1);
  bool has_triangles = false, has_seed = false;
  for (;;) {
    const std::size_t end = rest.find('&');
    const std::string_view pair = rest.substr(0, end);
    const std::size_t equals = pair.find('=');
    const std::string_view key = pair.substr(0, equals);
    bool* seen = key == "triangles" ? &has_triangles : key == "seed" ? &has_seed : nullptr;
    if (!seen)
      throw InputError(where + ": unknown key " + quoted(key) + ", " +
                       meant(key, {"triangles", "seed"}));
    if (equals == std::string_view::npos)
      throw InputError(where + ": " + quoted(key) + " has no value, expected KEY=VALUE");
    if (*seen) throw InputError(where + ": " + quoted(key) + " stands twice, expected once");
    *seen = true;
    const std::string_view value = pair.substr(equals + 1);
    if (seen == &has_seed) {
      request.seed = parse_number<std::uint64_t>(value, key, where);
    } else {
      request.triangles = parse_number<int>(value, key, where);
      check_count(model, request.triangles, where);
    }
    if (end == std::string_view::npos) return request;
    rest = rest.substr(end + 1);
  }
}

std::string nearest_word(std::string_view word, const std::vector<std::string>& known) {
  std::string best;
  std::size_t best_distance = 0;
  for (const std::string& candidate : known) {
    const std::size_t distance = edit_distance(word, candidate);
    if (distance <= std::max<std::size_t>(2, candidate.size() / 3) &&
        (best.empty() || distance < best_distance)) {
      best = candidate;
      best_distance = distance;
    }
  }
  return best;
}

}  // namespace thigma::models
