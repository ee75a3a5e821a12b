#include "base/output_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>

#include "base/errors.h"
#include "base/undo.h"

namespace geneva::base {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void refuse_incomplete(const fs::path& file) {
  refuse_by_system("cannot write all of " + file.string());
}

void write_all(const int descriptor, const std::string& text, const fs::path& file) {
  for (std::size_t written = 0; written < text.size();) {
    const ssize_t count = ::write(descriptor, text.data() + written, text.size() - written);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) refuse_incomplete(file);
    written += static_cast<std::size_t>(count);
  }
}

/// A descriptor that is closed in the end.
class Descriptor {
 public:
  explicit Descriptor(const int number) : number_(number) {}
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  [[nodiscard]] int number() const { return number_; }

 private:
  int number_;
};

/// Some file systems cannot, which is no error.
void synchronise(const int descriptor, const fs::path& path) {
  if (::fsync(descriptor) != 0 && errno != EINVAL && errno != ENOSYS) refuse_incomplete(path);
}

/// With the rights that a new file gets.
void open_to_others(const int descriptor) {
  const mode_t mask = ::umask(0);
  ::umask(mask);
  (void)::fchmod(descriptor, 0666 & ~mask);
}

fs::path directory_of(const fs::path& file) {
  return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

/// @param descriptor of the other file, just opened; < 0 if that failed
void replace(const fs::path& file, const std::string& text, const std::string& other,
             const int descriptor) {
  const Descriptor opened(descriptor);
  if (descriptor < 0) refuse_by_system("cannot write into " + directory_of(file).string());
  const Undo undo([other] { ::unlink(other.c_str()); });
  try {
    open_to_others(descriptor);
    write_all(descriptor, text, file);
    synchronise(descriptor, file);
    if (::rename(other.c_str(), file.c_str()) != 0)
      refuse_by_system("cannot write " + file.string());
    base::synchronise(directory_of(file));
  } catch (const InputError&) {
    ::unlink(other.c_str());
    throw;
  }
}

}  // namespace

std::string with_reason(const std::string& what) {
  const int reason = errno;
  return reason == 0 ? what : fmt::format("{}: {}", what, std::strerror(reason));
}

void refuse_by_system(const std::string& what) { throw InputError(with_reason(what)); }

std::ofstream open_output(const fs::path& file) {
  errno = 0;
  std::ofstream stream(file);
  if (!stream) refuse_by_system("cannot write " + file.string());
  errno = 0;  // close_output() looks at what goes wrong from here on
  return stream;
}

void close_output(std::ofstream& stream, const fs::path& file) {
  if (stream.good()) errno = 0;
  stream.close();
  if (!stream) refuse_incomplete(file);
}

void write_text(const fs::path& file, const std::string_view text) {
  std::ofstream stream = open_output(file);
  stream << text;
  close_output(stream, file);
}

void synchronise(const fs::path& path) {
  const Descriptor opened(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (opened.number() < 0) refuse_incomplete(path);
  synchronise(opened.number(), path);
}

void replace_file(const fs::path& file, const std::string& text) {
  std::string other = (directory_of(file) / ".geneva-").string() + std::string(6, 'X');
  const int descriptor = ::mkostemp(other.data(), O_CLOEXEC);  // which fills the X in
  replace(file, text, other, descriptor);
}

void replace_own_file(const fs::path& file, const std::string& text) {
  const std::string other = file.string() + ".partial";
  ::unlink(other.c_str());
  const int descriptor = ::open(other.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
  replace(file, text, other, descriptor);
}

}  // namespace geneva::base
