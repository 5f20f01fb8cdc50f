#pragma once
// The messages of a recording put together to samples again.

#include <optional>
#include <string>
#include <string_view>

#include "thigma/recording/recording.h"

namespace thigma::detail {

/// Samples whose first message has been read; a sample is several.
struct BegunSamples {
  std::optional<HapticSample> frame;
  std::optional<ContactSample> contact;
};

/// Reads one message: /config, /events and the end go into `recording`, all else into a sample. The
/// first message of a sample begins a new one. Messages of other topics mean nothing. Thread
/// [offline]; throws InputError or an exception of the JSON parser for what is not a message of
/// that topic.
void read_message(const std::string& topic, std::string_view data, RecordingInfo& recording,
                  BegunSamples& begun);

}  // namespace thigma::detail
