#include "thigma/files/growing_file.h"

#include <csignal>
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "thigma/core/error.h"
#include "thigma/files/file.h"

namespace thigma {
namespace {

namespace fs = std::filesystem;

fs::path new_folder(const char* name) {
  const fs::path folder =
      fs::temp_directory_path() / ("thigma_" + std::string(name) + std::to_string(::getpid()));
  fs::remove_all(folder);
  fs::create_directories(folder);
  return folder;
}

/// What a piece of work is refused with, "" when it is not.
template <class Work>
std::string refusal(const Work& work) {
  try {
    work();
  } catch (const IoError& error) {
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    return error.what();
  }
  return "";
}

/// Runs `work` in a process of its own; its exit code, or minus the signal that ended it.
template <class Work>
int in_child(const Work& work) {
  const pid_t child = ::fork();
  if (child == 0) ::_exit(work());
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFSIGNALED(status) ? -WTERMSIG(status) : WEXITSTATUS(status);
}

TEST(GrowingFile, takes_its_place_when_it_is_whole) {
  const fs::path folder = new_folder("grows");
  const std::string path = folder / "a";
  write_file(path, "older");
  GrowingFile file(path);
  file.append("one ");
  file.append("two", 1000);
  EXPECT_EQ(read_file(path), "older");
  EXPECT_EQ(read_file(path + ".part"), "one two") << "on its way to the disk at once";
  EXPECT_EQ(file.size(), 7u);
  file.keep();
  EXPECT_EQ(read_file(path), "one two");
  EXPECT_FALSE(fs::exists(path + ".part"));
  EXPECT_EQ(file.moved(), "");
  fs::remove_all(folder);
}

TEST(GrowingFile, is_removed_when_it_is_discarded) {
  const fs::path folder = new_folder("discarded");
  GrowingFile file(folder / "a");
  file.append("one");
  file.discard();
  EXPECT_TRUE(fs::is_empty(folder));
  fs::remove_all(folder);
}

TEST(GrowingFile, a_second_writer_is_refused_while_the_first_lives) {
  const fs::path folder = new_folder("second");
  const std::string path = folder / "a";
  GrowingFile first(path);
  first.append("first");
  const auto open_second = [&] { GrowingFile second((folder / "." / "a").string()); };
  EXPECT_NE(refusal(open_second).find("another process is writing it, expected another name"),
            std::string::npos);
  EXPECT_EQ(in_child([&] { return refusal(open_second).empty() ? 0 : 1; }), 1);
  first.append(" goes on");
  first.keep();
  EXPECT_EQ(read_file(path), "first goes on");
  EXPECT_EQ(refusal(open_second), "") << "the lock went with its process or file";
  fs::remove_all(folder);
}

TEST(GrowingFile, what_a_killed_writer_left_is_moved_away_whole) {
  const fs::path folder = new_folder("left");
  const std::string path = folder / "a";
  for (int i = 1; i <= 3; ++i) {
    const int ended = in_child([&] {
      GrowingFile file(path);
      file.append("killed " + std::to_string(i));
      ::kill(::getpid(), SIGKILL);
      return 0;
    });
    EXPECT_EQ(ended, -SIGKILL);
    EXPECT_EQ(read_file(path + ".part"), "killed " + std::to_string(i));
  }
  GrowingFile file(path);
  EXPECT_EQ(file.moved(), path + ".part.3");
  for (int i = 1; i <= 3; ++i)
    EXPECT_EQ(read_file(path + ".part." + std::to_string(i)), "killed " + std::to_string(i));
  file.append("whole");
  file.keep();
  EXPECT_EQ(read_file(path), "whole");
  fs::remove_all(folder);
}

TEST(GrowingFile, of_many_writers_at_once_each_is_whole_or_refused) {
  const fs::path folder = new_folder("many");
  const std::string path = folder / "a";
  std::vector<pid_t> children;
  for (int i = 0; i < 8; ++i) {
    const pid_t child = ::fork();
    if (child == 0) {
      int done = 0;
      for (int k = 0; k < 50; ++k) {
        try {
          GrowingFile file(path);
          for (int n = 0; n < 20; ++n) file.append(std::string(100, static_cast<char>('a' + i)));
          file.keep();
          ++done;
        } catch (const IoError&) {
        }
      }
      ::_exit(done > 0 ? 0 : 1);
    }
    children.push_back(child);
  }
  int finished = 0;
  while (finished < 8) {
    int status = 0;
    if (::waitpid(-1, &status, WNOHANG) > 0) ++finished;
    std::error_code none;
    if (!fs::exists(path, none)) continue;
    const std::string bytes = read_file(path);
    ASSERT_EQ(bytes, std::string(2000, bytes.at(0))) << "of one writer alone";
  }
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), fs::directory_iterator()), 1)
      << "nobody was killed, nothing was moved away";
  fs::remove_all(folder);
}

