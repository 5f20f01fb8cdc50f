#pragma once
// Vendors' libraries that a device may need, looked for at run time. No vendor header is used
// anywhere.

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "thigma/core/rt.h"
#include "thigma/core/shared_library.h"

namespace thigma {

/// One library and what makes it usable.
struct VendorLibrary {
  std::string_view scheme;  // of the device addresses it serves, with the colon
  std::string_view product;
  std::span<const char* const> names;    // tried in order
  std::span<const char* const> symbols;  // all needed
  std::string_view fix;                  // one sentence for who lacks it
};

enum class LibraryState : std::uint8_t {
  loadable,
  incomplete,  // lacks a symbol
  unusable,    // there, and does not open: for another processor, not readable, lacks another one
  missing,
};

/// What looking for one gave.
struct LibraryProbe {
  LibraryState state = LibraryState::missing;
  std::string name;    // that opened; "" when missing
  std::string reason;  // why not loadable, one line; "" otherwise
  std::string fix;     // the one step that mends it; "" otherwise
};

/// The table. Source: the vendors' public headers, names and symbols only.
/// Thread    [haptic].
std::span<const VendorLibrary> vendor_libraries() THIGMA_RT;

/// Opens, looks for the symbols, closes.
/// Thread    [offline].
LibraryProbe probe_library(const VendorLibrary& library);

/// The opened library of a scheme.
///
/// scheme   with the colon; a row of the table
/// errors   DeviceUnavailable: why, and what mends it, one line
/// Thread   [offline].
SharedLibrary open_vendor_library(std::string_view scheme);

}  // namespace thigma
