#include "mesher/enclosure.h"

#include <fcntl.h>
#include <linux/landlock.h>
#include <seccomp.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstdint>
#include <fstream>

namespace geneva::mesher {

namespace {

/// Of this process's address space [byte], most of it libraries.
[[maybe_unused]] double address_space() {  // not with a sanitizer
  double pages = 0.;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * static_cast<double>(sysconf(_SC_PAGESIZE));
}

void set_limit(const __rlimit_resource resource, const double most) {
  constexpr double unlimited = 9e18;
  rlimit present{};
  if (getrlimit(resource, &present) != 0) return;
  const rlim_t wanted = most < unlimited ? static_cast<rlim_t>(std::max(0., most)) : RLIM_INFINITY;
  const rlim_t value = std::min(wanted, present.rlim_max);
  const rlimit next{value, value};
  (void)setrlimit(resource, &next);
}

/// Only files of the directory can be read, none written (Landlock, Linux 5.13 and later).
bool enclose_files(const std::string& directory) {
  // Rights to files that this version of the interface knows, all of which are taken away.
  const long version =
      syscall(SYS_landlock_create_ruleset, nullptr, 0, LANDLOCK_CREATE_RULESET_VERSION);
  if (version < 1) return false;
  const int rights = version == 1 ? 13 : version == 2 ? 14 : 15;
  landlock_ruleset_attr rules{};
  rules.handled_access_fs = (std::uint64_t{1} << rights) - 1;
  const auto ruleset =
      static_cast<int>(syscall(SYS_landlock_create_ruleset, &rules, sizeof rules, 0));
  if (ruleset < 0) return false;
  bool holds = true;
  if (!directory.empty()) {
    landlock_path_beneath_attr beneath{};
    beneath.allowed_access = LANDLOCK_ACCESS_FS_READ_FILE | LANDLOCK_ACCESS_FS_READ_DIR;
    beneath.parent_fd = open(directory.c_str(), O_PATH | O_CLOEXEC);
    holds = beneath.parent_fd >= 0 &&
            syscall(SYS_landlock_add_rule, ruleset, LANDLOCK_RULE_PATH_BENEATH, &beneath, 0) == 0;
    if (beneath.parent_fd >= 0) close(beneath.parent_fd);
  }
  holds = holds && syscall(SYS_landlock_restrict_self, ruleset, 0) == 0;
  close(ruleset);
  return holds;
}

/// What a computation needs that reads files and answers on descriptors that are open.
constexpr std::array calls{SCMP_SYS(read),
                           SCMP_SYS(readv),
                           SCMP_SYS(pread64),
                           SCMP_SYS(write),
                           SCMP_SYS(writev),
                           SCMP_SYS(close),
                           SCMP_SYS(lseek),
                           SCMP_SYS(fstat),
                           SCMP_SYS(stat),
                           SCMP_SYS(lstat),
                           SCMP_SYS(newfstatat),
                           SCMP_SYS(statx),
                           SCMP_SYS(access),
                           SCMP_SYS(faccessat),
                           SCMP_SYS(faccessat2),
                           SCMP_SYS(readlink),
                           SCMP_SYS(readlinkat),
                           SCMP_SYS(getcwd),
                           SCMP_SYS(getdents64),
                           SCMP_SYS(brk),
                           SCMP_SYS(mmap),
                           SCMP_SYS(munmap),
                           SCMP_SYS(mremap),
                           SCMP_SYS(mprotect),
                           SCMP_SYS(madvise),
                           SCMP_SYS(futex),
                           SCMP_SYS(rt_sigaction),
                           SCMP_SYS(rt_sigprocmask),
                           SCMP_SYS(rt_sigreturn),
                           SCMP_SYS(sigaltstack),
                           SCMP_SYS(getpid),
                           SCMP_SYS(gettid),
                           SCMP_SYS(getuid),
                           SCMP_SYS(geteuid),
                           SCMP_SYS(getgid),
                           SCMP_SYS(getegid),
                           SCMP_SYS(getrusage),
                           SCMP_SYS(times),
                           SCMP_SYS(clock_gettime),
                           SCMP_SYS(clock_getres),
                           SCMP_SYS(clock_nanosleep),
                           SCMP_SYS(gettimeofday),
                           SCMP_SYS(time),
                           SCMP_SYS(sysinfo),
                           SCMP_SYS(uname),
                           SCMP_SYS(getrandom),
                           SCMP_SYS(sched_yield),
                           SCMP_SYS(sched_getaffinity),
                           SCMP_SYS(exit),
                           SCMP_SYS(exit_group)};

/// Everything else is refused to it as not permitted (seccomp).
bool enclose_calls() {
  const scmp_filter_ctx filter = seccomp_init(SCMP_ACT_ERRNO(EPERM));
  if (filter == nullptr) return false;
  int error = 0;
  for (const int call : calls) error |= seccomp_rule_add(filter, SCMP_ACT_ALLOW, call, 0);
  const auto allow_if = [&](const int call, const scmp_arg_cmp condition) {
    error |= seccomp_rule_add_array(filter, SCMP_ACT_ALLOW, call, 1, &condition);
  };
  constexpr scmp_datum_t writing = O_WRONLY | O_RDWR | O_CREAT | O_TRUNC | O_APPEND;
  allow_if(SCMP_SYS(open), {1, SCMP_CMP_MASKED_EQ, writing, 0});
  allow_if(SCMP_SYS(openat), {2, SCMP_CMP_MASKED_EQ, writing, 0});
  // abort() signals the process itself
  allow_if(SCMP_SYS(tgkill), {0, SCMP_CMP_EQ, static_cast<scmp_datum_t>(getpid()), 0});
  error |= seccomp_load(filter);
  seccomp_release(filter);
  return error == 0;
}

}  // namespace

void limit(const mesh::MesherLimits& limits) {
#ifndef __SANITIZE_ADDRESS__  // whose shadow memory is larger than any limit
  set_limit(RLIMIT_AS, address_space() + limits.memory);
#endif
  set_limit(RLIMIT_CPU, std::ceil(limits.seconds) + 1.);
  set_limit(RLIMIT_FSIZE, 0.);
  set_limit(RLIMIT_CORE, 0.);
  set_limit(RLIMIT_NPROC, 0.);
}

bool enclose(const std::string& directory) {
  if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) return false;
  const bool no_files = enclose_files(directory);
  const bool no_calls = enclose_calls();
  return no_files && no_calls;
}

}  // namespace geneva::mesher
