#include "fuzz/targets/any_mesh.h"

namespace thigma::fuzz {

/// The first byte says whether what follows is text. Of a binary file the count of triangles is
/// then made right, as that is how one is known.
void fuzz_stl(Bytes bytes) {
  if (bytes.empty()) return;
  const std::string_view rest = text_of(bytes.subspan(1));
  if (bytes[0] == std::byte{'t'}) return read_any_mesh("solid " + std::string(rest));
  constexpr std::size_t kHeader = 80, kTriangle = 50;
  std::string file(kHeader, ' ');
  const std::size_t count = rest.size() / kTriangle;
  for (int i = 0; i < 4; ++i) file += static_cast<char>(count >> (8 * i) & 0xff);
  const bool is_whole = bytes[0] == std::byte{'b'};
  read_any_mesh(file + std::string(is_whole ? rest.substr(0, count * kTriangle) : rest));
}

}  // namespace thigma::fuzz
