#include "experiments/fig-5-10/ways.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>

#include "experiments/common/outside_depth.h"

#include "thigma/math/quantile.h"
#include "thigma/session/session_config.h"

namespace thigma::experiments::fig_5_10 {
namespace {

DepthSurface depth_surface(const std::string& jaw, const Context& context) {
  return make_depth_surface(make_mesh(model_uri(jaw, context.quick ? kQuickTriangles : 0)));
}

/// Ripple, peak and mean level of frames.
void judge(const LedMotion& motion, double period, Ran& ran) {
  ran.coupling = coupling_force(ran.frames);
  const auto from = static_cast<std::size_t>((motion.first_touch + kSettled) / period);
  const bool is_whole = ran.frames.size() == motion.handle.size();
  ran.ripple = is_whole ? ripple(ran.coupling, from, ran.coupling.size(), period)
                        : std::numeric_limits<double>::infinity();
  for (const double f : ran.coupling) ran.peak = std::max(ran.peak, f);
  for (const CoupledFrame& f : ran.frames)
    ran.level += f.level / static_cast<double>(ran.frames.size());
}

}  // namespace

Ran play(const CoupledSetup& base, const LedMotion& motion, const Way& way) {
  CoupledSetup setup = base;
  setup.contact.resolution.metric.haptic = way.threshold;
  setup.contact.resolution.is_exact = way.threshold == 0.0;
  setup.contact.resolution.deviation_cap = way.cap;
  setup.contact.max_clusters = way.clusters;
  setup.contact.response.stiffness = way.stiffness;
  setup.contact.response.damping *= std::sqrt(way.stiffness / kStiffness);
  setup.contact_every = way.every;
  setup.is_linearized = way.is_linearized;
  Ran ran;
  ran.frames = run_coupled(setup, motion.handle);
  judge(motion, setup.period, ran);
  return ran;
}

void add(const Way& way, const Ran& ran, Outcome& outcome) {
  add_row(outcome.tables[0],
          {way.series, way.threshold, 1000.0 / way.every, way.is_linearized ? 1.0 : 0.0,
           static_cast<double>(way.clusters), way.cap, way.stiffness, ran.ripple, ran.peak,
           ran.level, ran.deepest, ran.settled, static_cast<double>(ran.frames.size())});
  char label[64];
  std::snprintf(label, sizeof label, "%.1f %%, %.0f Hz%s", 100.0 * way.threshold,
                1000.0 / way.every, way.is_linearized ? "" : ", held");
  plot::Series force{.label = label}, stretch;
  for (std::size_t i = 0; i < ran.frames.size(); i += 2) {
    force.x.push_back(1e-3 * static_cast<double>(i));
    force.y.push_back(std::min(ran.coupling[i], 20.0));
    stretch.x.push_back(force.x.back());
    stretch.y.push_back(std::min(1e3 * ran.frames[i].stretch, 20.0));
  }
  plot::Figure& figure = outcome.figure;
  const bool is_constrained = std::string(way.series) == "constraint";
  figure.panels[is_constrained ? 3 : way.is_linearized ? 0 : 1].series.push_back(force);
  if (way.is_linearized && !is_constrained) figure.panels[2].series.push_back(stretch);
}

void run_constrained(const Context& context, const SessionPair& session, const LedMotion& motion,
                     Outcome& outcome) {
  SessionConfig config = session.config;
  use_constraints(config);
  CoupledSetup setup = setup_of(session, motion);
  setup.contact = config.contact;
  setup.constraint = config.haptic.constraint;
  const DepthSurface object = depth_surface("jaw_upper", context);
  const DepthSurface scene = depth_surface("jaw_lower", context);
  const Pose scene_from_world = inverse(config.contact.scene[0].world_from_body);
  double rippled = 0.0, deepest = 0.0, peak = 1e300;
  for (const int every : {2, 4, 10, 20}) {
    tell(context, "constraints at every " + std::to_string(every));
    setup.contact_every = every;
    Ran ran;
    ran.frames = run_coupled(setup, motion.handle);
    judge(motion, setup.period, ran);
    std::vector<double> depth;
    DepthMemory memory;
    for (std::size_t k = 0; k < ran.frames.size(); k += context.quick ? 20 : 5) {
      const BodyState& y = ran.frames[k].body;
      const Pose pose = Pose{y.position, y.orientation} * config.contact.body_from_mesh;
      depth.push_back(outside_depth(object, scene_from_world * pose, scene, memory));
    }
    ran.deepest = *std::max_element(depth.begin(), depth.end());
    ran.settled = sample_quantile(depth, 0.5);
    add({"constraint", 0.0, every, true, 0, 0.0, 0.0}, ran, outcome);
    if (every <= 10) rippled = std::max(rippled, ran.ripple);
    deepest = std::max(deepest, ran.deepest);
    peak = std::min(peak, ran.peak);
  }
  for (Claim& claim :
       std::vector<Claim>{at_most("constraint-stable",
                                  "ripple of the coupling force with constraints, at 100 Hz and "
                                  "above",
                                  rippled, kCalm, "N"),
                          at_most("constraint-depth",
                                  "deepest between the meshes with constraints at 500 to 50 Hz, by "
                                  "code outside the engine",
                                  1e3 * deepest, 0.02, "mm"),
                          at_least("constraint-peak", "largest coupling force of those runs, least",
                                   peak, 1.0, "N")})
    outcome.claims.push_back(std::move(claim));
}

}  // namespace thigma::experiments::fig_5_10
