// Binary STL is known by its size: the count of triangles is made right again after a change, but
// now and then.

#include "fuzz/fuzz_target.h"

#include "thigma/import/detail/mesh_formats.h"

namespace thigma::fuzz {

void mutate_stl(std::string& bytes, std::size_t most, std::uint32_t seed, Mutate mutate) {
  constexpr std::size_t kHeader = 84, kTriangle = 50;
  const bool was_binary = detail::has_binary_stl_size(bytes);
  const std::size_t size = bytes.size();
  bytes.resize(std::max(most, size));
  bytes.resize(mutate(reinterpret_cast<std::uint8_t*>(bytes.data()), size, bytes.size()));
  if (!was_binary || bytes.size() < kHeader || seed % 8 == 0) return;
  const std::size_t count = (bytes.size() - kHeader) / kTriangle;
  bytes.resize(kHeader + count * kTriangle);
  for (std::size_t i = 0; i < 4; ++i) bytes[80 + i] = static_cast<char>(count >> (8 * i) & 0xff);
}

}  // namespace thigma::fuzz
