// Damaged files of every format: each is read as some mesh or refused in one line, in bounded
// memory.

#include <atomic>
#include <cstdlib>
#include <new>

#include "support/mesh_file_samples.h"
#include <gtest/gtest.h>

#include "thigma/core/error.h"
#include "thigma/import/inspect.h"
#include "thigma/math/random.h"
#include "thigma/mesh/shapes.h"

namespace {

// Largest single allocation since the last reset: what a lying header would cause.
std::atomic<std::size_t> largest_allocation{0};

}  // namespace

// Not inlined: the compiler would see malloc's memory end in delete and warn. The non-throwing form
// too: the library uses it for temporary buffers, and every new must match the delete below.
[[gnu::noinline]] void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  std::size_t seen = largest_allocation.load(std::memory_order_relaxed);
  while (size > seen && !largest_allocation.compare_exchange_weak(seen, size)) {
  }
  return std::malloc(size == 0 ? 1 : size);
}
[[gnu::noinline]] void* operator new(std::size_t size) {
  if (void* p = operator new(size, std::nothrow)) return p;
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* p) noexcept { std::free(p); }
[[gnu::noinline]] void operator delete(void* p, std::size_t) noexcept { std::free(p); }

namespace thigma {
namespace {

using detail::kMeshFormats;
using detail::MeshFormatRow;

// Reads and inspects; what was read must be sound, what was refused must say so in one line.
bool survives(const std::string& bytes, std::string* message = nullptr) {
  largest_allocation = 0;
  bool is_read = false;
  try {
    const MeshFile file = parse_mesh(bytes, "damaged");
    is_read = true;
    for (const Vec3& p : file.mesh.positions) EXPECT_TRUE(p.allFinite());
    for (const auto& t : file.mesh.triangles) {
      for (const std::int32_t v : t) {
        EXPECT_GE(v, 0);
        EXPECT_LT(static_cast<std::size_t>(v), file.mesh.positions.size());
      }
    }
    const MeshReport report = inspect_mesh(file, "damaged");
    EXPECT_TRUE(std::isfinite(report.area) && std::isfinite(report.radius));
    EXPECT_TRUE(!report.volume || (std::isfinite(*report.volume) && report.inertia->allFinite()));
  } catch (const InputError& error) {
    const std::string text = error.what();
    EXPECT_EQ(text.rfind("damaged: ", 0), 0u) << text;
    EXPECT_EQ(text.find('\n'), std::string::npos) << text;
    EXPECT_LT(text.size(), 400u);
    if (message != nullptr) *message = text;
  }
  // Indices and positions take a few times the bytes of the shortest text for them.
  EXPECT_LT(largest_allocation, 200 * bytes.size() + 65536);
  return is_read;
}

TEST(CorruptFiles, every_format_has_a_sound_file) {
  for (const MeshFormatRow& row : kMeshFormats) {
    const std::string bytes = test::mesh_file(make_ball(1.0, 2), row);
    EXPECT_EQ(parse_mesh(bytes, "sound").format, row.format) << row.name;
    EXPECT_EQ(&row, detail::row_of(row.format));
  }
}

TEST(CorruptFiles, truncated_anywhere) {
  for (const MeshFormatRow& row : kMeshFormats) {
    const std::string good = test::mesh_file(make_ball(1.0, 2), row);
    ASSERT_TRUE(survives(good)) << row.name;
    int read = 0;
    for (std::size_t size = 0; size < good.size(); size += 1 + size / 97)
      read += survives(good.substr(0, size));
    // Text may end a line early without harm to a reader; binary formats must notice.
    if (test::is_binary(good)) EXPECT_EQ(read, 0) << row.name;
  }
}

TEST(CorruptFiles, bits_flipped_anywhere) {
  Random random(77);
  for (const MeshFormatRow& row : kMeshFormats) {
    const std::string good = test::mesh_file(make_ball(1.0, 2), row);
    int refused = 0;
    for (int round = 0; round < 1500; ++round) {
      std::string bad = good;
      const std::uint64_t flips = 1 + random.below(4);
      for (std::uint64_t i = 0; i < flips; ++i) {
        // Headers are short: aim at them half of the time.
        const std::size_t range =
            round % 2 == 0 ? bad.size() : std::min<std::size_t>(bad.size(), 200);
        bad[random.below(range)] ^= static_cast<char>(1u << random.below(8));
      }
      refused += !survives(bad);
    }
    EXPECT_GT(refused, 20) << row.name;  // most bits of a binary file are digits of coordinates
  }
}

TEST(CorruptFiles, bytes_replaced_inserted_and_removed) {
  Random random(78);
  for (const MeshFormatRow& row : kMeshFormats) {
    const std::string good = test::mesh_file(make_ball(1.0, 2), row);
    for (int round = 0; round < 600; ++round) {
      std::string bad = good;
      const std::size_t at = random.below(bad.size());
      const std::size_t length = random.below(40);
      switch (round % 3) {
        case 0:
          bad.erase(at, length);
          break;
        case 1:
          bad.insert(at, bad.substr(random.below(bad.size()), length));
          break;
        default:
          for (std::size_t i = at; i < std::min(bad.size(), at + length); ++i)
            bad[i] = static_cast<char>(random.below(256));
      }
      survives(bad);
    }
  }
}

TEST(CorruptFiles, headers_that_lie_do_not_take_memory) {
  const std::string vertex = "property double x\nproperty double y\nproperty double z\n";
  const std::string face = "property list uint uint vertex_indices\nend_header\n";
  std::string message;
  for (const char* count : {"1000000000", "2147483647", "4294967296", "9223372036854775807"}) {
    for (const char* format : {"ascii", "binary_little_endian", "binary_big_endian"}) {
      const std::string head = std::string("ply\nformat ") + format + " 1.0\n";
      EXPECT_FALSE(survives(
          head + "element vertex " + count + "\n" + vertex + "element face 1\n" + face, &message));
      EXPECT_FALSE(survives(
          head + "element vertex 0\n" + vertex + "element face " + count + "\n" + face, &message));
      EXPECT_FALSE(survives(head + "element other " + count +
                                "\nproperty char a\nelement vertex 0\n" + vertex +
                                "element face 1\n" + face,
                            &message));
    }
    EXPECT_FALSE(survives(std::string("OFF\n") + count + " 1 0\n0 0 0\n", &message));
    EXPECT_FALSE(
        survives(std::string("OFF\n3 ") + count + " 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", &message));
    EXPECT_FALSE(
        survives(std::string("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n") + count + " 0 1 2\n", &message));
  }
  // A list that claims four thousand million corners.
  std::string list = "ply\nformat binary_little_endian 1.0\nelement vertex 0\n" + vertex +
                     "element face 1\n" + face;
  list += "\xff\xff\xff\xff";
  EXPECT_FALSE(survives(list, &message));
  std::string stl(84, ' ');
  stl[80] = stl[81] = stl[82] = stl[83] = '\xff';
  EXPECT_FALSE(survives(stl, &message));
}

TEST(CorruptFiles, noise_is_no_mesh) {
  Random random(79);
  for (int round = 0; round < 500; ++round) {
    std::string noise;
    const std::size_t size = 1 + random.below(600);
    for (std::size_t i = 0; i < size; ++i)
      noise += static_cast<char>(round % 2 == 0 ? random.below(256) : 32 + random.below(95));
    EXPECT_FALSE(survives(noise));
  }
}

}  // namespace
}  // namespace thigma
