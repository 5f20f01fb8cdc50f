#include "experiments/level-choice/pose_frame.h"

#include <algorithm>
#include <limits>

#include "benchmarks/point_cells.h"
#include "benchmarks/probe.h"

#include "thigma/contact/clustering.h"
#include "thigma/contact/query_contacts.h"
#include "thigma/response/direct.h"

namespace thigma::experiments::level_choice {
namespace {

constexpr std::size_t kRoom = 400'000;
constexpr std::size_t kBurst = 4;  // frames before a sample is taken, the last three timed
constexpr int kClusters = 16;      // of the force that is compared
// exact contacts of a pose that recall is taken over, at most
constexpr std::size_t kCompared = 2000;

void add_force(PoseFrame& frame, double tolerance) {
  ContactClusters clusters;
  ClusterScratch scratch;
  cluster_contacts(frame.contacts, {}, {.max_clusters = kClusters, .tolerance = tolerance}, scratch,
                   clusters);
  for (const ContactCluster& c : clusters.clusters)
    frame.force -= std::max(c.depth + tolerance, 0.0) * c.normal;
  PenaltyParams shared;
  shared.stiffness = 1.0;
  shared.damping = 0.0;
  shared.tolerance = tolerance;
  shared.is_divided_among_clusters = true;
  frame.shared_force = direct_wrench(clusters, shared, Vec3::Zero()).force;
}

/// Runs a query on the poses up to a sample; the first starts from the root.
template <class Query>
std::vector<double> time_burst(const TouchedPair& pair, std::size_t sample, Query query) {
  std::vector<double> times;
  for (std::size_t i = sample - std::min(sample, kBurst - 1); i <= sample; ++i) {
    const double start = bench::thread_cpu();
    query(pair.touching[i]);
    times.push_back(bench::thread_cpu() - start);
  }
  if (times.size() > 1) times.erase(times.begin());
  return times;
}

/// Points of the object lie on it, those of the scene on the scene; the other end is depth away
/// along the normal.
Contact contact_of(const bench::ShellContact& c) {
  Contact contact;
  contact.point = c.is_of_object ? c.point : Vec3(c.point + c.depth * c.normal);
  contact.scene_point = c.is_of_object ? Vec3(c.point - c.depth * c.normal) : c.point;
  contact.normal = c.normal;
  contact.depth = c.depth;
  return contact;
}

/// What least_separation makes of the contacts in memory.
void add_narrowed(const TouchedPair& pair, std::size_t sample, QueryMemory& memory,
                  PoseFrame& frame) {
  const ContactWorld& world = pair.session.config.contact;
  const SceneBody& body = world.scene.front();
  const SeparationQuery query{.tolerance = world.tolerance};
  const double start = bench::thread_cpu();
  frame.narrowed = thigma::least_separation({*world.object, pair.touching[sample]},
                                            {*body.hierarchy, body.world_from_body}, memory.set,
                                            query, memory.separation);
  frame.narrowing = bench::thread_cpu() - start;
}

std::vector<Vec3> middles_of(const std::vector<Contact>& contacts, std::size_t step = 1) {
  std::vector<Vec3> middles;
  for (std::size_t i = 0; i < contacts.size(); i += step)
    middles.push_back(0.5 * (contacts[i].point + contacts[i].scene_point));
  return middles;
}

}  // namespace

QueryMemory make_memory(const TouchedPair& pair) {
  const ContactWorld& world = pair.session.config.contact;
  QueryMemory memory;
  reserve_front(memory.front, *world.object, *world.scene.front().hierarchy);
  reserve_separation(memory.separation, *world.object, *world.scene.front().hierarchy);
  memory.set.contacts.reserve(kRoom);
  return memory;
}

PoseFrame query_at(const TouchedPair& pair, std::size_t sample, const Resolution& resolution,
                   QueryMemory& memory) {
  const ContactWorld& world = pair.session.config.contact;
  const SceneBody& body = world.scene.front();
  const ContactQuery query{.tolerance = world.tolerance, .resolution = resolution};
  PoseFrame frame;
  clear_front(memory.front);
  frame.query = time_burst(pair, sample, [&](const Pose& pose) {
    clear(memory.set);
    query_contacts({*world.object, pose}, {*body.hierarchy, body.world_from_body}, query,
                   memory.front, memory.set);
  });
  frame.contacts = memory.set.contacts;
  frame.front = static_cast<double>(memory.set.stats.front);
  add_force(frame, world.tolerance);
  if (!resolution.is_exact) add_narrowed(pair, sample, memory, frame);
  return frame;
}

PoseFrame query_at(const TouchedPair& pair, std::size_t sample, const ShellPair& shells,
                   QueryMemory& memory) {
  const ContactWorld& world = pair.session.config.contact;
  const Pose& world_from_scene = world.scene.front().world_from_body;
  PoseFrame frame;
  frame.query = time_burst(pair, sample, [&](const Pose& pose) {
    query_shells(shells.object, pose, shells.scene, world_from_scene, world.tolerance,
                 memory.shell);
  });
  for (const bench::ShellContact& c : memory.shell) frame.contacts.push_back(contact_of(c));
  frame.front = std::numeric_limits<double>::quiet_NaN();
  add_force(frame, world.tolerance);
  return frame;
}

double recall_of(const PoseFrame& exact, const PoseFrame& frame, double near) {
  const std::vector<Vec3> asked = middles_of(exact.contacts, exact.contacts.size() / kCompared + 1);
  const bench::PointCells cells = bench::sort_into_cells(middles_of(frame.contacts), near);
  const auto found = std::count_if(
      asked.begin(), asked.end(), [&](const Vec3& p) { return bench::has_point_within(cells, p); });
  return static_cast<double>(found) / static_cast<double>(asked.size());
}

LeastSeparation least_separation(const PoseFrame& frame) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  LeastSeparation least{kFar, kFar, kFar};
  for (const Contact& c : frame.contacts) {
    least.reported = std::min(least.reported, -c.depth);
    least.low = std::min(least.low, -c.depth - c.bound);
    least.high = std::min(least.high, -c.depth + c.bound);
  }
  return least;
}

}  // namespace thigma::experiments::level_choice
