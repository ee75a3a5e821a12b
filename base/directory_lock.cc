#include "base/directory_lock.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <string>
#include <utility>

#include "base/errors.h"
#include "base/output_file.h"

namespace geneva::base {

namespace {

int open_lock(const std::filesystem::path& file) {
  const int descriptor = ::open(file.c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_CLOEXEC, 0666);
  if (descriptor < 0)
    refuse_by_system(
        fmt::format("results cannot be written beside {}", file.parent_path().string()));
  return descriptor;
}

/// Whether the name still stands for what was opened: the holder removes it before it lets go.
bool is_still(const std::filesystem::path& file, const int descriptor) {
  struct stat named {};
  struct stat opened {};
  return ::lstat(file.c_str(), &named) == 0 && ::fstat(descriptor, &opened) == 0 &&
         named.st_ino == opened.st_ino && named.st_dev == opened.st_dev;
}

std::string holder_of(const int descriptor) {
  std::array<char, 32> text{};
  const ssize_t length = ::pread(descriptor, text.data(), text.size() - 1, 0);
  const std::string number(text.data(), length > 0 ? static_cast<std::size_t>(length) : 0);
  const std::size_t end = number.find_first_not_of("0123456789");
  return end == 0 || number.empty() ? "unknown" : number.substr(0, end);
}

void write_holder(const int descriptor) {
  const std::string text = fmt::format("{}\n", ::getpid());
  (void)!::ftruncate(descriptor, 0);
  (void)!::pwrite(descriptor, text.data(), text.size(), 0);  // it is only for the message
}

}  // namespace

DirectoryLock::DirectoryLock(std::filesystem::path file, const std::string& guarded)
    : file_(std::move(file)), descriptor_(open_lock(file_)) {
  while (true) {
    // A file system without locks does not keep anybody from writing.
    if (::flock(descriptor_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
      const std::string holder = holder_of(descriptor_);
      ::close(descriptor_);
      throw InputError(fmt::format(
          "{}: another run (process {}) writes there; wait for its end, or give another directory "
          "with --output",
          guarded, holder));
    }
    if (is_still(file_, descriptor_)) break;
    ::close(descriptor_);
    descriptor_ = open_lock(file_);
  }
  try {
    write_holder(descriptor_);
    undo_.emplace([path = file_] { ::unlink(path.c_str()); });
  } catch (...) {  // no memory
    ::unlink(file_.c_str());
    ::close(descriptor_);
    throw;
  }
}

DirectoryLock::~DirectoryLock() {
  undo_.reset();
  ::unlink(file_.c_str());
  ::close(descriptor_);
}

}  // namespace geneva::base
