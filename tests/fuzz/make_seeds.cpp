// Writes the seeds of tests/fuzz/corpus from the project's own models: make_fuzz_seeds FOLDER. What
// fuzzing has found lies beside them under names that begin with found_.

#include "fuzz/make_seeds.h"

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "clod/asset_samples.h"
#include "depth/textured_plates.h"
#include "fuzz/fuzz_target.h"
#include "recording/recording_samples.h"
#include "support/mesh_file_samples.h"
#include "support/plane_session.h"
#include "support/png_bytes.h"
#include "viewer/server/protocol.h"

#include "thigma/clod/clod_file.h"
#include "thigma/device/detail/vrpn_message.h"
#include "thigma/files/file.h"
#include "thigma/mesh/shapes.h"
#include "thigma/recording/config_json.h"
#include "thigma/scene/scene_file.h"
#include "thigma/texture/texture_file.h"

namespace thigma::fuzz {
namespace {

/// What the services of devices send.
void put_devices(const Seeds& seeds) {
  const std::string state =
      R"({"session_id":7,"inverse3":[{"device_id":"049D","config":{"type":"inverse3","basis":)"
      R"({"permutation":"XYZ"}},"state":{"cursor_position":{"x":0.01,"y":-0.12,"z":0.15},)"
      R"("cursor_velocity":{"x":0,"y":0,"z":0}},"status":{"calibrated":true,"ready":true}}],)"
      R"("wireless_verse_grip":[{"device_id":"61","state":{"orientation":{"w":1,"x":0,"y":0,)"
      R"("z":0},"buttons":{"a":true,"b":false,"c":false}}}]})";
  seeds.put("haply", "json", "j" + state);
  seeds.put("haply", "version", "v{\"version\":\"3.5.0\"}");
  seeds.put("haply", "answer",
            "vHTTP/1.1 101 Switching Protocols\r\nUpgrade: websocket\r\nSec-WebSocket-Accept: "
            "s3pPLMBiTxaQ9kYGzzhZRbK+xOo=\r\n");
  std::string frame = "\x81\x7e";
  frame += static_cast<char>(state.size() >> 8);
  frame += static_cast<char>(state.size());
  seeds.put("haply", "frame", frame + state + "\x89\x02hi" + frame + state);
  std::string talk;
  detail::append_vrpn_message(
      {detail::kVrpnSenderIs, 0, 1.5, detail::vrpn_name_payload("Phantom0")}, talk);
  detail::append_vrpn_message(
      {detail::kVrpnTypeIs, 3, 1.5, detail::vrpn_name_payload("vrpn_Tracker Pos_Quat")}, talk);
  detail::append_vrpn_message({3, 0, 1.5, std::string(63, '\0') + "\x01"}, talk);
  detail::append_vrpn_message({4, 0, 1.5, std::string("\0\0\0\1\0\0\0\1", 8)}, talk);
  seeds.put("vrpn", "talk", talk);
  seeds.put("vrpn", "cookie", detail::vrpn_cookie());
  seeds.put("vrpn", "spacenav", std::string("s\0\0\0\0\x50\1", 7) + std::string(26, '\0'));
}

void put_meshes(const Seeds& seeds) {
  const TriangleMesh ball = make_ball(0.02, 1), box = make_box(Vec3(0.01, 0.02, 0.03));
  const TriangleMesh doubled = joined(box, flipped(box));
  for (const auto& [name, mesh] :
       {std::pair{std::string("ball"), ball}, {"box", box}, {"doubled", doubled}}) {
    for (const detail::MeshFormatRow& row : detail::kMeshFormats) {
      if (row.write == nullptr) continue;
      seeds.put(row.ending + 1, name + "_" + test::mesh_file_name(row), row.write(mesh, name));
    }
  }
  seeds.put("obj", "textured",
            "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 1\nvt 0 0\nvt 1 0\nvt 0 1\nvn 0 0 1\nf 1/1/1 2/2/1 "
            "3/3/1\nf -1/1 -2/2 -3/3 # b\n");
  seeds.put("off", "colours",
            "OFF\n4 2 0\n0 0 0\n1 0 0\n0 1 0\n1 1 1\n3 0 1 2 255 0 0\n4 0 1 2 3\n");
}

void put_pictures(const Seeds& seeds) {
  std::string greys;
  for (int i = 0; i < 64; ++i) greys += static_cast<char>(4 * i);
  for (const int bits : {2, 8, 16}) {
    const std::size_t row = static_cast<std::size_t>(4 * bits / 8);
    const std::vector<unsigned char> rows(greys.begin(),
                                          greys.begin() + static_cast<std::ptrdiff_t>(4 * row));
    seeds.put("png", "grey" + std::to_string(bits), test::png_of(4, 4, bits, rows));
    seeds.put("png", "woven" + std::to_string(bits),
              test::png_of(4, 4, bits, rows, PNG_COLOR_TYPE_GRAY, PNG_INTERLACE_ADAM7));
  }
  seeds.put("pgm", "plain", "P2\n# heights\n3 2\n255\n0 10 20\n30 40 255\n");
  seeds.put("pgm", "raw8", "P5 4 4 255\n" + greys.substr(0, 16));
  seeds.put("pgm", "raw16", "P5 4 4 65535\n" + greys.substr(0, 32));
}

void put_assets(const Seeds& seeds) {
  const ClodAsset exact = build_clod_asset(make_box(Vec3(0.01, 0.02, 0.03)), {});
  seeds.put("clod", "box", format_clod(exact));
  seeds.put("clod", "ball", format_clod(build_clod_asset(test::wavy_ball(2), test::generous())));
  Random random(5);
  TextureAsset plate;
  plate.texture = make_texture(test::plate_source(random, {.texels = 6, .noise = 1e-5}), "plate");
  plate.figures = {3, 1.25, 1e-6, 4e-6, std::nullopt};
  seeds.put("tex", "plate", format_texture(plate));
}

void put_recordings(const Seeds& seeds) {
  const std::string samples = test::write_recording("fuzz_seed.mcap", 2);
  seeds.put("recording", "samples", read_file(samples));
  const std::string path = ::testing::TempDir() + "thigma_fuzz_session.mcap";
  const SessionConfig config = test::plane_session();
  RecordedConfig recorded;
  recorded.params = config.haptic;
  recorded.world_from_body = config.world_from_body;
  RecordingWriter writer(path, write_config(recorded));
  SessionConfig few = config;
  few.duration = 0.003;
  HandDevice hand(test::plane_hand(HandPath::press));
  const SessionSummary summary = run_lockstep(few, hand,
                                              {[&](const HapticSample& s) { writer.write(s); },
                                               [&](const ContactSample& s) { writer.write(s); },
                                               [&](const SessionEvent& e) { writer.write(e); }});
  writer.close({.frames = summary.frames, .state_hash = summary.state_hash, .dropped = 0});
  const std::string whole = read_file(path);
  seeds.put("recording", "session", whole);
  seeds.put("recording", "cut", whole.substr(0, whole.size() - 40));
}

void put_texts(const Seeds& seeds) {
  for (const char* name : {"jaws", "blocks", "spoon_in_cup", "file_on_cad"})
    seeds.put("scene", name, std::string(builtin_scene(name)));
  for (const char* world : {"tower", "row_of_blocks", "drawer", "links", "two_hands", "gears"})
    seeds.put("scene", world,
              read_file(std::string(THIGMA_SOURCE_DIR) + "/scenes/" + world + ".toml"));
  seeds.put("script", "two",
            "t,x,y,z,qx,qy,qz,qw\n0,0,0,0,0,0,0,1\n# on\n1,0.01,0,0,0,0,0.6,0.8\n");
  seeds.put("script", "buttons",
            "t,x,y,z,qx,qy,qz,qw,buttons\n0,0,0,0.05,0,0,0,1,0\n0.5,0,0,0,1,0,0,0,1\n2,0,0,0,0,1,0,"
            "0,3\n");
  seeds.put("poses", "two", "x,y,z,qx,qy,qz,qw\n0,0,0,0,0,0,1\n\n1e-3,-2,+3,0.6,0,0,0.8\n");
  const char* const addresses[] = {"hand:",
                                   "hand:?path=press&tremor=1e-5&seed=3",
                                   "hand:?mass=0.1&delay=0.01&jitter=0.002&device=falcon",
                                   "null:?rate=100",
                                   "web:",
                                   "nothing"};
  for (int i = 0; i < 6; ++i) seeds.put("uri", "address" + std::to_string(i), addresses[i]);
}

std::string frame(int opcode, std::string_view payload) {
  std::string out(1, static_cast<char>(0x80 | opcode));
  if (payload.size() < 126) {
    out += static_cast<char>(0x80 | payload.size());
  } else {
    out += static_cast<char>(0x80 | 126);
    out += static_cast<char>(payload.size() >> 8);
    out += static_cast<char>(payload.size() & 0xff);
  }
  return out + std::string(4, '\0') + std::string(payload);  // a mask of zeros
}

void put_messages(const Seeds& seeds) {
  const char* const texts[] = {
      R"({"type":"hold","id":1,"value":true})",
      R"({"type":"use_device","id":2,"value":"web:"})",
      R"({"type":"pause","id":3,"value":false})",
      R"({"type":"step","id":4,"value":10})",
      R"({"type":"set","id":5,"name":"s0","value":0.01})",
      R"({"type":"level","id":6,"mesh":0,"value":2})",
      R"({"type":"open","id":7,"value":"jaws"})",
      R"({"type":"seek","id":8,"value":1.5})",
      R"({"type":"upload","id":9,"name":"a.obj","value":100})",
      R"({"type":"place","id":10,"name":"hold","value":0.001,"repair":true})",
      R"({"type":"grab","id":11,"value":"block 7","point":[0.01,0,-0.005]})"};
  std::string all;
  for (int i = 0; i < 11; ++i) {
    seeds.put("message", "text" + std::to_string(i), std::string("t") + texts[i]);
    all += frame(1, texts[i]);
  }
  std::vector<WebSample> samples(2);
  samples[0].time = 1.0;
  samples[1].time = 1.01;
  samples[1].pose.position = Vec3(0.01, 0.0, 0.0);
  samples[1].buttons = 1;
  const std::string device = live::encode_device(1.02, samples);
  seeds.put("message", "device", "b" + device);
  seeds.put("message", "upload",
            std::string("b\x21\x01\x00\x00\x03\x00\x00\x00", 9) + std::string(16, '\0') + "abc");
  seeds.put("frames", "texts", "f" + all);
  seeds.put("frames", "device", "f" + frame(2, device) + frame(9, "ping") + frame(8, "\x03\xe8"));
  seeds.put("frames", "page", "hGET / HTTP/1.1\r\nHost: localhost\r\n\r\n");
}

}  // namespace
}  // namespace thigma::fuzz

int main(int count, char** words) {
  if (count != 2) {
    std::fprintf(stderr, "usage: make_fuzz_seeds FOLDER\n");
    return 2;
  }
  const thigma::fuzz::Seeds seeds{words[1]};
  thigma::fuzz::put_meshes(seeds);
  thigma::fuzz::put_devices(seeds);
  thigma::fuzz::put_pictures(seeds);
  thigma::fuzz::put_assets(seeds);
  thigma::fuzz::put_recordings(seeds);
  thigma::fuzz::put_worlds(seeds);
  thigma::fuzz::put_texts(seeds);
  thigma::fuzz::put_messages(seeds);
}
