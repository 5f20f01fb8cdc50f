#include "thigma/loop/samples.h"

#include <bit>
#include <cmath>
#include <concepts>
#include <type_traits>

#include "thigma/dynamics/contact_model_fields.h"
#include "thigma/loop/sample_fields.h"

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

namespace {

// What is not finite is one value: files keep it as null, so a digest must not tell it apart.
void add_datum(StateHash& hash, double number) THIGMA_RT {
  if (std::isfinite(number)) {
    add_number(hash, number);
  } else {
    add_bits(hash, ~std::uint64_t{0});
  }
}

void add_data(StateHash& hash, const Vec3& v) THIGMA_RT {
  for (int i = 0; i < 3; ++i) add_datum(hash, v[i]);
}

void add_data(StateHash& hash, const Quat& q) THIGMA_RT {
  for (int i = 0; i < 4; ++i) add_datum(hash, q.coeffs()[i]);
}

/// Adds the fields of a list (contact_model_fields.h, sample_fields.h).
struct FieldHash {
  StateHash& hash;

  void operator()(const char*, double number) const THIGMA_RT { add_datum(hash, number); }
  template <class Whole>
  requires std::integral<Whole> || std::is_enum_v<Whole>
  void operator()(const char*, Whole value) const THIGMA_RT {
    add_bits(hash, static_cast<std::uint64_t>(value));
  }
  void vector(const char*, const Vec3& v) const THIGMA_RT { add_data(hash, v); }
  void pose(const Pose& pose) const THIGMA_RT {
    add_data(hash, pose.position);
    add_data(hash, pose.orientation);
  }
  void twist(const Twist& twist) const THIGMA_RT {
    add_data(hash, twist.linear);
    add_data(hash, twist.angular);
  }
  template <class Value>
  void unless(const char* key, Value value, Value usual) const THIGMA_RT {
    if (value != usual) (*this)(key, value);
  }
  void unless_zero(const char* key, const Vec3& v) const THIGMA_RT {
    if ((v.array() != 0.0).any()) vector(key, v);
  }
  void optional_pose(const char*, bool has, const Pose& value) const THIGMA_RT {
    if (has) pose(value);
  }
  void digest(const char*, std::uint64_t) const THIGMA_RT {}
};

}  // namespace

std::uint64_t input_digest(const HapticSample& sample) THIGMA_RT {
  StateHash hash;
  visit_device_state(sample, FieldHash{hash});
  return hash.value;
}

std::uint64_t model_digest(const LinearContactModel& model) THIGMA_RT {
  StateHash hash;
  add_data(hash, model.state.position);
  add_data(hash, model.state.orientation);
  add_data(hash, model.state.linear_momentum);
  add_data(hash, model.state.angular_momentum);
  add_datum(hash, model.time);
  add_bits(hash, model.sequence);
  for (const PlaneTerm& term : model.planes) visit_plane(term, FieldHash{hash});
  for (const DepthTerm& term : model.depths) visit_depth(term, FieldHash{hash});
  const ConstraintModel& constraints = model.constraints;
  if (constraints.reach > 0.0) {
    add_datum(hash, constraints.travel);
    add_datum(hash, constraints.reach);
    for (const ContactRow& row : constraints.rows) visit_row(row, FieldHash{hash});
  }
  return hash.value;
}

}  // namespace thigma
