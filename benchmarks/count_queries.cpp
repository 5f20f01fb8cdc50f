// Queries of stored pairs, for scripts/instructions:
//   thigma_count_queries list
//   thigma_count_queries prepare FOLDER PAIR [TRIANGLES]
//   thigma_count_queries count FOLDER PAIR meeting|apart WAY    what callgrind counts
//   thigma_count_queries quality FOLDER PAIR meeting|apart WAY  how near that is to the exact query
// Each prints one line of JSON.

#include <cstdio>
#include <cstdlib>
#include <span>
#include <string>
#include <vector>

#include "benchmarks/query_way.h"
#include "benchmarks/stored_pair.h"

#include "thigma/core/error.h"

namespace {

using namespace thigma;

// A tenth of the path, in runs of ten poses and the one before them.
constexpr std::size_t kRun = 10, kRuns = 10;

// The only code between whose entry and end instructions are counted.
extern "C" __attribute__((noinline)) void thigma_counted_query(const PlacedHierarchy& object,
                                                               const PlacedHierarchy& scene,
                                                               const ContactQuery& query,
                                                               ContactFront& front,
                                                               ContactSet& set) {
  query_contacts(object, scene, query, front, set);
}

int count(const bench::StoredPair& pair, const Resolution& way) {
  ContactFront front;
  reserve_front(front, pair.object, pair.scene);
  ContactSet set;
  set.contacts.reserve(400'000);
  const ContactQuery query{.tolerance = pair.tolerance, .resolution = way};
  const std::size_t stride = pair.path.size() / kRuns;
  std::size_t counted = 0;
  double contacts = 0.0, tests = 0.0;
  for (std::size_t i = 0; i < pair.path.size(); ++i) {
    const std::size_t place = i % stride;
    if (place > kRun) continue;
    const PlacedHierarchy object{pair.object, pair.path[i]}, scene{pair.scene};
    clear(set);
    if (place == 0) {
      query_contacts(object, scene, query, front, set);
      continue;
    }
    thigma_counted_query(object, scene, query, front, set);
    contacts += static_cast<double>(set.contacts.size());
    tests += static_cast<double>(set.stats.tests);
    ++counted;
  }
  const double each = 1.0 / static_cast<double>(counted);
  std::printf("{\"queries\": %zu, \"contacts\": %.1f, \"tests\": %.1f}\n", counted, contacts * each,
              tests * each);
  return 0;
}

int compare(const bench::StoredPair& pair, const Resolution& way) {
  const bench::WayQuality q = bench::way_quality(pair, way);
  std::printf(
      "{\"force_error\": %.4f, \"force_step\": %.4f, \"separation_error\": %.6f, "
      "\"contacts\": %.1f}\n",
      q.force, q.step, q.separation, q.contacts);
  return 0;
}

int list_pairs() {
  std::string text;
  for (const std::string& name : bench::storable_pairs())
    text += (text.empty() ? "\"" : ", \"") + name + "\"";
  std::printf("[%s]\n", text.c_str());
  return 0;
}

int run(std::span<const std::string> words) {
  if (words.size() == 1 && words[0] == "list") return list_pairs();
  if ((words.size() == 3 || words.size() == 4) && words[0] == "prepare") {
    bench::store_pair(words[1], words[2], words.size() == 4 ? std::atoi(words[3].c_str()) : 0);
    return 0;
  }
  if (words.size() == 5 && (words[0] == "count" || words[0] == "quality")) {
    const bench::StoredPair pair = bench::load_pair(words[1], words[2], words[3]);
    const Resolution way = bench::query_way(words[4]);
    return words[0] == "count" ? count(pair, way) : compare(pair, way);
  }
  std::fprintf(stderr,
               "thigma_count_queries: expected list, prepare FOLDER PAIR [TRIANGLES], or count or "
               "quality FOLDER PAIR PATH WAY\n");
  return 2;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(std::vector<std::string>(argv + 1, argv + argc));
  } catch (const std::exception& e) {
    std::fprintf(stderr, "thigma_count_queries: %s\n", e.what());
    return 4;
  }
}
