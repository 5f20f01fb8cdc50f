#include "support/audit.h"

#include <cstddef>
#include <cstdlib>
#include <vector>

#include <dlfcn.h>
#include <errno.h>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <pthread.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <ucontext.h>
#include <unistd.h>

#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer) || \
    __has_feature(realtime_sanitizer)
#define THIGMA_NO_AUDIT 1
#endif
#endif
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) || !defined(__x86_64__)
#define THIGMA_NO_AUDIT 1
#endif

namespace thigma::test {
namespace {

// Plain thread-local numbers: the signal handler and the interposers run in the watched thread.
thread_local volatile bool is_watched = false;
thread_local AuditCounts watched;

}  // namespace
}  // namespace thigma::test

#ifndef THIGMA_NO_AUDIT

namespace {

void note_allocation() {
  if (thigma::test::is_watched) ++thigma::test::watched.allocations;
}
void note_lock() {
  if (thigma::test::is_watched) ++thigma::test::watched.locks;
}

template <class Function>
Function next_function(const char* name, const char* version = nullptr) {
  void* found = version != nullptr ? dlvsym(RTLD_NEXT, name, version) : dlsym(RTLD_NEXT, name);
  return reinterpret_cast<Function>(found);
}

}  // namespace

extern "C" {

void* __libc_malloc(size_t);
void __libc_free(void*);
void* __libc_calloc(size_t, size_t);
void* __libc_realloc(void*, size_t);
void* __libc_memalign(size_t, size_t);

void* malloc(size_t n) {
  note_allocation();
  return __libc_malloc(n);
}
void free(void* p) {
  if (p != nullptr && thigma::test::is_watched) ++thigma::test::watched.frees;
  __libc_free(p);
}
void* calloc(size_t n, size_t size) {
  note_allocation();
  return __libc_calloc(n, size);
}
void* realloc(void* p, size_t n) {
  note_allocation();
  return __libc_realloc(p, n);
}
void* memalign(size_t alignment, size_t n) {
  note_allocation();
  return __libc_memalign(alignment, n);
}
void* aligned_alloc(size_t alignment, size_t n) {
  note_allocation();
  return __libc_memalign(alignment, n);
}
int posix_memalign(void** out, size_t alignment, size_t n) {
  note_allocation();
  void* p = __libc_memalign(alignment, n);
  if (p == nullptr) return ENOMEM;
  *out = p;
  return 0;
}

int pthread_mutex_lock(pthread_mutex_t* m) {
  static const auto real = next_function<int (*)(pthread_mutex_t*)>("pthread_mutex_lock");
  note_lock();
  return real(m);
}
int pthread_mutex_trylock(pthread_mutex_t* m) {
  static const auto real = next_function<int (*)(pthread_mutex_t*)>("pthread_mutex_trylock");
  note_lock();
  return real(m);
}
int pthread_rwlock_rdlock(pthread_rwlock_t* l) {
  static const auto real = next_function<int (*)(pthread_rwlock_t*)>("pthread_rwlock_rdlock");
  note_lock();
  return real(l);
}
int pthread_rwlock_wrlock(pthread_rwlock_t* l) {
  static const auto real = next_function<int (*)(pthread_rwlock_t*)>("pthread_rwlock_wrlock");
  note_lock();
  return real(l);
}
// Two versions of these exist; without naming one dlsym finds that of 1999.
int pthread_cond_wait(pthread_cond_t* c, pthread_mutex_t* m) {
  static const auto real =
      next_function<int (*)(pthread_cond_t*, pthread_mutex_t*)>("pthread_cond_wait", "GLIBC_2.3.2");
  note_lock();
  return real(c, m);
}
int pthread_cond_timedwait(pthread_cond_t* c, pthread_mutex_t* m, const timespec* t) {
  static const auto real =
      next_function<int (*)(pthread_cond_t*, pthread_mutex_t*, const timespec*)>(
          "pthread_cond_timedwait", "GLIBC_2.3.2");
  note_lock();
  return real(c, m, t);
}
int pthread_cond_signal(pthread_cond_t* c) {
  static const auto real =
      next_function<int (*)(pthread_cond_t*)>("pthread_cond_signal", "GLIBC_2.3.2");
  note_lock();
  return real(c);
}
int pthread_cond_broadcast(pthread_cond_t* c) {
  static const auto real =
      next_function<int (*)(pthread_cond_t*)>("pthread_cond_broadcast", "GLIBC_2.3.2");
  note_lock();
  return real(c);
}

}  // extern "C"

namespace thigma::test {
namespace {

void on_system_call(int, siginfo_t* info, void* context) {
  if (is_watched) {
    ++watched.system_calls;
    watched.last_system_call = info->si_syscall;
  }
  static_cast<ucontext_t*>(context)->uc_mcontext.gregs[REG_RAX] = -ENOSYS;
}

}  // namespace

const char* why_no_audit() { return nullptr; }

bool forbid_system_calls() {
  struct sigaction action {};
  action.sa_sigaction = on_system_call;
  action.sa_flags = SA_SIGINFO;
  if (sigaction(SIGSYS, &action, nullptr) != 0) return false;
  // Allowed: reading the clock, returning from the handler, and what a thread needs to end. Not
  // futex: a lock that somebody else holds is seen even where the interposers are not asked.
  std::vector<sock_filter> program{BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr))};
  for (const unsigned number : {SYS_clock_gettime, SYS_rt_sigreturn, SYS_exit, SYS_exit_group,
                                SYS_madvise, SYS_munmap, SYS_rt_sigprocmask}) {
    program.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, number, 0, 1));
    program.push_back(BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW));
  }
  program.push_back(BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_TRAP));
  const sock_fprog filter{static_cast<unsigned short>(program.size()), program.data()};
  if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) return false;
  return syscall(SYS_seccomp, SECCOMP_SET_MODE_FILTER, 0, &filter) == 0;
}

}  // namespace thigma::test

#else  // a build that cannot

namespace thigma::test {
const char* why_no_audit() {
  return "this build's sanitizer interposes the allocator and the locks itself: the audit runs in "
         "the release and dev "
         "presets";
}
bool forbid_system_calls() { return false; }
}  // namespace thigma::test

#endif

namespace thigma::test {

AuditScope::AuditScope() {
  watched = {};
  is_watched = true;
}
AuditScope::~AuditScope() { is_watched = false; }
AuditCounts AuditScope::counts() const {
  is_watched = false;
  const AuditCounts counts = watched;
  is_watched = true;
  return counts;
}

}  // namespace thigma::test
