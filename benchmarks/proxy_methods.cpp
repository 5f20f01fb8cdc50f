#include "benchmarks/proxy_methods.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>

#include "benchmarks/point_cells.h"
#include "benchmarks/probe.h"
#include "benchmarks/shell_rows.h"

#include "thigma/constraint/build_constraints.h"
#include "thigma/contact/query_contacts.h"

namespace thigma::bench {
namespace {

constexpr std::size_t kRoom = 400'000;  // contacts of a fresh query

Pose pose_of(const ContactWorld& world, const BodyState& state) {
  return Pose{state.position, state.orientation} * world.body_from_mesh;
}

/// Takes a run's time of a frame.
void take(std::size_t frame, double seconds, MethodRun& run) {
  if (frame == run.seconds.size())
    run.seconds.push_back(seconds);
  else
    run.seconds[frame] = std::min(run.seconds[frame], seconds);
}

/// The exact query at a place, remembering the last.
struct ExactAsker {
  const ContactWorld& world;
  ContactFront front{};
  ContactSet set{};

  explicit ExactAsker(const ContactWorld& w) : world(w) {
    reserve_front(front, *world.object, *world.scene.front().hierarchy);
    set.contacts.reserve(kRoom);
  }
  void ask(const Pose& pose, const ContactQuery& query) {
    query_scene({*world.object, pose}, {world.scene.data(), 1}, query, {&front, 1}, set);
  }
};

}  // namespace

double MethodRun::contacts() const {
  double sum = 0.0;
  for (const Report& report : reports) sum += static_cast<double>(report.points.size());
  return reports.empty() ? 0.0 : sum / static_cast<double>(reports.size());
}

std::vector<AskedQuery> asked_on(const ContactWorld& world,
                                 const std::vector<StampedBody>& bodies) {
  ContactScratch scratch;
  reserve_contact_scratch(world, scratch);
  const auto sample = std::make_unique<ContactSample>();
  std::vector<AskedQuery> asked;
  for (const StampedBody& body : bodies) {
    contact_step(world, body, scratch, *sample);
    asked.push_back({pose_of(world, body.state), scratch.looked_ahead, scratch.separation});
  }
  return asked;
}

ShellPair build_shells(const Scene& scene, const std::vector<AskedQuery>& asked) {
  const LoadedObject object = load_object(scene.description.object);
  const SceneObject& other = scene.description.statics.front();
  const LoadedObject fixed = load_object(other);
  std::vector<double> tolerances;
  for (const AskedQuery& query : asked)
    if (!(query.separation > query.tolerance)) tolerances.push_back(query.tolerance);
  std::sort(tolerances.begin(), tolerances.end());
  const double wide = tolerances.empty() ? 0.0 : tolerances[tolerances.size() * 9 / 10];
  const double radius = std::min(object.ball.radius, fixed.ball.radius);
  const auto shell = [&](const LoadedObject& of) {
    const double band = std::max({0.03 * radius, 0.02 * of.ball.radius, wide});
    return build_point_shell(of.mesh, {.field = {.band = band}});
  };
  return {shell(object), shell(fixed), other.world_from_mesh};
}

void run_engine(const ContactWorld& world, const std::vector<StampedBody>& bodies, MethodRun& query,
                MethodRun& whole) {
  ContactScratch scratch;
  reserve_contact_scratch(world, scratch);
  const auto sample = std::make_unique<ContactSample>();
  const bool is_first = query.reports.empty();
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const double start = thread_cpu();
    find_contacts(world, bodies[i], scratch);
    const double found = thread_cpu();
    make_model(world, bodies[i], scratch, *sample);
    const double end = thread_cpu();
    take(i, found - start, query);
    take(i, end - start, whole);
    if (!is_first) continue;
    query.reports.push_back(report_of(scratch.contacts));
    whole.reports.push_back(query.reports.back());
  }
}

void run_shell(const ShellPair& shells, const std::vector<AskedQuery>& asked, MethodRun& out) {
  std::vector<ShellContact> contacts;
  const bool is_first = out.reports.empty();
  for (std::size_t i = 0; i < asked.size(); ++i) {
    const double start = thread_cpu();
    query_shells(shells.object, asked[i].world_from_object, shells.scene, shells.world_from_scene,
                 asked[i].tolerance, contacts);
    take(i, thread_cpu() - start, out);
    if (is_first) out.reports.push_back(report_of_depths(contacts));
  }
}

Checked find_truths(const ContactWorld& world, const std::vector<AskedQuery>& asked, int frames) {
  Checked out;
  out.radius = std::min(world.object->radius, world.scene.front().hierarchy->radius);
  for (int i = 0; i < frames; ++i) {
    const std::size_t frame =
        static_cast<std::size_t>(2 * i + 1) * asked.size() / (2 * static_cast<std::size_t>(frames));
    ExactAsker fresh(world);
    fresh.ask(asked[frame].world_from_object, {.tolerance = asked[frame].tolerance});
    out.frames.push_back(frame);
    out.tolerances.push_back(asked[frame].tolerance);
    out.reports.push_back(report_of(fresh.set));
  }
  return out;
}

void compare_reports(const Checked& truth, MethodRun& method) {
  constexpr double kReach = 0.02;  // by the radius, as the bench's other pairs
  double exact = 0.0, found = 0.0, sum = 0.0, most = 0.0;
  for (std::size_t k = 0; k < truth.frames.size(); ++k) {
    const Report& report = method.reports[truth.frames[k]];
    const double d = truth.tolerances[k];
    const PointCells cells = sort_into_cells(report.points, kReach * truth.radius);
    for (const Vec3& point : truth.reports[k].points)
      found += has_point_within(cells, point) ? 1.0 : 0.0;
    exact += static_cast<double>(truth.reports[k].points.size());
    const auto kept = [&](const std::optional<double>& least) {
      return std::min(least.value_or(d), d);
    };
    const double off = std::fabs(kept(report.least) - kept(truth.reports[k].least)) / truth.radius;
    sum += off;
    most = std::max(most, off);
  }
  if (exact > 0.0) method.quality.recall = found / exact;
  method.quality.error_max = most;
  method.quality.error_mean = sum / static_cast<double>(truth.frames.size());
}

PlayedSession play_shell(SceneSession& session, const ShellPair& shells, double seconds) {
  const ContactWorld& world = session.config.contact;
  ContactScratch scratch;
  reserve_contact_scratch(world, scratch);
  std::vector<ShellContact> contacts;
  ShellRowScratch rows;
  const Friction friction = friction_on(world, 0);
  return play_session(session, seconds, [&](const StampedBody& body, ContactSample& sample) {
    contact_step(world, body, scratch, sample);  // how far to look, and the model's stamp
    query_shells(shells.object, pose_of(world, body.state), shells.scene, shells.world_from_scene,
                 scratch.looked_ahead, contacts);
    const double separation = contacts.empty() ? scratch.separation : scratch.looked_ahead;
    make_shell_rows(*world.constraints, body.state, contacts, separation, friction, rows,
                    sample.model.constraints);
  });
}

double deepest_on(const ContactWorld& world, const std::vector<StampedBody>& bodies) {
  constexpr std::size_t kStride = 4;
  ExactAsker asker(world);
  double deepest = 0.0;
  for (std::size_t i = 0; i < bodies.size(); i += kStride) {
    asker.ask(pose_of(world, bodies[i].state),
              {.tolerance = world.constraints->slop, .most_pairs = 6000});
    deepest = std::max(deepest, -least_distance(asker.set));
  }
  return deepest;
}

}  // namespace thigma::bench
