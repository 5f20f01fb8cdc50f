#pragma once
// Copies of recordings that lack something or say something else: for tests of what reads them.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "thigma/recording/mcap_file.h"

namespace thigma::test {

/// Copies a recording's messages in order.
///
/// data_of  what the copy has for a message of a topic; nothing: the message is left out
inline void copy_recording(const std::string& from, const std::string& to,
                           const std::function<std::optional<std::string>(
                               const std::string& topic, const McapMessage& message)>& data_of) {
  const McapFile file = read_mcap(from);
  McapWriter writer(to);
  std::vector<std::uint16_t> channels;
  for (const std::string& topic : file.topics)
    channels.push_back(writer.add_channel(topic, "thigma.copied", ""));
  for (const McapMessage& message : file.messages) {
    const auto channel = static_cast<std::size_t>(message.channel);
    if (const auto data = data_of(file.topics[channel], message))
      writer.write(channels[channel], message.sequence, message.time, *data);
  }
  writer.close();
}

}  // namespace thigma::test
