#include "services.h"

#include <cstring>

namespace standin_test {

Running::Running(const std::string& program, const std::string& name,
                 std::vector<std::string> words, std::vector<std::string> keys) {
  static int count = 0;
  path_ = ::testing::TempDir() + "si_" + std::to_string(getpid()) + "_" + std::to_string(++count);
  std::remove(path_.c_str());
  int inherited = -1;
  si::Board* board = si::open_board(path_.c_str(), &inherited);
  EXPECT_NE(board, nullptr);
  si::use_board(board);
  const std::string file = STANDIN_FOLDER "/" + program;
  words.insert(words.begin(), {file, path_, "--record", path_ + ".raw"});
  std::vector<char*> arguments, variables;
  for (std::string& word : words) {
    arguments.push_back(word.data());
  }
  for (char** v = environ; *v != nullptr; ++v) {
    variables.push_back(*v);
  }
  for (std::string& key : keys) {
    key = "STANDIN_" + name + "_" + key;
    variables.push_back(key.data());
  }
  arguments.push_back(nullptr);
  variables.push_back(nullptr);
  int out[2] = {};
  EXPECT_EQ(pipe(out), 0);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, out[1], STDOUT_FILENO);
  posix_spawn_file_actions_addclose(&actions, out[0]);
  EXPECT_EQ(
      posix_spawn(&process_, file.c_str(), &actions, nullptr, arguments.data(), variables.data()),
      0);
  posix_spawn_file_actions_destroy(&actions);
  ::close(out[1]);
  std::FILE* told = fdopen(out[0], "r");
  char line[512] = {};
  if (std::fgets(line, sizeof(line), told) != nullptr && std::strlen(line) > 10) {
    where_ = std::string(line + 10, std::strlen(line) - 11);
  }
  std::fclose(told);
  EXPECT_FALSE(where_.empty()) << file;
}

Running::~Running() {
  if (process_ > 0) {
    kill(process_, SIGKILL);
    waitpid(process_, nullptr, 0);
  }
  std::remove(path_.c_str());
  std::remove((path_ + ".raw").c_str());
  std::remove((path_ + ".csv").c_str());
}

bool Running::has_ended() {
  if (process_ > 0 && waitpid(process_, nullptr, WNOHANG) == process_) {
    process_ = 0;
  }
  return process_ == 0;
}

std::string Running::log() const {
  const si::Locked lock;
  EXPECT_EQ(standin_log((path_ + ".csv").c_str()), 0);
  return text_of(path_ + ".csv");
}

std::string Running::text_of(const std::string& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

int Wire::unix_socket(const std::string& path) {
  const int fd = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  std::strncpy(address.sun_path, path.c_str(), sizeof(address.sun_path) - 1);
  EXPECT_EQ(connect(fd, reinterpret_cast<const sockaddr*>(&address), sizeof(address)), 0) << path;
  return fd;
}

const std::string& Wire::read(std::size_t size, double seconds) {
  for (double waited = 0.0; in_.size() < size && !gone_ && waited < seconds; waited += 0.005) {
    pollfd waiting{fd_, POLLIN, 0};
    if (poll(&waiting, 1, 5) > 0) {
      gone_ = !si::receive(fd_, &in_);
    }
  }
  return in_;
}

bool Wire::is_closed(double seconds) {
  for (double waited = 0.0; !gone_ && waited < seconds; waited += 0.01) {
    read(in_.size() + 1, 0.01);
  }
  return gone_;
}

void Wire::close() {
  if (fd_ >= 0) {
    ::close(fd_);
    fd_ = -1;
  }
}

pid_t run_child(const std::function<void()>& work) {
  const pid_t child = fork();
  if (child == 0) {
    work();
    for (;;) {
      pause();
    }
  }
  return child;
}

void kill_child(pid_t child) {
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
}

}  // namespace standin_test
