#include "apps/program.h"

#include <csignal>
#include <cstring>
#include <fstream>
#include <iterator>
#include <sstream>
#include <thread>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;

namespace thigma::test {
namespace {

namespace fs = std::filesystem;

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double seconds_of(const timeval& t) {
  return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
}

}  // namespace

Program::Program(const std::vector<std::string>& arguments)
    : start_(std::chrono::steady_clock::now()) {
  static int count = 0;
  ++count;
  out_ = work_folder() / ("stdout" + std::to_string(count));
  err_ = work_folder() / ("stderr" + std::to_string(count));
  std::vector<char*> argv;
  const std::string program = THIGMA_PROGRAM;
  argv.push_back(const_cast<char*>(program.c_str()));
  for (const std::string& a : arguments) argv.push_back(const_cast<char*>(a.c_str()));
  argv.push_back(nullptr);
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_addopen(&files, 0, "/dev/null", O_RDONLY, 0);
  constexpr int kNew = O_WRONLY | O_CREAT | O_TRUNC;
  posix_spawn_file_actions_addopen(&files, 1, out_.c_str(), kNew, 0600);
  posix_spawn_file_actions_addopen(&files, 2, err_.c_str(), kNew, 0600);
  const int failed = posix_spawn(&pid_, program.c_str(), &files, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&files);
  EXPECT_EQ(failed, 0) << program << ": " << std::strerror(failed);
  is_reaped_ = failed != 0;
}

Program::~Program() {
  if (!is_reaped_) {
    ::kill(pid_, SIGKILL);
    reap(true);
  }
  std::error_code ignored;
  fs::remove(out_, ignored);
  fs::remove(err_, ignored);
}

void Program::send(int signal) const {
  if (!is_reaped_) ::kill(pid_, signal);
}

double Program::resident_mib() const {
  std::ifstream status("/proc/" + std::to_string(pid_) + "/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with("VmRSS:")) return std::atof(line.c_str() + 6) / 1024.0;
  return 0.0;
}

std::string Program::said() const { return read_text(err_); }

bool Program::reap(bool is_blocking) {
  if (is_reaped_) return true;
  int status = 0;
  rusage usage{};
  const pid_t done = ::wait4(pid_, &status, is_blocking ? 0 : WNOHANG, &usage);
  if (done != pid_) return false;
  is_reaped_ = true;
  if (WIFEXITED(status)) ended_.code = WEXITSTATUS(status);
  if (WIFSIGNALED(status)) ended_.signal = WTERMSIG(status);
  ended_.seconds = seconds_since(start_);
  ended_.cpu_seconds = seconds_of(usage.ru_utime) + seconds_of(usage.ru_stime);
  ended_.peak_mib = static_cast<double>(usage.ru_maxrss) / 1024.0;
  ended_.out = read_text(out_);
  ended_.err = read_text(err_);
  return true;
}

bool Program::waits_for(const std::string& text, double limit) {
  const auto start = std::chrono::steady_clock::now();
  while (said().find(text) == std::string::npos) {
    if (reap(false) || seconds_since(start) > limit) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return true;
}

Ended Program::finish(double limit) {
  const auto start = std::chrono::steady_clock::now();
  while (!reap(false)) {
    if (seconds_since(start) > limit) {
      ::kill(pid_, SIGKILL);
      reap(true);
      ended_.timed_out = true;
      ADD_FAILURE() << "still running after " << limit << " s; standard error:\n" << ended_.err;
      break;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return ended_;
}

Ended run_program(const std::vector<std::string>& arguments, double limit) {
  return Program(arguments).finish(limit);
}

std::vector<nlohmann::json> json_lines(const Ended& ended) {
  std::vector<nlohmann::json> lines;
  std::istringstream text(ended.out);
  for (std::string line; std::getline(text, line);) {
    nlohmann::json json = nlohmann::json::parse(line, nullptr, false);
    EXPECT_TRUE(json.is_object()) << line;
    lines.push_back(std::move(json));
  }
  return lines;
}

nlohmann::json json_line(const Ended& ended) {
  const std::vector<nlohmann::json> lines = json_lines(ended);
  EXPECT_EQ(lines.size(), 1u) << ended.out << ended.err;
  return lines.size() == 1 ? lines.front() : nlohmann::json::object();
}

void expect_one_line(const Ended& ended, const std::string& start) {
  EXPECT_EQ(ended.err.rfind("thigma: " + start, 0), 0u) << ended.err;
  EXPECT_EQ(ended.err.find('\n') + 1, ended.err.size()) << ended.err;
}

const fs::path& work_folder() {
  static const fs::path folder = [] {
    fs::path path = fs::temp_directory_path() / ("thigma_program_" + std::to_string(::getpid()));
    fs::remove_all(path);
    fs::create_directories(path);
    ::setenv("XDG_DATA_HOME", (path / "data").c_str(), 1);  // nothing goes to the user's own
    static const fs::path at_exit = path;
    std::atexit([] {
      std::error_code ignored;
      fs::remove_all(at_exit, ignored);
    });
    return path;
  }();
  return folder;
}

std::string write_text(const std::string& name, const std::string& bytes) {
  const fs::path path = work_folder() / name;
  std::ofstream file(path, std::ios::binary);
  file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  EXPECT_TRUE(file.good()) << path;
  return path.string();
}

std::string read_text(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace thigma::test
