#pragma once
// The experiments there are: each folder's own.

#include "experiments/common/experiment.h"

namespace thigma::experiments {

Outcome run_table_3_2(const Context& context);
Outcome run_table_3_3(const Context& context);
Outcome run_fig_3_15(const Context& context);
Outcome run_fig_3_16(const Context& context);
Outcome run_fig_4_8(const Context& context);
Outcome run_fig_4_9(const Context& context);
Outcome run_fig_4_10(const Context& context);
Outcome run_fig_4_14(const Context& context);
Outcome run_fig_4_15(const Context& context);
Outcome run_fig_4_16(const Context& context);
Outcome run_fig_5_12(const Context& context);
Outcome run_fig_3_18(const Context& context);
Outcome run_fig_3_19(const Context& context);
Outcome run_no_popping(const Context& context);
Outcome run_e1_static_queries(const Context& context);
Outcome run_e2_force_quality(const Context& context);
Outcome run_e3_z_width(const Context& context);
Outcome run_e4_passivity(const Context& context);
Outcome run_e5_free_space(const Context& context);
Outcome run_e6_impact(const Context& context);
Outcome run_e8_lod_error(const Context& context);
Outcome run_e13_real_time(const Context& context);
Outcome run_e14_degradation(const Context& context);
Outcome run_force_steps(const Context& context);
Outcome run_e16_scaling(const Context& context);
Outcome run_fig_5_4(const Context& context);
Outcome run_fig_5_6(const Context& context);
Outcome run_fig_5_8(const Context& context);
Outcome run_fig_5_10(const Context& context);
Outcome run_gains(const Context& context);
Outcome run_level_choice(const Context& context);
Outcome run_never_enters(const Context& context);
Outcome run_relief(const Context& context);
Outcome run_throws(const Context& context);
Outcome run_constraint_force(const Context& context);
Outcome run_closed_loops(const Context& context);
Outcome run_tiles(const Context& context);
Outcome run_friction(const Context& context);

}  // namespace thigma::experiments
