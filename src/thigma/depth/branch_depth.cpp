// Directional depth over every texel, by branch and bound. A place to look is a texel of one side
// over a triangle of the other; a node is a cell of a pyramid with such a pair of triangles. The
// cell's largest texel, the largest of the other side that may lie under it and the largest coarse
// height bound all depths in it, so the node with the largest bound is opened first until no bound
// is above the best depth found.
#include <algorithm>
#include <cmath>
#include <vector>

#include "thigma/depth/depth.h"
#include "thigma/depth/detail/fine_sheets.h"
#include "thigma/depth/detail/near_maxima.h"
#include "thigma/depth/detail/texel_pair.h"

namespace thigma {
namespace {

using detail::PreparedContact;
using detail::TexelCell;
using detail::TexelPair;

struct Node {
  double others = 0.0;  // as CellBound
  std::int32_t pair = -1;
  TexelCell cell;
};

// A node in the heap; `index` is that of its creation and decides between equal bounds.
struct Open {
  double bound = 0.0;
  std::int32_t index = 0;
};

struct IsLess {
  bool operator()(const Open& a, const Open& b) const noexcept {
    return a.bound != b.bound ? a.bound < b.bound : a.index > b.index;
  }
};

// A texel that was the best of a search.
struct Incumbent {
  double depth = kNoDepth;
  bool is_of_object = true;
  std::int32_t triangle = -1, other_triangle = -1;
  int column = 0, row = 0;
  Vec2 at = Vec2::Zero();
};

// Texels of a leaf: opening smaller cells costs more than trying their texels.
constexpr int kLeafLevel = 1;

class BranchDepth final : public DepthBackend {
 public:
  explicit BranchDepth(const BranchDepthParams& params) : params_(params) {}

  void sample(std::span<const DepthContact> contacts, const DepthRequest& request,
              std::span<DepthSamples> results) noexcept override {
    if (last_.size() < contacts.size()) last_.resize(contacts.size());
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      sample_contact(contacts[i], request, last_[i], results[i]);
    }
  }

 private:
  void sample_contact(const DepthContact& contact, const DepthRequest& request, Incumbent& last,
                      DepthSamples& result) noexcept {
    result = DepthSamples{};
    if (!detail::prepare_contact(contact, prepared_)) return;
    result.frame = prepared_.frame;
    const Incumbent best = search(contact, last, &result);
    last = best;
    if (best.depth == kNoDepth) return;
    result.is_found = true;
    result.depth[0] = best.depth;
    result.at = best.at;
    const double texel = detail::finer_texel(contact);
    detail::settle_height_field(prepared_, Vec2(texel, texel), result);
    collect_near(request.near, result);
    if (request.has_differences) sample_moved(contact, request, best, result);
  }

  void sample_moved(const DepthContact& contact, const DepthRequest& request, const Incumbent& here,
                    DepthSamples& result) noexcept {
    const double texel = detail::finer_texel(contact);
    result.shift = request.step > 0.0 ? request.step : texel;
    result.turn = result.shift / std::max((contact.point - contact.centre).norm(), result.shift);
    for (int i = 1; i < kConfigurations; ++i) {
      detail::project_moved(contact, configuration_motion(result, contact.centre, i), prepared_);
      result.depth[static_cast<std::size_t>(i)] = search(contact, here, nullptr).depth;
    }
  }

  // The best texel with the object as projected; result: null, or gets nodes and remaining.
  Incumbent search(const DepthContact& contact, const Incumbent& start,
                   DepthSamples* result) noexcept {
    pairs_.clear();
    heap_.clear();
    nodes_.clear();
    const bool is_bounded = std::isfinite(contact.reach);
    add_pairs(prepared_.object, prepared_.scene, is_bounded);
    const std::size_t of_object = pairs_.size();
    add_pairs(prepared_.scene, prepared_.object, is_bounded);
    Incumbent best;
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
      const TexelPair& pair = pairs_[i];
      if ((i < of_object) == start.is_of_object && pair.driver_triangle == start.triangle)
        try_texel(static_cast<std::int32_t>(i), start.column, start.row, best);
    }
    try_middles(best);
    for (std::size_t i = 0; i < pairs_.size(); ++i) push_roots(static_cast<std::int32_t>(i), best);
    std::int32_t nodes = 0;
    double remaining = 0.0;
    while (!heap_.empty() && heap_.front().bound > best.depth) {
      if (nodes >= params_.max_nodes && best.depth != kNoDepth) {
        remaining = heap_.front().bound - best.depth;
        break;
      }
      ++nodes;
      std::pop_heap(heap_.begin(), heap_.end(), IsLess{});
      const Node node = nodes_[static_cast<std::size_t>(heap_.back().index)];
      heap_.pop_back();
      open(node, best);
    }
    if (result) {
      result->nodes = nodes;
      result->remaining = remaining;
    }
    return best;
  }

  void add_pairs(const ProjectedPatch& driver, const ProjectedPatch& other,
                 bool is_bounded) noexcept {
    for (const ProjectedTriangle& a : driver.triangles) {
      const PlaneBox fine{a.box.low + driver.sideways.low, a.box.high + driver.sideways.high};
      if (!overlap(fine, prepared_.box)) continue;
      const PlaneBox under{fine.low - other.sideways.high, fine.high - other.sideways.low};
      for (const ProjectedTriangle& b : other.triangles) {
        if (overlap(under, b.box))
          pairs_.push_back(
              detail::make_texel_pair({driver, a}, {other, b}, prepared_.box, is_bounded));
      }
    }
  }

