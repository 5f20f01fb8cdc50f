// thigma contacts OBJECT SCENE: the contacts of an object along a path of poses, one JSON object a
// pose, a table where a person reads, a row each in a CSV file.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "json_out.h"
#include "pose_file.h"
#include "progress.h"
#include "resolution_options.h"
#include "verbs.h"
#include <nlohmann/json.hpp>

#include "thigma/clod/build_hierarchy.h"
#include "thigma/contact/query_contacts.h"
#include "thigma/core/cpu_clock.h"
#include "thigma/core/error.h"
#include "thigma/files/file.h"
#include "thigma/models/make_model.h"
#include "thigma/scene/asset_cache.h"

namespace thigma::app {
namespace {

// A pose with more is a tolerance in other units than the meshes, not a contact query.
constexpr std::size_t kMostContacts = 20'000'000;

struct ContactsOptions {
  std::string object, scene, poses;
  double tolerance = -1.0;
  double scale = 1.0;
  double step_time = 0.001;  // between poses [s]
  bool fresh = false, repair = false;
  std::string csv;  // file; "" none
  ResolutionOptions resolution;
};

ClodHierarchy load(const std::string& name, const char* role, const ContactsOptions& options,
                   bool is_exact, const Common& common) {
  const Log log = common.quiet ? Log{} : [](const std::string& text) {
    std::cerr << "thigma: " << text << "\n";
  };
  ClodSource source{
      .name = name, .role = role, .scale = options.scale, .is_repair = options.repair};
  const bool is_file = !models::is_model_uri(name) && is_clod_file(name);
  if (is_exact && !is_file) return build_exact_hierarchy(load_surface(source, log));
  Progress progress("building " + name, "triangles", !common.quiet);
  source.progress = [&](double share, double triangles) { progress.update(share, triangles); };
  source.params.threads = std::clamp(static_cast<int>(std::thread::hardware_concurrency()), 1, 8);
  return std::move(load_clod(source, log).hierarchy);
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
  if (set.contacts.empty())
    j["min_distance"] = nullptr;
  else
    j["min_distance"] = least_distance(set);
  j["contacts"] = nlohmann::ordered_json::array();
  for (const Contact& c : set.contacts) j["contacts"].push_back(to_json(c));
  j["dropped"] = set.dropped;
  j["front"] = set.stats.front;
  j["tests"] = set.stats.tests;
  j["cpu_us"] = cpu_us;
  j["mandatory_tests"] = set.stats.mandatory_tests;  // no budget can leave them out
  // contacts coarser than asked for want of budget
  j["unrefined"] = set.stats.unrefined;
  return j;
}

/// The contacts as a person reads them, a table a pose, or a program, rows of a CSV file.
struct ContactRows {
  std::string csv;  // of all poses; "" where no file is wanted
  bool is_table = false;

  static constexpr const char* kHeader =
      "pose,point_x [m],point_y [m],point_z [m],scene_x [m],scene_y [m],scene_z [m],normal_x,"
      "normal_y,normal_z,depth [m],bound [m],object_level,scene_level\n";

  void add(std::size_t pose, const ContactSet& set) {
    if (is_table) print_table(pose, set);
    if (csv.empty()) return;
    char line[512];
    for (const Contact& c : set.contacts) {
      std::snprintf(line, sizeof line,
                    "%zu,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%d,%d\n",
                    pose, c.point.x(), c.point.y(), c.point.z(), c.scene_point.x(),
                    c.scene_point.y(), c.scene_point.z(), c.normal.x(), c.normal.y(), c.normal.z(),
                    c.depth, c.bound, c.object_level, c.scene_level);
      csv += line;
    }
  }

