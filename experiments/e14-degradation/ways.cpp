#include "experiments/e14-degradation/ways.h"

#include <string>

#include "experiments/common/statistics.h"

#include "thigma/math/quantile.h"

namespace thigma::experiments::e14_degradation {
namespace {

struct Way {
  const char* name;
  Resolution resolution;
};

std::vector<Way> all_ways() {
  const Resolution levels = as_in_text(0.025);
  Resolution capped = levels, by_patch = levels;
  capped.deviation_cap = 0.02;
  by_patch.reading = SupportReading::patch;
  Resolution carried = by_patch;
  carried.carry = 0.1;
  return {{"s0 = 2.5 %", levels},
          {"s0 = 2.5 %, cap 2 %", capped},
          {"s0 = 2.5 %, one D a patch", by_patch},
          {"s0 = 2.5 %, one D a patch, carried by 0.1 d", carried}};
}

/// Components of the force in every so many frames.
std::vector<double> forces(const Profile& profile, std::size_t stride) {
  std::vector<double> all;
  for (std::size_t i = 0; i < profile.force.size(); i += stride)
    for (int axis = 0; axis < 3; ++axis) all.push_back(profile.force[i][axis]);
  return all;
}

std::vector<double> exact_forces(const WayStudy& study) {
  Path some;
  some.step = study.path.step * study.exact_stride;
  for (std::size_t i = 0; i < study.path.poses.size();
       i += static_cast<std::size_t>(study.exact_stride))
    some.poses.push_back(study.path.poses[i]);
  return forces(replay(study.pair, some, as_in_text(0.0), study.gains, 1, ClusterStart::afresh), 1);
}

}  // namespace

Table way_table() {
  return {.name = "ways",
          .columns = {"pair", "query", "first frame, CPU [us]", "CPU p50 [us]", "CPU p99 [us]",
                      "CPU p99.9 [us]", "CPU most [us]", "contacts mean", "error of the force"}};
}

std::vector<Claim> study_ways(const Context& context, const WayStudy& study, Table& table) {
  const std::string here = std::string(study.name) + ": ";
  const std::vector<double> exact =
      study.exact_stride > 0 ? exact_forces(study) : std::vector<double>{};
  double last = 0.0, usual = 0.0;
  for (const Way& way : all_ways()) {
    tell(context, here + way.name);
    const Profile profile =
        replay(study.pair, study.path, way.resolution, study.gains, 1, ClusterStart::afresh);
    // A front begins empty: once, and before anybody feels anything.
    const std::vector<double> cpu(profile.cpu.begin() + 1, profile.cpu.end());
    last = 1e6 * sample_quantile(cpu, 0.999);
    if (usual == 0.0) usual = last;
    const Cell error =
        exact.empty() ? Cell("")
                      : Cell(relative_error(
                            forces(profile, static_cast<std::size_t>(study.exact_stride)), exact));
    add_row(table, {study.name, way.name, 1e6 * profile.cpu.front(),
                    1e6 * sample_quantile(cpu, 0.5), 1e6 * sample_quantile(cpu, 0.99), last,
                    1e6 * sample_quantile(cpu, 1.0), mean(profile.contacts), error});
  }
  return {
      stated(std::string("p999-levels-") + study.name,
             here + "p99.9 of CPU time at s0 = 2.5 %, but for the first frame", usual, "us"),
      on_this_machine(at_most(std::string("p999-") + study.name,
                              here + "the same with one D a patch and contacts carried by 0.1 d, "
                                     "but for the first frame",
                              last, study.limit, "us"))};
}

}  // namespace thigma::experiments::e14_degradation
