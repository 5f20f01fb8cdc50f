// thigma cache: the levels of detail that run has kept.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "json_out.h"
#include "verbs.h"
#include <nlohmann/json.hpp>

#include "thigma/scene/asset_cache.h"

namespace thigma::app {
namespace {

constexpr double kDay = 86400.0;  // [s]

struct CacheOptions {
  std::string what;
  std::optional<double> older;  // [days]
};

std::uint64_t total_bytes(const std::vector<KeptAsset>& assets) {
  std::uint64_t sum = 0;
  for (const KeptAsset& asset : assets) sum += asset.bytes;
  return sum;
}

double megabytes(std::uint64_t bytes) { return 1e-6 * static_cast<double>(bytes); }

int list(const Common& common, const CacheOptions& options) {
  if (options.older) {
    print_error("--older belongs to cache clear");
    return kUsage;
  }
  const std::string folder = cache_folder();
  const std::vector<KeptAsset> assets = list_cache(folder);
  if (common.json) {
    for (const KeptAsset& a : assets)
      print_json(
          {{"file", a.path}, {"bytes", a.bytes}, {"days_unused", std::max(0.0, a.age) / kDay}});
    print_json({{"folder", folder}, {"files", assets.size()}, {"bytes", total_bytes(assets)}});
    return kDone;
  }
  for (const KeptAsset& a : assets)
    std::printf("%8.2f MB  unused for %5.1f days  %s\n", megabytes(a.bytes),
                std::max(0.0, a.age) / kDay, a.path.c_str());
  std::printf(
      "%8.2f MB in %zu files in %s\n", megabytes(total_bytes(assets)), assets.size(),
      folder.empty() ? "no folder: neither XDG_CACHE_HOME nor HOME is set" : folder.c_str());
  return kDone;
}

int clear(const Common& common, const CacheOptions& options) {
  if (options.older && !(*options.older >= 0.0 && std::isfinite(*options.older))) {
    print_error("--older must be a number of days, 0 or more");
    return kUsage;
  }
  const std::vector<KeptAsset> removed =
      clear_cache(cache_folder(), kDay * options.older.value_or(0.0));
  if (common.json)
    print_json({{"removed", removed.size()}, {"bytes", total_bytes(removed)}});
  else
    std::printf("%zu files removed, %.2f MB\n", removed.size(), megabytes(total_bytes(removed)));
  return kDone;
}

}  // namespace

void add_cache(CLI::App& app, Common& common) {
  auto options = std::make_shared<CacheOptions>();
  CLI::App* verb =
      add_verb(app, common, "cache", "list or clear the levels of detail that run keeps",
               [&common, options] {
                 return options->what == "clear" ? clear(common, *options) : list(common, *options);
               });
  verb->add_option("what", options->what,
                   "list: files, sizes, and for how long they have not been used; clear: remove "
                   "them, they are built again when they are needed")
      ->required()
      ->check(CLI::IsMember({"list", "clear"}));
  verb->add_option("--older", options->older, "clear only what was not used for so many days");
}

}  // namespace thigma::app
