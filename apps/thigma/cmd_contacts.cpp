// thigma contacts OBJECT SCENE: the contacts of an object along a path of poses, one JSON object a pose.

#include <time.h>

#include <cmath>
#include <cstdio>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "json_out.h"
#include "pose_file.h"
#include "scenes/make_model.h"
#include "thigma/clod/build_hierarchy.h"
#include "thigma/contact/query_contacts.h"
#include "thigma/core/error.h"
#include "thigma/mesh/load_mesh.h"
#include "verbs.h"

namespace thigma::app {
namespace {

// A pose with more is a tolerance in other units than the meshes, not a contact query.
constexpr std::size_t kMostContacts = 20'000'000;

struct ContactsOptions {
  std::string object, scene, poses;
  double tolerance = -1.0;
  double scale = 1.0;
  bool exact = false, fresh = false, repair = false;
  std::vector<std::string> levels;  // options of contact levels of detail, refused for now
};

double cpu_microseconds() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return 1e6 * static_cast<double>(t.tv_sec) + 1e-3 * static_cast<double>(t.tv_nsec);
}

ClodHierarchy load(const std::string& name, const char* role, const ContactsOptions& options, const Common& common) {
  TriangleMesh mesh;
  if (scenes::is_model_uri(name)) {
    mesh = scenes::make_model(scenes::parse_model_uri(name, role));
    scale_mesh(mesh, options.scale, name);
  } else {
    std::vector<std::string> repairs;
    mesh = load_usable_mesh(name, options.scale, options.repair, nullptr, &repairs);
    if (!common.quiet) {
      for (const std::string& repair : repairs) std::cerr << "thigma: " << name << ": repaired: " << repair << "\n";
    }
  }
  return build_exact_hierarchy(mesh);
}

nlohmann::ordered_json to_json(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

nlohmann::ordered_json to_json(const Contact& c) {
  nlohmann::ordered_json j;
  j["point"] = to_json(c.point);
  j["scene_point"] = to_json(c.scene_point);
  j["normal"] = to_json(c.normal);
  j["depth"] = c.depth;
  j["levels"] = {c.object_level, c.scene_level};
  j["bound"] = c.bound;
  return j;
}

nlohmann::ordered_json to_json(std::size_t index, const ContactSet& set, double cpu_us) {
  nlohmann::ordered_json j;
  j["index"] = index;
  if (set.contacts.empty()) j["min_distance"] = nullptr;
  else j["min_distance"] = least_distance(set);
  j["contacts"] = nlohmann::ordered_json::array();
  for (const Contact& c : set.contacts) j["contacts"].push_back(to_json(c));
  j["dropped"] = set.dropped;
  j["front"] = set.stats.front;
  j["tests"] = set.stats.tests;
  j["cpu_us"] = cpu_us;
  return j;
}

int contacts(const Common& common, const ContactsOptions& options) {
  if (!options.levels.empty()) {
    std::fprintf(stderr, "thigma: contacts: levels of detail come with a later version; this one answers exactly: "
                         "leave out --threshold, --deviation-cap, --budget-us, --budget-tests, --metric and --dt\n");
    return kUsage;
  }
  if (!(options.tolerance >= 0.0) || !std::isfinite(options.tolerance)) {
    std::fprintf(stderr, "thigma: contacts: --tolerance must be a finite length >= 0 [m]\n");
    return kUsage;
  }
  if (!(options.scale > 0.0) || !std::isfinite(options.scale)) {
    std::fprintf(stderr, "thigma: contacts: --scale must be a finite number above 0\n");
    return kUsage;
  }
  const std::vector<Pose> poses = read_poses(options.poses);
  const ClodHierarchy object = load(options.object, "OBJECT", options, common);
  const ClodHierarchy scene = load(options.scene, "SCENE", options, common);
  ContactFront front;
  reserve_front(front, object, scene);
  ContactSet set;
  set.contacts.reserve(16'384);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    double spent = 0.0;
    for (bool complete = false; !complete;) {
      clear(set);
      if (options.fresh) clear_front(front);
      const double start = cpu_microseconds();
      query_contacts(object, poses[i], scene, Pose{}, {.tolerance = options.tolerance}, front, set);
      spent = cpu_microseconds() - start;
      complete = set.dropped == 0;
      const std::size_t wanted = set.contacts.size() + static_cast<std::size_t>(set.dropped);
      if (wanted > kMostContacts) {
        std::fprintf(stderr, "thigma: contacts: %zu contacts at pose %zu, at most %zu can be listed; expected a "
                             "smaller --tolerance\n", wanted, i, kMostContacts);
        return kFailed;
      }
      if (!complete) set.contacts.reserve(wanted + wanted / 4);
    }
    print_json(to_json(i, set, spent));
  }
  return kDone;
}

}  // namespace

void add_contacts(CLI::App& app, Common& common) {
  const auto options = std::make_shared<ContactsOptions>();
  CLI::App* verb = add_verb(app, common, "contacts", "List the contacts between two meshes along a path of poses",
                            [&common, options] { return contacts(common, *options); });
  verb->add_option("OBJECT", options->object, "mesh that moves: a file or procedural:NAME")->required();
  verb->add_option("SCENE", options->scene, "mesh that stays at the identity")->required();
  verb->add_option("--poses", options->poses, "CSV: x,y,z,qx,qy,qz,qw; one world pose of OBJECT a line [m]")->required();
  verb->add_option("--tolerance", options->tolerance, "contacts are pairs at most this far apart [m]")->required();
  verb->add_option("--scale", options->scale, "metres per unit of both meshes");
  verb->add_flag("--exact", options->exact, "full resolution (the default)");
  verb->add_flag("--fresh", options->fresh, "forget the pose before at every line");
  verb->add_flag("--repair", options->repair, "take repairable meshes and repair them");
  for (const char* name : {"--threshold", "--deviation-cap", "--budget-us", "--budget-tests", "--metric", "--dt"}) {
    verb->add_option(name, options->levels, "contact levels of detail: not in this version")->group("");
  }
}

}  // namespace thigma::app
