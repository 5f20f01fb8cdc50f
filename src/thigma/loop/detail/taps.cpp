#include "thigma/loop/detail/taps.h"

#include <algorithm>
#include <cmath>

#include "thigma/math/elementary.h"

namespace thigma::detail {
namespace {

constexpr double kSilence = 1e-3;  // of its size at first: less is not felt
constexpr double kLongest = 7.0;   // decays, after which less than that is left

double work_on_hand(const Wrench& wrench, const Vec6& moved) THIGMA_RT {
  return wrench.force.dot(moved.head<3>()) + wrench.torque.dot(moved.tail<3>());
}

void drop_faded(TapState& taps) THIGMA_RT {
  static_assert(kLongest > 6.9);  // e^-6.9 is kSilence
  for (std::size_t i = 0; i < taps.voices.size();) {
    if (taps.voices[i].age * taps.voices[i].decay_rate < kLongest) {
      ++i;
      continue;
    }
    taps.voices[i] = taps.voices.back();
    taps.voices.pop_back();
  }
}

}  // namespace

void start_tap(const Impact& impact, const Tap& tap, const Vec3& centre, const Vec3& handle,
               TapState& taps) THIGMA_RT {
  TapVoice voice;
  voice.size = tap.amplitude * impact.speed;
  if (!(voice.size > 0.0) || !std::isfinite(voice.size)) return;
  voice.unit.force = -impact.normal;
  voice.unit.torque = (centre + impact.arm - handle).cross(voice.unit.force);
  voice.age = 0.0;
  voice.frequency = tap.frequency;
  voice.decay_rate = 1.0 / tap.decay;
  taps.store += 0.5 * impact.impulse * impact.speed;
  if (taps.voices.push_back(voice)) return;
  const auto size_now = [](const TapVoice& v) {
    return v.size * exponential(-v.age * v.decay_rate);
  };
  TapVoice* weakest = taps.voices.begin();
  for (TapVoice& v : taps.voices)
    if (size_now(v) < size_now(*weakest)) weakest = &v;
  if (size_now(*weakest) < voice.size) *weakest = voice;
}

Wrench next_taps(const Vec6& moved, double elapsed, TapState& taps) THIGMA_RT {
  taps.store -= work_on_hand(taps.held, moved);
  taps.asked = taps.held = {};
  if (taps.store < 0.0) taps.voices.clear();  // handed out too much: owed until the next impact
  Wrench sum;
  for (TapVoice& v : taps.voices) {
    v.age += elapsed;
    const double force =
        v.size * exponential(-v.age * v.decay_rate) * sine(2.0 * kPi * v.frequency * v.age);
    sum = sum + force * v.unit;
  }
  drop_faded(taps);
  if (taps.voices.empty()) {
    taps.store = std::min(taps.store, 0.0);
    return sum;
  }
  // The hand will go on about as it went.
  const double handed_out = work_on_hand(sum, moved);
  if (handed_out > 0.0 && handed_out > taps.store) sum = (taps.store / handed_out) * sum;
  taps.asked = taps.held = sum;
  return sum;
}

}  // namespace thigma::detail
