// The device as a process of its own: what is left of the force when the client is killed, and keys
// from outside.
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "client.h"
#include "common/board.h"
#include <spawn.h>
#include <sys/wait.h>

extern char** environ;

namespace standin_test {
namespace {

namespace si = standin;

// A board in a file, environment, and a client that can be killed.
class Killed : public ::testing::Test {
 protected:
  void SetUp() override {
    path_ = ::testing::TempDir() + "standin_board_" + std::to_string(getpid());
    std::remove(path_.c_str());
    int inherited = -1;
    before_ = si::open_board(path_.c_str(), &inherited);
    ASSERT_NE(before_, nullptr);
    si::use_board(before_);
  }
  void TearDown() override {
    kill_client();
    before_->quit.store(1);
    EXPECT_TRUE(wait_for([this] { return before_->device.load() <= 0; }));
    std::remove(path_.c_str());
  }

  void start(const std::string& kind, std::vector<std::string> environment) {
    const std::string file =
        std::string(STANDIN_FOLDER) + (kind == "hd" ? "/hd/libHD.so" : "/drd/libdrd.so");
    const std::string prefix = kind == "hd" ? "STANDIN_HD_" : "STANDIN_DRD_";
    std::vector<std::string> words = {STANDIN_CLIENT, file, kind, "2.0"};
    environment.push_back("BOARD=" + path_);
    for (std::string& variable : environment) {
      variable = prefix + variable;
    }
    std::vector<char*> arguments, variables;
    for (std::string& word : words) {
      arguments.push_back(word.data());
    }
    for (char** v = environ; *v != nullptr; ++v) {
      variables.push_back(*v);
    }
    for (std::string& variable : environment) {
      variables.push_back(variable.data());
    }
    arguments.push_back(nullptr);
    variables.push_back(nullptr);
    ASSERT_EQ(
        posix_spawn(&client_, STANDIN_CLIENT, nullptr, nullptr, arguments.data(), variables.data()),
        0);
  }

  void kill_client() {
    if (client_ > 0) {
      kill(client_, SIGKILL);
      waitpid(client_, nullptr, 0);
      client_ = 0;
    }
  }

  static bool has_force() { return si::get(0, si::k_applied_fx) == 2.0; }

  std::string path_;
  si::Board* before_ = nullptr;
  pid_t client_ = 0;
};

TEST_F(Killed, force_dimension_cuts_by_its_watchdog) {
  start("drd", {"PROCESS=1", "WATCHDOG=160", "LINGER_S=0.5"});
  ASSERT_TRUE(wait_for([] { return has_force(); }));
  EXPECT_GT(before_->device.load(), 0);
  EXPECT_NE(before_->device.load(), client_);
  kill_client();
  EXPECT_TRUE(wait_for([] { return si::get(0, si::k_applied_fx) == 0.0; }));
  const double silence = si::get(0, si::k_force_off_time) - si::get(0, si::k_last_set_time);
  EXPECT_GE(silence, 160 * 125e-6);
  EXPECT_LT(silence, 20 * 160 * 125e-6);  // a busy machine may wake the device late
  EXPECT_EQ(si::get(0, si::k_force_off_cause), 3.0);
  EXPECT_EQ(si::get(0, si::k_last_fx), 2.0);
  EXPECT_TRUE(
      wait_for([this] { return before_->device.load() == 0; }));  // it ends after its client
}

TEST_F(Killed, openhaptics_documents_nothing_that_would_cut) {
  start("hd", {"PROCESS=1", "RAMP_RATE=1000", "IMPULSE_LIMIT=100", "LINGER_S=0.5"});
  ASSERT_TRUE(wait_for([] { return has_force(); }));
  kill_client();
  usleep(100000);
  EXPECT_TRUE(has_force());
}

TEST_F(Killed, openhaptics_with_a_time_out_that_we_chose) {
  start("hd",
        {"PROCESS=1", "RAMP_RATE=1000", "IMPULSE_LIMIT=100", "COMM_TIMEOUT_MS=500", "LINGER_S=2"});
  ASSERT_TRUE(wait_for([] { return has_force(); }));
  kill_client();
  EXPECT_TRUE(wait_for([] { return si::get(0, si::k_applied_fx) == 0.0; }));
}

TEST_F(Killed, the_record_is_there_after_the_client_and_its_device_died) {
  start("drd", {"WATCHDOG=0"});  // the device is a thread of the client
  ASSERT_TRUE(wait_for([] { return has_force(); }));
  kill_client();
  const std::string log = path_ + ".csv";
  const std::string command = STANDIN_FOLDER "/standin_control " + path_ + " log " + log;
  ASSERT_EQ(std::system(command.c_str()), 0);
  std::ifstream file(log);
  const std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  EXPECT_NE(text.find(",drdOpen,"), std::string::npos);
  EXPECT_NE(text.find(",dhdSetForceAndTorqueAndGripperForce,0,2,"), std::string::npos);
  EXPECT_NE(text.find("# 0.last_fx=2\n"), std::string::npos);
  std::remove(log.c_str());
}

TEST_F(Killed, keys_are_set_from_outside_while_the_client_runs) {
  start("drd", {"WATCHDOG=0", "BUTTONS=1", "1_BUTTONS=6"});
  ASSERT_TRUE(wait_for([] { return has_force(); }));
  EXPECT_EQ(si::get(0, si::k_buttons), 1.0);
  EXPECT_EQ(si::get(1, si::k_buttons), 6.0);
  const std::string command = STANDIN_FOLDER "/standin_control " + path_ + " set unplug 1";
  ASSERT_EQ(std::system(command.c_str()), 0);
  EXPECT_TRUE(wait_for([] { return si::get(0, si::k_force_off_cause) == 5.0; }));
  EXPECT_EQ(si::get(0, si::k_applied_fx), 0.0);
}

TEST(WrongLibraries, are_refused_by_the_loader) {
  for (const char* folder : {"garbage", "wrong_arch"}) {
    EXPECT_FALSE(Library(folder, "libHD.so").is_open());
    EXPECT_FALSE(Library(folder, "libdrd.so").is_open());
  }
}

}  // namespace
}  // namespace standin_test
