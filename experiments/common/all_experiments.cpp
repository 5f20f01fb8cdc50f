#include "experiments/common/all_experiments.h"

#include "experiments/common/texture_experiments.h"

namespace thigma::experiments {

const std::vector<Experiment>& all_experiments() {
  static const std::vector<Experiment> list = {
      {"table-3-2", "Table 3.2", "levels of detail of the benchmark models", run_table_3_2},
      {"table-3-3", "Table 3.3", "dimples of the golf ball left in the force, over the threshold",
       run_table_3_3},
      {"fig-3-15", "Fig. 3.15", "moving jaws: force, query time and front up to 2.5 %",
       run_fig_3_15},
      {"fig-3-16", "Fig. 3.16", "golf club on ball: the same up to 3 %", run_fig_3_16},
      {"table-4-1", "Table 4.1", "triangles of the textured models", run_table_4_1},
      {"fig-4-8", "Fig. 4.8", "roughness of a wave through probes of several diameters",
       run_fig_4_8},
      {"fig-4-9", "Fig. 4.9", "roughness of a wave under several normal forces", run_fig_4_9},
      {"fig-4-10", "Fig. 4.10", "roughness of a wave at several speeds", run_fig_4_10},
      {"fig-4-14", "Fig. 4.14", "a ridged block dragged over a gear", run_fig_4_14},
      {"fig-4-15", "Fig. 4.15", "a striped block turned in another", run_fig_4_15},
      {"fig-4-16", "Fig. 4.16", "time of a file that scrapes a CAD part, over its contacts",
       run_fig_4_16},
      {"hammer-on-torus", "Sec. 4.5.2",
       "a textured hammer led around a torus; the textured scenes led by a hand",
       run_hammer_on_torus},
      {"fig-5-12", "Fig. 5.12", "a probe on a plate with ridges", run_fig_5_12},
      {"fig-3-18", "Fig. 3.18", "spoon into cup: levels by the velocity-dependent metric",
       run_fig_3_18},
      {"fig-3-19", "Fig. 3.19", "spoon into cup: queries and front up to the first impact",
       run_fig_3_19},
      {"level-choice", "Sec. 3.4.3, 3.5.2",
       "what s0 buys: levels, error and time over the threshold", run_level_choice},
      {"no-popping", "Sec. 3.4.4", "force steps where a contact changes its level of detail",
       run_no_popping},
      {"force-steps", "Sec. 5.4", "force steps over corners, cluster and level switches",
       run_force_steps},
      {"fig-5-4", "Fig. 5.4", "the coupling's saturating spring", run_fig_5_4},
      {"fig-5-6", "Fig. 5.6", "spoon in free space: masses that integrators bear", run_fig_5_6},
      {"fig-5-8", "Fig. 5.8", "spoon and cup in contact: integrators and stiffness", run_fig_5_8},
      {"fig-5-10", "Fig. 5.10", "jaws with and without the linearized contact model", run_fig_5_10},
      {"e1-static-queries", "protocol E1", "fresh queries at predefined distances",
       run_e1_static_queries},
      {"e2-force-quality", "protocol E2", "force and torque on six analytic scenes",
       run_e2_force_quality},
      {"e3-z-width", "protocol E3", "walls that are stable and passive, and what the engine bears",
       run_e3_z_width},
      {"e4-passivity", "protocol E4", "energy at the port, late samples, the passivity controller",
       run_e4_passivity},
      {"e5-free-space", "protocol E5", "lag and apparent mass in the air", run_e5_free_space},
      {"e6-impact", "protocol E6", "steps into a wall: hardness, latency, rebound; taps",
       run_e6_impact},
      {"e8-lod-error", "protocol E8", "error of force and torque over the threshold",
       run_e8_lod_error},
      {"e10-depth-accuracy", "protocol E10",
       "depth, gradient and Hessian against closed forms and rays", run_e10_depth_accuracy},
      {"e13-real-time", "protocol E13",
       "rates to 10 kHz: where the time goes, beside an empty loop", run_e13_real_time},
      {"e14-degradation", "protocol E14", "queries that stop early: budgets kept, error left",
       run_e14_degradation},
      {"e16-scaling", "protocol E16", "growth with the number of triangles", run_e16_scaling},
      {"gains", "Sec. 5.5", "what `thigma tune` proposes, in the closed loop", run_gains},
  };
  return list;
}

}  // namespace thigma::experiments
