// libFuzzer's entry points for one target, which THIGMA_FUZZ_TARGET names.

#include <cstring>

#include "fuzz/fuzz_target.h"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

namespace {

const thigma::fuzz::Target& target() {
  for (const thigma::fuzz::Target& t : thigma::fuzz::kTargets)
    if (std::strcmp(t.name, THIGMA_FUZZ_TARGET) == 0) return t;
  std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const thigma::fuzz::Target& one = target();
  one.run({reinterpret_cast<const std::byte*>(data), size});
  return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t most, unsigned seed) {
  static const thigma::fuzz::Target& one = target();
  if (one.mutate == nullptr) return LLVMFuzzerMutate(data, size, most);
  std::string bytes(reinterpret_cast<const char*>(data), size);
  one.mutate(bytes, most, seed, LLVMFuzzerMutate);
  const std::size_t made = std::min(bytes.size(), most);
  std::memcpy(data, bytes.data(), made);
  return made;
}
