// Every wrench is kept with its time until the sample that tells of the motion it drove has come.
// What has not been told yet is predicted from the last velocity, and what the prediction may be
// wrong by is set aside.

#include "thigma/loop/passivity_control.h"

#include <algorithm>
#include <cmath>

#include "thigma/math/rotation.h"

namespace thigma {
namespace {

using Sent = PassivityControl::Sent;

Sent& sent_at(PassivityControl& control, std::uint64_t index) THIGMA_RT {
  return control.sent[index % PassivityControl::kMostFrames];
}

/// When the wrench of this index gave way to the next, or now.
double end_of(PassivityControl& control, std::uint64_t index, double now) THIGMA_RT {
  return index + 1 < control.count ? sent_at(control, index + 1).time : now;
}

/// Moves on to the wrench that acted at `time`.
void find_acting(double time, PassivityControl& control) THIGMA_RT {
  if (control.count > PassivityControl::kMostFrames)
    control.acting = std::max(control.acting, control.count - PassivityControl::kMostFrames);
  // Times are sums of periods: what is off by rounding alone is the same time.
  constexpr double kSlack = 1e-9;  // [s]
  while (control.acting + 1 < control.count &&
         sent_at(control, control.acting + 1).time <= time + kSlack)
    ++control.acting;
}

double power(const Wrench& w, const Twist& t) THIGMA_RT {
  return w.force.dot(t.linear) + w.torque.dot(t.angular);
}

/// What a wrench may do over a way the handle may go unseen for each m/s^2 [J/s, times s].
double unseen_power(const PassivityParams& params, const Wrench& w) THIGMA_RT {
  return params.acceleration * std::sqrt(w.force.squaredNorm()) +
         params.angular_acceleration * std::sqrt(w.torque.squaredNorm());
}

/// In springs that pull with this wrench [J].
double held_energy(const PassivityParams& params, const Wrench& w) THIGMA_RT {
  double energy = 0.0;
  if (params.stiffness > 0.0) energy += 0.5 * w.force.squaredNorm() / params.stiffness;
  if (params.angular_stiffness > 0.0)
    energy += 0.5 * w.torque.squaredNorm() / params.angular_stiffness;
  return energy;
}

/// Largest share a in [0, 1] with held a^2 + flow a <= have.
double backed_share(double held, double flow, double have) THIGMA_RT {
  if (held + flow <= have) return 1.0;
  if (held > 0.0) {
    const double root = std::sqrt(flow * flow + 4.0 * held * have);
    // Of the two forms the one that does not cancel.
    const double share = flow > 0.0 ? 2.0 * have / (flow + root) : (root - flow) / (2.0 * held);
    return std::clamp(share, 0.0, 1.0);
  }
  return flow > 0.0 ? std::clamp(have / flow, 0.0, 1.0) : 1.0;
}

Vec3 not_turned(const Vec3& v, const Vec3& wanted) THIGMA_RT {
  return v.dot(wanted) >= 0.0 ? v : Vec3(Vec3::Zero());
}

}  // namespace

PassivityParams passivity_for(double stiffness, double angular_stiffness, double period,
                              double delay) THIGMA_RT {
  const double late = period + delay;
  PassivityParams params;
  params.is_on = true;
  params.period = period;
  params.delay = delay;
  params.max_damping = stiffness * late;
  params.max_angular_damping = angular_stiffness * late;
  params.stiffness = stiffness;
  params.angular_stiffness = angular_stiffness;
  return params;
}

void observe_handle(const PassivityParams& params, const Motion& handle, double now,
                    PassivityControl& control) THIGMA_RT {
  const double taken = now - params.delay;
  if (control.has_sample && control.count > 0) {
    // The step that ends with this sample lay between the two times of taking; one wrench acted
    // over most of it.
    const double middle = 0.5 * (now + control.last_time) - params.delay;
    find_acting(middle, control);
    const Wrench& drove = sent_at(control, control.acting).wrench;
    if (sent_at(control, control.acting).time <= middle) {
      const Vec3 moved = handle.pose.position - control.last.position;
      const Vec3 turned =
          vector_from_rotation(handle.pose.orientation * control.last.orientation.conjugate());
      control.energy -= drove.force.dot(moved) + drove.torque.dot(turned);
    }
    find_acting(taken, control);
  }
  control.has_sample = true;
  control.last = handle.pose;
  control.last_time = now;
  control.predicted = control.energy;
  control.reserve = 0.0;
  for (std::uint64_t i = control.acting; i < control.count; ++i) {
    const Sent& each = sent_at(control, i);
    const double begin = std::max(each.time, taken), end = end_of(control, i, now);
    if (!(end > begin)) continue;
    const double age = 0.5 * (begin + end) - taken + params.velocity_lag;
    control.predicted -= (end - begin) * power(each.wrench, handle.twist);
    control.reserve += (end - begin) * age * unseen_power(params, each.wrench);
  }
}

Wrench passive_wrench(const PassivityParams& params, const Motion& handle, const Wrench& wanted,
                      double now, PassivityControl& control) THIGMA_RT {
  control.damping = 0.0;
  control.share = 1.0;
  Wrench sent;
  if (!wanted.force.isZero(0.0) || !wanted.torque.isZero(0.0)) {
    const double age = params.delay + 0.5 * params.period + params.velocity_lag;
    const double held = held_energy(params, wanted);
    const double flow =
        params.period * (power(wanted, handle.twist) + age * unseen_power(params, wanted));
    const double sure = control.predicted - control.reserve;
    control.share = backed_share(held, flow, std::max(0.0, sure + params.credit));
    sent = control.share * wanted;
    const double ratio =
        params.max_damping > 0.0 ? params.max_angular_damping / params.max_damping : 0.0;
    const double square =
        handle.twist.linear.squaredNorm() + ratio * handle.twist.angular.squaredNorm();
    const double deficit = held + flow - sure;
    if (deficit > 0.0 && square > 0.0) {
      control.damping = std::min(deficit / (params.period * square), params.max_damping);
      sent.force = not_turned(sent.force - control.damping * handle.twist.linear, wanted.force);
      sent.torque =
          not_turned(sent.torque - control.damping * ratio * handle.twist.angular, wanted.torque);
    }
    ++control.wanted_frames;
    control.share_sum += control.share;
    control.damping_max = std::max(control.damping_max, control.damping);
    if (control.damping > 0.0 || control.share < 1.0) ++control.acted_frames;
  }
  sent_at(control, control.count) = {now, sent};
  ++control.count;
  return sent;
}

void correct_sent(const Wrench& sent, PassivityControl& control) THIGMA_RT {
  if (control.count > 0) sent_at(control, control.count - 1).wrench = sent;
}

}  // namespace thigma
