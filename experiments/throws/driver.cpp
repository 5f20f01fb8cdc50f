// Many throws, resumable: `thigma_throws COUNT STATE [SEED]` goes on from the state file, which it
// writes every 500 throws, up to COUNT. Constraints; the throws are those of the experiment.

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <sstream>
#include <stdexcept>
#include <string>

#include "experiments/throws/thrown.h"

#include "thigma/files/file.h"

namespace thigma::experiments {
namespace {

struct State {
  std::uint64_t seed = 1, next = 0;
  ThrowCount count{};
};

template <class Visit>
void each_number(State& state, const Visit& visit) {
  visit(state.seed);
  visit(state.next);
  for (auto* counts :
       {&state.count.thrown, &state.count.passed, &state.count.entered, &state.count.faults})
    for (std::int64_t& n : *counts) visit(n);
  visit(state.count.held_back);
  visit(state.count.frames);
  visit(state.count.touched);
  visit(state.count.depth);
}

State read_state(const std::string& path, std::uint64_t seed) {
  State state{.seed = seed};
  if (!std::filesystem::exists(path)) return state;
  std::istringstream text(read_file(path));
  each_number(state, [&](auto& n) { text >> n; });
  if (!text) throw std::runtime_error(path + ": no state of throws");
  if (state.seed != seed) throw std::runtime_error(path + ": of another seed");
  return state;
}

void write_state(const std::string& path, State& state) {
  std::ostringstream text;
  text.precision(17);
  each_number(state, [&](const auto& n) { text << n << '\n'; });
  write_file(path, text.str());
}

int run(std::uint64_t count, const std::string& path, std::uint64_t seed) {
  State state = read_state(path, seed);
  const ThrowWorld world = make_throw_world();
  while (state.next < count) {
    const Throw one = make_throw(seed, state.next++);
    add_throw(one, run_throw(world, one, true), state.count);
    if (state.next % 500 == 0 || state.next == count) write_state(path, state);
  }
  const ThrowCount& c = state.count;
  std::printf(
      "%llu throws: %lld pass, %lld enter (deepest %.3g um), %lld end by a fault, "
      "%lld touch, %.3g of the frames held back\n",
      static_cast<unsigned long long>(state.next), static_cast<long long>(total(c.passed)),
      static_cast<long long>(total(c.entered)), 1e6 * c.depth,
      static_cast<long long>(total(c.faults)), static_cast<long long>(c.touched),
      static_cast<double>(c.held_back) / static_cast<double>(c.frames));
  return total(c.passed) == 0 && total(c.entered) == 0 ? 0 : 1;
}

}  // namespace
}  // namespace thigma::experiments

int main(int argc, char** argv) {
  if (argc < 3) {
    std::fprintf(stderr, "thigma_throws COUNT STATE [SEED]\n");
    return 2;
  }
  try {
    const std::uint64_t seed = argc > 3 ? std::strtoull(argv[3], nullptr, 10) : 1;
    return thigma::experiments::run(std::strtoull(argv[1], nullptr, 10), argv[2], seed);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "thigma_throws: %s\n", error.what());
    return 2;
  }
}
