#include "thigma/device/detail/trouble_line.h"

#include <array>
#include <string>
#include <thread>

#include <gtest/gtest.h>

namespace thigma::detail {
namespace {

TEST(TroubleLine, a_loss_takes_the_place_of_a_warning_and_the_first_stays) {
  TroubleLine line;
  EXPECT_STREQ(line.text(), "");
  line.warn("warm", "0x0200");
  EXPECT_STREQ(line.text(), "warm: 0x0200");
  line.warn("warmer");
  EXPECT_STREQ(line.text(), "warmer");
  EXPECT_FALSE(line.is_lost());
  line.lose("gone", "a\nb");
  line.lose("gone again");
  EXPECT_STREQ(line.text(), "gone: a b");
  EXPECT_TRUE(line.is_lost());
}

TEST(TroubleLine, a_warning_is_told_as_long_as_it_is_so) {
  constexpr const char *kLate = "late", *kWeak = "weak";
  TroubleLine line;
  for (int i = 0; i < 100; ++i) {  // again and again
    line.warn_while(true, kLate);
    EXPECT_STREQ(line.text(), "late");
    line.clear(kWeak);  // another one
    EXPECT_STREQ(line.text(), "late");
    line.warn_while(false, kLate);
    EXPECT_STREQ(line.text(), "");
  }
  const char* const held = (line.warn(kWeak, "2 N"), line.text());
  line.clear(kWeak);
  EXPECT_STREQ(held, "weak: 2 N");  // who reads it still does
  line.lose("gone");
  line.clear("gone");
  EXPECT_STREQ(line.text(), "gone");
  EXPECT_TRUE(line.is_lost());
}

TEST(TroubleLine, of_two_threads_that_lose_the_device_one_has_its_whole_word) {
  constexpr int kTries = 300;
  const std::array<std::string, 2> words = {std::string(120, 'a'), std::string(90, 'b')};
  for (int i = 0; i < kTries; ++i) {
    TroubleLine line;
    std::atomic<int> ready{0};
    const auto lose = [&](const std::string& word) {
      for (++ready; ready < 2;) std::this_thread::yield();
      line.lose(word.c_str());
      EXPECT_TRUE(line.is_lost());
    };
    std::thread other([&] { lose(words[1]); });
    lose(words[0]);
    other.join();
    const std::string text = line.text();
    ASSERT_TRUE(text == words[0] || text == words[1]) << text;
  }
}

}  // namespace
}  // namespace thigma::detail
