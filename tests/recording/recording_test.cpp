#include "thigma/recording/recording.h"

#include <cstdlib>
#include <filesystem>
#include <limits>
#include <map>

#include "recording/recording_samples.h"
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "thigma/core/error.h"
#include "thigma/files/file.h"
#include "thigma/recording/mcap_file.h"

namespace thigma {
namespace {

TEST(Recording, bits_are_told_in_sixteen_digits) {
  EXPECT_EQ(hex_text(0), std::string(16, '0'));
  EXPECT_EQ(hex_text(0x0123456789abcdefull), "0123456789abcdef");
}

using Json = nlohmann::json;

double number(const Json& j, const char* key) { return j.at(key).get<double>(); }
Vec3 vector_of(const Json& j) { return {number(j, "x"), number(j, "y"), number(j, "z")}; }
Quat turn_of(const Json& j) {
  return {number(j, "w"), number(j, "x"), number(j, "y"), number(j, "z")};
}

// As Foxglove's public schemas have it: stamps, frames, all lists of an entity, whole triangles.
void expect_entity(const Json& entity) {
  EXPECT_LT(entity.at("timestamp").at("nsec").get<long>(), 1'000'000'000);
  EXPECT_TRUE(entity.at("frame_id") == "world" || entity.at("frame_id") == "object");
  EXPECT_EQ(entity.at("lifetime").at("sec"), 0);
  for (const char* kind :
       {"arrows", "cubes", "spheres", "cylinders", "lines", "triangles", "texts", "models"})
    EXPECT_TRUE(entity.at(kind).is_array()) << kind;
  for (const Json& list : entity.at("triangles")) {
    EXPECT_EQ(list.at("indices").size() % 3, 0u);
    for (const Json& index : list.at("indices"))
      EXPECT_LT(index.get<std::size_t>(), list.at("points").size());
    EXPECT_NEAR(turn_of(list.at("pose").at("orientation")).norm(), 1.0, 1e-12);
  }
}

TEST(Recording, shows_surfaces_frames_contacts_and_force_in_the_schemas_of_foxglove) {
  const std::string path = testing::TempDir() + "thigma_pictures.mcap";
  constexpr std::uint64_t kFrames = 500;
  {
    RecordingWriter writer(path, "{}");
    writer.write(RecordedSurface{"object",
                                 true,
                                 {{0, 0, 0}, {0.3, 0, 0}, {0, 0.4, 0}, {0, 0, 0.1}},
                                 {{0, 1, 2}, {0, 2, 3}}});
    for (std::uint64_t i = 0; i < kFrames; ++i) {
      if (i % 10 == 0) writer.write(test::contact_sample(i / 10));
      writer.write(test::sample(i));
    }
    writer.close({kFrames, 1, 0});
  }
  const McapFile file = read_mcap(path);
  std::map<std::string, int> entities;
  int transforms = 0;
  for (const McapMessage& message : file.messages) {
    const std::string& topic = file.topics[static_cast<std::size_t>(message.channel)];
    if (topic != "/tf" && topic != "/scene") continue;
    const Json json = Json::parse(message.data);
    if (topic == "/scene") {
      ASSERT_EQ(json.at("entities").size(), 1u);
      expect_entity(json.at("entities")[0]);
      ++entities[json.at("entities")[0].at("id").get<std::string>()];
      continue;
    }
    ++transforms;
    const HapticSample s = test::sample(message.time / 1'000'000);
    const Json& object = json.at("transforms")[0];
    EXPECT_EQ(object.at("parent_frame_id"), "world");
    EXPECT_EQ(object.at("child_frame_id"), "object");
    EXPECT_EQ(vector_of(object.at("translation")), s.body.position);
    EXPECT_EQ(turn_of(object.at("rotation")).coeffs(), s.body.orientation.coeffs());
    EXPECT_EQ(vector_of(json.at("transforms")[1].at("translation")), s.handle.pose.position);
  }
  EXPECT_EQ(entities["object"], 1);
  EXPECT_NEAR(transforms, 30, 2);  // 60 a second
  EXPECT_EQ(entities["force"], transforms);
  EXPECT_NEAR(entities["contacts"], 25, 3);
  // Nothing of it is read back.
  const Recording recording = read_recording(path);
  EXPECT_EQ(recording.frames.size(), kFrames);
  EXPECT_TRUE(recording.has_end);
  for (const char* name : {"foxglove.FrameTransforms", "foxglove.SceneUpdate"})
    EXPECT_NE(file.bytes.find(name), std::string::npos) << name;
}

TEST(Recording, opens_in_the_official_reader_with_all_topics) {
  const std::filesystem::path reader =
      std::filesystem::path(THIGMA_SOURCE_DIR) / "tests/mcap_reader";
  if (!std::filesystem::exists(reader / "node_modules/@mcap/core")) {
    GTEST_SKIP() << "needs `npm ci` in tests/mcap_reader (scripts/test does it where npm reaches a "
                    "registry)";
  }
  const std::string path = test::write_recording("official_session.mcap", 500);
  const std::string out = path + ".json";
  const std::string command =
      "node '" + (reader / "read.mjs").string() + "' '" + path + "' > '" + out + "'";
  ASSERT_EQ(std::system(command.c_str()), 0);
  const std::string line = read_file(out);
  for (const char* topic : {"/device/state\":500", "/device/command\":500", "/body/state\":500",
                            "/timing\":500", "/contact/model\":50", "/contact/frame\":50",
                            "/events\":", "/config\":1", "/tf\":", "/scene\":"}) {
    EXPECT_NE(line.find(topic), std::string::npos) << topic << " in " << line.substr(0, 300);
  }
}

}  // namespace
}  // namespace thigma
