#pragma once
// The messages of a recording of a world, one by one.

#include <cstdint>
#include <limits>
#include <string>
#include <string_view>

#include <nlohmann/json_fwd.hpp>

#include "thigma/recording/detail/json_text.h"
#include "thigma/recording/world_recording.h"

namespace thigma::detail {

/// Throws InputError "FILE: what, expected a recording of a world".
[[noreturn]] void refuse(const std::string& path, const std::string& what);

/// A whole number from 0 to `most`; whoever casts -1 or 1.5 has another. Throws InputError.
std::uint64_t count_of(const nlohmann::json& value, const char* name,
                       std::uint64_t most = std::numeric_limits<std::uint64_t>::max());
std::uint64_t read_count(const nlohmann::json& json, const char* name,
                         std::uint64_t most = std::numeric_limits<std::uint64_t>::max());

/// /config. Throws InputError, or what the JSON library throws.
void read_world_config(std::string_view text, const std::string& path, WorldRecording& out);

// The rest of their keys after `frame`; reading throws InputError, or what the JSON library throws.
void put_body(const BodyState& y, JsonObject& json);
BodyState read_body(const nlohmann::json& json);
void put_joint(const RecordedJoint& joint, JsonObject& json);
RecordedJoint read_joint(const nlohmann::json& json);
void put_wrench(const Wrench& wrench, JsonObject& json);
Wrench read_wrench(const nlohmann::json& json);
void put_hand(const RecordedHand& hand, JsonObject& json);
RecordedHand read_hand(const nlohmann::json& json);
void put_tick(const HandTick& made, JsonObject& json);
/// step: that has to come next of the hand; last: time of the one before [s]
HandTick read_tick(const nlohmann::json& json, std::size_t hand, std::uint64_t step, double last);

}  // namespace thigma::detail
