// Levels of detail in the cache: found again, built again when anything is different, whole at
// any moment.

#include "thigma/scene/asset_cache.h"

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <thread>

#include <gtest/gtest.h>
#include <unistd.h>

#include "thigma/clod/clod_file.h"
#include "thigma/clod/validate_hierarchy.h"
#include "thigma/core/error.h"
#include "thigma/files/checksum.h"
#include "thigma/files/compression.h"
#include "thigma/files/file.h"
#include "thigma/import/write_mesh.h"
#include "thigma/mesh/shapes.h"

namespace thigma {
namespace {

namespace fs = std::filesystem;

/// A mesh in a folder of its own; the user's cache is inside it, too.
class AssetCacheFiles : public ::testing::Test {
 protected:
  void SetUp() override {
    static int count = 0;
    folder_ = fs::temp_directory_path() /
              ("thigma_cache_" + std::to_string(::getpid()) + "_" + std::to_string(count++));
    fs::create_directories(folder_ / "meshes");
    ::setenv("XDG_CACHE_HOME", (folder_ / "home").c_str(), 1);
    source_.name = (folder_ / "meshes" / "torus.obj").string();
    source_.params.simplify.stages = simplify_stages(0.5, 0.5);
    source_.params.simplify.deviation_limit = 0.05;
    write_mesh(make_torus(1.0, 0.4, 16, 12));
  }
  void TearDown() override { fs::remove_all(folder_); }

  void write_mesh(const TriangleMesh& mesh) const {
    write_file(source_.name, format_mesh(mesh, MeshFormat::obj, "torus"));
  }
  ClodAsset load(const AssetCache& cache = {}) {
    told_.clear();
    return load_clod_cached(source_, cache,
                            [this](const std::string& text) { told_ += text + "\n"; });
  }
  bool says(const char* text) const { return told_.find(text) != std::string::npos; }
  std::vector<fs::path> kept(const char* where) const {
    std::vector<fs::path> files;
    if (!fs::exists(folder_ / where)) return files;
    for (const auto& entry : fs::recursive_directory_iterator(folder_ / where))
      if (entry.is_regular_file() && entry.path() != source_.name) files.push_back(entry.path());
    return files;
  }

