#include "thigma/texture/texture_file.h"

#include <cstring>

#include "depth/textured_plates.h"
#include "support/full.h"
#include <gtest/gtest.h>

#include "thigma/core/error.h"
#include "thigma/math/random.h"

namespace thigma {
namespace {

TextureAsset sample() {
  Random random(5);
  TextureAsset asset;
  asset.texture = make_texture(test::plate_source(random, {.texels = 12, .noise = 1e-5}), "plate");
  asset.figures = {3, 1.25, 1e-6, 4e-6, std::nullopt};
  return asset;
}

const std::string& sample_bytes() {
  static const std::string bytes = format_texture(sample());
  return bytes;
}

std::string complaint_of_file(std::string_view bytes, double scale = 1.0) {
  try {
    parse_texture(bytes, "a.tex", scale);
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()).rfind("a.tex: ", 0), 0u) << error.what();
    return error.what();
  }
  return "";
}

TEST(TextureFile, GivesBackEveryBit) {
  const TextureAsset wrote = sample(), read = parse_texture(sample_bytes(), "a.tex");
  EXPECT_EQ(format_texture(read), sample_bytes());
  const HapticTexture &a = wrote.texture, &b = read.texture;
  EXPECT_EQ(a.coarse.positions, b.coarse.positions);
  EXPECT_EQ(a.coarse.triangles, b.coarse.triangles);
  EXPECT_EQ(a.corners, b.corners);
  ASSERT_EQ(a.texels.size(), b.texels.size());
  EXPECT_EQ(std::memcmp(a.texels.data(), b.texels.data(), a.texels.size() * sizeof(Texel)), 0);
  EXPECT_EQ(a.texel_size, b.texel_size);
  EXPECT_EQ(a.amplitude, b.amplitude);
  EXPECT_EQ(a.pyramid.size(), b.pyramid.size());
  EXPECT_EQ(read.figures.charts, 3);
  EXPECT_EQ(read.figures.distortion_max, 1.25);
  EXPECT_EQ(read.figures.fit_error_max, 4e-6);
  EXPECT_FALSE(read.figures.crack_max.has_value());
}

TEST(TextureFile, ReadsFilesInOtherUnits) {
  const TextureAsset metres = sample();
  const TextureAsset scaled = parse_texture(sample_bytes(), "a.tex", 0.001);
  EXPECT_NEAR(scaled.texture.texel_size, 1e-3 * metres.texture.texel_size, 1e-15);
  EXPECT_NEAR(scaled.texture.amplitude, 1e-3 * metres.texture.amplitude,
              1e-6 * 1e-3 * metres.texture.amplitude);
  EXPECT_NEAR(*scaled.figures.fit_error_rms, 1e-9, 1e-18);
  for (const double wrong : {0.0, -1.0, std::numeric_limits<double>::infinity(), 1e60})
    EXPECT_NE(complaint_of_file(sample_bytes(), wrong), "") << wrong;
}

TEST(TextureFile, RefusesWhatIsCutOffOrChanged) {
  std::string bytes = sample_bytes();
  for (std::size_t size = 0; size < bytes.size(); size += size < 600 || test::is_full() ? 1 : 97)
    EXPECT_NE(complaint_of_file(std::string_view(bytes).substr(0, size)), "") << size;
  Random random(6);
  for (int i = 0; i < 500; ++i) {
    const std::size_t at = i < 400 ? static_cast<std::size_t>(i) : random.below(bytes.size());
    const int bit = static_cast<int>(random.below(8));
    bytes[at] = static_cast<char>(bytes[at] ^ (1 << bit));
    EXPECT_NE(complaint_of_file(bytes), "") << at << ' ' << bit;
    bytes[at] = static_cast<char>(bytes[at] ^ (1 << bit));
  }
  EXPECT_EQ(complaint_of_file(bytes), "");
  EXPECT_NE(complaint_of_file("v 0 0 0\n").find("no .tex file"), std::string::npos);
}

/// The sample with some bytes of a chunk replaced, its checksums right: a file that lies.
std::string with(const std::string& chunk, std::size_t at, std::string_view instead,
                 std::uint32_t record = 0) {
  const auto chunks = read_chunks(kTextureKind, sample_bytes(), "sample");
  ChunkWriter file(kTextureKind, chunks.size(), sample_bytes().size());
  for (const Chunk& c : chunks) {
    std::string bytes(c.bytes);
    if (c.name == chunk) bytes.replace(at, instead.size(), instead);
    file.begin(c.name, c.is_required, c.name == chunk && record > 0 ? record : c.record_bytes);
    file.out() += bytes;
  }
  return file.finish();
}

template <class T>
std::string bytes_of(T value) {
  return std::string(reinterpret_cast<const char*>(&value), sizeof value);
}

TEST(TextureFile, RefusesWhatLies) {
  EXPECT_EQ(complaint_of_file(with("figures", 0, bytes_of(std::int32_t{9}))), "");
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const struct {
    std::string bytes, says;
  } cases[] = {
      {with("map", 0, bytes_of(std::int32_t{16384})), "texels"},
      {with("map", 0, bytes_of(std::int32_t{-1})), "a map of"},
      {with("map", 0, "", 4), "records of 4 bytes"},
      {with("positions", 0, bytes_of(nan)), "position 0"},
      {with("positions", 8, bytes_of(1e60)), "position 0"},
      {with("triangles", 4, bytes_of(std::int32_t{1000})), "triangle 0"},
      {with("triangles", 4, bytes_of(std::int32_t{-1})), "triangle 0"},
      {with("corners", 0, bytes_of(nan)), "leaves the map"},
      {with("corners", 0, bytes_of(40.0)), "leaves the map"},
      {with("texels", 0, bytes_of(std::numeric_limits<float>::infinity())), "texel 0"},
      {with("texels", 0, bytes_of(1e3f)), "texel 0"},
  };
  for (const auto& c : cases)
    EXPECT_NE(complaint_of_file(c.bytes).find(c.says), std::string::npos)
        << complaint_of_file(c.bytes);
}

TEST(TextureFile, SkipsUnknownChunksThatAreOptional) {
  const auto chunks = read_chunks(kTextureKind, sample_bytes(), "sample");
  for (const bool is_required : {false, true}) {
    ChunkWriter file(kTextureKind, chunks.size() + 1, 0);
    for (const Chunk& c : chunks) {
      file.begin(c.name, c.is_required, c.record_bytes);
      file.out() += c.bytes;
    }
    file.begin("later", is_required, 4);
    file.out() += "abcd";
    EXPECT_EQ(complaint_of_file(file.finish()).empty(), !is_required);
  }
}

}  // namespace
}  // namespace thigma
