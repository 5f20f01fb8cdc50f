#include <cmath>
#include <cstring>
#include <filesystem>
#include <limits>

#include "recording/recording_samples.h"
#include "support/far_recording.h"
#include <gtest/gtest.h>

#include "thigma/core/error.h"
#include "thigma/files/file.h"
#include "thigma/recording/mcap_file.h"

namespace thigma {
namespace {

template <class Vector>
void expect_bits(const Vector& a, const Vector& b) {
  for (int i = 0; i < static_cast<int>(a.size()); ++i) {
    EXPECT_EQ(std::bit_cast<std::uint64_t>(double(a[i])),
              std::bit_cast<std::uint64_t>(double(b[i])));
  }
}

void expect_bits(double a, double b) {
  EXPECT_EQ(std::bit_cast<std::uint64_t>(a), std::bit_cast<std::uint64_t>(b));
}

void expect_bits(const Wrench& a, const Wrench& b) {
  expect_bits(a.force, b.force);
  expect_bits(a.torque, b.torque);
}

void expect_bits(const Motion& a, const Motion& b) {
  expect_bits(a.pose.position, b.pose.position);
  expect_bits(a.pose.orientation.coeffs(), b.pose.orientation.coeffs());
  expect_bits(a.twist.linear, b.twist.linear);
  expect_bits(a.twist.angular, b.twist.angular);
}

void expect_bits(const BodyState& a, const BodyState& b) {
  expect_bits(to_vector(a), to_vector(b));
}

TEST(ReadRecording, haptic_frames_come_back_bit_for_bit) {
  const Recording r = read_recording(test::write_recording("bits.mcap", 450));
  ASSERT_EQ(r.frames.size(), 450u);
  EXPECT_TRUE(r.warnings.empty());
  for (std::uint64_t i = 0; i < 450; ++i) {
    const HapticSample want = test::sample(i);
    const HapticSample& got = r.frames[i];
    EXPECT_EQ(got.frame, want.frame);
    EXPECT_EQ(input_digest(got), want.input_digest);
    EXPECT_EQ(got.input_digest, want.input_digest);
    expect_bits(got.device.motion, want.device.motion);
    expect_bits(got.handle, want.handle);
    expect_bits(got.body, want.body);
    expect_bits(got.coupling, want.coupling);
    expect_bits(got.contact, want.contact);
    expect_bits(got.feedback, want.feedback);
    expect_bits(got.command, want.command);
    expect_bits(got.model_age, want.model_age);
    expect_bits(got.model_weight, want.model_weight);
    expect_bits(got.penetration, want.penetration);
    expect_bits(got.stretch, want.stretch);
    expect_bits(got.energy, want.energy);
    EXPECT_EQ(got.touching, want.touching);
    EXPECT_EQ(got.is_grasped, want.is_grasped);
    EXPECT_EQ(got.is_armed, want.is_armed);
    EXPECT_EQ(got.fault, want.fault);
    EXPECT_EQ(got.step_cpu, want.step_cpu);
    EXPECT_EQ(got.wake_late, want.wake_late);
    expect_bits(got.wanted_speed, want.wanted_speed);
    expect_bits(got.solve_residual, want.solve_residual);
    EXPECT_EQ(got.is_held_back, want.is_held_back);
    EXPECT_EQ(got.is_squeezed, want.is_squeezed);
    ASSERT_EQ(got.pressing.size(), want.pressing.size());
    for (std::size_t k = 0; k < want.pressing.size(); ++k) {
      EXPECT_EQ(got.pressing[k].id, want.pressing[k].id);
      expect_bits(got.pressing[k].force, want.pressing[k].force);
    }
  }
}

TEST(ReadRecording, contact_models_come_back_bit_for_bit) {
  const Recording r = read_recording(test::write_recording("models.mcap", 200));
  ASSERT_EQ(r.contacts.size(), 20u);
  for (std::uint64_t i = 0; i < 20; ++i) {
    const ContactSample want = test::contact_sample(i);
    const ContactSample& got = r.contacts[i];
    EXPECT_EQ(got.model.sequence, i);
    EXPECT_EQ(got.model_digest, want.model_digest);
    EXPECT_EQ(model_digest(got.model), want.model_digest);
    expect_bits(got.model.time, want.model.time);
    expect_bits(got.model.state, want.model.state);
    ASSERT_EQ(got.model.planes.size(), 3u);
    for (std::size_t k = 0; k < 3; ++k) {
      const PlaneTerm& a = got.model.planes[k];
      const PlaneTerm& b = want.model.planes[k];
      expect_bits(a.arm_body, b.arm_body);
      expect_bits(a.normal, b.normal);
      expect_bits(a.scene_point, b.scene_point);
      expect_bits(a.scene_velocity, b.scene_velocity);
      expect_bits(a.stiffness, b.stiffness);
      expect_bits(a.damping, b.damping);
      expect_bits(a.tolerance, b.tolerance);
      EXPECT_EQ(a.id, b.id);
    }
    ASSERT_EQ(got.model.depths.size(), 1u);
    expect_bits(got.model.depths[0].depth, want.model.depths[0].depth);
    expect_bits(got.model.depths[0].linear, want.model.depths[0].linear);
    expect_bits(got.model.depths[0].angular, want.model.depths[0].angular);
    expect_bits(got.model.depths[0].stiffness, want.model.depths[0].stiffness);
    expect_bits(got.model.depths[0].damping, want.model.depths[0].damping);
    expect_bits(got.model.depths[0].tolerance, want.model.depths[0].tolerance);
    EXPECT_EQ(got.model.depths[0].id, 7);
    EXPECT_EQ(model_digest(got.model), want.model_digest);
    EXPECT_EQ(got.contacts, want.contacts);
    expect_bits(got.depth_max, want.depth_max);
    EXPECT_EQ(got.mandatory_tests, want.mandatory_tests);
    EXPECT_EQ(got.unrefined, want.unrefined);
    EXPECT_EQ(got.level_changes, want.level_changes);
    expect_bits(got.bound_max, want.bound_max);
    EXPECT_EQ(got.object_levels, want.object_levels);
    EXPECT_EQ(got.scene_levels, want.scene_levels);
    EXPECT_EQ(got.rows, want.rows);
    EXPECT_EQ(got.travel_halvings, want.travel_halvings);
    EXPECT_EQ(got.left_out, want.left_out);
    expect_bits(got.travel, want.travel);
    expect_bits(got.look_ahead, want.look_ahead);
    EXPECT_EQ(got.coarse, want.coarse);
  }
}

// A row of relief without a plane is as in recordings from before there was one.
TEST(ReadRecording, rows_come_back_bit_for_bit) {
  ContactSample want = test::contact_sample(3);
  ConstraintModel& constraints = want.model.constraints;
  constraints.travel = 1e-4;
  constraints.reach = 0.03;
  const RowKind kinds[] = {RowKind::scene_plane, RowKind::object_plane, RowKind::edges,
                           RowKind::relief, RowKind::relief};
  for (int k = 0; k < 5; ++k) {
    ContactRow row = make_row(kinds[k]);
    row.id = 0xfedcba9876543210ull + static_cast<std::uint64_t>(k);
    row.object_point = Vec3(1.0, 2.0, 3.0) / (k + 7.0);
    row.scene_point = Vec3(-1.0, 2.0, -3.0) / (k + 3.0);
    row.object_direction = Vec3(0.1, 0.2, 0.3) / (k + 1.0);
    row.scene_direction = Vec3(0.6, 0.0, -0.8);
    if (k == 4) row.plane = Vec3(0.28, -0.0, -0.96);
    constraints.rows.push_back(row);
  }
  want.model_digest = model_digest(want.model);
  const std::string path = ::testing::TempDir() + "thigma_rows.mcap";
  RecordingWriter writer(path, "{}");
  writer.write(want);
  writer.close({});
  const Recording r = read_recording(path);
  ASSERT_EQ(r.contacts.size(), 1u);
  const auto& got = r.contacts[0].model.constraints.rows;
  ASSERT_EQ(got.size(), constraints.rows.size());
  for (std::size_t k = 0; k < got.size(); ++k) {
    const ContactRow& row = constraints.rows[k];
    EXPECT_EQ(got[k].kind, row.kind);
    EXPECT_EQ(got[k].id, row.id);
    expect_bits(got[k].object_point, row.object_point);
    expect_bits(got[k].scene_point, row.scene_point);
    expect_bits(got[k].object_direction, row.object_direction);
    expect_bits(got[k].scene_direction, row.scene_direction);
    expect_bits(got[k].plane, row.plane);
  }
  EXPECT_EQ(model_digest(r.contacts[0].model), want.model_digest);
  constraints.rows[4].plane.setZero();
  EXPECT_NE(model_digest(want.model), want.model_digest);
}

TEST(ReadRecording, the_end_is_read_or_known_to_be_missing) {
  const Recording r = read_recording(test::write_recording("end.mcap", 20));
  EXPECT_TRUE(r.has_end);
  EXPECT_EQ(r.end.frames, 20u);
  EXPECT_EQ(r.end.state_hash, 0x0123456789abcdefull);
  EXPECT_EQ(r.end.dropped, 2u);
}

TEST(ReadRecording, events_come_back) {
  const Recording r = read_recording(test::write_recording("events.mcap", 450));
  ASSERT_EQ(r.events.size(), 2u);
  EXPECT_EQ(r.events[0].kind, EventKind::armed);
  EXPECT_EQ(r.events[0].frame, 7u);
  EXPECT_EQ(r.events[1].kind, EventKind::fault);
  EXPECT_EQ(r.events[1].detail, "pose_jump");
  EXPECT_EQ(r.events[1].time, 0.401);
}

TEST(ReadRecording, signed_zero_and_unknowns_survive) {
  const std::string path = ::testing::TempDir() + "thigma_zero.mcap";
  HapticSample s = test::sample(0);
  s.device.motion.pose.position = Vec3(-0.0, 5e-324, std::numeric_limits<double>::quiet_NaN());
  s.device.motion.twist.linear = Vec3(1e300, -1e22, std::numeric_limits<double>::infinity());
  RecordingWriter writer(path, "{}");
  writer.write(s);
  writer.close({});
  const Recording r = read_recording(path);
  const Vec3& p = r.frames.at(0).device.motion.pose.position;
  EXPECT_TRUE(std::signbit(p.x()));
  EXPECT_EQ(p.y(), 5e-324);
  EXPECT_TRUE(std::isnan(p.z()));
  EXPECT_EQ(r.frames[0].device.motion.twist.linear.x(), 1e300);
  EXPECT_EQ(r.frames[0].device.motion.twist.linear.y(), -1e22);
  EXPECT_EQ(input_digest(r.frames[0]), input_digest(s));
}

TEST(ReadRecording, files_that_are_no_recordings_are_refused) {
  const std::string path = ::testing::TempDir() + "thigma_bad.mcap";
  write_file(path, "not a recording");
  EXPECT_THROW(read_recording(path), InputError);
  EXPECT_THROW(read_recording(path + ".absent"), InputError);
  const auto refuses = [&](const char* topic, const char* json) {
    McapWriter writer(path);
    const auto channel = writer.add_channel(topic, "", "");
    writer.write(channel, 0, 0, json);
    writer.close();
    try {
      read_recording(path);
      return false;
    } catch (const InputError& error) {
      return std::string(error.what()).find("expected") != std::string::npos;
    }
  };
  EXPECT_TRUE(refuses("/other", "{}"));                  // no /config
  EXPECT_TRUE(refuses("/device/state", "{}"));           // fields missing
  EXPECT_TRUE(refuses("/device/state", "{\"frame\":"));  // JSON cut off
  EXPECT_TRUE(refuses("/body/state", "{}"));             // before its frame
  EXPECT_TRUE(refuses("/contact/model", R"({"sequence":"x"})"));
}

TEST(ReadRecording, goes_through_a_long_one_in_little_memory) {
  const std::string path = test::write_recording("stream.mcap", 3000);
  const Recording whole = read_recording(path);
  FileSource source(path, 1 << 16);
  McapMessages messages(source);
  std::size_t frames = 0, contacts = 0;
  std::vector<SamplePlace> places;
  const RecordingInfo info = stream_recording(
      source, path,
      {[&](const std::string& config) { return config == whole.config; },
       [&](const HapticSample& s, const SamplePlace& place) {
         ASSERT_LT(frames, whole.frames.size());
         EXPECT_EQ(input_digest(s), input_digest(whole.frames[frames++]));
         places.push_back(place);
       },
       [&](const ContactSample& s, const SamplePlace&) {
         ASSERT_LT(contacts, whole.contacts.size());
         EXPECT_EQ(model_digest(s.model), model_digest(whole.contacts[contacts++].model));
       }});
  EXPECT_EQ(frames, 3000u);
  EXPECT_EQ(contacts, 300u);
  EXPECT_EQ(info.frame_count, 3000u);
  EXPECT_EQ(info.last_time, whole.frames.back().time);
  // One compressed chunk of 1 MiB is in memory at once, no more.
  for (const std::size_t i : {2999u, 0u, 1234u})
    EXPECT_EQ(input_digest(read_frame_at(messages, places[i])), input_digest(whole.frames[i]));
  EXPECT_GT(source.size(), 8 * source.memory());
}

TEST(ReadRecording, reads_one_of_more_than_4_GiB) {
  const std::string path = test::write_recording("far.mcap", 450);
  const Recording near = read_recording(path);
  const std::uint64_t hole = (std::uint64_t{1} << 32) + 4321;
  test::push_away(path, hole);
  const Recording far = read_recording(path);
  EXPECT_TRUE(far.warnings.empty());
  EXPECT_TRUE(far.has_end);
  ASSERT_EQ(far.frames.size(), near.frames.size());
  EXPECT_EQ(input_digest(far.frames.back()), input_digest(near.frames.back()));
  EXPECT_EQ(far.events.size(), near.events.size());
  McapPlace first;
  stream_recording(path, {{},
                          [&](const HapticSample&, const SamplePlace& p) {
                            if (first.is_none()) first = p.messages[0];
                          },
                          {}});
  EXPECT_GT(std::max(first.chunk, first.at), hole);
  std::filesystem::remove(path);
}

TEST(ReadRecording, stops_where_no_more_is_wanted) {
  const std::string path = test::write_recording("stop.mcap", 100);
  int frames = 0;
  const RecordingInfo info =
      stream_recording(path, {[](const std::string&) { return false; },
                              [&](const HapticSample&, const SamplePlace&) { ++frames; },
                              {}});
  EXPECT_EQ(frames, 0);
  EXPECT_EQ(info.config, read_recording(path).config);
}

}  // namespace
}  // namespace thigma
