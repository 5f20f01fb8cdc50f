#include "thigma/models/textured_model.h"

#include <algorithm>
#include <charconv>

#include "thigma/core/error.h"
#include "thigma/math/elementary.h"
#include "thigma/models/make_model.h"
#include "thigma/models/textured_parts.h"

namespace thigma::models {
namespace {

constexpr int kLeastTexels = 16, kMostTexels = 8192;

// Sec. 5.5.4: a plate of 35 x 35 cm with sinusoidal ridges 8 mm high; their distance is not told.
constexpr double kPlateSide = 0.35, kPlateRidge = 0.008, kPlatePitch = 0.035;
// Fig. 4.11: striped blocks that lie in each other; no size is told.
constexpr double kBlockLong = 0.08, kBlockWide = 0.06, kBlockHigh = 0.02;

HapticTexture make_ridged_plate(int texels) {
  const TexturedSlab slab{{kPlateSide, kPlateSide, 0.010}, texels, [](double x, double) {
                            return 0.5 * kPlateRidge * sine(2.0 * kPi * x / kPlatePitch);
                          }};
  return make_texture(make_textured_slab(slab), "ridged_plate");
}

std::vector<std::string> names() {
  std::vector<std::string> list;
  for (const TexturedInfo& info : textured_models()) list.push_back(info.name);
  return list;
}

const TexturedInfo& find_textured(std::string_view name, const std::string& where) {
  for (const TexturedInfo& info : textured_models())
    if (name == info.name) return info;
  const std::string nearest = nearest_word(name, names());
  std::string all;
  for (const std::string& known : names()) all += " " + known;
  throw InputError(where + ": no procedural texture '" + std::string(name.substr(0, 60)) +
                   "', expected " + (nearest.empty() ? "" : "'" + nearest + "', ") + "one of" +
                   all);
}

void check_texels(int texels, const std::string& where) {
  if (texels < kLeastTexels || texels > kMostTexels)
    throw InputError(where + ": " + std::to_string(texels) + " texels, expected " +
                     std::to_string(kLeastTexels) + " to " + std::to_string(kMostTexels));
}

/// Triangles of a slab with the places of their corners in the map.
struct SlabBuilder {
  TextureSource source;
  int spare = 0;  // triangles without relief so far

