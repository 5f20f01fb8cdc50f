// thigma tune: proposals, warnings, refusals.

#include "apps/program.h"
#include <gtest/gtest.h>

namespace thigma::test {
namespace {

using nlohmann::json;

TEST(TuneVerb, ProposesForAnObjectInADevice) {
  const Ended e = run_program({"tune", "--device", "hand:?device=touch&dof=3", "--mass", "0.01",
                               "--inertia", "1e-6,2e-6,2e-6", "--response", "penalty", "--json"});
  ASSERT_EQ(e.code, 0) << e.err;
  const json j = json_line(e);
  EXPECT_TRUE(j.at("scene").is_null());
  EXPECT_EQ(j.at("linear").at("binds"), "device");
  EXPECT_DOUBLE_EQ(j.at("linear").at("limit").get<double>(), 400.0);
  EXPECT_LT(j.at("linear").at("stiffness").get<double>(), 400.0);
  EXPECT_EQ(j.at("angular").at("binds"), "frames");
  EXPECT_TRUE(j.at("angular").at("limits").at("device").is_null());
  EXPECT_DOUBLE_EQ(j.at("contact").at("limit").get<double>(), 0.01 * 1e6);
  EXPECT_DOUBLE_EQ(j.at("max_force").get<double>(), 3.3);
  EXPECT_TRUE(j.at("max_torque").is_null());
  EXPECT_TRUE(j.at("warnings").empty());
  const Ended late = run_program({"tune", "--device", "hand:?device=touch&dof=3", "--mass", "0.01",
                                  "--inertia", "2e-6", "--delay", "0.015", "--json"});
  EXPECT_LT(json_line(late).at("linear").at("stiffness").get<double>(), 40.0);
}

TEST(TuneVerb, WarnsWhereASceneIsOutside) {
  const auto warned = [](const std::string& gains) {
    const std::string scene = write_text(
        "tuned.toml", "[object]\nmesh = \"procedural:ball?triangles=320\"\nmass = 0.01\n" + gains +
                          "\n[[static]]\nmesh = \"procedural:ball?triangles=320\"\n");
    const Ended e = run_program({"tune", scene, "--response", "penalty", "--json"});
    EXPECT_EQ(e.code, 0) << e.err;
    std::vector<std::string> names;
    const json said = json_line(e);
    for (const json& w : said.at("warnings")) names.push_back(w.at("gain"));
    return names;
  };
  EXPECT_TRUE(warned("").empty());
  EXPECT_EQ(warned("[contact]\nstiffness = 20000\n"), (std::vector<std::string>{"stiffness"}));
  EXPECT_EQ(warned("[coupling]\nlinear_stiffness = 5000\nmax_force = 20\n"),
            (std::vector<std::string>{"linear_stiffness", "max_force"}));
}

TEST(TuneVerb, AScenesAutoGainsAreItsProposal) {
  const std::string scene = write_text(
      "auto.toml",
      "gains = \"auto\"\n[object]\nmesh = \"procedural:ball?triangles=320\"\n[[static]]\nmesh = "
      "\"procedural:ball?triangles=320\"\n[device]\nuri = \"hand:?device=falcon&dof=3\"\n");
  const json j = json_line(run_program({"tune", scene, "--response", "penalty", "--json"}));
  EXPECT_EQ(j.at("scene_gains").at("linear_stiffness"), j.at("linear").at("stiffness"));
  EXPECT_EQ(j.at("scene_gains").at("contact_stiffness"), j.at("contact").at("stiffness"));
  EXPECT_TRUE(j.at("warnings").empty());
  const json run = json_line(run_program(
      {"run", scene, "--headless", "--lockstep", "--duration", "1", "--exact", "--json"}));
  EXPECT_TRUE(run.at("safety_events").empty());
}

TEST(TuneVerb, UnderConstraintsTheCouplingAloneIsJudged) {
  const std::string scene = write_text(
      "kept_out.toml",
      "[object]\nmesh = \"procedural:ball?triangles=320\"\nmass = 0.01\n[contact]\nresponse = "
      "\"constraint\"\nstiffness = 20000\n[coupling]\nlinear_stiffness = 5000\n[[static]]\nmesh = "
      "\"procedural:ball?triangles=320\"\n");
  const json j = json_line(run_program({"tune", scene, "--json"}));
  EXPECT_TRUE(j.at("contact").is_null());
  EXPECT_TRUE(j.at("scene_gains").at("contact_stiffness").is_null());
  ASSERT_EQ(j.at("warnings").size(), 1u) << j;  // none of the contact stiffness, which is not used
  EXPECT_EQ(j.at("warnings")[0].at("gain"), "linear_stiffness");
  const Ended said = run_program({"tune", scene, "--text"});
  EXPECT_NE(said.out.find("the hand feels the coupling alone"), std::string::npos) << said.out;
  EXPECT_EQ(said.out.find("stiffness = 2"), std::string::npos) << said.out;  // of a contact
}

TEST(TuneVerb, UnderThePotentialTheStiffnessIsThatOfAnArea) {
  const std::string scene = write_text(
      "over_an_area.toml",
      "[object]\nmesh = \"procedural:ball?triangles=320\"\nmass = 0.01\n[contact]\nresponse = "
      "\"potential\"\nstiffness = 3000\narea = 2e-5\nexponent = 2\n[[static]]\nmesh = "
      "\"procedural:ball?triangles=320\"\n");
  const json j = json_line(run_program({"tune", scene, "--json"}));
  EXPECT_EQ(j.at("scene_gains").at("contact_stiffness"), 3000.0);
  EXPECT_EQ(j.at("scene_gains").at("contact_area"), 2e-5);
  EXPECT_EQ(j.at("scene_gains").at("contact_exponent"), 2);
  const Ended said = run_program({"tune", scene, "--text"});
  EXPECT_NE(said.out.find("A0 = 20 mm^2, p = 2: k = 3000 N/m, k/A0 = 1.5e+08 Pa/m"),
            std::string::npos)
      << said.out;
}

TEST(TuneVerb, RefusesWithOneSentence) {
  const std::vector<std::vector<std::string>> wrong = {
      {"tune"},
      {"tune", "--device", "hand:"},
      {"tune", "--device", "hand:", "--mass", "0", "--inertia", "1e-6"},
      {"tune", "--device", "hand:", "--mass", "0.01", "--inertia", "1e-6,2e-6"},
      {"tune", "--device", "hand:", "--mass", "0.01", "--inertia", "x"},
      {"tune", "--device", "hand:?mas=1", "--mass", "0.01", "--inertia", "1e-6"},
      {"tune", "jaws", "--mass", "0.01"},
      {"tune", "jaws", "--rate", "1"},
      {"tune", "jaws", "--response", "soft"},
      {"tune", "jaws", "--delay", "-1"}};
  for (const auto& arguments : wrong) {
    const Ended e = run_program(arguments);
    EXPECT_EQ(e.code, 2) << arguments.back() << "\n" << e.err;
    expect_one_line(e);
  }
  EXPECT_EQ(run_program({"tune", "nowhere.toml"}).code, 4);
  EXPECT_EQ(run_program({"tune", "--device", "dhd:", "--mass", "1", "--inertia", "1"}).code, 3);
}

}  // namespace
}  // namespace thigma::test
