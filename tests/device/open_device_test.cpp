#include "thigma/device/open_device.h"

#include <cmath>
#include <cstdio>
#include <fstream>

#include <gtest/gtest.h>

#include "thigma/core/error.h"
#include "thigma/device/detail/hand_table.h"
#include "thigma/device/script.h"

namespace thigma {
namespace {

std::string refusal(const std::string& address) {
  try {
    open_device(address);
  } catch (const DeviceAddressError& error) {
    return error.what();
  }
  return "no error";
}

TEST(OpenDevice, HostsAreNamesOfMachinesAndBringNoLinesOfTheirOwn) {
  for (const char* address :
       {"haply:?host=a\r\nX-Header: 1", "haply:?host=a b", "haply:?host=", "vrpn:T@a/b"}) {
    try {
      open_device(address);
      FAIL() << address;
    } catch (const DeviceAddressError& error) {
      const std::string why = error.what();
      EXPECT_NE(why.find("expected the name or address of a machine"), std::string::npos) << why;
      EXPECT_EQ(why.find('\n'), std::string::npos);
    }
  }
}

TEST(OpenDevice, HandTakesItsParameters) {
  const HandParams p = parse_hand("mass=0.1&friction=0&delay=0.003&force=2&dof=3&seed=9&path=tap");
  EXPECT_EQ(p.mass, 0.1);
  EXPECT_EQ(p.friction, 0.0);
  EXPECT_EQ(p.delay, 0.003);
  EXPECT_EQ(p.program.force, 2.0);
  EXPECT_FALSE(p.senses_rotation);
  EXPECT_FALSE(p.actuates_rotation);
  EXPECT_EQ(p.seed, 9u);
  EXPECT_EQ(p.program.path, HandPath::tap);
  EXPECT_EQ(parse_hand("").mass, HandParams{}.mass);
}

TEST(OpenDevice, EveryNumberOfTheTableReachesItsOwnField) {
  for (const detail::HandNumber& number : detail::hand_numbers()) {
    HandParams defaults = parse_hand("");
    const double value = number.high;
    std::string query = std::string(number.name) + "=" + std::to_string(value);
    HandParams p = parse_hand(query);
    EXPECT_NEAR(number.field(p), value, 1e-6 * std::fabs(value)) << number.name;
    EXPECT_NE(number.field(p), number.field(defaults)) << number.name;
    int changed = 0;
    for (const detail::HandNumber& other : detail::hand_numbers()) {
      changed += other.field(p) != other.field(defaults) ? 1 : 0;
    }
    // A clearance of its own moves reach along.
    EXPECT_EQ(changed, number.name == "clearance" ? 2 : 1) << number.name;
  }
}

TEST(OpenDevice, OnlyTheDemoShakesByItself) {
  EXPECT_GT(parse_hand("").tremor, 0.0);
  EXPECT_GT(parse_hand("path=demo").tremor, 0.0);
  EXPECT_EQ(parse_hand("path=press").tremor, 0.0);
  EXPECT_EQ(parse_hand("tremor=0.001&path=press").tremor, 0.001);
  EXPECT_EQ(parse_hand("tremor=0").tremor, 0.0);
}

TEST(OpenDevice, InterfaceNamesAreAllThere) {
  for (const char* name :
       {"mass", "damping", "friction", "encoder", "delay", "jitter", "arm_mass", "arm_stiffness",
        "arm_damping", "tremor", "force", "max_force", "max_torque"}) {
    EXPECT_NO_THROW(parse_hand(std::string(name) + "=0.005")) << name;
  }
}

TEST(OpenDevice, ModelGivesLimitsThatSingleNumbersOverride) {
  const HandParams touch = parse_hand("device=touch");
  EXPECT_EQ(touch.max_force, 3.3);
  EXPECT_TRUE(touch.senses_rotation);
  EXPECT_FALSE(touch.actuates_rotation);
  const HandParams mine =
      parse_hand("max_force=2&actuates_rotation=1&device=touch&max_torque=0.05");
  EXPECT_EQ(mine.max_force, 2.0);
  EXPECT_EQ(mine.max_torque, 0.05);
  EXPECT_TRUE(mine.actuates_rotation);
}

TEST(OpenDevice, ContextPlacesTheProgram) {
  DeviceContext context;
  context.start.position = {0.01, 0.02, 0.03};
  context.approach = {0.0, 3.0, 4.0};
  context.clearance = 0.004;
  context.object_radius = 0.01;
  context.seed = 42;
  const HandParams p = parse_hand("", context);
  EXPECT_LT((p.program.approach - Vec3(0.0, 0.6, 0.8)).norm(), 1e-15);
  EXPECT_NEAR(p.program.approach.dot(p.program.slide), 0.0, 1e-15);
  EXPECT_NEAR(p.program.slide.norm(), 1.0, 1e-15);
  EXPECT_EQ(p.program.start.position, context.start.position);
  EXPECT_DOUBLE_EQ(p.program.slide_length, 0.002);
  EXPECT_DOUBLE_EQ(p.program.reach, 0.016);
  EXPECT_EQ(p.seed, 42u);
  EXPECT_EQ(parse_hand("seed=7", context).seed, 7u);
}

TEST(OpenDevice, ContextOfAnySizeOpens) {
  for (const double radius : {1e-9, 1.0, 1e9}) {
    DeviceContext context;
    context.object_radius = radius;
    context.clearance = 2.0 * radius;
    EXPECT_NO_THROW(open_device("hand:", context)) << radius;
  }
}

TEST(OpenDevice, MistakesAreNamedWithTheNearestRightOne) {
  EXPECT_EQ(refusal("hand:?fricton=1"), "hand: no parameter 'fricton', nearest is 'friction'");
  EXPECT_EQ(refusal("hand:?mass=heavy"), "hand: mass = 'heavy', expected a finite number");
  EXPECT_EQ(refusal("hand:?mass=1kg"), "hand: mass = '1kg', expected a finite number");
  EXPECT_EQ(refusal("hand:?mass=nan"), "hand: mass = 'nan', expected a finite number");
  EXPECT_EQ(refusal("hand:?mass=-1"), "hand: mass = -1, expected from 0 to 100 kg");
  EXPECT_EQ(refusal("hand:?mass"), "hand: 'mass', expected name=value");
  EXPECT_EQ(refusal("hand:?mass=1&mass=2"), "hand: 'mass' is given twice, expected once");
  EXPECT_EQ(refusal("hand:?mass=1&"), "hand: '', expected name=value");
  EXPECT_EQ(refusal("hand:mass=1"), "hand: 'mass=1', expected ?name=value&name=value");
  EXPECT_EQ(refusal("hand:?dof=5"), "hand: dof = '5', expected 6 or 3");
  EXPECT_EQ(refusal("hand:?seed=-3"), "hand: seed = '-3', expected an integer from 0 to 2^53");
  EXPECT_EQ(refusal("hand:?device=toch"), "hand: no device 'toch', nearest is 'touch'");
  EXPECT_EQ(refusal("null:?clutsch=0"), "null: no parameter 'clutsch', nearest is 'clutch'");
  EXPECT_EQ(refusal("null:?clutch=2"), "null: clutch = '2', expected 0 or 1");
  // As good as a device that is not there: the address may be right for another program.
  try {
    open_device("hnad:");
    ADD_FAILURE() << "no error";
  } catch (const DeviceUnavailable& error) {
    EXPECT_STREQ(error.what(), "no device 'hnad:', nearest is 'hand:'");
  }
  try {
    open_device("omega:0");  // near to none
    ADD_FAILURE() << "no error";
  } catch (const DeviceUnavailable& error) {
    EXPECT_NE(std::string(error.what()).find("no device 'omega:', expected one of hand:, script:"),
              std::string::npos)
        << error.what();
  }
  EXPECT_EQ(
      refusal("touch"),
      "device 'touch' has no scheme, expected one of hand:, script:FILE, web:, replay:FILE, null:, "
      "openhaptics:NAME, dhd:NUMBER, haply:ID, vrpn:NAME@HOST, spacenav:, gamepad:NUMBER");
  EXPECT_EQ(refusal("script:"), "script: no file, expected script:FILE");
}

TEST(OpenDevice, WhatThisMachineLacksIsUnavailable) {
  // The port of loopback that nobody listens on; the name that nobody has.
  for (const char* address :
       {"openhaptics:", "dhd:0", "haply:?port=1", "vrpn:Tracker0@localhost:1", "web:"}) {
    EXPECT_THROW(open_device(address), DeviceUnavailable) << address;
  }
}

TEST(OpenDevice, FilesBecomeScriptsAndPaths) {
  const std::string path = testing::TempDir() + "thigma_open_device.csv";
  std::ofstream(path) << "t,x,y,z,qx,qy,qz,qw\n0,0.01,0,0,0,0,0,1\n1,0.02,0,0,0,0,0,1\n";
  const auto script = open_device("script:" + path);
  EXPECT_EQ(script->read(0.0).motion.pose.position.x(), 0.01);
  const HandParams p = parse_hand("path=" + path);
  ASSERT_EQ(p.script.size(), 2u);
  const auto hand = make_hand(p);
  EXPECT_NEAR(hand->read(0.0).motion.pose.position.x(), 0.01, p.encoder);
  EXPECT_EQ(hand->phase(), HandPhase::script);
  for (int i = 1; i <= 2500; ++i) hand->read(i * 1e-3);
  EXPECT_NEAR(hand->true_motion().pose.position.x(), 0.02, 2e-4);  // to friction / stiffness
  std::remove(path.c_str());
  EXPECT_THROW(open_device("script:" + path), InputError);
  EXPECT_THROW(parse_hand("path=" + path), InputError);
}

TEST(OpenDevice, NullHoldsItsClutchOrNot) {
  EXPECT_EQ(open_device("null:")->read(0.0).buttons, kClutchButton);
  EXPECT_EQ(open_device("null:?clutch=0")->read(0.0).buttons, 0u);
}

TEST(OpenDevice, WhatIsSimulatedHoldsNobody) {
  EXPECT_TRUE(DeviceLimits{}.holds_person);  // unless a device says otherwise
  EXPECT_FALSE(open_device("hand:")->limits().holds_person);
  EXPECT_FALSE(open_device("null:")->limits().holds_person);
  EXPECT_FALSE(make_script_device({TimedPose{}}, {})->limits().holds_person);
}

TEST(OpenDevice, HandsParametersAreListedAsTheyAre) {
  for (const DeviceScheme& scheme : device_schemes()) {
    if (scheme.scheme != "hand:") continue;
    EXPECT_FALSE(scheme.parameters.empty());
    for (const DeviceParameter& parameter : scheme.parameters) {
      if (parameter.unit.empty()) continue;
      // A default as listed is accepted and changes nothing.
      EXPECT_NO_THROW(parse_hand(parameter.name + "=" + parameter.default_value)) << parameter.name;
    }
  }
}

}  // namespace
}  // namespace thigma
