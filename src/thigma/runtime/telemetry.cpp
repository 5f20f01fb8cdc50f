#include "thigma/runtime/telemetry.h"

#include <bit>

namespace thigma {

void add_bits(StateHash& hash, std::uint64_t bits) THIGMA_RT {
  // Every step is a bijection of the hash for given bits, so a single changed word always changes
  // the result.
  std::uint64_t h = (hash.value ^ bits) * 0x9e3779b97f4a7c15ull;
  h ^= h >> 29;
  h *= 0xbf58476d1ce4e5b9ull;
  hash.value = h ^ (h >> 32);
}

void add_number(StateHash& hash, double number) THIGMA_RT {
  add_bits(hash, std::bit_cast<std::uint64_t>(number));
}

void add_vector(StateHash& hash, const Vec3& v) THIGMA_RT {
  for (int i = 0; i < 3; ++i) add_number(hash, v[i]);
}

void add_quaternion(StateHash& hash, const Quat& q) THIGMA_RT {
  for (int i = 0; i < 4; ++i) add_number(hash, q.coeffs()[i]);
}

void add_frame(StateHash& hash, const BodyState& body, const Wrench& command) THIGMA_RT {
  add_vector(hash, body.position);
  add_quaternion(hash, body.orientation);
  add_vector(hash, body.linear_momentum);
  add_vector(hash, body.angular_momentum);
  add_vector(hash, command.force);
  add_vector(hash, command.torque);
}

std::uint64_t input_digest(const HapticSample& sample) THIGMA_RT {
  StateHash hash;
  add_bits(hash, sample.frame);
  add_number(hash, sample.time);
  add_number(hash, sample.elapsed);
  const DeviceState& d = sample.device;
  add_number(hash, d.time);
  add_vector(hash, d.motion.pose.position);
  add_quaternion(hash, d.motion.pose.orientation);
  add_vector(hash, d.motion.twist.linear);
  add_vector(hash, d.motion.twist.angular);
  add_bits(hash, d.buttons);
  add_bits(hash, static_cast<std::uint64_t>(d.status));
  add_bits(hash, sample.model_sequence);
  add_bits(hash, static_cast<std::uint64_t>(sample.external_fault));
  return hash.value;
}

std::uint64_t model_digest(const LinearContactModel& model) THIGMA_RT {
  StateHash hash;
  add_frame(hash, model.state, Wrench{});
  add_number(hash, model.time);
  add_bits(hash, model.sequence);
  for (const PlaneTerm& t : model.planes) {
    add_vector(hash, t.arm_body);
    add_vector(hash, t.normal);
    add_vector(hash, t.scene_point);
    add_vector(hash, t.scene_velocity);
    add_vector(hash, t.tangential_anchor);
    add_number(hash, t.stiffness);
    add_number(hash, t.damping);
    add_number(hash, t.tolerance);
    add_bits(hash, static_cast<std::uint64_t>(t.id));
  }
  for (const TaylorTerm& t : model.taylors) {
    add_vector(hash, t.wrench.force);
    add_vector(hash, t.wrench.torque);
    add_vector(hash, t.normal);
    for (int i = 0; i < t.jacobian.size(); ++i) add_number(hash, t.jacobian.data()[i]);
  }
  return hash.value;
}

}  // namespace thigma
