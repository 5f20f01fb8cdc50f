// Sec. 3.4.4: contacts that change their level of detail must not be felt; `thigma run` on three
// scenes, with interpolation and without.

#include <algorithm>
#include <string_view>

#include "benchmarks/probe.h"
#include "experiments/common/all_experiments.h"
#include "experiments/common/session_pair.h"

#include "thigma/contact/query_contacts.h"
#include "thigma/math/quantile.h"

namespace thigma::experiments {
namespace no_popping {
namespace {

constexpr const char* kScenes[] = {"jaws", "golf", "ball_joint"};
constexpr double kLargest = 1.5;  // step where a level changes over the largest elsewhere

constexpr std::size_t kExactFrames = 200;  // consecutive ones, that the exact query is timed on

/// One way to run a scene.
struct Way {
  const char* name;
  double cap;
  bool interpolates;
};

constexpr Way kWays[] = {{"s0 = 2.5 %", kNoCap, true},
                         {"s0 = 2.5 %; no interpolation", kNoCap, false},
                         {"s0 = 2.5 %, cap 2 %", 0.02, true},
                         {"s0 = 2.5 %, cap 2 %; no interpolation", 0.02, false}};
constexpr std::size_t kDefault = 0, kBare = 1, kCapped = 2;

/// What a way was like, and where the object was while it touched.
struct Ran {
  SessionSummary summary;
  std::vector<Pose> touching;  // world_from_mesh, one a contact frame
};

Ran run_way(SessionPair session, const Way& way) {
  Resolution& resolution = session.config.contact.resolution;
  resolution.is_exact = false;
  resolution.deviation_cap = way.cap;
  resolution.interpolates = way.interpolates;
  const std::unique_ptr<HapticDevice> hand = open_device("hand:", session.hand);
  session.config.haptic.device = hand->limits();
  Ran ran;
  const auto look = [&](const ContactSample& sample) {
    const BodyState& state = sample.model.state;
    if (sample.contacts > 0)
      ran.touching.push_back(Pose{state.position, state.orientation} *
                             session.config.contact.body_from_mesh);
  };
  ran.summary = run_lockstep(session.config, *hand, {.haptic = {}, .contact = look, .event = {}});
  return ran;
}

/// CPU times of the exact query in the middle of a contact, each from the pose of a millisecond
/// before [s].
std::vector<double> time_exact(const SessionPair& session, const std::vector<Pose>& touching) {
  const ContactWorld& world = session.config.contact;
  const SceneBody& body = world.scene.front();
  ContactFront front;
  reserve_front(front, *world.object, *body.hierarchy);
  ContactSet set;
  set.contacts.reserve(400'000);
  std::vector<double> seconds;
  const std::size_t first = touching.size() / 2;
  for (std::size_t i = first; i < std::min(touching.size(), first + kExactFrames + 1); ++i) {
    clear(set);
    const double start = bench::thread_cpu();
    query_contacts({*world.object, touching[i]}, {*body.hierarchy, body.world_from_body},
                   {.tolerance = world.tolerance}, front, set);
    if (i > first) seconds.push_back(bench::thread_cpu() - start);
  }
  return seconds;
}

double step_ratio(const SessionSummary& s) {
  return s.force_steps.contact.level_change / s.force_steps.contact.other;
}

Claim make_larger(const std::vector<SessionSummary>& all) {
  return above(
      "larger", "jaws: the step where a level changes without interpolation over that with it",
      all[kBare].force_steps.contact.level_change / all[kDefault].force_steps.contact.level_change,
      1.0);
}

void add_scene(const std::string& scene, const std::vector<SessionSummary>& all,
               const std::vector<double>& exact, Outcome& outcome) {
  plot::Panel panel{.title = scene,
                    .x = {.label = "way to query"},
                    .y = {.label = "step [N]"},
                    .series = {{.label = "where a level changes", .mark = plot::Mark::points},
                               {.label = "elsewhere", .mark = plot::Mark::points}}};
  for (std::size_t i = 0; i < all.size(); ++i) {
    const SessionSummary& s = all[i];
    const ForceStep& step = s.force_steps.contact;
    add_row(outcome.tables[0],
            {scene, kWays[i].name, step.level_change, step.other, step_ratio(s),
             static_cast<double>(s.force_steps.level_change_frames), s.query_cpu.p50,
             s.query_cpu.p99, s.contacts_mean, s.front_mean, s.force_max});
    for (plot::Series& series : panel.series) series.x.push_back(static_cast<double>(i));
    panel.series[0].y.push_back(step.level_change);
    panel.series[1].y.push_back(step.other);
  }
  outcome.figure.panels.push_back(panel);
  const std::string here = scene + ": ";
  const Claim smooth =
      at_most("smooth-" + scene,
              here +
                  "largest step where a contact changes level over the largest elsewhere, at "
                  "the defaults",
              step_ratio(all[kDefault]), kLargest);
  std::vector<Claim> claims = {
      smooth,
      stated("bare-" + scene, here + "the same without interpolation", step_ratio(all[kBare])),
      stated("capped-" + scene, here + "the same with a cap of 2 % on the deviation",
             step_ratio(all[kCapped])),
      stated(
          "rate-" + scene,
          here + "contact queries a second of CPU time, but for one of a hundred, at the defaults",
          1.0 / all[kDefault].query_cpu.p99, "Hz"),
      stated("rate-exact-" + scene, here + "the same of the exact query, in the middle of contact",
             1.0 / sample_quantile(exact, 0.99), "Hz")};
  for (Claim& claim : claims) outcome.claims.push_back(std::move(claim));
}

}  // namespace
}  // namespace no_popping

Outcome run_no_popping(const Context& context) {
  using namespace no_popping;
  Outcome outcome;
  outcome.tables = {
      {.columns = {"scene", "query", "step where a level changes [N]", "step elsewhere [N]",
                   "ratio", "frames with a change", "query CPU p50 [s]", "query CPU p99 [s]",
                   "contacts mean", "front mean", "largest force [N]"}}};
  outcome.figure = {.title = "Steps of the contact force (Sec. 3.4.4)",
                    .note =
                        "largest from one haptic frame to the next, as `thigma run` has the "
                        "scene; a point a way to query, in the order of data.csv"};
  for (const char* scene : kScenes) {
    const SessionPair session = session_pair(*context.assets, scene, context.quick ? 3.0 : 10.0);
    std::vector<SessionSummary> summaries;
    std::vector<double> exact;
    for (const Way& way : kWays) {
      tell(context, std::string(scene) + ": " + way.name);
      const Ran ran = run_way(session, way);
      if (summaries.empty()) exact = time_exact(session, ran.touching);
      summaries.push_back(ran.summary);
    }
    add_scene(scene, summaries, exact, outcome);
    if (std::string_view(scene) == "jaws") outcome.claims.push_back(make_larger(summaries));
  }
  return outcome;
}

}  // namespace thigma::experiments
