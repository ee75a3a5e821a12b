// Loaded before a program (LD_PRELOAD), makes the system fail it: of the calls that write below a
// directory, GENEVA_FAULT_PATH, the one with the number GENEVA_FAULT_AT, and with
// GENEVA_FAULT_FOR=all those after it, fail as on a full disk; with GENEVA_FAULT_KILL the process
// is killed there instead. GENEVA_FAULT_COUNT names a file to which every process adds the number
// of such calls and of allocations in its end. With GENEVA_FAULT_NEW the n-th allocation by
// operator new since main() began fails as if there was no memory, of the program with the file
// name GENEVA_FAULT_PROGRAM; GENEVA_FAULT_PLACES names a file to which the n of the first
// allocation with each stack of calls is written.

#include <dlfcn.h>
#include <execinfo.h>
#include <fcntl.h>
#include <signal.h>
#include <sys/uio.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <climits>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <mutex>
#include <new>
#include <unordered_map>
#include <utility>

#include "tests/cli/call_stack.h"

namespace {

std::atomic<long> calls{0};
std::atomic<long> allocations{0};
std::atomic<bool> is_in_main{false};

const char* directory() { return std::getenv("GENEVA_FAULT_PATH"); }

long number(const char* name) {
  const char* const text = std::getenv(name);
  return text != nullptr ? std::atol(text) : -1;
}

bool is_below(const char* path) {
  const char* const wanted = directory();
  return wanted != nullptr && path != nullptr && std::strstr(path, wanted) != nullptr;
}

bool is_below(const int descriptor) {
  char link[64];
  char path[PATH_MAX + 1];
  std::snprintf(link, sizeof link, "/proc/self/fd/%d", descriptor);
  const ssize_t length = ::readlink(link, path, PATH_MAX);
  if (length <= 0) return false;
  path[length] = '\0';
  return is_below(path);
}

/// Relative names are below the current directory.
bool is_below_here(const char* path) {
  if (path == nullptr || path[0] == '/') return is_below(path);
  char here[PATH_MAX];
  return ::getcwd(here, sizeof here) != nullptr && is_below(here);
}

/// Counts a call; whether it has to fail.
bool fails() {
  static const long at = number("GENEVA_FAULT_AT");
  static const bool for_all = std::getenv("GENEVA_FAULT_FOR") != nullptr;
  static const bool kills = std::getenv("GENEVA_FAULT_KILL") != nullptr;
  const long now = ++calls;
  if (at < 0 || now < at || (now > at && !for_all)) return false;
  if (kills) ::raise(SIGKILL);
  errno = ENOSPC;
  return true;
}

template <typename Function>
Function next(const char* name) {
  return reinterpret_cast<Function>(::dlsym(RTLD_NEXT, name));
}

template <typename T>
struct Malloc {
  using value_type = T;
  Malloc() = default;
  template <typename U>
  Malloc(const Malloc<U>& /*other*/) {}
  T* allocate(const std::size_t n) {
    return static_cast<T*>(std::malloc(n * sizeof(T)));  // NOLINT(bugprone-sizeof-expression)
  }
  void deallocate(T* const memory, std::size_t /*n*/) { std::free(memory); }
  bool operator==(const Malloc& /*other*/) const { return true; }
  bool operator!=(const Malloc& /*other*/) const { return false; }
};

/// Where the program allocates, by the return addresses of its innermost calls; kept without
/// operator new, which it is called from, and never destroyed: what libraries destroy after main()
/// allocates, too.
class Places {
 public:
  void note(const long n) {
    constexpr int depth = 7;
    void* frames[depth];
    const int found = ::backtrace(frames, depth);
    std::size_t hash = 0;
    for (int i = 1; i < found; ++i)
      hash = (hash ^ reinterpret_cast<std::size_t>(frames[i])) * 0x9E3779B97F4A7C15;
    const std::lock_guard<std::mutex> lock(mutex_);
    places_.try_emplace(hash, n);
  }

  void write() {
    if (file_ == nullptr) return;
    const std::lock_guard<std::mutex> lock(mutex_);
    if (std::FILE* const stream = std::fopen(file_, "a")) {
      for (const auto& [hash, first] : places_) std::fprintf(stream, "%ld\n", first);
      std::fclose(stream);
    }
  }

  [[nodiscard]] bool are_wanted() const { return file_ != nullptr; }

 private:
  const char* file_ = std::getenv("GENEVA_FAULT_PLACES");
  std::mutex mutex_;
  std::unordered_map<std::size_t, long, std::hash<std::size_t>, std::equal_to<>,
                     Malloc<std::pair<const std::size_t, long>>>
      places_;
};

Places& places() {
  static Places* const all = new (std::malloc(sizeof(Places))) Places;
  return *all;
}

struct Count {
  ~Count() {
    if (const char* const file = std::getenv("GENEVA_FAULT_COUNT")) {
      const long all = calls;
      const long news = allocations;
      if (std::FILE* const stream = std::fopen(file, "a")) {
        std::fprintf(stream, "%ld %ld\n", all, news);
        std::fclose(stream);
      }
    }
    places().write();
  }
} count;

}  // namespace

