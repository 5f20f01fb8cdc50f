#include "thigma/scene/packed_scene.h"

#include <filesystem>

#include <gtest/gtest.h>

#include "thigma/clod/clod_asset.h"
#include "thigma/core/error.h"
#include "thigma/files/byte_source.h"
#include "thigma/files/file.h"
#include "thigma/scene/load_scene.h"
#include "thigma/scene/scene_file.h"

namespace thigma {
namespace {

namespace fs = std::filesystem;

constexpr const char* kOctahedron =
    "v 15 0 0\nv -15 0 0\nv 0 15 0\nv 0 -15 0\nv 0 0 15\nv 0 0 -15\nf 1 3 5\nf 3 2 5\nf 2 4 5\n"
    "f 4 1 5\nf 3 1 6\nf 2 3 6\nf 4 2 6\nf 1 4 6\n";

class PackedScene : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(::testing::TempDir()) /
              ::testing::UnitTest::GetInstance()->current_test_info()->name();
    fs::remove_all(folder_);
    fs::create_directories(folder_ / "a");
    fs::create_directories(folder_ / "b");
    fs::create_directories(folder_ / "out");
    write_file(path("a/scan.obj"), kOctahedron);
    write_file(path("b/scan.obj"), std::string("# another\n") + kOctahedron);
    write_file(path("scene.toml"),
               "title = \"Two scans\"\n[object]\nmesh = \"a/scan.obj\"\nunit_scale = 1e-3\n"
               "position = [0, 0, 0.04]\n[[static]]\nmesh = \"b/scan.obj\"\nunit_scale = 1e-3\n"
               "[static.material]\nfriction = 0.3\n[[static]]\nmesh = \"a/scan.obj\"\n"
               "unit_scale = 2e-3\nposition = [0.1, 0, 0]\n[device]\nuri = \"script:x.csv\"\n");
  }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  /// A file with these attachments, and what opening it says.
  std::string refusal_of(const std::vector<McapAttachment>& files) {
    const std::string packed = path("hostile.mcap");
    {
      McapWriter writer(packed);
      for (const McapAttachment& file : files) writer.attach(file);
      writer.close();
    }
    try {
      read_packed_scene(packed, path("out"));
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }

  fs::path folder_;
};

TEST_F(PackedScene, IsWholeInAnEmptyFolder) {
  write_packed_scene(path("two.mcap"), read_scene(path("scene.toml")));
  fs::remove_all(folder_ / "a");
  fs::remove_all(folder_ / "b");
  EXPECT_TRUE(has_packed_scene(path("two.mcap")));
  EXPECT_TRUE(is_packed_scene(path("two.mcap")));
  const SceneDescription scene = read_packed_scene(path("two.mcap"), path("out"));
  EXPECT_EQ(scene.title, "Two scans");
  EXPECT_EQ(scene.object.world_from_mesh.position, Vec3(0, 0, 0.04));
  ASSERT_EQ(scene.statics.size(), 2u);
  EXPECT_EQ(scene.statics[0].material->friction.kinetic, 0.3);
  EXPECT_EQ(scene.statics[1].mesh, scene.object.mesh) << "the same file is packed once";
  EXPECT_NE(scene.statics[0].mesh, scene.object.mesh) << "two files of one name stay two";
  EXPECT_EQ(read_file(scene.object.mesh), kOctahedron);
  EXPECT_EQ(scene.device.uri, "hand:") << "what comes from elsewhere moves nothing by itself";
  const Scene loaded = load_scene(scene);
  EXPECT_EQ(loaded.object->hierarchy.triangle_count, 8);
}

TEST_F(PackedScene, SavedAsTomlItRunsFromItsFolder) {
  fs::create_directories(folder_ / "saved");
  write_scene_folder(path("saved/mine.toml"), read_scene(path("scene.toml")));
  fs::remove_all(folder_ / "a");
  fs::remove_all(folder_ / "b");
  fs::rename(folder_ / "saved", folder_ / "moved");
  const SceneDescription scene = read_scene(path("moved/mine.toml"));
  EXPECT_EQ(read_file(scene.object.mesh), kOctahedron);
  EXPECT_EQ(scene.statics[0].material->friction.kinetic, 0.3);
}

TEST_F(PackedScene, ABuiltInSceneNeedsNoFiles) {
  EXPECT_EQ(pack_scene(read_scene("jaws")).size(), 1u);
  write_packed_scene(path("jaws.mcap"), read_scene("jaws"));
  EXPECT_EQ(read_packed_scene(path("jaws.mcap"), path("out")).object.mesh,
            read_scene("jaws").object.mesh);
}

TEST_F(PackedScene, NoNameLeadsOutOfTheFolder) {
  const McapAttachment scene{"scene.toml", "application/toml",
                             "[object]\nmesh = \"procedural:ball\"\n"};
  EXPECT_EQ(refusal_of({scene}), "");
  for (const char* name :
       {"../evil", "assets/../../evil", "/etc/evil", "assets/a/b", "assets/.hidden", "assets/",
        "evil", "assets\\x", "assets/a b", "SCENE.TOML", ""}) {
    EXPECT_NE(refusal_of({scene, {name, "", "x"}}).find("an attachment '"), std::string::npos)
        << name;
  }
  McapAttachment long_name{"assets/", "", "x"};
  long_name.name.append(101, 'x');
  EXPECT_NE(refusal_of({scene, long_name}), "");
  EXPECT_NE(refusal_of({scene, scene}).find("two attachments"), std::string::npos);
  EXPECT_NE(refusal_of({{"assets/a", "", "x"}}).find("no scene in it"), std::string::npos);
  EXPECT_FALSE(fs::exists(folder_ / "evil"));
}

TEST_F(PackedScene, ASceneFromElsewhereReadsItsOwnFilesAlone) {
  const auto with_mesh = [](const std::string& mesh) {
    return McapAttachment{"scene.toml", "", "[object]\nunit_scale = 1\nmesh = \"" + mesh + "\"\n"};
  };
  const McapAttachment asset{"assets/ok.obj", "", kOctahedron};
  EXPECT_EQ(refusal_of({with_mesh("assets/ok.obj"), asset}), "");
  for (const std::string& mesh :
       {path("a/scan.obj"), std::string("../a/scan.obj"), std::string("assets/../../a/scan.obj"),
        std::string("assets/../assets/ok.obj"), std::string("scene.toml")}) {
    EXPECT_NE(refusal_of({with_mesh(mesh), asset}).find("its scene names the file"),
              std::string::npos)
        << mesh;
  }
  EXPECT_NE(refusal_of({with_mesh("assets/missing.obj"), asset}).find("is not there"),
            std::string::npos);
}

TEST_F(PackedScene, ADeviceFromElsewhereBringsNoSecondOne) {
  for (const std::string uri :
       {"null:?camera=vrpn:x@host.example?force=0", "null:?rotation=script:/etc/passwd",
        "null:", "web:?camera=haply:?host=host.example&port=80", "vrpn:x@host.example",
        "NULL:?camera=dhd:0"}) {
    const std::string packed = path("strange.mcap");
    {
      McapWriter writer(packed);
      const std::string toml =
          "[object]\nmesh = \"procedural:ball\"\n[[static]]\nmesh = "
          "\"procedural:ball\"\n[device]\nuri = \"" +
          uri + "\"\n";
      writer.attach({.name = "scene.toml", .media_type = "application/toml", .data = toml});
      writer.close();
    }
    const std::string read = read_packed_scene(packed, path("out")).device.uri;
    const std::string scheme = uri.substr(0, uri.find(':') + 1);
    EXPECT_EQ(read, scheme == "null:" || scheme == "web:" ? scheme : "hand:") << uri;
  }
}

TEST_F(PackedScene, WhatIsDamagedIsRefused) {
  write_packed_scene(path("two.mcap"), read_scene(path("scene.toml")));
  const std::string whole = read_file(path("two.mcap"));
  int refused = 0, taken = 0;
  for (std::size_t at = 8; at < whole.size(); at += 7) {
    std::string bytes = whole;
    bytes[at] = static_cast<char>(bytes[at] ^ 0x41);
    MemorySource source(bytes);
    try {
      read_attachments(source, "F");
      ++taken;
    } catch (const InputError&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, taken) << "the checksums cover the attachments";
  for (std::size_t size = 0; size < whole.size(); size += 31) {
    const std::string bytes = whole.substr(0, size);
    MemorySource source(bytes);
    try {
      EXPECT_LE(read_attachments(source, "F").size(), 3u);
    } catch (const InputError&) {
    }
  }
}

}  // namespace
}  // namespace thigma
