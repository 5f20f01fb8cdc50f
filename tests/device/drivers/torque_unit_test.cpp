// The unit of a Phantom's torque, found with a person, against the stand-in in both units: how much
// torque that person may get to feel.
#include "thigma/device/detail/torque_unit.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <thread>

#include "standins/client.h"
#include <gtest/gtest.h>

#include "thigma/device/detail/hd_session.h"
#include "thigma/device/open_device.h"

namespace thigma::detail {
namespace {

using standin_test::Library;

constexpr double kNever = 1e9;
// Nothing stronger in either unit before a person has said that this was nothing [N m].
constexpr double kBound = 0.05;
constexpr TorqueRamp kQuick{0.03, 0.4};  // ten times as fast as a person gets it

const Library& hd() {
  static const Library library("hd", "libHD.so");
  return library;
}

double applied_torque() {
  return std::hypot(hd().get("applied_tx"), hd().get("applied_ty"), hd().get("applied_tz"));
}

/// Who holds the stylus.
struct Person {
  double feels = 0.015;     // from there on [N m]
  double reaction = 0.02;   // until the button is let go; ten times as fast as well [s]
  bool holds_tight = true;  // the stylus does not turn
  bool is_honest = true;    // says that nothing was felt only where it was so; else never a yes
  bool presses = true;      // the button at all
};

/// What a person got and what was found.
struct Found {
  double unit = 0.0;    // what the library takes for 1 N m
  double most = 0.0;    // torque asked of the motors [N m]
  double at_end = 0.0;  // sent at the end [vendor's unit]
  int questions = 0;
  double force_output = 0.0;  // at the last question
};

Found try_person(double standin_unit, const Person& person, std::function<bool()> stop = {}) {
  hd().reset();
  hd().set("model", 2);
  hd().set("torque_unit", standin_unit);
  hd().set("hold", person.holds_tight ? 1 : 0);
  hd().set("buttons", person.presses ? 1 : 0);
  std::atomic<bool> is_over{false};
  std::atomic<bool> has_felt{false};
  std::thread finger([&] {
    while (!is_over) {
      if (applied_torque() > person.feels) {
        usleep(static_cast<unsigned>(1e6 * person.reaction));
        has_felt = true;
        hd().set("buttons", 0);
      }
      usleep(500);
    }
  });
  Found found;
  const HdLibrary library = open_hd_library();
  {
    const HdHandle handle(library, "");
    const CalibrationTalk talk{
        [](const std::string&) {},
        [&](const std::string& question) {
          ++found.questions;
          found.force_output = hd().get("force_output");
          if (question.find("Ready?") != std::string::npos) return true;
          if (!person.is_honest) return false;
          const bool asks_of_nothing = question.find("no torque at all") != std::string::npos;
          return asks_of_nothing ? !has_felt
                                 : has_felt || question.find("turned") != std::string::npos;
        },
        std::move(stop)};
    found.unit = find_torque_unit(library, handle.id(), talk, kQuick);
  }
  is_over = true;
  finger.join();
  found.most = standin_unit * hd().get("torque_max");
  found.at_end = std::hypot(hd().get("last_tx"), hd().get("last_ty"), hd().get("last_tz"));
  EXPECT_EQ(hd().get("force_output"), 0.0);
  EXPECT_EQ(found.at_end, 0.0);
  return found;
}

class TorqueUnit : public testing::Test {
 protected:
  void SetUp() override { ASSERT_TRUE(hd().is_open()) << dlerror(); }
  static void print(const char* who, double standin_unit, const Found& f) {
    std::printf("%-34s %-6s %-9s %7.1f mN m  %d questions\n", who,
                standin_unit == 1.0 ? "N m" : "mN m",
                f.unit == 0.0   ? "not found"
                : f.unit == 1.0 ? "N m"
                                : "mN m",
                1e3 * f.most, f.questions);
  }
};

TEST_F(TorqueUnit, nobody_feels_much_in_either_unit_before_it_is_found) {
  struct Case {
    const char* who;
    Person person;
    bool is_found;
  };
  Person light, stiff, numb, turned, silent, away;
  stiff.feels = 0.03;
  turned.feels = kNever;  // says nothing by itself
  turned.holds_tight = false;
  numb.feels = 0.04;
  numb.reaction = 0.05;
  silent.is_honest = false;
  silent.feels = kNever;
  away.presses = false;
  const Case cases[] = {{"feels 15 mN m, lets go", light, true},
                        {"feels 30 mN m, lets go", stiff, true},
                        {"feels 40 mN m, slow", numb, true},
                        {"only the stylus turns", turned, true},
                        {"never says yes", silent, false}};
  std::printf("who holds the stylus               unit   found     most torque asked\n");
  for (const Case& c : cases) {
    for (const double unit : {1.0, 1e-3}) {
      const Found f = try_person(unit, c.person);
      print(c.who, unit, f);
      EXPECT_LE(f.most, 1.0001 * kBound) << c.who;
      EXPECT_EQ(f.unit, !c.is_found ? 0.0 : 1.0 / unit) << c.who << ' ' << unit;
    }
  }
  EXPECT_EQ(kTorqueSteps[1], kBound);                                   // in N m
  EXPECT_EQ(1e-3 * kTorqueSteps[std::size(kTorqueSteps) - 1], kBound);  // in mN m
}

TEST_F(TorqueUnit, who_feels_it_late_is_still_believed_to_be_in_newton_metres) {
  Person late;  // in steps 3 to 5, where nobody feels anything in mN m
  late.feels = 0.1;
  EXPECT_EQ(try_person(1.0, late).unit, 1.0);
}

TEST_F(TorqueUnit, forces_are_off_while_it_asks) {
  const Found f = try_person(1e-3, {});
  EXPECT_EQ(f.force_output, 0.0);
  EXPECT_GT(f.questions, 4);
}

TEST_F(TorqueUnit, a_button_that_is_let_go_is_zero_in_the_next_frame_and_asked_about) {
  Person accident;  // lets go of it though nothing is felt: no torque there, says the person
  accident.feels = 0.002;
  accident.is_honest = false;
  const Found f = try_person(1.0, accident);
  EXPECT_EQ(f.unit, 0.0);
  EXPECT_LT(f.most, 0.006);
}

TEST_F(TorqueUnit, a_stop_ends_it_and_nothing_is_found) {
  int looks = 0;
  const Found f = try_person(1.0, {.feels = kNever}, [&looks] { return ++looks > 20; });
  EXPECT_EQ(f.unit, 0.0);
  EXPECT_LT(f.most, 0.011);
}

TEST_F(TorqueUnit, is_left_out_where_nobody_answers) {
  hd().reset();
  hd().set("model", 2);
  hd().set("buttons", 1);
  const HdLibrary library = open_hd_library();
  const HdHandle handle(library, "");
  CalibrationTalk talk{[](const std::string&) {}, [](const std::string&) { return true; }};
  talk.is_answered = false;
  EXPECT_EQ(find_torque_unit(library, handle.id(), talk, kQuick), 0.0);
  EXPECT_EQ(hd().get("torque_nonzero"), 0.0);
}

}  // namespace
}  // namespace thigma::detail
