#pragma once
// One function a reader: takes any bytes, and either comes back or ends the process. Found by
// libFuzzer (the `fuzz` preset), replayed by fuzz_replay_tests in every build.

#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "thigma/core/error.h"

namespace thigma::fuzz {

using Bytes = std::span<const std::byte>;

inline std::string_view text_of(Bytes bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// What a reader promises of bytes it took. Throws std::logic_error, which no target catches.
inline void require(bool holds, const char* promise) {
  if (!holds) throw std::logic_error(std::string("a promise is broken: ") + promise);
}

/// Whether `read` takes its input. It may refuse only by InputError, in one line that begins with
/// `name`.
inline bool is_taken(const std::string& name, const std::function<void()>& read) {
  try {
    read();
  } catch (const InputError& error) {
    const std::string_view why = error.what();
    require(why.starts_with(name), "a refusal names the file");
    require(why.find('\n') == std::string_view::npos, "a refusal is one line");
    return false;
  }
  return true;
}

/// Set where every input is worth all that takes long: the committed ones.
inline bool is_thorough = false;

/// Whether an input is one of about `many`, told by its bytes, so that what was found does it
/// again: for what takes far longer than reading.
inline bool is_one_of(std::uint32_t many, Bytes bytes) {
  if (is_thorough) return true;
  std::uint32_t mixed = 2166136261u;
  for (const std::byte b : bytes) mixed = (mixed ^ static_cast<std::uint32_t>(b)) * 16777619u;
  return (mixed >> 16) % many == 0;
}

/// Changes bytes at random in place, of at most `most`; returns their new number. libFuzzer's, or a
/// test's.
using Mutate = std::size_t (*)(std::uint8_t* bytes, std::size_t size, std::size_t most);

void fuzz_mesh(Bytes bytes);  // of every mesh format: recognised by content
void fuzz_png(Bytes bytes);
void fuzz_pgm(Bytes bytes);
void fuzz_clod(Bytes bytes);
void fuzz_tex(Bytes bytes);
void fuzz_scene(Bytes bytes);
void fuzz_recording(Bytes bytes);
void fuzz_world(Bytes bytes);  // a recording of several bodies
void fuzz_script(Bytes bytes);
void fuzz_poses(Bytes bytes);
void fuzz_uri(Bytes bytes);
void fuzz_frames(Bytes bytes);
void fuzz_message(Bytes bytes);
void fuzz_haply(Bytes bytes);
void fuzz_vrpn(Bytes bytes);

/// Changes what is inside a format with checksums or sizes, and mends what guards it.
void mutate_clod(std::string& bytes, std::size_t most, std::uint32_t seed, Mutate mutate);
void mutate_tex(std::string& bytes, std::size_t most, std::uint32_t seed, Mutate mutate);
void mutate_recording(std::string& bytes, std::size_t most, std::uint32_t seed, Mutate mutate);
void mutate_png(std::string& bytes, std::size_t most, std::uint32_t seed, Mutate mutate);
void mutate_stl(std::string& bytes, std::size_t most, std::uint32_t seed, Mutate mutate);

struct Target {
  const char* name;
  void (*run)(Bytes);
  void (*mutate)(std::string&, std::size_t, std::uint32_t, Mutate);  // null: any change will do
};
inline constexpr Target kTargets[] = {
    {"png", fuzz_png, mutate_png},           {"pgm", fuzz_pgm, nullptr},
    {"clod", fuzz_clod, mutate_clod},        {"tex", fuzz_tex, mutate_tex},
    {"scene", fuzz_scene, nullptr},          {"recording", fuzz_recording, mutate_recording},
    {"world", fuzz_world, mutate_recording}, {"script", fuzz_script, nullptr},
    {"poses", fuzz_poses, nullptr},          {"uri", fuzz_uri, nullptr},
    {"frames", fuzz_frames, nullptr},        {"message", fuzz_message, nullptr},
    {"haply", fuzz_haply, nullptr},          {"vrpn", fuzz_vrpn, nullptr},
};

/// All targets: one for each kind of mesh files, by its ending without the dot, then kTargets.
std::vector<Target> targets();

}  // namespace thigma::fuzz
