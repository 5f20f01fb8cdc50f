#pragma once
// What is said of a recording that ends before it should.

#include <cstdint>
#include <cstdio>
#include <string>

#include "thigma/recording/mcap_file.h"

namespace thigma::detail {

/// Where it ends, and why, in one line.
///
/// last_time  of its last frame [s]
/// file       all of it that could be read
inline std::string cut_text(double last_time, std::uint64_t frame_count, const McapScan& file) {
  const std::string why = !file.cut.empty() ? file.cut : "the session went on";
  char text[160];
  std::snprintf(text, sizeof text,
                "the recording ends at %.3f s, %llu frames, byte %llu of %llu: ", last_time,
                static_cast<unsigned long long>(frame_count),
                static_cast<unsigned long long>(file.end),
                static_cast<unsigned long long>(file.size));
  return text + why;
}

}  // namespace thigma::detail
