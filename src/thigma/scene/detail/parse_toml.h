#pragma once
// TOML text into tables, by toml++. What its parser takes for granted it asserts; without
// assertions, as in every release build, its behaviour is undefined where that does not hold, and
// hostile texts get there. So here assertions stay, and throw. Include this header, never the
// library's own.

#include <stdexcept>
#include <string>
#include <string_view>

namespace thigma {

/// What the parser takes for granted does not hold. Never leaves parse_toml.
class TomlAssertion : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

[[noreturn]] void toml_assertion_failed(const char* what);

}  // namespace thigma

#pragma push_macro("NDEBUG")
#undef NDEBUG
#define TOML_ASSERT(expr) ((expr) ? void() : ::thigma::toml_assertion_failed(#expr))
#include <toml++/toml.h>
#pragma pop_macro("NDEBUG")

namespace thigma {

/// Text of a scene's file. Thread: [offline]; InputError beyond 1 MiB, before it is read.
[[nodiscard]] std::string read_scene_text(const std::string& path);

/// The tables of a scene, an optional byte order mark before them.
///
/// file    for messages and for the places of nodes
/// Thread  [offline]; InputError "FILE: what, line N, expected" where it is no TOML or beyond 1 MiB
[[nodiscard]] toml::table parse_toml(std::string_view text, const std::string& file);

}  // namespace thigma
