#include "thigma/clod/clod_file.h"

#include <bit>
#include <cstring>
#include <filesystem>

#include "clod/asset_samples.h"
#include "support/full.h"
#include <gtest/gtest.h>

#include "thigma/clod/detail/build_levels.h"
#include "thigma/contact/query_contacts.h"
#include "thigma/core/error.h"
#include "thigma/files/file.h"

namespace thigma {
namespace {

using test::sample_asset;

const std::string& sample_bytes() {
  static const std::string bytes = format_clod(sample_asset());
  return bytes;
}

/// What a reader says about bytes, "" when it takes them.
std::string complaint(std::string_view bytes) {
  try {
    parse_clod(bytes, "a.clod");
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()).rfind("a.clod: ", 0), 0u) << error.what();
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
    return error.what();
  }
  return "";
}

void expect_refused(const std::string& bytes, const std::string& says) {
  const std::string why = complaint(bytes);
  EXPECT_NE(why, "") << "expected: " << says;
  EXPECT_NE(why.find(says), std::string::npos) << why;
}

template <class T>
void expect_same_bits(const T& a, const T& b, const char* what) {
  ASSERT_EQ(a.size(), b.size()) << what;
  for (std::size_t i = 0; i < a.size(); ++i)
    ASSERT_EQ(std::memcmp(&a[i], &b[i], sizeof a[i]), 0) << what << ' ' << i;
}

TEST(ClodFile, GivesBackEveryBit) {
  const ClodAsset& wrote = sample_asset();
  const ClodAsset read = parse_clod(sample_bytes(), "a.clod");
  const ClodHierarchy &a = wrote.hierarchy, &b = read.hierarchy;
  ASSERT_GT(a.level_patches.size(), 10u);
  EXPECT_EQ(a.radius, b.radius);
  EXPECT_EQ(a.center, b.center);
  EXPECT_EQ(a.triangle_count, b.triangle_count);
  ASSERT_EQ(a.nodes.size(), b.nodes.size());
  for (std::size_t i = 0; i < a.nodes.size(); ++i) {
    const ClodNode &m = a.nodes[i], &n = b.nodes[i];
    EXPECT_TRUE(m.center == n.center && m.radius == n.radius && m.hausdorff == n.hausdorff &&
                m.first_child == n.first_child && m.child_count == n.child_count &&
                m.level == n.level && m.patch == n.patch && m.contact == n.contact &&
                m.first_vertex == n.first_vertex && m.vertex_count == n.vertex_count &&
                m.first_lane == n.first_lane && m.lane_count == n.lane_count);
  }
  expect_same_bits(a.vertices, b.vertices, "vertices");
  expect_same_bits(a.lanes, b.lanes, "lanes");
  expect_same_bits(a.support, b.support, "support");
  expect_same_bits(a.triangle_ids, b.triangle_ids, "triangle_ids");
  EXPECT_EQ(reinterpret_cast<std::uintptr_t>(b.lanes.data()) % 32, 0u);
  ASSERT_EQ(wrote.meshes.size(), read.meshes.size());
  ASSERT_GT(wrote.meshes.size(), 3u);
  for (std::size_t k = 0; k < wrote.meshes.size(); ++k) {
    expect_same_bits(wrote.meshes[k].positions, read.meshes[k].positions, "positions");
    expect_same_bits(wrote.meshes[k].triangles, read.meshes[k].triangles, "triangles");
  }
  EXPECT_EQ(wrote.mass.measure.inertia, read.mass.measure.inertia);
  EXPECT_TRUE(read.mass.is_closed);
  // Whatever else there is: written again, every byte is the same.
  EXPECT_EQ(format_clod(read), sample_bytes());
}

TEST(ClodFile, IsWrittenWholeOrNotAtAll) {
  const std::string path =
      (std::filesystem::temp_directory_path() / "thigma_clod_file_test.clod").string();
  write_clod(sample_asset(), path);
  EXPECT_EQ(format_clod(read_clod(path), path), read_file(path));
  std::filesystem::remove(path);
  EXPECT_THROW(write_clod(sample_asset(), "/no/such/folder/a.clod"), IoError);
}

TEST(ClodFile, TakesExactHierarchiesAndTheFormOfTheText) {
  ClodAsset exact;
  exact.hierarchy = build_exact_hierarchy(test::wavy_ball(4));
  EXPECT_EQ(format_clod(parse_clod(format_clod(exact), "exact")), format_clod(exact));
  ClodAsset of_the_text;
  of_the_text.hierarchy =
      detail::build_levels(test::wavy_ball(4), test::generous(),
                           {.is_reparented = false, .has_culling_hulls = false}, nullptr);
  of_the_text.origin.is_reparented = of_the_text.origin.has_culling_hulls = false;
  const std::string bytes = format_clod(of_the_text);
  EXPECT_EQ(format_clod(parse_clod(bytes, "text")), bytes);
}

