// A world of several bodies: a second with a simulated hand, then steps of one's own.
#include <cstdio>

#include "thigma/core/error.h"
#include "thigma/scene/world_scene.h"

int main() try {
  thigma::LoadedWorld loaded =
      thigma::load_world(thigma::read_world_scene("scenes/row_of_blocks.toml"));
  loaded.config.duration = 1.0;
  const thigma::WorldDevices devices = thigma::open_world_devices(loaded, {}, 1);
  const thigma::WorldSummary felt = thigma::run_world(loaded.config, devices.list);
  std::printf("%zu bodies, largest force %.2f N, %.3g J from the hand\n",
              loaded.config.world.bodies.size(), felt.force_max, felt.port_energy);

  // The same without a session: steps of one's own.
  const thigma::World& world = loaded.config.world;
  thigma::WorldState state = loaded.config.start;
  const thigma::WorldScratchPtr scratch = thigma::reserve_world(world);
  const double start = thigma::mechanical_energy(world, state);
  for (int i = 0; i < 1000; ++i) thigma::step_world(world, {}, 0.001, state, *scratch);
  const thigma::Vec3& top = state.bodies.back().position;
  std::printf("'%s' at [%.4f, %.4f, %.4f] m after %.1f s, energy %+.1e J\n",
              world.bodies.back().name.c_str(), top.x(), top.y(), top.z(), state.time,
              thigma::mechanical_energy(world, state) - start);
} catch (const thigma::InputError& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 2;
}
