#pragma once
// The program `thigma` as its users have it: arguments in, exit code and two streams out.

#include <chrono>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>
#include <sys/types.h>

namespace thigma::test {

/// Of any process on a small or a lying file [MiB]. Sanitizers keep shadow memory and freed blocks.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr double kMostMib = 8000.0;
#else
inline constexpr double kMostMib = 300.0;
#endif

/// How a process ended and what it said.
struct Ended {
  int code = -1;           // exit code, or -1
  int signal = 0;          // that killed it, 0 for none
  bool timed_out = false;  // killed by this runner
  std::string out, err;    // standard output and error
  double peak_mib = 0.0;   // largest resident set, or that of the test program if larger [MiB]
  double cpu_seconds = 0.0;
  double seconds = 0.0;  // wall time: for reports, never asserted
};

/// A running program. Killed when it is forgotten, so that no test leaves one behind.
class Program {
 public:
  explicit Program(const std::vector<std::string>& arguments);
  ~Program();
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  void send(int signal) const;
  /// Resident memory now; 0 once it has ended [MiB].
  double resident_mib() const;
  /// Standard error so far.
  std::string said() const;
  /// Waits until said() contains `text`; false when the program ended or `limit` seconds passed.
  bool waits_for(const std::string& text, double limit = 60.0);
  /// Waits for the end; after `limit` seconds kills it.
  Ended finish(double limit = 120.0);

 private:
  bool reap(bool is_blocking);

  pid_t pid_ = -1;
  std::filesystem::path out_, err_;
  std::chrono::steady_clock::time_point start_;
  bool is_reaped_ = false;
  Ended ended_;
};

/// Runs `thigma` with these arguments.
Ended run_program(const std::vector<std::string>& arguments, double limit = 120.0);

/// Every line of standard output as JSON; a test failure for a line that is none.
std::vector<nlohmann::json> json_lines(const Ended& ended);

/// The only line; a test failure when there are more or fewer.
nlohmann::json json_line(const Ended& ended);

/// Fails unless standard error is exactly one line that starts with "thigma: " and `start`.
void expect_one_line(const Ended& ended, const std::string& start = "");

/// A folder of this test program, emptied when the program starts.
const std::filesystem::path& work_folder();

/// Writes a file in work_folder() and returns its path.
std::string write_text(const std::string& name, const std::string& bytes);
std::string read_text(const std::filesystem::path& path);

/// A file of this name in the folder of the tests.
inline std::string out_file(const std::string& name) { return (work_folder() / name).string(); }

inline const std::string kBall = "procedural:ball?triangles=320";
inline const std::string kHeader = "x,y,z,qx,qy,qz,qw\n";  // of a file of poses

}  // namespace thigma::test
