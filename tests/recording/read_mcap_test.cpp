#include <algorithm>
#include <filesystem>
#include <fstream>

#include "recording/recording_samples.h"
#include "support/full.h"
#include <gtest/gtest.h>

#include "thigma/core/error.h"
#include "thigma/files/checksum.h"
#include "thigma/files/file.h"
#include "thigma/recording/mcap_file.h"

namespace thigma {
namespace {

std::string scratch(const std::string& name) { return ::testing::TempDir() + "thigma_" + name; }

void put(const std::string& path, std::string_view bytes) {
  std::ofstream(path, std::ios::binary)
      .write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

/// `chunks` chunks of ten messages; the whole file.
McapFile sample_file(const std::string& name, int chunks) {
  const std::string path = scratch(name);
  McapWriter writer(path);
  const auto a = writer.add_channel("/a", "A", ""), b = writer.add_channel("/b", "B", "");
  for (int i = 0; i < 10 * chunks; ++i) {
    writer.write(i % 3 == 0 ? b : a, static_cast<std::uint32_t>(i), static_cast<std::uint64_t>(i),
                 "{\"v\":" + std::to_string(i * i) + "}");
    if (i % 10 == 9) writer.flush();
  }
  writer.close();
  return read_mcap(path);
}

bool is_prefix(const McapFile& part, const McapFile& whole) {
  const auto same = [&](const McapMessage& m, const McapMessage& n) {
    return m.sequence == n.sequence && m.time == n.time && m.data == n.data && m.place == n.place &&
           part.topics[static_cast<std::size_t>(m.channel)] ==
               whole.topics[static_cast<std::size_t>(n.channel)];
  };
  return part.messages.size() <= whole.messages.size() &&
         std::equal(part.messages.begin(), part.messages.end(), whole.messages.begin(), same);
}

TEST(ReadMcap, a_file_cut_at_any_byte_gives_its_whole_chunks_and_says_where_it_ends) {
  const McapFile whole = sample_file("cut_whole.mcap", 6);
  std::size_t before = 0;
  for (std::size_t size = 0; size < whole.bytes.size(); ++size) {
    const std::string cut = whole.bytes.substr(0, size);
    if (size < 8) {
      EXPECT_THROW(parse_mcap(cut, "x"), InputError) << size;
      continue;
    }
    const McapFile part = parse_mcap(cut, "x");
    ASSERT_NE(part.cut, "") << size;
    ASSERT_LE(part.end, size);
    ASSERT_TRUE(is_prefix(part, whole)) << size;
    ASSERT_EQ(part.messages.size() % 10, 0u) << "whole chunks";
    ASSERT_GE(part.messages.size(), before) << size;
    ASSERT_TRUE(part.warnings.empty());
    before = part.messages.size();
  }
  EXPECT_EQ(before, whole.messages.size());
}

TEST(ReadMcap, a_cut_file_ends_before_the_first_damage) {
  const McapFile whole = sample_file("damage_whole.mcap", 4);
  const std::string cut = whole.bytes.substr(0, whole.bytes.size() - 20);
  for (std::size_t at = 8; at < cut.size(); ++at) {
    std::string bytes = cut;
    bytes[at] = static_cast<char>(bytes[at] ^ 0x10);
    try {
      const McapFile part = parse_mcap(bytes, "x");
      ASSERT_TRUE(is_prefix(part, whole)) << at;
      ASSERT_NE(part.cut, "") << at;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find("byte"), std::string::npos);
    }
  }
}

TEST(ReadMcap, what_a_power_cut_leaves_of_a_page_is_not_taken_for_records) {
  const McapFile whole = sample_file("hole_whole.mcap", 4);
  for (std::size_t at = 100; at < whole.bytes.size(); at += 31) {
    const McapFile part = parse_mcap(whole.bytes.substr(0, at) + std::string(4096, '\0'), "x");
    ASSERT_TRUE(is_prefix(part, whole)) << at;
    ASSERT_NE(part.cut, "");
  }
}

TEST(ReadMcap, a_whole_file_with_damage_is_refused_or_said_never_cut) {
  const McapFile whole = sample_file("flip_whole.mcap", 2);
  const std::size_t footer = whole.bytes.size() - 37;
  for (std::size_t at = 8; at < footer; ++at) {
    std::string bytes = whole.bytes;
    bytes[at] = static_cast<char>(bytes[at] ^ 0x10);
    try {
      const McapFile file = parse_mcap(bytes, "x");
      ASSERT_EQ(file.cut, "") << at;
      if (file.warnings.empty()) {  // in what nobody reads: header, indexes
        ASSERT_EQ(file.messages.size(), whole.messages.size()) << at;
        ASSERT_TRUE(is_prefix(file, whole)) << at;
      }
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find("byte"), std::string::npos);
    }
  }
}

/// A recording of `frames` frames with all its samples as read; `path` is where.
Recording recorded(const std::string& name, std::uint64_t frames, std::string& bytes) {
  const std::string path = test::write_recording(name, frames);
  bytes = read_file(path);
  return read_recording(path);
}

void expect_prefix(const Recording& part, const Recording& whole, std::size_t size) {
  ASSERT_NE(part.cut_off, "") << size;
  ASSERT_EQ(part.warnings.size(), 1u) << size;
  ASSERT_LE(part.frames.size(), whole.frames.size()) << size;
  ASSERT_LE(part.contacts.size(), whole.contacts.size()) << size;
  for (std::size_t i = 0; i < part.frames.size(); ++i) {
    const HapticSample &a = part.frames[i], &b = whole.frames[i];
    ASSERT_EQ(input_digest(a), b.input_digest) << size;
    ASSERT_EQ(a.step_cpu, b.step_cpu) << size << ": the last message of a frame";
    ASSERT_TRUE(a.body.position == b.body.position && a.command.force == b.command.force) << size;
  }
  for (std::size_t i = 0; i < part.contacts.size(); ++i) {
    ASSERT_EQ(model_digest(part.contacts[i].model), whole.contacts[i].model_digest) << size;
    ASSERT_EQ(part.contacts[i].contacts, whole.contacts[i].contacts) << size;
  }
}

/// Reads what is left after `size` bytes; whether it is a recording.
bool expect_prefix_or_refusal(const std::string& bytes, const Recording& whole, std::size_t size) {
  const std::string path = scratch("recording_cut.mcap");
  put(path, std::string_view(bytes).substr(0, size));
  try {
    expect_prefix(read_recording(path), whole, size);
    return true;
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()).rfind(path + ": ", 0), 0u) << error.what();
    EXPECT_NE(std::string(error.what()).find("expected"), std::string::npos) << error.what();
    return false;
  }
}

TEST(ReadMcap, a_recording_cut_at_any_byte_is_a_prefix_or_refused) {
  std::string bytes;
  const Recording whole = recorded("every_byte.mcap", 3, bytes);
  const std::size_t step = test::is_full() ? 1 : 23;
  for (std::size_t size = 0; size < bytes.size(); size += step)
    expect_prefix_or_refusal(bytes, whole, size);
}

TEST(ReadMcap, a_large_recording_cut_anywhere_is_a_prefix) {
  std::string bytes;
  const Recording whole = recorded("large.mcap", test::is_full() ? 6000 : 3000, bytes);
  Random random(7);
  for (int i = 0; i < (test::is_full() ? 1000 : 12); ++i) {
    const std::size_t size = 4000 + random.below(bytes.size() - 4000);
    ASSERT_TRUE(expect_prefix_or_refusal(bytes, whole, size)) << size;
  }
}

}  // namespace
}  // namespace thigma
