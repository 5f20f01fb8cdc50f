#include "fuzz/targets/any_mesh.h"

namespace thigma::fuzz {

void fuzz_ply(Bytes bytes) { read_any_mesh("ply\n" + std::string(text_of(bytes))); }

}  // namespace thigma::fuzz
