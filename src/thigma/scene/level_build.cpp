#include "thigma/scene/level_build.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <stdexcept>
#include <thread>
#include <utility>

#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include "thigma/session/session_config.h"

namespace thigma {
namespace {

/// Whatever else runs, runs first. A niceness is of the thread here, not of the process.
void give_way() {
  constexpr int kNice = 15;
  setpriority(PRIO_PROCESS, static_cast<id_t>(syscall(SYS_gettid)), kNice);
}

}  // namespace

struct LevelBuild::Impl {
  /// Until the wait is over or nobody wants the levels any more.
  void wait(double seconds) {
    std::unique_lock lock(mutex);
    given_up.wait_for(lock, std::chrono::duration<double>(seconds),
                      [this] { return gives_up.load(std::memory_order_relaxed); });
    require_wanted();
  }
  void require_wanted() const {
    if (gives_up.load(std::memory_order_relaxed)) throw std::runtime_error("given up");
  }

  std::mutex mutex;
  std::condition_variable given_up;
  std::atomic<bool> is_over{false}, gives_up{false};
  std::exception_ptr error;
  Scene scene;
  std::thread thread;
};

LevelBuild::LevelBuild(SceneDescription description, LoadOptions options, double wait)
    : impl_(std::make_unique<Impl>()) {
  options.defers_levels = false;
  options.progress = [impl = impl_.get(), tell = std::move(options.progress)](
                         const std::string& what, double share, double triangles) {
    impl->require_wanted();
    if (tell) tell(what, share, triangles);
  };
  impl_->thread = std::thread([impl = impl_.get(), description = std::move(description),
                               options = std::move(options), wait]() mutable {
    give_way();
    try {
      impl->wait(wait);
      impl->scene = load_scene(std::move(description), options);
    } catch (...) {
      impl->error = std::current_exception();
    }
    impl->is_over.store(true, std::memory_order_release);
  });
}

void LevelBuild::give_up() {
  {
    const std::lock_guard lock(impl_->mutex);
    impl_->gives_up.store(true, std::memory_order_relaxed);
  }
  impl_->given_up.notify_all();
}

LevelBuild::~LevelBuild() {
  give_up();
  if (impl_->thread.joinable()) impl_->thread.join();
}

bool LevelBuild::is_over() const { return impl_->is_over.load(std::memory_order_acquire); }

Scene LevelBuild::take() {
  if (impl_->thread.joinable()) impl_->thread.join();
  if (impl_->error) std::rethrow_exception(impl_->error);
  return std::move(impl_->scene);
}

std::unique_ptr<ContactReplacement> replace_contacts(const SessionConfig& now, const Scene& scene,
                                                     const BodyState& near) {
  SessionConfig config = now;
  ContactWorld& world = config.contact;
  world.object = scene.config.contact.object;
  for (std::size_t i = 0; i < world.scene.size(); ++i)
    world.scene[i].hierarchy = scene.config.contact.scene[i].hierarchy;
  world.resolution = scene.config.contact.resolution;
  if (world.constraints) use_constraints(config);
  auto made = std::make_unique<ContactReplacement>();
  made->world = std::move(world);
  reserve_contact_scratch(made->world, made->scratch);
  find_contacts(made->world, {near, 0.0, 0}, made->scratch);
  return made;
}

}  // namespace thigma
