#include "fuzz/fuzz_target.h"

#include "thigma/clod/clod_file.h"
#include "thigma/contact/query_contacts.h"

namespace thigma::fuzz {
namespace {

/// "No query of it can fail": against itself, apart and in each other, exact and at a level.
void query(const ClodHierarchy& h) {
  ContactFront front;
  for (const double apart : {0.0, 0.5, 1.9}) {
    for (const bool is_exact : {true, false}) {
      ContactSet contacts;
      contacts.contacts.reserve(64);
      ContactQuery asked;
      asked.tolerance = 0.01 * h.radius;
      asked.resolution.is_exact = is_exact;
      Pose other;
      other.position = Vec3(apart * h.radius, 0.0, 0.0);
      query_contacts({h}, {h, other}, asked, front, contacts);
      require(contacts.contacts.size() <= 64, "contacts fit");
    }
  }
}

}  // namespace

void fuzz_clod(Bytes bytes) {
  ClodAsset asset;
  if (!is_taken("asset", [&] { asset = parse_clod(text_of(bytes), "asset"); })) return;
  const std::string written = format_clod(asset, "asset");
  require(format_clod(parse_clod(written, "asset"), "asset") == written,
          "what is read is written the same");
  if (asset.hierarchy.level_patches.size() > 200 || !(asset.hierarchy.radius < 1e6)) return;
  query(asset.hierarchy);
}

}  // namespace thigma::fuzz
