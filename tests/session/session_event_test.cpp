#include <gtest/gtest.h>

#include "thigma/session/session.h"

namespace thigma {
namespace {

TEST(SessionEvent, every_kind_has_a_name_of_its_own) {
  for (int i = 0; i < kEventKinds; ++i) {
    const auto kind = static_cast<EventKind>(i);
    EXPECT_EQ(event_of_name(event_name(kind)), kind) << event_name(kind);
  }
}

TEST(SessionEvent, any_other_name_is_none) {
  EXPECT_EQ(event_of_name(""), std::nullopt);
  EXPECT_EQ(event_of_name("end"), std::nullopt);
  EXPECT_EQ(event_of_name("Fault"), std::nullopt);
}

}  // namespace
}  // namespace thigma