TEST(GrowingFile, takes_all_of_a_piece_or_nothing) {
  const fs::path folder = new_folder("limit");
  const std::string path = folder / "a";
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  rlimit less = before;
  less.rlim_cur = 1000;
  GrowingFile file(path);
  file.append(std::string(900, 'a'));
  setrlimit(RLIMIT_FSIZE, &less);
  const std::string why = refusal([&] { file.append(std::string(200, 'b')); });
  EXPECT_NE(refusal([&] { file.append(std::string(101, 'c')); }), "");
  EXPECT_EQ(fs::file_size(path + ".part"), 900u);
  file.append(std::string(100, 'd'));  // as much as there is room for
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  EXPECT_EQ(why.rfind(path + ": cannot be written: ", 0), 0u) << why;
  file.keep();
  EXPECT_EQ(read_file(path), std::string(900, 'a') + std::string(100, 'd'));
  fs::remove_all(folder);
}

TEST(GrowingFile, a_deleted_file_is_noticed) {
  const fs::path folder = new_folder("deleted");
  GrowingFile file(folder / "a");
  file.append("one");
  fs::remove_all(folder);
  EXPECT_NE(refusal([&] { file.append("two"); }).find("deleted"), std::string::npos);
  EXPECT_NE(refusal([&] { file.keep(); }).find("deleted"), std::string::npos);
}

TEST(GrowingFile, follows_a_folder_that_is_moved) {
  const fs::path folder = new_folder("moves"), other = folder.string() + "_away";
  fs::remove_all(other);
  GrowingFile file(folder / "a");
  file.append("one");
  fs::rename(folder, other);
  file.append(" two");
  file.keep();
  EXPECT_EQ(read_file(other / "a"), "one two");
  fs::remove_all(other);
}

TEST(GrowingFile, a_folder_that_becomes_read_only_leaves_the_part) {
  const fs::path folder = new_folder("read_only");
  const std::string path = folder / "a";
  // As a user: root may write everywhere. The folder is the user's, so that it can close it.
  constexpr uid_t kNobody = 65534;
  const bool is_root = ::getuid() == 0;
  if (is_root) {
    ASSERT_EQ(::chown(folder.c_str(), kNobody, kNobody), 0);
  }
  enum { kAsExpected, kNotUser, kNotRefused, kOtherReason };
  const int ended = in_child([&] {
    if (is_root && ::setuid(kNobody) != 0) return kNotUser;
    GrowingFile file(path);
    file.append("one");
    ::chmod(folder.c_str(), 0555);
    file.append(" two");  // it is open
    const std::string why = refusal([&] { file.keep(); });
    if (why.empty()) return kNotRefused;
    const std::string other = refusal([&] { GrowingFile second(folder / "b"); });
    return why.find("denied") != std::string::npos && other.find("denied") != std::string::npos
               ? kAsExpected
               : kOtherReason;
  });
  EXPECT_EQ(ended, kAsExpected);
  EXPECT_EQ(read_file(path + ".part"), "one two");
  ::chmod(folder.c_str(), 0755);
  fs::remove_all(folder);
}

TEST(GrowingFile, only_a_regular_file_is_replaced) {
  for (const char* path : {"/dev/null", "/tmp", "/no/such/folder/a", "/proc/a"})
    EXPECT_EQ(refusal([&] { GrowingFile file(path); }).rfind(std::string(path) + ": ", 0), 0u);
}

TEST(GrowingFile, tells_whether_a_part_is_being_written) {
  const fs::path folder = new_folder("growing_told");
  const std::string path = (folder / "a").string();
  EXPECT_FALSE(is_growing(path + ".part"));
  {
    GrowingFile file(path);
    file.append("some");
    EXPECT_TRUE(is_growing(path + ".part"));
    EXPECT_FALSE(refusal([&] { GrowingFile second(path); }).empty());
  }
  EXPECT_TRUE(fs::exists(path + ".part"));
  EXPECT_FALSE(is_growing(path + ".part")) << "left by what is no more";
}

}  // namespace
}  // namespace thigma
