// More pages than there is room for, and a page that reads slowly, beside one that watches.

#include <vector>

#include "support/full.h"
#include "viewer/live_program.h"

#include "thigma/session/rt_thread.h"

namespace thigma::test {
namespace {

double now() { return 1e-9 * static_cast<double>(monotonic_ns()); }

TEST(LiveLoad, AThousandPagesComeAndGoAndTheSessionGoesOn) {
  RunningProgram run("thousand", {"--device", "hand:?path=rest"});
  ASSERT_TRUE(run.client);
  const Json before = run.running();
  ASSERT_FALSE(before.is_null());
  const double memory = run.program->resident_mib();
  constexpr int kPages = 1000, kAtOnce = 20;
  int open = 0, refused = 0;
  std::vector<std::unique_ptr<WebClient>> pages;
  for (int i = 0; i < kPages; ++i) {
    pages.push_back(std::make_unique<WebClient>(run.port));
    const int status = pages.back()->status();
    open += status == 101;
    refused += status == 503;
    EXPECT_TRUE(status == 101 || status == 503) << status;
    if (pages.size() == kAtOnce) pages.clear();
    while (run.client->read(0.0)) {  // is told of every one
    }
  }
  pages.clear();
  EXPECT_EQ(open + refused, kPages);
  EXPECT_GE(open, kPages / kAtOnce * 7) << "as many as there is room for beside the first";
  EXPECT_GT(refused, 0);
  run.expect_goes_on(before);
  EXPECT_LT(run.program->resident_mib(), memory + 32.0);
  // Those that left have left their places.
  const auto is_alone = [](const Json& s) { return s["pages"] == 1; };
  EXPECT_FALSE(state_where(*run.client, is_alone).is_null());
  EXPECT_EQ(WebClient(run.port).status(), 101);
  EXPECT_EQ(run.end().code, 130) << run.program->said();
}

TEST(LiveLoad, APageOnASlowLineSeesTheSessionAsItIsNow) {
  RunningProgram run("slow_line", {"--device", "hand:"});
  ASSERT_TRUE(run.client);
  const Json before = run.running();
  ASSERT_FALSE(before.is_null());
  WebClient slow(run.port, {.receive_buffer = 8 * 1024});
  ASSERT_EQ(slow.status(), 101);
  // A third of what a page is sent. It takes what comes at that pace, whatever it is.
  constexpr double kPace = 32e3;  // [bytes/s]
  const double seconds = is_full() ? 40.0 : 8.0;
  const double start = now();
  double read = 0.0, last = -1.0, latest = -1.0;
  Json told;
  while (now() - start < seconds) {
    if (read > kPace * (now() - start)) sleep_ns(5'000'000);
    // The first page is read as it comes, so that what it knows is of now.
    while (const std::optional<WebMessage> message = run.client->read(0.0)) {
      if (message->is_binary) continue;
      const Json json = Json::parse(message->data);
      if (json["type"] == "state") latest = json["time"].get<double>();
    }
    if (read > kPace * (now() - start)) continue;
    const std::optional<WebMessage> message = slow.read(0.05);
    if (!message) continue;
    read += static_cast<double>(message->data.size());
    if (message->is_binary) continue;
    const Json json = Json::parse(message->data);
    if (json["type"] != "state") continue;
    last = json["time"].get<double>();
    told = json;
  }
  ASSERT_GT(last, 0.0) << "a slow page is told as well";
  EXPECT_GT(told["dropped"]["yours"].get<int>(), 0) << "what it did not take is counted";
  EXPECT_LT(latest - last, 3.0) << "[s] behind the page that takes all";
  run.expect_goes_on(before);
  EXPECT_EQ(run.end().code, 130) << run.program->said();
}

}  // namespace
}  // namespace thigma::test
