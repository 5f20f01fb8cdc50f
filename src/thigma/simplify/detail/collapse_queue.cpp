#include "thigma/simplify/detail/collapse_queue.h"

#include <algorithm>
#include <utility>

#include "thigma/core/index.h"

// An attempt reads the patches of its star, hulls of others that meet the new triangles, and
// triangles of others that meet its boxes. A collapse moves the triangles of its star, and changes
// the patches of the star and those that they absorb. Where the one is not among the other, the
// attempt finds the same before and after. What else it reads is compared: the limit, and what the
// volume guard says. Topology is that of the fans of both ends: where those change, the candidate
// is stale.

namespace thigma::detail {
namespace {

std::int32_t version_of(const CollapseQueue& queue, std::int32_t a, std::int32_t b) {
  return queue.version[idx(a)] + queue.version[idx(b)];
}

bool is_stale(const CollapseQueue& queue, const Candidate& candidate) {
  return candidate.version != version_of(queue, candidate.a, candidate.b);
}

std::int32_t halfedge_of(const PatchedSurface& surface, const Candidate& candidate) {
  return find_halfedge(surface.mesh, candidate.a, candidate.b);
}

void leave(Lookahead& ahead, Lookahead::Place& place) {
  if (place.attempt >= 0) ahead.free.push_back(place.attempt);
  place.attempt = -1;
}

void leave_stale(Lookahead& ahead, Lookahead::Place& place) {
  ahead.lost += place.attempt >= 0 ? 1 : 0;
  leave(ahead, place);
}

/// Leaves out what has had its turn or is stale.
void clean(CollapseQueue& queue) {
  Lookahead& ahead = queue.ahead;
  std::size_t kept = 0;
  for (std::size_t i = ahead.turn; i < ahead.places.size(); ++i) {
    if (is_stale(queue, ahead.places[i].candidate))
      leave_stale(ahead, ahead.places[i]);
    else
      ahead.places[kept++] = ahead.places[i];
  }
  ahead.places.resize(kept);
  ahead.turn = 0;
}

bool lacks_attempt(const Lookahead& ahead, const Lookahead::Place& place) {
  return place.attempt < 0 || ahead.attempts[idx(place.attempt)].is_lost;
}

/// Takes candidates from the queue: those before the last place, and more until as many as wanted
/// lack an attempt.
void fill(CollapseQueue& queue, std::size_t wanted) {
  Lookahead& ahead = queue.ahead;
  auto lacking = static_cast<std::size_t>(
      std::count_if(ahead.places.begin(), ahead.places.end(),
                    [&](const Lookahead::Place& place) { return lacks_attempt(ahead, place); }));
  const std::size_t old = ahead.places.size();
  for (; !queue.waiting.empty(); queue.waiting.pop()) {
    const Candidate& top = queue.waiting.top();
    const bool is_before = old > 0 && !(top > ahead.places[old - 1].candidate);
    if (!is_before && lacking >= wanted) break;
    if (is_stale(queue, top)) continue;
    ahead.places.push_back({top, -1});
    ++lacking;
  }
  std::inplace_merge(ahead.places.begin(), ahead.places.begin() + static_cast<std::ptrdiff_t>(old),
                     ahead.places.end(), [](const Lookahead::Place& x, const Lookahead::Place& y) {
                       return y.candidate > x.candidate;
                     });
}

/// How many attempts to make at once: many where all of them serve, fewer with each that is lost.
std::size_t choose_room(Lookahead& ahead, int threads) {
  constexpr double kGrowth = 0.2;  // a round
  constexpr int kMost = 32;        // of a thread
  ahead.room += ahead.lost == 0 ? kGrowth : -ahead.lost;
  ahead.room = std::clamp(ahead.room, 1.0 * threads, 1.0 * kMost * threads);
  ahead.lost = 0;
  return static_cast<std::size_t>(ahead.room);
}

/// Chooses the first places that lack an attempt, and gives them one.
void choose_places(Lookahead& ahead, std::size_t count) {
  ahead.chosen.clear();
  for (std::size_t i = 0; i < ahead.places.size() && ahead.chosen.size() < count; ++i) {
    Lookahead::Place& place = ahead.places[i];
    if (!lacks_attempt(ahead, place)) continue;
    ahead.lost += place.attempt >= 0 ? 1 : 0;
    if (place.attempt < 0 && ahead.free.empty()) {
      ahead.free.push_back(static_cast<std::int32_t>(ahead.attempts.size()));
      ahead.attempts.emplace_back();
    }
    if (place.attempt < 0) {
      place.attempt = ahead.free.back();
      ahead.free.pop_back();
    }
    ahead.chosen.push_back(static_cast<std::int32_t>(i));
  }
}

/// Attempts the first places that lack it, on all threads.
void attempt_ahead(CollapseQueue& queue, const PatchedSurface& surface,
                   const CollapseContext& context, const LimitOfLength& limit_of) {
  Lookahead& ahead = queue.ahead;
  clean(queue);
  const std::size_t room = choose_room(ahead, queue.crew.threads());
  fill(queue, room);
  choose_places(ahead, room);
  ahead.scratch.resize(static_cast<std::size_t>(queue.crew.threads()));
  queue.crew.for_each(ahead.chosen.size(), [&](std::size_t i, std::size_t thread) {
    const Lookahead::Place& place = ahead.places[idx(ahead.chosen[i])];
    AttemptAhead& attempt = ahead.attempts[idx(place.attempt)];
    CollapseScratch& scratch = ahead.scratch[thread];
    attempt.limit = scratch.search.limit = limit_of(place.candidate.length);
    attempt.is_lost = false;
    find_collapse(surface, context, halfedge_of(surface, place.candidate), scratch);
    std::swap(static_cast<CollapseFinding&>(scratch), attempt.finding);
  });
}

/// Whether the attempt would find the same now.
bool holds(const AttemptAhead& attempt, double limit, const VolumeGuard& volume) {
  return !attempt.is_lost && attempt.limit == limit &&
         std::all_of(attempt.finding.answers.begin(), attempt.finding.answers.end(),
                     [&](const VolumeAnswer& answer) {
                       return keeps_within(volume, answer.change) == answer.is_kept;
                     });
}

bool has_seen(const CollapseFinding& finding, const PatchedSurface& surface,
              const SurfaceChange& change) {
  const auto is_changed = [&](std::int32_t patch) {
    return surface.patches[idx(patch)].triangles.empty() ||  // absorbed
           std::find(change.patches.begin(), change.patches.end(), patch) != change.patches.end();
  };
  const auto meets_hull = [&](const TreeBox& box) {
    return std::any_of(change.hulls.begin(), change.hulls.end(),
                       [&](const TreeBox& hull) { return hull.overlaps(box); });
  };
  if (finding.outcome == CollapseOutcome::topology) return false;
  return std::any_of(finding.star.patches.begin(), finding.star.patches.end(), is_changed) ||
         std::any_of(finding.tried.begin(), finding.tried.end(), meets_hull) ||
         std::any_of(finding.seen.begin(), finding.seen.end(),
                     [&](const TreeBox& box) { return box.overlaps(change.triangles); });
}

/// The same on this thread alone.
std::optional<Candidate> take_alone(CollapseQueue& queue, const PatchedSurface& surface,
                                    CollapseContext& context, const LimitOfLength& limit_of) {
  while (!queue.waiting.empty()) {
    const Candidate candidate = queue.waiting.top();
    queue.waiting.pop();
    if (is_stale(queue, candidate)) continue;
    context.scratch.search.limit = limit_of(candidate.length);
    find_collapse(surface, context, halfedge_of(surface, candidate), context.scratch);
    return candidate;
  }
  return std::nullopt;
}

}  // namespace

void push(CollapseQueue& queue, double length, std::int32_t a, std::int32_t b) {
  queue.waiting.push({length, std::min(a, b), std::max(a, b), version_of(queue, a, b)});
}

std::optional<Candidate> take_attempt(CollapseQueue& queue, const PatchedSurface& surface,
                                      CollapseContext& context, const LimitOfLength& limit_of) {
  if (queue.crew.threads() == 1) return take_alone(queue, surface, context, limit_of);
  Lookahead& ahead = queue.ahead;
  for (;;) {
    while (!queue.waiting.empty() && is_stale(queue, queue.waiting.top())) queue.waiting.pop();
    while (ahead.turn < ahead.places.size() && is_stale(queue, ahead.places[ahead.turn].candidate))
      leave_stale(ahead, ahead.places[ahead.turn++]);
    const bool has_ahead = ahead.turn < ahead.places.size();
    if (!has_ahead && queue.waiting.empty()) return std::nullopt;
    const bool is_next = has_ahead && (queue.waiting.empty() ||
                                       !(ahead.places[ahead.turn].candidate > queue.waiting.top()));
    if (is_next && !lacks_attempt(ahead, ahead.places[ahead.turn])) {
      Lookahead::Place& place = ahead.places[ahead.turn];
      AttemptAhead& attempt = ahead.attempts[idx(place.attempt)];
      const double limit = limit_of(place.candidate.length);
      if (holds(attempt, limit, context.volume)) {
        context.scratch.search.limit = limit;
        std::swap(static_cast<CollapseFinding&>(context.scratch), attempt.finding);
        leave(ahead, place);
        return ahead.places[ahead.turn++].candidate;
      }
      attempt.is_lost = true;
    }
    attempt_ahead(queue, surface, context, limit_of);
  }
}

void add_star(const PatchedSurface& surface, const EdgeStar& star, SurfaceChange& change) {
  if (change.patches.empty()) change.triangles = surface.box[idx(star.triangles[0].triangle)];
  change.patches = star.patches;
  for (const std::int32_t patch : star.patches)
    if (!surface.patches[idx(patch)].triangles.empty())
      change.hulls.push_back(surface.patches[idx(patch)].box);
  const auto add = [&](std::int32_t t) {
    change.triangles = united(change.triangles, surface.box[idx(t)]);
  };
  for (const StarTriangle& t : star.triangles) add(t.triangle);
  for (const std::int32_t t : star.removed)
    if (t >= 0 && surface.patch_of[idx(t)] >= 0) add(t);  // not yet gone
}

void note_change(CollapseQueue& queue, const PatchedSurface& surface, const SurfaceChange& change) {
  Lookahead& ahead = queue.ahead;
  for (std::size_t i = ahead.turn; i < ahead.places.size(); ++i) {
    if (lacks_attempt(ahead, ahead.places[i])) continue;
    AttemptAhead& attempt = ahead.attempts[idx(ahead.places[i].attempt)];
    attempt.is_lost = has_seen(attempt.finding, surface, change);
  }
}

void clear(CollapseQueue& queue) {
  queue.waiting = {};
  for (Lookahead::Place& place : queue.ahead.places) leave(queue.ahead, place);
  queue.ahead.places.clear();
  queue.ahead.turn = 0;
}

}  // namespace thigma::detail