 private:
  static void print_table(std::size_t pose, const ContactSet& set) {
    constexpr double kMilli = 1e3;
    if (set.contacts.empty()) {
      std::printf("pose %zu: no contact within the tolerance\n", pose);
      return;
    }
    const double least = kMilli * least_distance(set);
    std::printf("pose %zu: %zu contacts, %.4g mm %s\n", pose, set.contacts.size(), std::fabs(least),
                least < 0.0 ? "deep where deepest" : "apart where nearest");
    std::printf("  %28s  %24s  %10s  %10s  %s\n", "point [mm]", "normal", "depth [mm]",
                "bound [mm]", "levels");
    for (const Contact& c : set.contacts)
      std::printf("  %9.3f %9.3f %9.3f  %7.3f %7.3f %7.3f   %10.4g  %10.4g  %d, %d\n",
                  kMilli * c.point.x(), kMilli * c.point.y(), kMilli * c.point.z(), c.normal.x(),
                  c.normal.y(), c.normal.z(), kMilli * c.depth, kMilli * c.bound, c.object_level,
                  c.scene_level);
  }
};

/// What is wrong with the options, "" when nothing; otherwise the query they ask for.
std::string make_query(const ContactsOptions& options, ContactQuery& query) {
  if (!(options.tolerance >= 0.0) || !std::isfinite(options.tolerance))
    return "--tolerance must be a finite length >= 0 [m]";
  if (!(options.scale > 0.0) || !std::isfinite(options.scale))
    return "--scale must be a finite number above 0";
  if (!(options.step_time > 0.0) || !std::isfinite(options.step_time))
    return "--dt must be a finite time above 0 [s]";
  query.tolerance = options.tolerance;
  query.resolution.step_time = options.step_time;
  return apply(options.resolution, query.resolution);
}

int contacts(const Common& common, const ContactsOptions& options) {
  ContactQuery query;
  if (const std::string wrong = make_query(options, query); !wrong.empty()) {
    print_error("contacts: " + wrong);
    return kUsage;
  }
  const std::vector<Pose> poses = read_poses(options.poses);
  check_source({.name = options.scene,
                .role = "SCENE",
                .scale = options.scale,
                .is_repair = options.repair});
  const ClodHierarchy object =
      load(options.object, "OBJECT", options, query.resolution.is_exact, common);
  const ClodHierarchy scene =
      load(options.scene, "SCENE", options, query.resolution.is_exact, common);
  ContactFront front;
  reserve_front(front, object, scene);
  ContactSet set;
  set.contacts.reserve(16'384);
  ContactRows rows;
  if (!options.csv.empty()) rows.csv = ContactRows::kHeader;
  rows.is_table = !common.json;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    double spent = 0.0;
    for (bool complete = false; !complete;) {
      clear(set);
      if (options.fresh) clear_front(front);
      const double start = thread_cpu_seconds();
      query_contacts({object, poses[i]}, {scene}, query, front, set);
      spent = 1e6 * (thread_cpu_seconds() - start);
      complete = set.dropped == 0;
      const std::size_t wanted = set.contacts.size() + static_cast<std::size_t>(set.dropped);
      if (wanted > kMostContacts) {
        std::fprintf(
            stderr,
            "thigma: contacts: %zu contacts at pose %zu, at most %zu can be listed; expected a "
            "smaller --tolerance\n",
            wanted, i, kMostContacts);
        return kFailed;
      }
      if (!complete) set.contacts.reserve(wanted + wanted / 4);
    }
    rows.add(i, set);
    if (!rows.is_table) print_json(to_json(i, set, spent));
  }
  if (!options.csv.empty()) write_file(options.csv, rows.csv);
  return kDone;
}

}  // namespace

void add_contacts(CLI::App& app, Common& common) {
  const auto options = std::make_shared<ContactsOptions>();
  CLI::App* verb = add_verb(app, common, "contacts",
                            "list the contacts between two objects along a path of poses",
                            [&common, options] { return contacts(common, *options); });
  verb->add_option("OBJECT", options->object,
                   "what moves: a mesh or .clod file, or procedural:NAME")
      ->required();
  verb->add_option("SCENE", options->scene, "what stays at the identity")->required();
  verb->add_option("--poses", options->poses,
                   "CSV: x,y,z,qx,qy,qz,qw; one world pose of OBJECT a line [m]")
      ->required();
  verb->add_option("--tolerance", options->tolerance,
                   "contacts are pairs at most this far apart [m]")
      ->required();
  verb->add_option("--scale", options->scale, "metres per unit of both meshes");
  verb->add_option("-o,--output", options->csv,
                   "CSV file to write as well, a row a contact, units in the header");
  verb->add_flag("--fresh", options->fresh, "forget the pose before at every line");
  verb->add_flag("--repair", options->repair, "take repairable meshes and repair them");
  verb->add_option("--dt", options->step_time,
                   "time from pose to pose, for the velocity metric [s]; 0.001");
  add_resolution_options(*verb, options->resolution);
}

}  // namespace thigma::app