TEST(ClodFile, SameBytesWhateverTheThreads) {
  ClodParams params = test::generous();
  for (const int threads : {1, 2, 3}) {
    params.threads = threads;
    EXPECT_EQ(format_clod(build_clod_asset(test::sample_mesh(), params)), sample_bytes())
        << threads;
  }
}

TEST(ClodFile, ReadsFilesInOtherUnits) {
  const std::string path = ::testing::TempDir() + "thigma_unit.clod";
  write_file(path, sample_bytes());
  ClodAsset scaled = read_clod(path, 0.001);
  EXPECT_NEAR(scaled.hierarchy.radius, 0.001 * sample_asset().hierarchy.radius, 1e-15);
  EXPECT_EQ(find_flaw(scaled.hierarchy), "");
  EXPECT_EQ(scaled.origin.unit_scale, 0.001);
  for (const double wrong : {0.0, -1.0, 1e60, std::numeric_limits<double>::infinity()})
    EXPECT_THROW(read_clod(path, wrong), InputError);
  std::remove(path.c_str());
}

TEST(ClodFile, RefusesWhatIsCutOff) {
  const std::string& whole = sample_bytes();
  for (std::size_t size = 0; size < whole.size(); size += size < 2000 || test::is_full() ? 1 : 997)
    EXPECT_NE(complaint(std::string_view(whole).substr(0, size)), "") << size;
  expect_refused(whole.substr(0, whole.size() - 1), "cut off");
  expect_refused(whole + std::string(64, '\0'), "goes on");
}

TEST(ClodFile, FindsEveryChangedBit) {
  std::string bytes = sample_bytes();
  Random random(33);
  const auto flip = [&](std::size_t at, int bit) {
    bytes[at] = static_cast<char>(bytes[at] ^ (1 << bit));
    EXPECT_NE(complaint(bytes), "") << "byte " << at << " bit " << bit;
    bytes[at] = static_cast<char>(bytes[at] ^ (1 << bit));
  };
  for (std::size_t at = 0; at < 64 + 20 * 64; ++at) flip(at, static_cast<int>(at % 8));
  for (int i = 0; i < 300; ++i) flip(random.below(bytes.size()), static_cast<int>(random.below(8)));
  EXPECT_EQ(complaint(bytes), "");
}

TEST(ClodFile, SaysWhatIsWrong) {
  std::string newer = sample_bytes();
  newer[8] = 2;
  expect_refused(newer, "version 2");
  std::string other = sample_bytes();
  other[1] = 'X';
  expect_refused(other, "no .clod file");
  expect_refused("v 0 0 0\n", "no .clod file");
  std::string damaged = sample_bytes();
  damaged.back() = static_cast<char>(damaged.back() ^ 1);
  EXPECT_NE(complaint(damaged), "");
}

/// The sample with one more chunk.
std::string with_chunk(const std::string& name, bool is_required) {
  const auto chunks = read_chunks(kClodKind, sample_bytes(), "sample");
  ChunkWriter file(kClodKind, chunks.size() + 1, sample_bytes().size());
  file.begin(name, is_required, 3);
  file.out() += "abcdef";
  for (const Chunk& chunk : chunks) {
    file.begin(chunk.name, chunk.is_required, chunk.record_bytes);
    file.out() += chunk.bytes;
  }
  return file.finish();
}

TEST(ClodFile, SkipsWhatItNeedNotKnow) {
  EXPECT_EQ(format_clod(parse_clod(with_chunk("later", false), "a.clod")), sample_bytes());
  expect_refused(with_chunk("later", true), "newer thigma");
  expect_refused(with_chunk("nodes", false), "twice");
}

TEST(ClodFile, IsWhatTheDocumentSays) {
  const std::string text = read_file(THIGMA_SOURCE_DIR "/docs/formats.md");
  std::size_t last = 0;
  for (const Chunk& chunk : read_chunks(kClodKind, sample_bytes(), "sample")) {
    const std::string row = "| `" + chunk.name + "` | " + std::to_string(chunk.record_bytes) + " |";
    const std::size_t at = text.find(row);
    ASSERT_NE(at, std::string::npos) << row;
    EXPECT_GT(at, last) << "in the order of the file: " << row;
    last = at;
    const bool is_optional =
        chunk.name == "mass" || chunk.name == "origin" || chunk.name.starts_with("mesh_");
    EXPECT_EQ(chunk.is_required, !is_optional) << chunk.name;
  }
}

