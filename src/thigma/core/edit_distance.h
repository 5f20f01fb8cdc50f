#pragma once
// How far two words are apart, for those who mistype.

#include <cstddef>
#include <string_view>

namespace thigma {

/// Least number of letters put in, left out or changed that make one word the other
/// (Levenshtein). Thread [offline].
std::size_t edit_distance(std::string_view a, std::string_view b);

}  // namespace thigma
