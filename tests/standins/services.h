// Stand-ins that are processes, as a test starts, tells, asks and kills them.
#pragma once

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include "client.h"
#include "common/board.h"
#include "common/export.h"
#include "net/socket.h"
#include <poll.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;

namespace standin_test {

namespace si = standin;

// Runs build/PRESET/standins/PROGRAM with a board and a record of its own; kills it at the end.
class Running {
 public:
  // `keys` as STANDIN_<NAME>_<KEY>=VALUE without the front, by name of the stand-in.
  Running(const std::string& program, const std::string& name, std::vector<std::string> words,
          std::vector<std::string> keys = {});
  ~Running();
  Running(const Running&) = delete;
  Running& operator=(const Running&) = delete;

  // What follows "listening".
  const std::string& where() const { return where_; }
  int port() const { return static_cast<int>(get("port")); }
  pid_t process() const { return process_; }
  bool has_ended();

  void set(const char* key, double value) const { EXPECT_EQ(standin_set(key, value), 0) << key; }
  double get(const char* key) const { return standin_get(key); }
  // Waits until a key has a value.
  bool reaches(const char* key, double value) const {
    return wait_for([&] { return standin_get(key) == value; });
  }
  bool passes(const char* key, double value) const {
    return wait_for([&] { return standin_get(key) > value; });
  }
  // The raw record and the log of events, as text.
  std::string record() const { return text_of(path_ + ".raw"); }
  std::string log() const;
  const std::string& path() const { return path_; }

 private:
  static std::string text_of(const std::string& path);
  std::string path_;
  std::string where_;
  pid_t process_ = 0;
};

// A connection that reads with a limit of time.
class Wire {
 public:
  explicit Wire(int fd) : fd_(fd) {}
  ~Wire() { close(); }
  Wire(const Wire&) = delete;
  Wire& operator=(const Wire&) = delete;

  static int unix_socket(const std::string& path);
  bool send(std::string_view bytes) const { return si::send_all(fd_, bytes); }
  // At least so many bytes, less where the other side is gone or says nothing for `seconds`.
  const std::string& read(std::size_t size, double seconds = 10.0);
  // True where the other side has closed.
  bool is_closed(double seconds = 10.0);
  void drop(std::size_t size) { in_.erase(0, size); }
  std::string& in() { return in_; }
  int fd() const { return fd_; }
  void close();

 private:
  int fd_ = -1;
  bool gone_ = false;
  std::string in_;
};

// A child that does this and then waits to be killed; returns its process.
pid_t run_child(const std::function<void()>& work);
void kill_child(pid_t child);

}  // namespace standin_test