TEST(ClodFile, RefusesMissingAndMisshapenChunks) {
  const auto chunks = read_chunks(kClodKind, sample_bytes(), "sample");
  for (const Chunk& odd : chunks) {
    ChunkWriter without(kClodKind, chunks.size() - 1, 0), shorter(kClodKind, chunks.size(), 0),
        wider(kClodKind, chunks.size(), 0);
    for (const Chunk& chunk : chunks) {
      const bool is_odd = chunk.name == odd.name;
      for (ChunkWriter* file : {&without, &shorter, &wider}) {
        if (is_odd && file == &without) continue;
        const std::uint32_t gain = is_odd && file == &wider ? 1 : 0;
        file->begin(chunk.name, chunk.is_required, chunk.record_bytes + gain);
        const std::size_t loss = is_odd && file == &shorter ? chunk.record_bytes : 0;
        if (gain == 0) file->out() += chunk.bytes.substr(0, chunk.bytes.size() - loss);
      }
    }
    EXPECT_EQ(complaint(without.finish()) != "",
              odd.is_required || odd.name.starts_with("mesh_p") || odd.name.starts_with("mesh_t"))
        << odd.name;
    EXPECT_NE(complaint(shorter.finish()), "") << odd.name;
    EXPECT_NE(complaint(wider.finish()), "") << odd.name;
  }
}

/// Writes a few bytes over a chunk and gives everything its right checksum again: a file that lies.
std::string lying_file(Random& random) {
  const auto chunks = read_chunks(kClodKind, sample_bytes(), "sample");
  std::vector<std::string> bytes;
  for (const Chunk& chunk : chunks) bytes.emplace_back(chunk.bytes);
  const auto lies = 1 + random.below(4);
  for (std::uint64_t i = 0; i < lies; ++i) {
    std::string& target = bytes[random.below(bytes.size())];
    if (target.size() < 8) continue;
    const std::size_t at = random.below(target.size() - 7);
    const std::uint64_t kinds[] = {random.next(),      0,
                                   ~std::uint64_t{0},  0x7fffffff,
                                   0x7ff0000000000000, 0x7ff8000000000000,
                                   random.below(64),   std::uint64_t{1} << random.below(64)};
    const std::uint64_t kind = random.below(9);
    std::uint64_t value = 0;
    std::memcpy(&value, target.data() + at, 8);
    value = kind == 8 ? value ^ std::uint64_t{1} << random.below(64) : kinds[kind];
    std::memcpy(target.data() + at, &value, 1 + random.below(8));
  }
  ChunkWriter file(kClodKind, chunks.size(), sample_bytes().size());
  for (std::size_t i = 0; i < chunks.size(); ++i) {
    const std::size_t record = chunks[i].record_bytes;
    if (random.below(40) == 0)  // records gone or too many
      bytes[i].resize(record * random.below(2 * chunks[i].record_count + 2),
                      static_cast<char>(random.next()));
    file.begin(chunks[i].name, chunks[i].is_required, chunks[i].record_bytes);
    file.out() += bytes[i];
  }
  return file.finish();
}

/// Everything a program does with an asset. A wrong answer is no wonder, a crash or a hang is a
/// failure.
void use(const ClodAsset& asset) {
  const ClodHierarchy& other = sample_asset().hierarchy;
  ContactSet set;
  set.contacts.reserve(64);
  for (const bool is_exact : {true, false}) {
    ContactFront front, back;
    reserve_front(front, asset.hierarchy, other, 2000);
    reserve_front(back, other, asset.hierarchy, 2000);
    ContactQuery query{.tolerance = 0.02};
    query.resolution.is_exact = is_exact;
    for (int i = 0; i < 3; ++i) {
      Pose pose;
      pose.position = Vec3(0.3, 1.98 - 0.02 * i, 0.2);
      clear(set);
      query_contacts({asset.hierarchy, pose}, {other}, query, front, set);
      query_contacts({other, pose}, {asset.hierarchy}, query, back, set);
      EXPECT_LE(set.contacts.size(), 64u);
    }
  }
  for (std::size_t k = 0; k < asset.meshes.size(); ++k)
    EXPECT_EQ(patches_of_triangles(asset, static_cast<std::int32_t>(k)).size(),
              asset.meshes[k].triangles.size());
}

TEST(ClodFile, NoLieIsFollowed) {
  Random random(2021);
  int taken = 0;
  for (int round = 0; round < (test::is_full() ? 1000 : 250); ++round) {
    ClodAsset asset;
    try {
      asset = parse_clod(lying_file(random), "a.clod");
    } catch (const InputError& error) {
      EXPECT_EQ(std::string(error.what()).rfind("a.clod: ", 0), 0u) << error.what();
      continue;
    }
    ++taken;
    use(asset);
  }
  RecordProperty("taken", taken);
  std::printf("%d lying files read, the others refused\n", taken);
  EXPECT_GT(taken, 5) << "some lies cannot be seen";
}

TEST(ClodFile, BrokenAssetsAreNotWritten) {
  ClodAsset asset = sample_asset();
  asset.hierarchy.nodes[3].first_vertex = -1;
  EXPECT_THROW(format_clod(asset), InputError);
}

}  // namespace
}  // namespace thigma
