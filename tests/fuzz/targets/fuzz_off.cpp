#include "fuzz/targets/any_mesh.h"

namespace thigma::fuzz {

void fuzz_off(Bytes bytes) { read_any_mesh("OFF\n" + std::string(text_of(bytes))); }

}  // namespace thigma::fuzz
