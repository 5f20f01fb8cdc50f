#include "contact_table.h"

#include <chrono>
#include <cmath>
#include <cstdio>
#include <string>

#include "thigma/core/cpu_clock.h"
#include "thigma/core/error.h"

namespace thigma::bindings {
namespace {

constexpr double kUnitTolerance = 1e-6;            // of |q| - 1, docs/formats.md
constexpr std::size_t kMostContacts = 20'000'000;  // of a pose, as of `thigma contacts`
constexpr std::size_t kFirstCapacity = 16'384;
constexpr auto kPollPeriod = std::chrono::milliseconds(100);

void append(const ContactSet& set, double cpu, ContactTable& table) {
  table.distance.push_back(least_distance(set));
  table.cpu.push_back(cpu);
  table.front.push_back(set.stats.front);
  table.tests.push_back(set.stats.tests);
  for (const Contact& c : set.contacts) {
    table.point.push_back(c.point);
    table.scene_point.push_back(c.scene_point);
    table.normal.push_back(c.normal);
    table.depth.push_back(c.depth);
    table.bound.push_back(c.bound);
    table.level.push_back({c.object_level, c.scene_level});
  }
  table.start.push_back(static_cast<std::int64_t>(table.depth.size()));
}

}  // namespace

void check_query(const ContactQuery& query) {
  const Resolution& r = query.resolution;
  const auto refuse = [](const char* what) { throw InputError(std::string("contacts: ") + what); };
  if (!(query.tolerance >= 0.0) || !std::isfinite(query.tolerance))
    refuse("tolerance must be a finite length >= 0 [m]");
  if (!(r.step_time > 0.0) || !std::isfinite(r.step_time))
    refuse("step_time must be a finite time above 0 [s]");
  if (!(r.metric.haptic >= 0.0) || !std::isfinite(r.metric.haptic))
    refuse("threshold must be a fraction of the radius, 0 or more (0.025 is 2.5 %)");
  if (!(r.metric.velocity >= 0.0) || !std::isfinite(r.metric.velocity))
    refuse("velocity must be a time, 0 or more [s]");
  if (!(r.deviation_cap > 0.0)) refuse("deviation_cap must be a fraction of the radius above 0");
  if (r.budget_tests < 0) refuse("budget_tests must be 0 or more");
  if (!(r.budget_cpu >= 0.0 && r.budget_cpu < 1e3))
    refuse("budget_cpu must be at least 0 and below 1000 s");
}

bool needs_room(ContactSet& set, std::size_t pose) {
  if (set.dropped == 0) return false;
  const std::size_t wanted = set.contacts.size() + static_cast<std::size_t>(set.dropped);
  if (wanted > kMostContacts) {
    throw InputError("contacts: " + std::to_string(wanted) + " contacts at pose " +
                     std::to_string(pose) + ", at most " + std::to_string(kMostContacts) +
                     " can be listed; expected a smaller tolerance");
  }
  set.contacts.reserve(wanted + wanted / 4);
  return true;
}

ContactTable contacts_at_poses(const ClodHierarchy& object, const PlacedHierarchy& scene,
                               std::span<const Pose> poses, const TableQuery& query,
                               const Poll& poll) {
  check_query(query.contact);
  ContactTable table;
  table.distance.reserve(poses.size());
  table.start.reserve(poses.size() + 1);
  ContactFront front;
  reserve_front(front, object, scene.hierarchy);
  ContactSet set;
  set.contacts.reserve(kFirstCapacity);
  auto polled = std::chrono::steady_clock::now();
  for (std::size_t i = 0; i < poses.size(); ++i) {
    double cpu = 0.0;
    do {
      clear(set);
      if (query.is_fresh) clear_front(front);
      const double start = thread_cpu_seconds();
      query_contacts({object, poses[i]}, scene, query.contact, front, set);
      cpu = thread_cpu_seconds() - start;
    } while (needs_room(set, i));
    append(set, cpu, table);
    if (!poll || i % 16 != 0) continue;
    const auto now = std::chrono::steady_clock::now();
    if (now - polled < kPollPeriod) continue;
    poll();
    polled = now;
  }
  return table;
}

std::vector<Pose> poses_from_rows(std::span<const double> rows, const char* name) {
  std::vector<Pose> poses(rows.size() / 7);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const double* v = rows.data() + 7 * i;
    const auto refuse = [&](const std::string& what, const char* expected) {
      throw InputError(std::string(name) + ": " + what + ", row " + std::to_string(i) +
                       ", expected " + expected);
    };
    for (int k = 0; k < 7; ++k)
      if (!std::isfinite(v[k])) refuse(std::to_string(v[k]), "finite numbers");
    const double length = std::sqrt(v[3] * v[3] + v[4] * v[4] + v[5] * v[5] + v[6] * v[6]);
    if (!(std::fabs(length - 1.0) <= kUnitTolerance))
      refuse("quaternion of length " + std::to_string(length), "length 1 to 1e-6");
    poses[i].position = Vec3(v[0], v[1], v[2]);
    poses[i].orientation = Quat(v[6] / length, v[3] / length, v[4] / length, v[5] / length);
  }
  return poses;
}

}  // namespace thigma::bindings