  // Cells that cover the pair's box of texels, at most two each way.
  void push_roots(std::int32_t index, const Incumbent& best) noexcept {
    const TexelPair& pair = pairs_[static_cast<std::size_t>(index)];
    const HapticTexture& texture = *pair.driver->texture;
    const Vec2 last(texture.width - 1.0, texture.height - 1.0);
    const Vec2 low = pair.low.cwiseMax(0.0).cwiseMin(last),
               high = pair.high.cwiseMax(0.0).cwiseMin(last);
    if (!(low.array() <= high.array()).all()) return;
    int level = 1;
    const double size = (high - low).maxCoeff();
    while (level < static_cast<int>(texture.pyramid.size()) && std::ldexp(1.0, level) < size)
      ++level;
    const BoundsLevel& bounds = texture.pyramid[static_cast<std::size_t>(level - 1)];
    const double scale = std::ldexp(1.0, -level);
    const auto cell = [&](double at, int count) {
      return std::min(static_cast<int>(at * scale), count - 1);
    };
    for (int row = cell(low.y(), bounds.rows); row <= cell(high.y(), bounds.rows); ++row) {
      for (int column = cell(low.x(), bounds.columns); column <= cell(high.x(), bounds.columns);
           ++column)
        push(index, {level, column, row}, std::numeric_limits<double>::infinity(), best);
    }
  }

  void push(std::int32_t index, const TexelCell& cell, double others,
            const Incumbent& best) noexcept {
    const detail::CellBound bound =
        detail::upper_bound(pairs_[static_cast<std::size_t>(index)], cell, others, best.depth);
    if (!(bound.depth > best.depth)) return;
    heap_.push_back({bound.depth, static_cast<std::int32_t>(nodes_.size())});
    nodes_.push_back({bound.others, index, cell});
    std::push_heap(heap_.begin(), heap_.end(), IsLess{});
  }

  void open(const Node& node, Incumbent& best) noexcept {
    if (node.cell.level <= kLeafLevel) {
      try_texels(node, best);
    } else {
      for_children(node, [&](const TexelCell& cell) { push(node.pair, cell, node.others, best); });
    }
  }

  // A texel amidst each pair: something to compare with, and to return, from the start.
  void try_middles(Incumbent& best) noexcept {
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
      const TexelPair& pair = pairs_[i];
      if (!(pair.low.array() <= pair.high.array()).all()) continue;
      const HapticTexture& texture = *pair.driver->texture;
      const Vec2 last(texture.width - 1.0, texture.height - 1.0);
      const Vec2 middle = (0.5 * (pair.low + pair.high)).cwiseMax(0.0).cwiseMin(last);
      try_texel(static_cast<std::int32_t>(i), static_cast<int>(middle.x() + 0.5),
                static_cast<int>(middle.y() + 0.5), best);
    }
  }

  template <class Visit>
  void for_children(const Node& node, const Visit& visit) const noexcept {
    const HapticTexture& texture = *pairs_[static_cast<std::size_t>(node.pair)].driver->texture;
    const int level = node.cell.level - 1;
    const BoundsLevel& bounds = texture.pyramid[static_cast<std::size_t>(level - 1)];
    for (int k = 0; k < 4; ++k) {
      const int column = 2 * node.cell.column + k % 2, row = 2 * node.cell.row + k / 2;
      if (column < bounds.columns && row < bounds.rows) visit(TexelCell{level, column, row});
    }
  }

  void try_texels(const Node& node, Incumbent& best) noexcept {
    const HapticTexture& texture = *pairs_[static_cast<std::size_t>(node.pair)].driver->texture;
    const detail::TexelRange range = detail::texels_of(texture, node.cell);
    for (int row = range.first_row; row <= range.last_row; ++row) {
      for (int column = range.first_column; column <= range.last_column; ++column)
        try_texel(node.pair, column, row, best);
    }
  }

  void try_texel(std::int32_t index, int column, int row, Incumbent& best) noexcept {
    const TexelPair& pair = pairs_[static_cast<std::size_t>(index)];
    const detail::TexelDepth here = detail::depth_at_texel(pair, column, row);
    if (!(here.depth > best.depth)) return;
    best = {here.depth,
            pair.driver == &prepared_.object,
            pair.driver_triangle,
            pair.other_triangle,
            column,
            row,
            here.at};
  }

  // A search sees too few places for an average: what is near the maximum is looked for on a grid.
  void collect_near(double within, DepthSamples& result) noexcept {
    constexpr int kResolution = 50;
    if (within > 0.0) {
      const MapGrid grid{prepared_.box, kResolution, kResolution};
      render_heights(prepared_.object, grid, {}, object_);
      render_heights(prepared_.scene, grid, {}, scene_);
      detail::collect_near(object_, scene_, grid, within, result);
    } else {
      result.near.push_back({result.at, 1.0});
    }
  }

  BranchDepthParams params_;
  PreparedContact prepared_;
  std::vector<TexelPair> pairs_;
  std::vector<Node> nodes_;  // every one of a search
  std::vector<Open> heap_;
  std::vector<Incumbent> last_;  // of every contact
  HeightMap object_, scene_;
};

}  // namespace

std::unique_ptr<DepthBackend> make_branch_depth(const BranchDepthParams& params) {
  return std::make_unique<BranchDepth>(params);
}

}  // namespace thigma
