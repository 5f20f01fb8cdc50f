// libFuzzer's entry points. THIGMA_FUZZ_TARGET names a target; `fuzz_readers --targets` lists all.

#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "fuzz/fuzz_target.h"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

namespace {

thigma::fuzz::Target target() {
  const char* name = std::getenv("THIGMA_FUZZ_TARGET");
  for (const thigma::fuzz::Target& t : thigma::fuzz::targets())
    if (name != nullptr && std::strcmp(t.name, name) == 0) return t;
  std::fprintf(stderr, "fuzz_readers: THIGMA_FUZZ_TARGET names no target, see --targets\n");
  std::exit(2);
}

}  // namespace

extern "C" int LLVMFuzzerInitialize(int* count, char*** words) {
  if (*count != 2 || std::strcmp((*words)[1], "--targets") != 0) return 0;
  for (const thigma::fuzz::Target& t : thigma::fuzz::targets()) std::puts(t.name);
  std::exit(0);
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const thigma::fuzz::Target one = target();
  one.run({reinterpret_cast<const std::byte*>(data), size});
  return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t most, unsigned seed) {
  static const thigma::fuzz::Target one = target();
  if (one.mutate == nullptr) return LLVMFuzzerMutate(data, size, most);
  std::string bytes(reinterpret_cast<const char*>(data), size);
  one.mutate(bytes, most, seed, LLVMFuzzerMutate);
  const std::size_t made = std::min(bytes.size(), most);
  std::memcpy(data, bytes.data(), made);
  return made;
}