  void add(std::int32_t a, std::int32_t b, std::int32_t c, const std::array<Vec2, 3>& corners) {
    source.coarse.triangles.push_back({a, b, c});
    source.corners.push_back(corners);
  }
  /// A triangle without relief: a place of its own below the rows of the top.
  void add_plain(std::int32_t a, std::int32_t b, std::int32_t c, int first_row) {
    const double x = 3.0 * spare++ + 1.0, y = first_row + 1.0;
    add(a, b, c, {Vec2(x, y), Vec2(x + 1.5, y), Vec2(x, y + 1.5)});
  }
};

}  // namespace

const std::vector<TexturedInfo>& textured_models() {
  static const std::vector<TexturedInfo> list = {
      {"ridged_plate", 1024, "plate of 350 x 350 x 10 mm with sinusoidal ridges, 8 mm high"},
      {"striped_block", 1024, "block of 80 x 60 x 20 mm with stripes, 2 mm high, 10 mm apart"},
      {"ridged_block", 1024, "the same block with flat-topped ridges, 2 mm high, 10 mm apart"},
      {"gear", 1024, "gear of 80 mm, 24 mm wide, with 25 teeth like the ridges of the block"},
      {"hammer", 1024, "hammer of 240 mm, head and handle with knobs up to 0.6 mm high"},
      {"cad_part", 1024, "flange of 100 x 100 x 46 mm with a boss, rough by 0.45 mm"},
      {"file", 1024, "cross-cut file of 200 x 22 x 6 mm, cuts 0.3 mm high, 3 mm apart"},
      {"helicoidal_torus", 1024, "torus of 160 mm, its tube wound about by ridges 0.6 mm high"},
  };
  return list;
}

HapticTexture make_textured_model(const TexturedRequest& request) {
  const TexturedInfo& info = find_textured(request.name, "texture");
  const int texels = request.texels == 0 ? info.texels : request.texels;
  check_texels(texels, "texture");
  if (request.name == "ridged_plate") return make_ridged_plate(texels);
  // Stripes along y. Turned over about y, x becomes -x: two such blocks lie in each other because a
  // profile is odd.
  if (request.name == "striped_block")
    return make_block([](double turns) { return sine(2.0 * kPi * turns); }, texels, request.name);
  if (request.name == "ridged_block")
    return make_block([](double turns) { return flat_ridge(turns); }, texels, request.name);
  const std::vector<TexturedSheet> sheets = textured_part(request.name);
  return make_texture(make_textured_sheets(sheets, texels), request.name);
}

TexturedRequest parse_textured_uri(std::string_view uri, const std::string& where) {
  if (!is_model_uri(uri))
    throw InputError(where + ": no procedural texture, expected procedural:NAME?texels=N");
  std::string_view rest = uri.substr(uri.find(':') + 1);
  const std::size_t mark = rest.find('?');
  TexturedRequest request;
  request.name = find_textured(rest.substr(0, mark), where).name;
  if (mark == std::string_view::npos) return request;
  rest = rest.substr(mark + 1);
  constexpr std::string_view kKey = "texels=";
  const std::string_view value = rest.substr(std::min(kKey.size(), rest.size()));
  const auto [end, error] =
      std::from_chars(value.data(), value.data() + value.size(), request.texels);
  if (!rest.starts_with(kKey) || error != std::errc() || end != value.data() + value.size())
    throw InputError(where + ": unknown key or value, expected texels=N");
  check_texels(request.texels, where);
  return request;
}

HapticTexture make_block(const RidgeProfile& ridges, int texels, const std::string& name) {
  const TexturedSlab slab{{kBlockLong, kBlockWide, kBlockHigh}, texels, [&](double x, double) {
                            return 0.5 * kRidgeHeight * ridges(x / kRidgePitch);
                          }};
  return make_texture(make_textured_slab(slab), name);
}

TextureSource make_textured_slab(const TexturedSlab& slab) {
  constexpr int kSpareRows = 6;  // below the top: a border, triangles without relief, a border
  const int texels = slab.texels;
  const Vec3 half = 0.5 * slab.size;
  SlabBuilder b;
  for (const double z : {-half.z(), half.z()}) {
    for (const auto& [x, y] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {0, 0}})
      b.source.coarse.positions.push_back({x * half.x(), y * half.y(), z});
  }
  const double last = texels - 1.0;
  const std::array<Vec2, 5> place = {Vec2(0, 0), Vec2(last, 0), Vec2(last, last), Vec2(0, last),
                                     Vec2(0.5 * last, 0.5 * last)};
  for (std::int32_t k = 0; k < 4; ++k) {
    const std::int32_t next = (k + 1) % 4;
    b.add(5 + k, 5 + next, 9,
          {place[static_cast<std::size_t>(k)], place[static_cast<std::size_t>(next)], place[4]});
  }
  for (std::int32_t k = 0; k < 4; ++k) {
    const std::int32_t next = (k + 1) % 4;
    b.add_plain(next, k, 4, texels + 1);
    b.add_plain(k, next, 5 + next, texels + 1);
    b.add_plain(k, 5 + next, 5 + k, texels + 1);
  }
  b.source.width = std::max(texels, 3 * b.spare + 2);
  b.source.height = texels + kSpareRows;
  b.source.texels.assign(
      static_cast<std::size_t>(b.source.width) * static_cast<std::size_t>(b.source.height),
      Texel{});
  // One texel more where there is room: slopes at the rim are differences across it.
  const int columns = std::min(b.source.width, texels + 1);
  for (int row = 0; row <= texels; ++row) {
    for (int column = 0; column < columns; ++column) {
      const double x = slab.size.x() * (column / last - 0.5),
                   y = slab.size.y() * (row / last - 0.5);
      b.source
          .texels[static_cast<std::size_t>(row) * static_cast<std::size_t>(b.source.width) +
                  static_cast<std::size_t>(column)]
          .z = static_cast<float>(slab.height(x, y));
    }
  }
  return std::move(b.source);
}

}  // namespace thigma::models
