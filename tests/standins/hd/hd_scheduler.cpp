// The servo loop: one thread of the library that calls what was scheduled, by priority, at the rate
// that is set.
#include <algorithm>
#include <cmath>
#include <condition_variable>
#include <mutex>
#include <thread>
#include <vector>

#include "hd.h"

namespace standin {
namespace {

constexpr unsigned kContinue = 1;
using Callback = unsigned (*)(void*);

struct Operation {
  unsigned long id = 0;
  Callback callback = nullptr;
  void* data = nullptr;
  unsigned short priority = 0;
};

struct Scheduler {
  std::mutex mutex;
  std::condition_variable changed;
  std::vector<Operation> operations;  // by priority, the highest first
  std::thread thread;
  unsigned long last_id = 0;
  unsigned long running_id = 0;  // the one that is called now
  std::atomic<bool> run{false};
  std::atomic<unsigned long> tick{0};
  std::atomic<double> tick_time{0.0};
};

// Never destroyed: the library is left in any order.
Scheduler& scheduler() {
  static auto* const s = new Scheduler;
  return *s;
}
thread_local bool is_servo = false;

bool is_scheduled(const Scheduler& s, unsigned long id) {
  return std::any_of(s.operations.begin(), s.operations.end(),
                     [id](const Operation& o) { return o.id == id; });
}

void remove(Scheduler& s, unsigned long id) {
  std::erase_if(s.operations, [id](const Operation& o) { return o.id == id; });
}

// Calls one operation of this tick where it is still scheduled.
void call_one(Scheduler& s, const Operation& operation) {
  {
    const std::lock_guard guard(s.mutex);
    if (!is_scheduled(s, operation.id)) {
      return;
    }
    s.running_id = operation.id;
  }
  put(0, k_callbacks, get(0, k_callbacks) + 1.0);
  const unsigned result = operation.callback(operation.data);
  {
    const std::lock_guard guard(s.mutex);
    s.running_id = 0;
    if (result != kContinue) {
      remove(s, operation.id);
    }
  }
  s.changed.notify_all();
}

double random_part() {
  static unsigned state = 12345;
  state = state * 1664525u + 1013904223u;
  return static_cast<double>(state >> 8) / 16777216.0;
}

void serve() {
  Scheduler& s = scheduler();
  is_servo = true;
  std::vector<Operation> now_due;
  now_due.reserve(256);
  double next = now();
  while (s.run.load()) {
    const double period = 1.0 / std::fmax(1.0, get(0, k_rate));
    next += period;
    if (now() > next + period) {
      put(0, k_late_ticks, get(0, k_late_ticks) + 1.0);
      next = std::fmax(next, now() - 10.0 * period);
    }
    sleep_until(next + 1e-6 * get(0, k_jitter_us) * random_part());
    s.tick_time.store(now());
    s.tick.fetch_add(1);
    put(0, k_ticks, get(0, k_ticks) + 1.0);
    if (is_on(0, k_silent)) {
      continue;
    }
    {
      const std::lock_guard guard(s.mutex);
      now_due = s.operations;
    }
    for (const Operation& operation : now_due) {
      call_one(s, operation);
    }
  }
}

unsigned long schedule(const char* call, Callback callback, void* data, unsigned short priority) {
  Scheduler& s = scheduler();
  const std::lock_guard guard(s.mutex);
  if (s.operations.size() >= static_cast<std::size_t>(get(0, k_scheduler_slots))) {
    push_error(0, call, kSchedulerFull);
    return 0;
  }
  const Operation operation{++s.last_id, callback, data, priority};
  const auto place = std::find_if(s.operations.begin(), s.operations.end(),
                                  [priority](const Operation& o) { return o.priority < priority; });
  s.operations.insert(place, operation);
  return operation.id;
}

void wait_until_done(unsigned long id) {
  Scheduler& s = scheduler();
  std::unique_lock lock(s.mutex);
  s.changed.wait(lock, [&] { return !is_scheduled(s, id) && s.running_id != id; });
}

void update_modes() {
  const Locked lock;
  for (int unit = 0; unit < kUnits; ++unit) {
    if (is_on(unit, k_opened)) {
      update_mode(unit);
    }
  }
}

// 500, 1000, 2000 and, of FireWire, what floor(8000 / N + 0.5) gives.
bool is_rate(unsigned long rate) {
  bool known = rate == 500 || rate == 1000 || rate == 2000;
  for (int n = 1; n <= 8000 && !known; ++n) {
    known = rate == static_cast<unsigned long>(8000.0 / n + 0.5) && rate >= 500 && rate <= 2000;
  }
  return known;
}

void note_call(const char* call, double value) {
  const Locked lock;
  note(0, call, 0, &value, 1);
}

}  // namespace

bool scheduler_runs() { return scheduler().run.load(); }
bool on_scheduler_thread() { return is_servo; }
unsigned long servo_tick() { return scheduler().tick.load(); }

}  // namespace standin

