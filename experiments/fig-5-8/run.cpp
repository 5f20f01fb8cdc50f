// Fig. 5.8: a spoon pressed in the handle of a cup; one recorded motion played with two integrators
// and two stiffnesses.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>

#include "experiments/common/all_experiments.h"
#include "experiments/common/coupled_run.h"
#include "experiments/common/statistics.h"

namespace thigma::experiments {
namespace fig_5_8 {
namespace {

constexpr double kTolerance = 2e-5;          // of the response [m]
constexpr double kAngularDamping = 8.94e-3;  // as in Fig. 5.6, for every mass [N m s/rad]
constexpr double kSettled = 0.15;            // after the first touch [s]

struct Setting {
  const char* name;
  Integrator integrator;
  double mass, stiffness;
};

constexpr Setting kSettings[] = {
    {"RK4, 100 g, 2 kN/m", Integrator::runge_kutta, 0.100, 2000.0},
    {"BE, 10 g, 2 kN/m", Integrator::implicit_tangent, 0.010, 2000.0},
    {"BE, 100 g, 10 kN/m", Integrator::implicit_tangent, 0.100, 10000.0}};

/// How contacts answer: what the text does not say of them.
struct Answer {
  double damping = 0.0;  // of the contacts, of critical; the text has one and names no number
  int every = 1;         // haptic frames a contact frame
  int clusters = 5;      // K
  bool distributes_wide_contacts = true;  // contacts of large patches, see distribute_contacts.h
};

CoupledSetup setup_for(const SessionPair& session, const LedMotion& motion, const Setting& s,
                       const Answer& answer) {
  CoupledSetup setup = setup_of(session, motion);
  const double share = s.mass / setup.body.mass;
  setup.body = make_body(s.mass, setup.body.inertia * share);
  setup.start.linear_momentum *= share;
  setup.start.angular_momentum *= share;
  setup.coupling.linear_damping = 2.0 * std::sqrt(setup.coupling.linear_stiffness * s.mass);
  setup.coupling.angular_damping = kAngularDamping;
  setup.integrator = s.integrator;
  setup.contact.response.stiffness = s.stiffness;
  setup.contact.response.damping = 2.0 * answer.damping * std::sqrt(s.stiffness * s.mass);
  setup.contact_every = answer.every;
  setup.contact.max_clusters = answer.clusters;
  setup.contact.distributes_wide_contacts = answer.distributes_wide_contacts;
  return setup;
}

struct Ran {
  std::vector<CoupledFrame> frames;
  std::vector<double> contact, coupling, depth;
  double ripple = 0.0, deepest = 0.0, coincide = 0.0, peak = 0.0;
};

Ran play(const SessionPair& session, const LedMotion& motion, const Setting& setting,
         const Answer& answer) {
  const CoupledSetup setup = setup_for(session, motion, setting, answer);
  Ran ran;
  ran.frames = run_coupled(setup, motion.handle);
  ran.contact = contact_force(ran.frames);
  const auto from = static_cast<std::size_t>((motion.first_touch + kSettled) / setup.period);
  ran.ripple = ran.frames.size() == motion.handle.size()
                   ? ripple(ran.contact, from, motion.handle.size(), setup.period)
                   : std::numeric_limits<double>::infinity();
  return ran;
}

/// What only the three runs of the figure need.
void measure_depth(const SessionPair& session, const LedMotion& motion, const Setting& setting,
                   Ran& ran) {
  const CoupledSetup setup = setup_for(session, motion, setting, {});
  ran.coupling = coupling_force(ran.frames);
  ran.depth = exact_depths(setup.contact, ran.frames, 2, kTolerance);
  const auto from = static_cast<std::size_t>((motion.first_touch + kSettled) / setup.period);
  for (const double d : ran.depth) ran.deepest = std::max(ran.deepest, d);
  for (const double f : ran.coupling) ran.peak = std::max(ran.peak, f);
  if (ran.frames.size() > from) {
    ran.coincide =
        relative_error(std::span(ran.contact).subspan(from), std::span(ran.coupling).subspan(from));
  }
}

/// sweep.csv: the ripples of the three settings for other answers of the contacts.
Table sweep_answers(const Context& context, const SessionPair& session, const LedMotion& motion) {
  Table table{.name = "sweep",
              .columns = {"sweep", "contact damping, of critical", "contact rate [Hz]", "clusters",
                          "spread", "ripple: RK4, 100 g, 2 kN/m [N]", "BE, 10 g, 2 kN/m [N]",
                          "BE, 100 g, 10 kN/m [N]", "RK4 over BE", "BE 10 kN/m over BE"}};
  const auto add = [&](const char* sweep, const Answer& answer) {
    tell(context, std::string("sweep: ") + sweep);
    double ripples[3];
    for (std::size_t i = 0; i < 3; ++i)
      ripples[i] = play(session, motion, kSettings[i], answer).ripple;
    add_row(table,
            {sweep, answer.damping, session.config.rate / answer.every,
             static_cast<double>(answer.clusters), answer.distributes_wide_contacts ? 1.0 : 0.0,
             ripples[0], ripples[1], ripples[2], ripples[0] / ripples[1], ripples[2] / ripples[1]});
  };
  for (const double damping : {0.0, 0.03, 0.1, 0.3, 0.7}) add("damping", {damping, 1});
  for (const int every : {1, 2, 3, 5, 10}) add("rate", {0.0, every});
  for (const int clusters : {16, 5, 2, 1}) add("clusters", {0.0, 1, clusters, false});
  return table;
}

/// integrators.csv: ripples at 100 g over that of the stable run, with an integrator that damps and
/// one that does not.
Table sweep_integrators(const Context& context, const SessionPair& session, const LedMotion& motion,
                        double stable) {
  Table table{
      .name = "integrators",
      .columns = {"integrator", "stiffness [N/m]", "ripple at 100 g [N]", "over the stable run"}};
  for (const double stiffness : {2000.0, 5000.0, 10000.0}) {
    for (const Integrator integrator : {Integrator::runge_kutta, Integrator::implicit_tangent}) {
      const char* name = integrator == Integrator::runge_kutta ? "Runge-Kutta" : "backward Euler";
      tell(context, std::string("sweep: ") + name);
      const double ripple = play(session, motion, {name, integrator, 0.100, stiffness}, {}).ripple;
      add_row(table, {name, stiffness, ripple, ripple / stable});
    }
  }
  return table;
}

/// From the last two rows of integrators.csv.
std::string why_calm(const Table& integrators) {
  const auto over = [&](std::size_t from_end) {
    return std::get<double>(integrators.rows[integrators.rows.size() - from_end][3]);
  };
  char text[320];
  std::snprintf(text, sizeof text,
                "backward Euler damps what jumps of the contact points set off: at the same mass "
                "and stiffness "
                "Runge-Kutta, which does not, has %.1f times the ripple of the stable run, "
                "backward Euler %.1f times; "
                "damping, rate and number of the contacts change little (sweep.csv)",
                over(2), over(1));
  return text;
}

void draw(const Setting& setting, const Ran& ran, double period, Outcome& outcome) {
  plot::Series depth{.label = setting.name}, stretch, contact, coupling;
  for (std::size_t i = 0; i < ran.frames.size(); ++i) {
    const double t = static_cast<double>(i) * period;
    add_row(outcome.tables[0],
            {setting.name, t, i % 2 == 0 ? ran.depth[i / 2] : ran.depth[(i - 1) / 2],
             ran.frames[i].stretch, ran.contact[i], ran.coupling[i],
             static_cast<double>(ran.frames[i].contacts)});
    for (plot::Series* s : {&stretch, &contact, &coupling}) s->x.push_back(t);
    stretch.y.push_back(1e3 * ran.frames[i].stretch);
    contact.y.push_back(ran.contact[i]);
    coupling.y.push_back(ran.coupling[i]);
    if (i % 2 != 0) continue;
    depth.x.push_back(t);
    depth.y.push_back(1e3 * ran.depth[i / 2]);
  }
  const plot::Series* all[] = {&depth, &stretch, &contact, &coupling};
  for (std::size_t i = 0; i < 4; ++i) outcome.figure.panels[i].series.push_back(*all[i]);
}

}  // namespace
}  // namespace fig_5_8

Outcome run_fig_5_8(const Context& context) {
  using namespace fig_5_8;
  SessionPair session = session_pair(*context.assets, "simple_cup_spoon", 3.0);
  SessionConfig& config = session.config;
  config.contact.resolution.is_exact = true;
  config.contact.tolerance = kTolerance;
  config.contact.response.is_divided_among_clusters = false;  // Eq. 5.37: k for each cluster
  Coupling& coupling = config.haptic.coupling;
  coupling.linear_saturation.reset();
  coupling.angular_saturation.reset();
  tell(context, "leading the spoon");
  const LedMotion motion = lead(session, "hand:?path=slide&force=0.8", 0.15, 0.65);
  Outcome outcome;
  outcome.tables = {{.columns = {"setting", "time [s]", "depth [m]", "coupling deviation [m]",
                                 "contact force [N]", "coupling force [N]", "contacts"}}};
  outcome.figure = {.title = "Spoon and cup in contact (Fig. 5.8)",
                    .note =
                        "one motion of the simulated hand, played with three settings; depth "
                        "between the meshes",
                    .panels = {{.x = {.label = "time [s]"}, .y = {.label = "depth [mm]"}},
                               {.x = {.label = "time [s]"}, .y = {.label = "deviation [mm]"}},
                               {.x = {.label = "time [s]"}, .y = {.label = "contact force [N]"}},
                               {.x = {.label = "time [s]"}, .y = {.label = "coupling force [N]"}}},
                    .columns = 2};
  std::vector<Ran> ran;
  for (const Setting& setting : kSettings) {
    tell(context, setting.name);
    ran.push_back(play(session, motion, setting, {}));
    measure_depth(session, motion, setting, ran.back());
    draw(setting, ran.back(), 1.0 / config.rate, outcome);
  }
  outcome.tables.push_back(sweep_answers(context, session, motion));
  outcome.tables.push_back(sweep_integrators(context, session, motion, ran[1].ripple));
  outcome.claims = {
      above("oscillates-rk4", "contact force faster than 20 Hz, RK4 at 100 g, over the stable run",
            ran[0].ripple / ran[1].ripple, 3.0),
      known_not_to(above("oscillates-stiff", "the same, backward Euler at 100 g and 10 kN/m",
                         ran[2].ripple / ran[1].ripple, 3.0),
                   {why_calm(outcome.tables.back()), "integrators.csv", 1.5}),
      at_most("steady", "the same in the stable run, backward Euler at 10 g and 2 kN/m, in newtons",
              ran[1].ripple, 0.05, "N"),
      at_most("depth-2k", "deepest at 2 kN/m, between exact meshes", 1e3 * ran[1].deepest, 0.6,
              "mm"),
      at_most("depth-10k", "deepest at 10 kN/m", 1e3 * ran[2].deepest, 0.2, "mm"),
      at_most("coincide",
              "contact against coupling force in the stable run, root mean square of "
              "the difference",
              ran[1].coincide, 0.1),
      stated("peak", "largest coupling force in the stable run (source: 0.8 N)", ran[1].peak, "N")};
  return outcome;
}

}  // namespace thigma::experiments
