// Packed records in named chunks. What is read goes through make_texture like any other source;
// only indices, which it takes for granted, are checked here.
#include "thigma/texture/texture_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>

#include "thigma/files/file.h"
#include "thigma/import/read_mesh.h"
#include "thigma/texture/detail/texture_error.h"

namespace thigma {
namespace {

using detail::fail;

constexpr std::uint32_t kMapRecord = 8, kPositionRecord = 24, kTriangleRecord = 12,
                        kCornersRecord = 48, kTexelRecord = 12, kFiguresRecord = 36;

template <class T>
void put(std::string& out, const T& value) {
  static_assert(std::is_trivially_copyable_v<T>);
  out.append(reinterpret_cast<const char*>(&value), sizeof value);
}

template <class T>
T take(const char*& at) {
  T value;
  std::memcpy(&value, at, sizeof value);
  at += sizeof value;
  return value;
}

/// The chunks this version knows, by name.
struct Chunks {
  std::vector<Chunk> all;
  const std::string& name;

  const Chunk* find(std::string_view wanted, std::uint32_t record) const {
    for (const Chunk& chunk : all) {
      if (chunk.name != wanted) continue;
      if (chunk.record_bytes != record)
        fail(name,
             "records of " + std::to_string(chunk.record_bytes) + " bytes, chunk " + chunk.name,
             std::to_string(record));
      return &chunk;
    }
    return nullptr;
  }
  const Chunk& get(std::string_view wanted, std::uint32_t record) const {
    const Chunk* chunk = find(wanted, record);
    if (!chunk) fail(name, "no chunk " + std::string(wanted) + ", in its table", "one");
    return *chunk;
  }
};

Chunks known_chunks(std::string_view bytes, const std::string& name) {
  constexpr std::array<std::string_view, 6> kKnown = {"map",     "positions", "triangles",
                                                      "corners", "texels",    "figures"};
  Chunks chunks{{}, name};
  for (Chunk& chunk : read_chunks(kTextureKind, bytes, name)) {
    if (chunk.name == "levels")
      fail(name, "textures of levels of detail, in its table",
           "mesh = the .clod they were baked onto, beside them in a scene");
    const bool is_known = std::find(kKnown.begin(), kKnown.end(), chunk.name) != kKnown.end();
    if (!is_known && chunk.is_required)
      fail(name, "needs what this version does not know, chunk " + chunk.name, "a newer thigma");
    if (is_known) chunks.all.push_back(std::move(chunk));
  }
  return chunks;
}

void read_surface(const Chunks& chunks, double scale, TriangleMesh& mesh) {
  const Chunk& positions = chunks.get("positions", kPositionRecord);
  const char* at = positions.bytes.data();
  mesh.positions.resize(positions.record_count);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    Vec3& p = mesh.positions[i];
    for (int k = 0; k < 3; ++k) p[k] = scale * take<double>(at);
    if (!(p.cwiseAbs().maxCoeff() <= kMaxCoordinate))
      fail(chunks.name, "a position out of range, position " + std::to_string(i), "at most 1e50");
  }
  const Chunk& triangles = chunks.get("triangles", kTriangleRecord);
  at = triangles.bytes.data();
  mesh.triangles.resize(triangles.record_count);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    for (std::int32_t& v : mesh.triangles[i]) {
      v = take<std::int32_t>(at);
      if (v < 0 || static_cast<std::size_t>(v) >= mesh.positions.size())
        fail(chunks.name, "an index out of range, triangle " + std::to_string(i), "its positions");
    }
  }
}

void read_map(const Chunks& chunks, double scale, TextureSource& source) {
  const Chunk& map = chunks.get("map", kMapRecord);
  if (map.record_count != 1) fail(chunks.name, "map more or less than once, in that chunk", "1");
  const char* at = map.bytes.data();
  source.width = take<std::int32_t>(at);
  source.height = take<std::int32_t>(at);
  const Chunk& corners = chunks.get("corners", kCornersRecord);
  at = corners.bytes.data();
  source.corners.resize(corners.record_count);
  for (std::array<Vec2, 3>& triangle : source.corners) {
    for (Vec2& corner : triangle) {
      const double x = take<double>(at), y = take<double>(at);
      corner = {x, y};
    }
  }
  const Chunk& texels = chunks.get("texels", kTexelRecord);
  at = texels.bytes.data();
  source.texels.resize(texels.record_count);
  const auto scaled = [&] { return static_cast<float>(scale * double{take<float>(at)}); };
  for (Texel& texel : source.texels) {
    texel.x = scaled();
    texel.y = scaled();
    texel.z = scaled();
  }
}

