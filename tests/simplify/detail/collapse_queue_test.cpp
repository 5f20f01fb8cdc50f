#include "thigma/simplify/detail/collapse_queue.h"

#include "simplify/simplify_support.h"
#include <gtest/gtest.h>

#include "thigma/core/index.h"

namespace thigma::detail {
namespace {

/// Collapses by length, every edge in reach of a change being tried again, as the loop does.
struct QueueBench : test::SurfaceBench {
  CollapseQueue queue;

  QueueBench(TriangleMesh m, int threads) : SurfaceBench(std::move(m), 0.05), queue(threads) {
    queue.version.assign(mesh.positions.size(), 0);
    for (std::int32_t h = 0; h < static_cast<std::int32_t>(surface.mesh.twin.size()); ++h) push(h);
  }

  void push(std::int32_t h) {
    const std::int32_t a = tail_of(surface.mesh, h), b = head_of(surface.mesh, h);
    const auto& x = surface.mesh.positions;
    detail::push(queue, (x[idx(a)] - x[idx(b)]).norm(), a, b);
  }

  /// The limit grows with what has collapsed, as the loop's does.
  double limit_of(double length) const { return 0.2 * std::max(length, longest); }

  std::optional<Candidate> take() {
    return take_attempt(queue, surface, context, [&](double length) { return limit_of(length); });
  }

  void collapse(const Candidate& candidate, bool is_noted = true) {
    const EdgeStar& star = context.scratch.star;
    SurfaceChange change;
    add_star(surface, star, change);
    commit_collapse(surface, context, successor);
    longest = std::max(longest, candidate.length);
    for (const std::int32_t patch : star.patches)
      if (!surface.patches[idx(patch)].triangles.empty())
        merge_patch(surface, patch, context.scratch.hull, successor);
    add_star(surface, star, change);
    if (is_noted) note_change(queue, surface, change);
    ++queue.version[idx(star.head)];
    ++queue.version[idx(star.tail)];
    for (const StarTriangle& t : star.triangles) ++queue.version[idx(t.a)];
    for (const StarTriangle& t : star.triangles)
      for (std::int32_t k = 0; k < 3; ++k) push(3 * t.triangle + k);
  }

  double longest = 0.0;
};

bool same_finding(const CollapseFinding& x, const CollapseFinding& y) {
  if (x.outcome != y.outcome) return false;
  if (x.outcome != CollapseOutcome::collapsed) return true;
  return x.position == y.position && x.star.tail == y.star.tail && x.star.head == y.star.head &&
         x.patch_vertices == y.patch_vertices && x.has_all_hulls == y.has_all_hulls &&
         x.hulls_at == y.hulls_at;
}

struct Tally {
  int taken = 0, collapsed = 0, other = 0;  // other: than would be found at its turn
};

/// Takes all, and looks again for each when its turn has come.
Tally compare(QueueBench& bench, bool is_noted = true) {
  Tally tally;
  CollapseScratch again;
  while (const auto candidate = bench.take()) {
    ++tally.taken;
    again.search.limit = bench.limit_of(candidate->length);
    find_collapse(bench.surface, bench.context,
                  find_halfedge(bench.surface.mesh, candidate->a, candidate->b), again);
    // Scratch is used again: patches beyond those of the star are of others.
    CollapseFinding& found = bench.context.scratch;
    if (found.outcome == CollapseOutcome::collapsed)
      for (auto* lists : {&found.patch_vertices, &again.patch_vertices})
        lists->resize(again.star.patches.size());
    if (!same_finding(found, again)) {
      ++tally.other;
      if (!is_noted) break;  // it may not be committed
    }
    if (found.outcome != CollapseOutcome::collapsed) continue;
    ++tally.collapsed;
    bench.collapse(*candidate, is_noted);
  }
  return tally;
}

TEST(CollapseQueue, FindsAheadWhatIsFoundInTurn) {
  const std::array<TriangleMesh, 4> meshes = {test::wavy_ball(9), make_torus(1.0, 0.4, 24, 16),
                                              make_sheet(2, 1, 16, 8),
                                              make_hollow_ball(1.0, 0.6, 5)};
  for (const TriangleMesh& mesh : meshes)
    for (const int threads : {1, 2, 4}) {
      QueueBench bench(mesh, threads);
      const Tally tally = compare(bench);
      EXPECT_EQ(tally.other, 0) << threads;
      EXPECT_GT(tally.collapsed, 40) << threads;
      EXPECT_GT(tally.taken, tally.collapsed) << threads;
    }
}

TEST(CollapseQueue, GivesTheSameTurnsWithAnyNumberOfThreads) {
  QueueBench alone(test::wavy_ball(8), 1);
  compare(alone);
  for (const int threads : {2, 3, 7}) {
    QueueBench bench(test::wavy_ball(8), threads);
    compare(bench);
    EXPECT_TRUE(test::same(alone.surface, bench.surface)) << threads;
    EXPECT_EQ(alone.successor, bench.successor) << threads;
  }
}

// What the notes are for: without them attempts of before a change are taken after it.
TEST(CollapseQueue, IsWrongWhereChangesAreNotNoted) {
  int other = 0;
  for (int frequency = 6; frequency <= 12; ++frequency) {
    QueueBench bench(test::wavy_ball(frequency), 8);
    other += compare(bench, false).other;
  }
  EXPECT_GT(other, 0);
}

TEST(CollapseQueue, HasNothingOnceCleared) {
  for (const int threads : {1, 3}) {
    QueueBench bench(test::wavy_ball(5), threads);
    ASSERT_TRUE(bench.take());
    clear(bench.queue);
    EXPECT_FALSE(bench.take());
  }
}

}  // namespace
}  // namespace thigma::detail
