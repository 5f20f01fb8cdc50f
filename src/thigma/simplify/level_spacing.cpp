#include "thigma/simplify/level_spacing.h"

#include <cmath>

#include "thigma/simplify/simplify_surface.h"

namespace thigma {
namespace {

constexpr double kMostFall = 4.0;  // of triangles in a step whose patches halve

/// The factor that, taken as often as 2 goes into the ratio of two numbers of patches, makes that
/// ratio.
double even_factor(double ratio) {
  int steps = 0;
  for (double rest = ratio; rest >= 2.0; rest *= 0.5) ++steps;
  double low = 2.0, high = 4.0;
  for (int i = 0; i < 50; ++i) {  // bisection, where a power function might differ between machines
    const double middle = 0.5 * (low + high);
    double power = 1.0;
    for (int k = 0; k < steps; ++k) power *= middle;
    (power <= ratio ? low : high) = middle;
  }
  return low;
}

/// Of the levels between, the one of at least twice the patches of `next` that is nearest to
/// `wanted`; 0 when none.
std::size_t find_before(const std::vector<SimplifiedLevel>& levels, std::size_t next,
                        double wanted) {
  std::size_t best = 0;
  const auto distance = [&](std::size_t i) { return std::fabs(levels[i].patch_count - wanted); };
  for (std::size_t i = next - 1; i > 0; --i)
    if (levels[i].patch_count >= 2 * levels[next].patch_count &&
        2 * levels[i].patch_count <= levels[0].patch_count &&
        levels[i].resolution > levels[next].resolution &&
        (best == 0 || distance(i) < distance(best)))
      best = i;
  return best;
}

double triangle_count(const SimplifiedLevel& level) {
  return static_cast<double>(level.mesh.triangles.size());
}

/// Of the levels between two, those to keep for their triangles, fine to coarse.
std::vector<std::size_t> find_between(const std::vector<SimplifiedLevel>& levels, std::size_t from,
                                      std::size_t to) {
  std::vector<std::size_t> kept;
  const double last = triangle_count(levels[to]);
  if (!(triangle_count(levels[from]) > kMostFall * last)) return kept;
  std::size_t before = from;
  for (std::size_t i = from + 1; i < to; ++i) {
    const double count = triangle_count(levels[i]);
    if (2.0 * last > count) break;
    if (2.0 * count > triangle_count(levels[before]) ||
        levels[i].patch_count >= levels[before].patch_count ||
        levels[i].patch_count <= levels[to].patch_count ||
        !(levels[i].resolution < levels[before].resolution) ||
        !(levels[to].resolution < levels[i].resolution))
      continue;
    kept.push_back(i);
    before = i;
  }
  return kept;
}

/// Takes out the levels between two.
void drop_between(std::vector<SimplifiedLevel>& levels, std::size_t from, std::size_t to) {
  for (std::size_t i = from + 1; i < to; ++i)
    for (std::int32_t& parent : levels[from].parent)
      parent = levels[i].parent[static_cast<std::size_t>(parent)];
  const auto begin = levels.begin();
  levels.erase(begin + static_cast<std::ptrdiff_t>(from) + 1,
               begin + static_cast<std::ptrdiff_t>(to));
}

}  // namespace

void space_levels(std::vector<SimplifiedLevel>& levels) {
  const std::size_t last = levels.size() - 1;
  if (2 * levels[last].patch_count > levels[0].patch_count) {
    levels.resize(1);
    levels[0].parent.clear();
    return;
  }
  for (std::size_t next = last; next > 0;) {
    // Anew each time: what one step took too much or too little is spread over the rest.
    const double count = levels[next].patch_count;
    const std::size_t before =
        find_before(levels, next, count * even_factor(levels[0].patch_count / count));
    const std::vector<std::size_t> between = find_between(levels, before, next);
    for (std::size_t k = between.size(); k-- > 0; next = between[k])
      drop_between(levels, between[k], next);
    drop_between(levels, before, next);
    next = before;
  }
}

void drop_equal_resolutions(std::vector<SimplifiedLevel>& levels) {
  for (std::size_t i = levels.size() - 1; i > 1; --i)
    if (!(levels[i].resolution < levels[i - 1].resolution)) drop_between(levels, i - 2, i);
}

}  // namespace thigma
