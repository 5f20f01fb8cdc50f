#pragma once
// Ways to answer the queries of a constrained session, timed on its path, and what each answers.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "benchmarks/baselines/point_shell.h"
#include "benchmarks/bench_rows.h"
#include "benchmarks/measure_pair.h"
#include "benchmarks/proxy_path.h"

#include "thigma/loop/contact_step.h"

namespace thigma::bench {

/// What a contact frame asked, as it was answered: where nothing else fits the engine halves the
/// tolerance on the way.
struct AskedQuery {
  Pose world_from_object;   // mesh frame
  double tolerance = 0.0;   // [m]
  double separation = 0.0;  // that the exact answer has proven of all else [m]
};

/// The queries of an exact world on a path of bodies. Thread [offline].
std::vector<AskedQuery> asked_on(const ContactWorld& world, const std::vector<StampedBody>& bodies);

/// Both shells of a scene of one static body.
struct ShellPair {
  PointShell object, scene;
  Pose world_from_scene;
  std::size_t bytes() const { return shell_bytes(object) + shell_bytes(scene); }
};

/// The band of the fields is that of the bench's pairs, or as wide as what nine tenths of the
/// queries ask that find something. Thread [offline].
ShellPair build_shells(const Scene& scene, const std::vector<AskedQuery>& asked);

/// One way: the best time of each frame, and what it answered in the first run.
struct MethodRun {
  std::string name;
  std::vector<double> seconds{};  // [s]
  std::vector<Report> reports{};  // of every frame
  Quality quality{};
  Figure figure() const { return figure_of(seconds, 1e6); }
  double contacts() const;
};

/// Contact frames of a world, from no memory on: the query alone, and with the model.
void run_engine(const ContactWorld& world, const std::vector<StampedBody>& bodies, MethodRun& query,
                MethodRun& whole);

/// The point shells at the same.
void run_shell(const ShellPair& shells, const std::vector<AskedQuery>& asked, MethodRun& out);

/// Fresh exact queries on some frames, evenly.
struct Checked {
  std::vector<std::size_t> frames;
  std::vector<Report> reports;
  std::vector<double> tolerances;  // [m]
  double radius = 0.0;             // the smaller of the two [m]
};
Checked find_truths(const ContactWorld& world, const std::vector<AskedQuery>& asked, int frames);

/// Recall: the share of the exact contacts with a reported one within 2 % of the radius. Error: of
/// the least separation, no more than the tolerance, by the radius.
void compare_reports(const Checked& truth, MethodRun& method);

/// The session in which the shell's contacts make the rows. Its tolerance, and what it has proven
/// of the rest, are those of the exact query at the same place, which is not timed.
PlayedSession play_shell(SceneSession& session, const ShellPair& shells, double seconds);

/// How deep the exact surfaces are through each other at most, on every fourth body [m].
double deepest_on(const ContactWorld& world, const std::vector<StampedBody>& bodies);

}  // namespace thigma::bench