// What is not known is written as not a number.
double number(const std::optional<double>& value) {
  return value.value_or(std::numeric_limits<double>::quiet_NaN());
}

std::optional<double> maybe(double value) {
  return std::isfinite(value) ? std::optional<double>(value) : std::nullopt;
}

BakeFigures read_figures(const Chunk& chunk, double scale) {
  BakeFigures figures;
  if (chunk.record_count != 1) return figures;
  const char* at = chunk.bytes.data();
  figures.charts = take<std::int32_t>(at);
  figures.distortion_max = maybe(take<double>(at)).value_or(0.0);
  figures.fit_error_rms = maybe(scale * take<double>(at));
  figures.fit_error_max = maybe(scale * take<double>(at));
  figures.crack_max = maybe(scale * take<double>(at));
  return figures;
}

}  // namespace

std::string format_texture(const TextureAsset& asset) {
  const HapticTexture& t = asset.texture;
  const std::size_t texels =
      static_cast<std::size_t>(t.width) * static_cast<std::size_t>(t.height) * kTexelRecord;
  ChunkWriter file(kTextureKind, 6,
                   texels + t.corners.size() * (kCornersRecord + kTriangleRecord) +
                       t.coarse.positions.size() * kPositionRecord);
  file.begin("map", true, kMapRecord);
  put(file.out(), std::int32_t{t.width});
  put(file.out(), std::int32_t{t.height});
  file.begin("positions", true, kPositionRecord);
  for (const Vec3& p : t.coarse.positions)
    for (int k = 0; k < 3; ++k) put(file.out(), p[k]);
  file.begin("triangles", true, kTriangleRecord);
  for (const auto& triangle : t.coarse.triangles) put(file.out(), triangle);
  file.begin("corners", true, kCornersRecord);
  for (const auto& triangle : t.corners) {
    for (const Vec2& corner : triangle) {
      put(file.out(), corner.x());
      put(file.out(), corner.y());
    }
  }
  file.begin("texels", true, kTexelRecord);
  for (int row = 0; row < t.height; ++row) {
    for (int column = 0; column < t.width; ++column) {
      const Texel& texel = texel_at(t, column, row);
      for (const float value : {texel.x, texel.y, texel.z}) put(file.out(), value);
    }
  }
  const BakeFigures& f = asset.figures;
  file.begin("figures", false, kFiguresRecord);
  put(file.out(), f.charts);
  for (const double value :
       {f.distortion_max, number(f.fit_error_rms), number(f.fit_error_max), number(f.crack_max)})
    put(file.out(), value);
  return file.finish();
}

TextureAsset parse_texture(std::string_view bytes, const std::string& name, double unit_scale) {
  if (!(unit_scale > 0.0) || !std::isfinite(unit_scale))
    fail(name, "the scale is " + std::to_string(unit_scale) + ", as given",
         "a positive number of metres per unit");
  const Chunks chunks = known_chunks(bytes, name);
  TextureSource source;
  read_surface(chunks, unit_scale, source.coarse);
  read_map(chunks, unit_scale, source);
  TextureAsset asset;
  if (const Chunk* figures = chunks.find("figures", kFiguresRecord))
    asset.figures = read_figures(*figures, unit_scale);
  asset.texture = make_texture(std::move(source), name);
  return asset;
}

TextureAsset read_texture(const std::string& path, double unit_scale) {
  return parse_texture(read_file(path), path, unit_scale);
}

bool is_texture(std::string_view bytes) { return bytes.starts_with(kTextureKind.magic); }

}  // namespace thigma
