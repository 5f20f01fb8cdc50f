#pragma once
// How a session of a world went, for people and as JSON.

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "thigma/scene/world_scene.h"
#include "thigma/session/histogram.h"

namespace thigma::app {

/// What a summary does not know itself.
struct WorldRunFacts {
  std::vector<std::string> devices;  // addresses, by hand
  double cpu_seconds = 0.0;          // of the processor, for all steps [s]
  DurationHistogram steps;           // of the processor, by step
  bool has_clock = false;            // it went by the clock
  bool is_recorded_whole = true;     // or not at all
};

/// Counts a step. Thread: the world's.
void count_step(const WorldFrame& frame, WorldRunFacts& facts);

nlohmann::ordered_json world_summary_json(const WorldSummary& s, const LoadedWorld& world,
                                          const WorldRunFacts& facts);
/// Why a device was at fault, for people: which, and what it says itself; "" where none was.
std::string fault_reason(const WorldSummary& s, const std::vector<std::string>& devices);
/// The fault that ended a session, for people.
std::string fault_line(const WorldSummary& s, const LoadedWorld& world,
                       const std::vector<std::string>& devices);
/// On standard output.
void print_world_summary(const WorldSummary& s, const LoadedWorld& world,
                         const WorldRunFacts& facts);

}  // namespace thigma::app
