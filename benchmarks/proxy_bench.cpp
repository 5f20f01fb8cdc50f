#include "benchmarks/proxy_bench.h"

#include <algorithm>
#include <memory>
#include <string>

#include "benchmarks/proxy_methods.h"
#include "benchmarks/proxy_path.h"

#include "thigma/clod/clod_asset.h"
#include "thigma/scene/scene_file.h"

namespace thigma::bench {
namespace {

/// How long a scene's session is recorded: the hand comes down, presses, slides, twists, taps twice
/// and goes back in 4 s. Shorter where surfaces conform, whose exact queries take milliseconds.
struct Recorded {
  std::string scene;
  double seconds = 4.0;
  int checked = 80;  // frames that are compared with fresh exact queries
};
const Recorded kRecorded[] = {
    {"jaws"}, {"golf"}, {"ellipsoid"}, {"ball_joint", 2.0}, {"cup_spoon"}, {"conforming", 2.0, 10}};
constexpr double kQuickSeconds = 1.5;
constexpr int kRuns = 3;

/// Sessions of a scene, exact and with levels far away, and the path of the first.
struct ProxyCase {
  ProxyScene exact, far;
  SceneSession exact_session, far_session;
  PlayedSession path;
  ShellPair shells;
};

PlayedSession play_engine(const ProxyScene& scene, double seconds, double carry = 0.0) {
  SceneSession session = open_proxy_session(scene);
  ContactWorld& world = session.config.contact;
  world.resolution.carry = carry;
  ContactScratch scratch;
  reserve_contact_scratch(world, scratch);
  return play_session(session, seconds, [&](const StampedBody& body, ContactSample& sample) {
    contact_step(world, body, scratch, sample);
  });
}

std::unique_ptr<ProxyCase> make_case(const std::string& name, double seconds, bool quick) {
  auto made = std::make_unique<ProxyCase>();
  ProxyRequest request{.scene = name, .triangles = quick ? 3000 : 0};
  made->exact = load_proxy_scene(request);
  request.has_levels_far = true;
  made->far = load_proxy_scene(request);
  made->exact_session = open_proxy_session(made->exact);
  made->far_session = open_proxy_session(made->far);
  made->path = play_engine(made->exact, seconds);
  return made;
}

/// What a session with other contacts does: force beside the exact one's, and how deep it goes.
void judge(const ProxyCase& c, const PlayedSession& played, Quality& quality) {
  quality.force_error = force_error(played, c.path);
  quality.entered = deepest_on(c.exact_session.config.contact, played.bodies) /
                    c.exact.scene.object->hierarchy.radius;
}

Row row_of(const std::string& scene, const MethodRun& ours, const MethodRun& shell) {
  Row row;
  row.name = scene + ", " + ours.name;
  row.unit = "us";
  row.ours = ours.figure();
  row.contacts_ours = ours.contacts();
  row.found_ours = ours.quality;
  row.baseline = "point shell, tree, both ways";
  row.theirs = shell.figure();
  row.contacts_baseline = shell.contacts();
  row.found_baseline = shell.quality;
  return row;
}

std::string told(const ProxyCase& c, const std::vector<AskedQuery>& asked) {
  std::vector<double> share;
  const double radius = c.exact.scene.object->hierarchy.radius;
  for (const AskedQuery& query : asked) share.push_back(100.0 * query.tolerance / radius);
  std::sort(share.begin(), share.end());
  return std::string(c.exact.is_default ? "" : "the scene's own response is another; ") +
         std::to_string(asked.size()) + " frames; tolerance " +
         number("%.2f", share[share.size() / 2]) + " % of the radius in the median, " +
         number("%.2f", share.back()) + " % at most; both shells " +
         number("%.0f", static_cast<double>(c.shells.bytes()) / 1048576.0) + " MiB";
}

std::vector<Row> measure_scene(const Recorded& recorded, bool quick) {
  const std::string& name = recorded.scene;
  const double seconds = quick ? kQuickSeconds : recorded.seconds;
  const std::unique_ptr<ProxyCase> c = make_case(name, seconds, quick);
  const ContactWorld& world = c->exact_session.config.contact;
  const std::vector<AskedQuery> asked = asked_on(world, c->path.bodies);
  c->shells = build_shells(c->exact.scene, asked);
  MethodRun query{"exact, all measured"}, rows{"exact, all measured, and its rows"};
  MethodRun carried{"exact, as the session asks"}, carried_rows{"exact, and its rows"};
  ContactWorld measuring = world;
  measuring.resolution.carry = 0.0;
  MethodRun far{"levels far away, s0 = 2.5 %"}, far_rows{"levels far away, and their rows"};
  MethodRun shell{"point shell"};
  for (int run = 0; run < kRuns; ++run) {  // by turns, so that all see the same machine
    run_engine(measuring, c->path.bodies, query, rows);
    run_shell(c->shells, asked, shell);
    run_engine(world, c->path.bodies, carried, carried_rows);
    run_engine(c->far_session.config.contact, c->path.bodies, far, far_rows);
  }
  const Checked truth = find_truths(world, asked, quick ? 10 : recorded.checked);
  for (MethodRun* method : {&query, &rows, &carried, &shell}) compare_reports(truth, *method);
  judge(*c, c->path, query.quality);
  judge(*c, c->path, rows.quality);
  const double share = world.resolution.carry;
  judge(*c, play_engine(c->exact, seconds, share), carried.quality);
  carried_rows.quality = carried.quality;
  judge(*c, play_engine(c->far, seconds), far.quality);
  far_rows.quality = far.quality;
  SceneSession session = open_proxy_session(c->exact);
  judge(*c, play_shell(session, c->shells, seconds), shell.quality);
  std::vector<Row> out;
  for (const MethodRun* method : {&query, &rows, &carried, &carried_rows, &far, &far_rows})
    out.push_back(row_of(name, *method, shell));
  for (Row& row : out) row.note = told(*c, asked);
  return out;
}

Measurement measurement_of(const Recorded& recorded, bool quick) {
  return {"proxy-" + recorded.scene, [=] { return measure_scene(recorded, quick); }, true};
}

}  // namespace

std::vector<Measurement> proxy_measurements(bool quick) {
  std::vector<Measurement> out;
  for (const Recorded& recorded : kRecorded) out.push_back(measurement_of(recorded, quick));
  return out;
}

Measurement proxy_measurement(const std::string& scene, bool quick) {
  check_can_measure(read_scene(scene), scene);
  return measurement_of({.scene = scene}, quick);
}

}  // namespace thigma::bench
