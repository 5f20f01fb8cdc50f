// Recordings of a small world as seeds: by the clock, in lockstep, with a page's hand, and lying.

#include "fuzz/make_seeds.h"
#include "fuzz/small_world.h"
#include "support/mcap_bytes.h"

#include "thigma/device/web_device.h"
#include "thigma/files/file.h"
#include "thigma/session/rt_thread.h"
#include "thigma/session/world_threads.h"

namespace thigma::fuzz {
namespace {

constexpr double kDuration = 0.004;  // [s]

/// page  a third hand is a page's
std::string recorded(bool is_apart, bool has_page) {
  const std::string path = ::testing::TempDir() + "thigma_fuzz_world.mcap";
  LoadedWorld world = small_world(1000.0, std::nullopt);
  world.config.duration = kDuration;
  app::WorldRecorderInfo info;
  info.scene = "small";
  info.devices = {"hand:?path=press", "hand:"};
  info.is_apart = is_apart;
  if (has_page) info.devices.emplace_back("web:");
  app::add_recorded_hands(info.devices, world);
  WorldDevices devices = open_world_devices(world, info.devices, info.seed);
  WebDeviceChannel link;
  const std::unique_ptr<HapticDevice> page = make_web_device(link);
  if (has_page) devices.list.back() = page.get();
  app::WorldRecorder recorder(path, world, info);
  WorldShell shell;
  shell.sink = [&](const WorldFrame& frame) {
    WorldFrame seen = frame;
    if (has_page && frame.frame == 1) seen.aimed = WorldAim{2, Vec3(0.01, 0.0, 0.0)};
    recorder.write(seen);
  };
  shell.ticks = [&](std::span<const HandTick> ticks) { recorder.write(ticks); };
  recorder.close(is_apart ? run_world_on_threads(world.config, devices.list, shell, RtRequest{})
                          : run_world(world.config, devices.list, shell.sink));
  return read_file(path);
}

/// The same in one chunk, where each record is as `change` leaves it; left out where that says so.
std::string changed(const std::string& bytes,
                    const std::function<bool(test::McapRecord& record)>& change) {
  const auto after_magic = [](std::string_view file) {
    return file.substr(detail::kMcapMagic.size());
  };
  std::string made(detail::kMcapMagic), content;
  for (const test::McapRecord& outer : test::records_of(after_magic(bytes))) {
    if (outer.opcode == detail::kHeader) test::put_record(made, outer);
    if (outer.opcode != detail::kChunk) continue;
    for (test::McapRecord& record :
         test::records_of(test::content_of_chunk(outer.body, std::uint64_t{1} << 20)))
      if (change(record)) test::put_record(content, record);
  }
  test::put_record(made, {detail::kChunk, test::chunk_of(content, true)});
  test::put_mcap_end(made);
  return made;
}

/// Another text in the place of the first one that is found.
std::string lying(const std::string& bytes, const std::string& text, const std::string& lie) {
  bool is_done = false;
  std::string made = changed(bytes, [&](test::McapRecord& record) {
    const std::size_t at = is_done ? std::string::npos : record.body.find(text);
    if (at == std::string::npos) return true;
    record.body.replace(at, text.size(), lie);
    is_done = true;
    return true;
  });
  if (!is_done) throw std::logic_error("no seed has the text " + text);
  return made;
}

/// Without messages of such a text.
std::string without(const std::string& bytes, const std::string& text) {
  return changed(bytes, [&](const test::McapRecord& record) {
    return record.opcode != detail::kMessage || record.body.find(text) == std::string::npos;
  });
}

}  // namespace

void put_worlds(const Seeds& seeds) {
  const auto put = [&](const char* name, const std::string& bytes) {
    seeds.put("world", name, bytes);
  };
  const std::string apart = recorded(true, false), lockstep = recorded(false, false);
  const std::string page = recorded(true, true);
  put("apart", apart);
  put("lockstep", lockstep);
  put("page", page);
  put("cut", changed(apart, [](const auto&) { return true; }).substr(0, apart.size() / 2));
  put("lie_fewer_bodies", lying(lockstep, R"("left","right")", R"("left")"));
  put("lie_other_body", lying(lockstep, R"("left","right")", R"("right","left")"));
  put("lie_more_joints", lying(lockstep, R"(["rail"])", R"(["rail","other"])"));
  put("lie_more_devices", lying(apart, R"("hand:"])", R"("hand:","web:"])"));
  put("lie_fewer_devices", lying(apart, R"(,"hand:"])", "]"));
  put("lie_not_apart", lying(apart, R"("apart":true)", R"("apart":false)"));
  put("lie_time_back", lying(apart, R"("now":)", R"("now":9,"n":)"));
  put("lie_time_huge", lying(apart, R"("now":)", R"("now":1e300,"n":)"));
  put("lie_elapsed_null", lying(apart, R"("elapsed":)", R"("elapsed":null,"e":)"));
  put("lie_elapsed_huge", lying(apart, R"("elapsed":)", R"("elapsed":1e9,"e":)"));
  put("lie_news_beyond", lying(apart, R"("news":)", R"("news":99,"n":)"));
  put("lie_note_beyond", lying(apart, R"("read":)", R"("read":77,"r":)"));
  put("lie_note_huge", lying(apart, R"("told":)", R"("told":18446744073709551615,"t":)"));
  put("lie_quaternion",
      lying(apart, R"("quat_xyzw":[0,0,0,1],"linear":)", R"("quat_xyzw":[0,0,0,0],"linear":)"));
  put("lie_not_a_number", lying(lockstep, R"("linear_momentum":[)", R"("linear_momentum":[null,)"));
  put("lie_frames_huge", lying(apart, R"("frames":)", R"("frames":18446744073709551615,"f":)"));
  put("lie_steps_lost", lying(apart, R"("haptic_steps":[)", R"("haptic_steps":[9)"));
  put("lie_aim_huge", lying(page, R"("aim":2)", R"("aim":2147483648)"));
  put("without_haptic", without(apart, R"("elapsed")"));
  put("without_frames", without(lockstep, R"("linear_momentum")"));
  put("without_all_frames_apart", without(without(apart, R"("linear_momentum")"), R"("elapsed")"));
}

}  // namespace thigma::fuzz