#define WRAP(result, name, parameters, arguments, is_ours)      \
  extern "C" result name parameters {                           \
    static const auto real = next<result(*) parameters>(#name); \
    if ((is_ours) && fails()) return -1;                        \
    return real arguments;                                      \
  }

WRAP(ssize_t, write, (int fd, const void* data, size_t size), (fd, data, size), is_below(fd))
WRAP(ssize_t, writev, (int fd, const iovec* data, int n), (fd, data, n), is_below(fd))
WRAP(ssize_t, pwrite, (int fd, const void* data, size_t size, off_t at), (fd, data, size, at),
     is_below(fd))
WRAP(ssize_t, pwrite64, (int fd, const void* data, size_t size, off64_t at), (fd, data, size, at),
     is_below(fd))
WRAP(ssize_t, pwritev, (int fd, const iovec* data, int n, off_t at), (fd, data, n, at),
     is_below(fd))
WRAP(ssize_t, pwritev64, (int fd, const iovec* data, int n, off64_t at), (fd, data, n, at),
     is_below(fd))
WRAP(int, ftruncate, (int fd, off_t size), (fd, size), is_below(fd))
WRAP(int, ftruncate64, (int fd, off64_t size), (fd, size), is_below(fd))
WRAP(int, fsync, (int fd), (fd), is_below(fd))
WRAP(int, rename, (const char* from, const char* to), (from, to), is_below_here(from))
WRAP(int, renameat2, (int a, const char* from, int b, const char* to, unsigned int flags),
     (a, from, b, to, flags), is_below_here(from))
WRAP(int, mkdir, (const char* path, mode_t mode), (path, mode), is_below_here(path))
WRAP(int, link, (const char* from, const char* to), (from, to), is_below_here(to))

#define WRAP_OPEN(name)                                                      \
  extern "C" int name(const char* path, int flags, ...) {                    \
    static const auto real = next<int (*)(const char*, int, ...)>(#name);    \
    va_list rest;                                                            \
    va_start(rest, flags);                                                   \
    const mode_t mode = (flags & O_CREAT) != 0 ? va_arg(rest, mode_t) : 0;   \
    va_end(rest);                                                            \
    if ((flags & O_CREAT) != 0 && is_below_here(path) && fails()) return -1; \
    return real(path, flags, mode);                                          \
  }

WRAP_OPEN(open)
WRAP_OPEN(open64)

namespace {

/// Libraries allocate before main(), where nothing can be said.
using Main = int (*)(int, char**, char**);
Main real_main = nullptr;

/// Whether the allocations of this process count.
bool is_meant() {
  const char* const wanted = std::getenv("GENEVA_FAULT_PROGRAM");
  char path[PATH_MAX];
  const ssize_t length = ::readlink("/proc/self/exe", path, PATH_MAX - 1);
  if (wanted == nullptr || length <= 0) return false;
  path[length] = '\0';
  return std::strcmp(::basename(path), wanted) == 0;
}

/// A program that crashes says where.
void tell_crash(const int signal) {
  void* frames[64];
  ::backtrace_symbols_fd(frames, ::backtrace(frames, 64), STDERR_FILENO);
  ::raise(signal);
}

int watched_main(int argc, char** argv, char** environment) {
  struct sigaction crash = {};
  crash.sa_handler = tell_crash;
  crash.sa_flags = static_cast<int>(SA_RESETHAND | SA_NODEFER);
  for (const int signal : {SIGSEGV, SIGBUS}) ::sigaction(signal, &crash, nullptr);
  is_in_main = is_meant();
  std::atexit([] { is_in_main = false; });  // nothing can be said of what libraries allocate then
  return real_main(argc, argv, environment);
}

void note_allocation() {
  static const long at = number("GENEVA_FAULT_NEW");
  const long now = ++allocations;
  if (places().are_wanted()) places().note(now);
  if (now != at || is_where_nothing_may_fail()) return;
  if (const std::new_handler handler = std::get_new_handler()) handler();
  throw std::bad_alloc();
}

}  // namespace

// NOLINTNEXTLINE(bugprone-reserved-identifier)
extern "C" int __libc_start_main(Main main, int argc, char** argv, void (*init)(), void (*fini)(),
                                 void (*end_of_linker)(), void* stack) {
  using Start = int (*)(Main, int, char**, void (*)(), void (*)(), void (*)(), void*);
  real_main = main;
  return next<Start>("__libc_start_main")(watched_main, argc, argv, init, fini, end_of_linker,
                                          stack);
}

void* operator new(const std::size_t size) {
  if (is_in_main) note_allocation();
  if (void* const memory = std::malloc(size == 0 ? 1 : size)) return memory;
  throw std::bad_alloc();
}

void operator delete(void* const memory) noexcept { std::free(memory); }
void operator delete(void* const memory, std::size_t) noexcept { std::free(memory); }
