#include "thigma/files/file.h"

#include <filesystem>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "thigma/core/error.h"

namespace thigma {
namespace {

std::filesystem::path fresh_folder(const char* name) {
  const std::filesystem::path folder = std::filesystem::temp_directory_path() /
                                       ("thigma_" + std::string(name) + std::to_string(::getpid()));
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  return folder;
}

TEST(File, what_is_written_is_read_back_and_nothing_else_is_left) {
  const std::filesystem::path folder = fresh_folder("file");
  const std::string path = folder / "a.bin";
  std::string bytes;
  for (int i = 0; i < 300000; ++i) bytes += static_cast<char>(i * 7);
  write_file(path, "older and to be replaced");
  write_file(path, bytes);
  EXPECT_EQ(read_file(path), bytes);
  write_file(path, "");
  EXPECT_EQ(read_file(path), "");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder),
                          std::filesystem::directory_iterator()),
            1);
  std::filesystem::remove_all(folder);
}

TEST(File, what_cannot_be_read_is_bad_input_in_one_line) {
  for (const char* path : {"/no/such/folder/mesh.obj", "/", "/dev/zero"}) {
    try {
      read_file(path);
      FAIL() << path << " was read";
    } catch (const InputError& error) {
      EXPECT_EQ(std::string(error.what()).find(path), 0u);
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    }
  }
}

TEST(File, a_failed_write_leaves_the_old_file) {
  const std::filesystem::path folder = fresh_folder("failed");
  EXPECT_THROW(write_file(folder / "missing" / "a.bin", "x"), IoError);
  EXPECT_THROW(write_file(folder, "x"), IoError);
  EXPECT_TRUE(std::filesystem::is_empty(folder));
  std::filesystem::remove_all(folder);
}

TEST(File, a_pipe_that_nobody_writes_to_is_refused_and_one_that_is_written_is_read) {
  const std::filesystem::path folder = fresh_folder("pipe");
  const std::string path = folder / "pipe";
  ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0);
  try {
    read_file(path);
    FAIL() << "read from nobody";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("nobody writes"), std::string::npos) << error.what();
  }
  const std::string sent(300000, 'x');
  std::thread writer([&] { std::ofstream(path) << sent; });
  EXPECT_EQ(read_file(path), sent);
  writer.join();
  std::thread silent([&] { std::ofstream(path).close(); });
  EXPECT_EQ(read_file(path), "");
  silent.join();
  std::filesystem::remove_all(folder);
}

TEST(File, only_a_whole_byte_order_mark_before_a_text_is_skipped) {
  EXPECT_EQ(without_byte_order_mark("\xEF\xBB\xBF"
                                    "v 0"),
            "v 0");
  EXPECT_EQ(without_byte_order_mark("\xEF\xBB\xBF"), "");
  for (const char* text : {"", "v 0", "\xEF\xBB", "\xBB\xBF", " \xEF\xBB\xBF"})
    EXPECT_EQ(without_byte_order_mark(text), text);
}

TEST(File, of_many_writers_at_once_one_wins_and_each_is_whole) {
  const std::filesystem::path folder = fresh_folder("writers");
  const std::string path = folder / "a.bin";
  write_file(path, std::string(100000, 'z'));
  int running = 0;
  for (char name = 'a'; name < 'e'; ++name, ++running) {
    if (::fork() != 0) continue;
    for (int i = 0; i < 20; ++i) write_file(path, std::string(100000, name));
    ::_exit(0);
  }
  for (int status = 0; running > 0;) {
    if (::waitpid(-1, &status, WNOHANG) > 0) {
      EXPECT_EQ(status, 0);
      --running;
    }
    const std::string bytes = read_file(path);
    ASSERT_EQ(bytes, std::string(100000, bytes.at(0)));
  }
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder),
                          std::filesystem::directory_iterator()),
            1);
  std::filesystem::remove_all(folder);
}

// A process of the same number: in another container that shares the folder, or one that was
// killed.
TEST(File, a_temporary_file_of_somebody_else_is_left_alone) {
  const std::filesystem::path folder = fresh_folder("others");
  const std::string path = folder / "a.bin";
  std::vector<std::string> others;
  for (int i = 0; i < 300; ++i) {
    others.push_back(path + ".part" + std::to_string(::getpid()) + "." + std::to_string(i));
    std::ofstream(others.back()) << "theirs";
  }
  write_file(path, "ours");
  EXPECT_EQ(read_file(path), "ours");
  for (const std::string& other : others) EXPECT_EQ(read_file(other), "theirs");
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace thigma