  fs::path folder_;
  ClodSource source_;
  std::string told_;
};

TEST_F(AssetCacheFiles, AreBuiltOnce) {
  const std::string built = format_clod(load());
  EXPECT_TRUE(says("built in"));
  EXPECT_TRUE(says("kept in"));
  EXPECT_EQ(kept("meshes").size(), 0u);  // a user's folder stays as it is
  ASSERT_EQ(kept("home").size(), 1u);
  EXPECT_EQ(kept("home")[0].filename().string().rfind("torus.obj.", 0), 0u);
  EXPECT_EQ(kept("home")[0].extension(), has_zstd() ? ".zst" : ".clod");
  EXPECT_EQ(format_clod(load()), built);
  EXPECT_EQ(told_, "");
}

TEST_F(AssetCacheFiles, FollowTheMesh) {
  load();
  write_mesh(make_torus(1.0, 0.3, 16, 12));
  const ClodAsset second = load();
  EXPECT_TRUE(says("built in"));
  EXPECT_NEAR(second.mass.measure.volume, 2.0 * 9.87 * 0.09, 0.2);
  EXPECT_EQ(kept("home").size(), 2u);
  load();
  EXPECT_EQ(told_, "");
}

TEST_F(AssetCacheFiles, FollowTheParameters) {
  const std::string first = format_clod(load());
  source_.params.simplify.deviation_limit = 0.03;
  EXPECT_NE(format_clod(load()), first);
  EXPECT_EQ(kept("home").size(), 2u);
  source_.params.simplify.deviation_limit = 0.05;
  EXPECT_EQ(format_clod(load()), first);
  EXPECT_EQ(told_, "");
  source_.params.threads = 2;  // same bytes, same asset
  EXPECT_EQ(format_clod(load()), first);
  EXPECT_EQ(told_, "");
}

TEST_F(AssetCacheFiles, ServeEveryScale) {
  const double radius = load().hierarchy.radius;
  source_.scale = 0.001;
  const ClodAsset scaled = load();
  EXPECT_EQ(told_, "");
  EXPECT_NEAR(scaled.hierarchy.radius, 0.001 * radius, 1e-12);
  EXPECT_EQ(scaled.origin.unit_scale, 0.001);
  EXPECT_EQ(find_flaw(scaled.hierarchy), "");
  source_.contact_tolerance = 1e-5;  // in metres, so another asset
  load();
  EXPECT_TRUE(says("built in"));
}

TEST_F(AssetCacheFiles, AreBuiltAgainWhenDamaged) {
  const std::string whole = format_clod(load());
  const std::string path = kept("home").at(0).string();
  for (const std::string& damaged :
       {std::string(), whole.substr(0, whole.size() / 2), std::string("v 0 0 0\n"), whole + "x"}) {
    write_file(path, damaged);
    EXPECT_EQ(format_clod(load()), whole);
    EXPECT_TRUE(says("built again")) << told_;
    told_.clear();
    EXPECT_EQ(format_clod(load()), whole);
    EXPECT_EQ(told_, "") << "what was built is kept, whole";
  }
}

TEST_F(AssetCacheFiles, AreCompressedAndBuiltAgainWhereTheFrameIsDamaged) {
  if (!has_zstd()) GTEST_SKIP() << "this build has no zstd";
  const std::string whole = format_clod(load());
  const std::string path = kept("home").at(0).string(), frame = read_file(path);
  EXPECT_LT(frame.size(), whole.size() * 2 / 3);
  EXPECT_EQ(expand(frame, whole.size()), whole);
  std::string flipped = frame, lying = frame;
  flipped[frame.size() / 2] = static_cast<char>(flipped[frame.size() / 2] ^ 0x40);
  lying[6] = static_cast<char>(lying[6] + 1);  // the size that the frame says
  for (const std::string& damaged : {frame.substr(0, frame.size() / 2), flipped, lying}) {
    write_file(path, damaged);
    EXPECT_EQ(format_clod(load()), whole);
    EXPECT_TRUE(says("built again")) << told_;
    EXPECT_EQ(read_file(path), frame);
  }
}

TEST_F(AssetCacheFiles, OfEarlierProgramsAreNotCompressedAndUsed) {
  const std::string whole = format_clod(load());
  const fs::path path = kept("home").at(0);
  if (path.extension() != ".zst") GTEST_SKIP() << "this build has no zstd";
  fs::remove(path);
  write_file((path.parent_path() / path.stem()).string(), whole);
  told_.clear();
  EXPECT_EQ(format_clod(load()), whole);
  EXPECT_EQ(told_, "");
  EXPECT_EQ(list_cache(cache_folder()).size(), 1u);
}

TEST_F(AssetCacheFiles, AreBuiltAgainByAProgramThatBuildsOtherwise) {
  ClodAsset other = load();
  const std::string wanted = format_clod(other);
  other.origin.key[0] ^= 1;
  write_file(kept("home").at(0).string(), format_clod(other));
  EXPECT_EQ(format_clod(load()), wanted);
  EXPECT_TRUE(says("another version")) << told_;
}

TEST_F(AssetCacheFiles, AreListedAndCleared) {
  EXPECT_TRUE(list_cache(cache_folder()).empty());
  load();
  source_.name = "procedural:ball?triangles=320";
  load();
  const fs::path stranger = folder_ / "home" / "thigma" / "notes.txt";
  write_file(stranger.string(), "mine");
  const std::vector<KeptAsset> all = list_cache(cache_folder());
  ASSERT_EQ(all.size(), 2u);
  EXPECT_NE(all[0].path.find("ball."), std::string::npos);
  EXPECT_EQ(all[0].bytes, fs::file_size(all[0].path));
  // One that has not been used for ten days.
  fs::last_write_time(all[0].path, fs::file_time_type::clock::now() - std::chrono::hours(240));
  EXPECT_NEAR(list_cache(cache_folder())[0].age, 864000.0, 60.0);
  EXPECT_EQ(clear_cache(cache_folder(), 11.0 * 86400.0).size(), 0u);
  load();  // uses it
  EXPECT_LT(list_cache(cache_folder())[0].age, 60.0);
  fs::last_write_time(all[0].path, fs::file_time_type::clock::now() - std::chrono::hours(240));
  EXPECT_EQ(clear_cache(cache_folder(), 9.0 * 86400.0).size(), 1u);
  EXPECT_EQ(clear_cache(cache_folder()).size(), 1u);
  EXPECT_TRUE(list_cache(cache_folder()).empty());
  EXPECT_TRUE(fs::exists(stranger));
}

// Levels that were kept outlive a rebuild of the program, so the number has to change with the
// bytes, and only then: raise kBuildRevision and write both here.
TEST_F(AssetCacheFiles, HaveANumberForTheirBytes) {
  std::string bytes;
  for (const char* name : {"procedural:ball?triangles=2000", "procedural:torus?triangles=2000"}) {
    source_.name = name;
    ClodAsset asset = load({.is_enabled = false, .folder = ""});
    bytes += format_clod(asset);
  }
  EXPECT_EQ(kBuildRevision, 1);
  EXPECT_EQ(hex_text(sha256(bytes)).substr(0, 16), "998092bebdc4d25e");
}

TEST_F(AssetCacheFiles, AreNotNeeded) {
  ::setenv("XDG_CACHE_HOME", "relative", 1);
  ::setenv("HOME", "", 1);
  source_.name = "procedural:ball?triangles=320";
  EXPECT_EQ(load().hierarchy.triangle_count, 320);
  EXPECT_TRUE(says("not kept")) << told_;
  EXPECT_EQ(load({.is_enabled = false, .folder = ""}).hierarchy.triangle_count, 320);
  EXPECT_EQ(told_, "");
}

TEST_F(AssetCacheFiles, KeepModelsForTheUser) {
  source_.name = "procedural:ball?triangles=320";
  load();
  EXPECT_TRUE(says("home/thigma/ball."));
  source_.name = "procedural:ball?triangles=320&seed=1";  // the same
  load();
  EXPECT_EQ(told_, "");
  source_.name = "procedural:ball?triangles=500";
  load();
  EXPECT_TRUE(says("built in"));
  EXPECT_EQ(kept("home").size(), 2u);
  load({.is_enabled = true, .folder = (folder_ / "chosen").string()});
  EXPECT_EQ(kept("chosen").size(), 1u);
}

TEST_F(AssetCacheFiles, TakeClodFilesAsTheyAre) {
  write_file((folder_ / "meshes" / "a.clod").string(), format_clod(load()));
  source_.name = (folder_ / "meshes" / "a.clod").string();
  source_.scale = 2.0;
  EXPECT_NEAR(load().hierarchy.radius, 2.8, 1e-9);
  EXPECT_EQ(told_, "");
  EXPECT_TRUE(is_clod_file(source_.name));
  EXPECT_FALSE(is_clod_file((folder_ / "meshes" / "torus.obj").string()));
  EXPECT_THROW(load_surface(source_), InputError);
}

TEST_F(AssetCacheFiles, AreWholeWhoeverWritesThem) {
  const std::string wanted = format_clod(load());
  const fs::path path = kept("home").at(0);
  std::vector<std::thread> others;
  std::atomic<int> wrong{0};
  for (int t = 0; t < 4; ++t)
    others.emplace_back([&, t] {
      for (int i = 0; i < 3; ++i) {
        if (t == 0) fs::remove(path);
        if (format_clod(load_clod_cached(source_)) != wanted) ++wrong;
      }
    });
  for (std::thread& other : others) other.join();
  EXPECT_EQ(wrong, 0);
  load();
  EXPECT_EQ(kept("home").size(), 1u);
}

}  // namespace
}  // namespace thigma
