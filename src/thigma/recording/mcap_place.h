#pragma once
// Where messages of an MCAP file are.

#include <array>
#include <cstdint>

namespace thigma {

/// Where a message is: in the file, or in what a compressed chunk of it holds.
struct McapPlace {
  std::uint64_t chunk = 0;  // the record of the compressed chunk in the file [byte]; 0: in none
  std::uint64_t at = 0;     // the record of the message, in the file or in that chunk [byte]

  bool is_none() const { return chunk == 0 && at == 0; }
  friend bool operator==(const McapPlace&, const McapPlace&) = default;
};

/// Where the messages of a sample are, in the order of docs/formats.md; is_none() where it lacks
/// that one.
struct SamplePlace {
  std::array<McapPlace, 4> messages{};
};

}  // namespace thigma
