#pragma once
// Edges that wait for their turn to collapse; with several threads looked at before it.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <queue>
#include <vector>

#include "thigma/core/crew.h"
#include "thigma/simplify/filtered_edge_collapse.h"

namespace thigma::detail {

/// An edge that may be tried. Stale once either end has changed since.
struct Candidate {
  double length = 0.0;  // projected [m]
  std::int32_t a = -1, b = -1;
  std::int32_t version = 0;  // sum of the versions of its ends
  bool operator>(const Candidate& other) const {
    if (length != other.length) return length > other.length;
    return a != other.a ? a > other.a : b > other.b;
  }
};

/// What was found for a candidate before its turn.
struct AttemptAhead {
  double limit = 0.0;    // of the deviation [m]
  bool is_lost = false;  // the surface has changed where it looked
  CollapseFinding finding;
};

/// Candidates that left the queue, shortest first, and attempts of some of them.
struct Lookahead {
  struct Place {
    Candidate candidate;
    std::int32_t attempt = -1;
  };
  std::vector<Place> places;
  std::size_t turn = 0;                // those before have had it
  std::vector<AttemptAhead> attempts;  // as the places name them
  std::vector<std::int32_t> free, chosen;
  double room = 0.0;                     // attempts at once
  int lost = 0;                          // of those since the last round
  std::vector<CollapseScratch> scratch;  // of each thread
};

/// Candidates, the shortest first. With several threads attempts are made before their turn and
/// used if nothing has changed for them, so that what comes of it is the same with any number.
struct CollapseQueue {
  explicit CollapseQueue(int threads) : crew(threads) {}

  std::priority_queue<Candidate, std::vector<Candidate>, std::greater<>> waiting;
  std::vector<std::int32_t> version;  // of each vertex; only ever grows
  Lookahead ahead;
  Crew crew;
};

/// Puts an edge with its ends as they are now into the queue.
///
/// length  projected [m]
void push(CollapseQueue& queue, double length, std::int32_t a, std::int32_t b);

/// How far from the original an edge of some projected length may go [m].
using LimitOfLength = std::function<double(double)>;

/// Takes the shortest candidate that is not stale; context.scratch has what was found for it.
/// returns  nothing where none is left
/// Thread   [offline]; deterministic.
std::optional<Candidate> take_attempt(CollapseQueue& queue, const PatchedSurface& surface,
                                      CollapseContext& context, const LimitOfLength& limit_of);

/// What a collapse and the merges after it change.
struct SurfaceChange {
  std::vector<std::int32_t> patches;  // that are others now, or none
  std::vector<TreeBox> hulls;         // of them, before and after [m]
  TreeBox triangles;                  // around those that moved, before and after [m]
};

/// Adds the patches and triangles of a star as they are now: to be called before and after.
void add_star(const PatchedSurface& surface, const EdgeStar& star, SurfaceChange& change);

/// To be told of every change while candidates are left. Attempts that it may touch are lost.
void note_change(CollapseQueue& queue, const PatchedSurface& surface, const SurfaceChange& change);

/// Forgets all candidates.
void clear(CollapseQueue& queue);

}  // namespace thigma::detail
