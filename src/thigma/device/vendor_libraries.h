#pragma once
// Vendors' libraries that a device may need, looked for at run time. No vendor header is used
// anywhere.

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "thigma/core/rt.h"

namespace thigma {

/// One library and what makes it usable.
struct VendorLibrary {
  std::string_view scheme;  // of the device addresses it serves, with the colon
  std::string_view product;
  std::span<const char* const> names;    // tried in order
  std::span<const char* const> symbols;  // all needed
  std::string_view fix;                  // one sentence for who lacks it
};

enum class LibraryState : std::uint8_t { loadable, incomplete, missing };

/// What looking for one gave.
struct LibraryProbe {
  LibraryState state = LibraryState::missing;
  std::string name;    // that opened; "" when missing
  std::string reason;  // why not loadable, one line; "" otherwise
};

/// The table. Source: the vendors' public headers, names and symbols only.
/// Thread    [haptic].
std::span<const VendorLibrary> vendor_libraries() THIGMA_RT;

/// Opens, looks for the symbols, closes.
/// Thread    [offline].
LibraryProbe probe_library(const VendorLibrary& library);

}  // namespace thigma