using namespace standin;

STANDIN_EXPORT void hdStartScheduler() {
  Scheduler& s = scheduler();
  if (is_on(0, k_fail_scheduler)) {
    push_error(0, "hdStartScheduler", static_cast<int>(get(0, k_fail_scheduler)));
    return;
  }
  if (s.run.exchange(true)) {
    return;
  }
  if (s.thread.joinable()) {
    s.thread.join();
  }
  note_call("hdStartScheduler", get(0, k_rate));
  update_modes();  // forces are enabled from here
  s.thread = std::thread(serve);
}

STANDIN_EXPORT void hdStopScheduler() {
  Scheduler& s = scheduler();
  if (!s.run.exchange(false)) {
    return;
  }
  if (!is_servo && s.thread.joinable()) {
    s.thread.join();
  }
  note_call("hdStopScheduler", 0.0);
  update_modes();
}

STANDIN_EXPORT void hdSetSchedulerRate(unsigned long rate) {
  if (!is_rate(rate)) {
    push_error(0, "hdSetSchedulerRate", kInvalidValue);
    return;
  }
  note_call("hdSetSchedulerRate", static_cast<double>(rate));
  put(0, k_rate, static_cast<double>(rate));
}

STANDIN_EXPORT unsigned long hdScheduleAsynchronous(unsigned (*callback)(void*), void* data,
                                                    unsigned short priority) {
  // From the servo thread it is called at once, whatever its priority.
  if (is_servo && callback(data) != kContinue) {
    return 0;
  }
  return schedule("hdScheduleAsynchronous", callback, data, priority);
}

STANDIN_EXPORT void hdScheduleSynchronous(unsigned (*callback)(void*), void* data,
                                          unsigned short priority) {
  if (is_servo || !scheduler_runs()) {
    while (callback(data) == kContinue) {
    }
    return;
  }
  const unsigned long id = schedule("hdScheduleSynchronous", callback, data, priority);
  if (id != 0) {
    wait_until_done(id);
  }
}

STANDIN_EXPORT void hdUnschedule(unsigned long id) {
  Scheduler& s = scheduler();
  std::unique_lock lock(s.mutex);
  if (!is_scheduled(s, id)) {
    lock.unlock();
    push_error(0, "hdUnschedule", kInvalidOperation);
    return;
  }
  remove(s, id);
  if (!is_servo) {
    s.changed.wait(lock, [&] { return s.running_id != id; });
  }
}

STANDIN_EXPORT unsigned char hdWaitForCompletion(unsigned long id, unsigned how) {
  Scheduler& s = scheduler();
  if (how == 1) {
    wait_until_done(id);
    return 1;
  }
  const std::lock_guard guard(s.mutex);
  return is_scheduled(s, id) ? 1 : 0;
}

STANDIN_EXPORT double hdGetSchedulerTimeStamp() { return now() - scheduler().tick_time.load(); }
