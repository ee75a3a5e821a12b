#include "base/directory_replacement.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <limits.h>
#include <stdio.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <exception>
#include <system_error>

#include "base/allocation.h"
#include "base/directory.h"
#include "base/errors.h"
#include "base/output_file.h"

namespace geneva::base {

namespace fs = std::filesystem;

namespace {

constexpr const char* other_place = "give another one with --output";

[[noreturn]] void refuse(const fs::path& directory, const std::string& why) {
  throw InputError(
      fmt::format("results directory {}: {}; {}", directory.string(), why, other_place));
}

bool is_there(const fs::path& path) {
  std::error_code ignored;
  return fs::symlink_status(path, ignored).type() != fs::file_type::not_found;
}

fs::path nearest_existing(fs::path path) {
  while (!is_there(path)) path = path.parent_path();
  return path;
}

/// A file system mounted there cannot be renamed.
bool is_mounted(const fs::path& directory) {
  struct stat own {};
  struct stat parents {};
  return ::stat(directory.c_str(), &own) == 0 &&
         ::stat(directory.parent_path().c_str(), &parents) == 0 && own.st_dev != parents.st_dev;
}

/// Whether the process works in the directory or below it: its users would be left in one that is
/// no more.
bool is_worked_in(const fs::path& directory) {
  std::error_code error;
  const fs::path here = fs::current_path(error);
  if (error) return false;
  const auto [end, unused] =
      std::mismatch(directory.begin(), directory.end(), here.begin(), here.end());
  return end == directory.end();
}

void check_lengths(const fs::path& final) {
  constexpr std::size_t longest_own_name = 32;  // of the files within, and what stands beside it
  constexpr std::size_t longest_addition = 20;  // ".checkpoint.partial" and a dot
  std::size_t name = 0;
  for (const fs::path& part : final) name = std::max(name, part.string().size());
  const std::size_t path = final.string().size();
  if (name + longest_addition > NAME_MAX)
    refuse(final, fmt::format("a name in it has {} bytes, of which {} can be written", name,
                              NAME_MAX - longest_addition));
  if (path + longest_addition + longest_own_name > PATH_MAX)
    refuse(final, fmt::format("its path has {} bytes, of which {} can be written", path,
                              PATH_MAX - longest_addition - longest_own_name));
}

/// The same file under another name, or where the file system knows no two names, a copy.
void link_or_copy(const fs::path& from, const fs::path& to) {
  if (::link(from.c_str(), to.c_str()) == 0) return;
  std::error_code error;
  fs::copy_file(from, to, error);
  if (error) throw InputError(fmt::format("cannot keep {}: {}", from.string(), error.message()));
}

bool is_regular(const fs::path& path) {
  std::error_code ignored;
  return fs::symlink_status(path, ignored).type() == fs::file_type::regular;
}

void move(const fs::path& from, const fs::path& to) {
  if (::rename(from.c_str(), to.c_str()) != 0)
    refuse_by_system(fmt::format("cannot rename {} to {}", from.string(), to.string()));
}

}  // namespace

fs::path beside(const fs::path& final, const std::string& what) {
  return final.parent_path() / fmt::format(".{}.{}", final.filename().string(), what);
}

fs::path resolved(const fs::path& path) {
  const fs::path wanted = (fs::absolute(path) / "").lexically_normal().parent_path();
  check_lengths(wanted);
  std::error_code error;
  const fs::path existing = nearest_existing(wanted);
  const fs::path base = fs::canonical(existing, error);
  if (error)
    refuse(path, fs::is_symlink(fs::symlink_status(existing))
                     ? fmt::format("{} is a link that leads to nothing", existing.string())
                     : error.message());
  return existing == wanted ? base : base / wanted.lexically_relative(existing);
}

fs::path working_directory_of(const fs::path& final) { return beside(resolved(final), "partial"); }

void check_replaceable(const fs::path& directory) {
  const fs::path final = resolved(directory);
  const fs::path existing = nearest_existing(final);
  if (!fs::is_directory(existing)) refuse(directory, "a file of that name is in the way");
  if (is_there(final) && (final == final.root_path() || is_mounted(final)))
    refuse(directory, "a file system of its own cannot be replaced, a directory within it can");
  if (is_worked_in(final))
    refuse(directory, "it would be replaced while it is the current directory, or holds that");
  const fs::path parent = is_there(final) ? final.parent_path() : existing;
  for (const fs::path& needed : {existing, parent})
    if (::access(needed.c_str(), W_OK | X_OK) != 0)
      refuse(directory,
             fmt::format("{} cannot be written ({})", needed == final ? "it" : needed.string(),
                         std::strerror(errno)));
}

DirectoryReplacement::DirectoryReplacement(const fs::path& final)
    : final_(resolved(final)), working_(beside(final_, "partial")), aside_(beside(final_, "old")) {
  check_replaceable(final);
  make_parents();
  try {
    begin();
  } catch (...) {
    remove_parents();
    throw;
  }
}

DirectoryReplacement::~DirectoryReplacement() {
  if (undo_) remove_tree(working_);
  undo_.reset();
  lock_.reset();
  remove_parents();
}

void DirectoryReplacement::begin() {
  undo_parents_.emplace([this] { remove_parents(); });
  lock_.emplace(beside(final_, "lock"), fmt::format("results directory {}", final_.string()));
  mend();
  undo_.emplace([working = working_] {
    for (int i = 0; i < 2 && !remove_tree(working); ++i) continue;  // others may still write there
  });
  if (::mkdir(working_.c_str(), 0777) != 0)
    refuse_by_system(fmt::format("results directory {} cannot be written", final_.string()));
}

/// Those still empty.
void DirectoryReplacement::remove_parents() const {
  for (const fs::path& parent : made_) ::rmdir(parent.c_str());
}

void DirectoryReplacement::make_parents() {
  for (fs::path parent = final_.parent_path(); !is_there(parent); parent = parent.parent_path())
    made_.push_back(parent);
  std::error_code error;
  fs::create_directories(final_.parent_path(), error);
  if (error) refuse(final_, error.message());
}

/// Puts in order what an interrupted replacement left.
void DirectoryReplacement::mend() const {
  if (is_there(aside_) && !is_there(final_)) move(aside_, final_);
  for (const fs::path& left : {aside_, working_})
    if (is_there(left)) put_away(left);
}

/// Removes an old directory; what it holds beside files goes into the new one.
void DirectoryReplacement::put_away(const fs::path& old) const {
  std::error_code ignored;
  if (fs::is_directory(final_, ignored))
    for (const fs::path& entry : entries_of(old))
      if (const fs::path place = final_ / entry.filename(); !is_regular(entry) && !is_there(place))
        move(entry, place);
  remove_tree(old);
}

void DirectoryReplacement::exchange() const {
  if (!is_there(final_)) return move(working_, final_);
  if (::renameat2(AT_FDCWD, working_.c_str(), AT_FDCWD, final_.c_str(), RENAME_EXCHANGE) == 0)
    return;
  if (errno != EINVAL && errno != ENOSYS)
    refuse_by_system(fmt::format("cannot replace {}", final_.string()));
  move(final_, aside_);
  try {
    move(working_, final_);
  } catch (const InputError&) {
    move(aside_, final_);
    throw;
  }
}

void DirectoryReplacement::keep(const std::function<bool(const std::string&)>& is_kept) const {
  if (!fs::is_directory(final_)) return;
  for (const fs::path& file : entries_of(final_))
    if (const fs::path place = working_ / file.filename();
        is_regular(file) && !is_there(place) && is_kept(file.filename().string()))
      link_or_copy(file, place);
  struct stat old {};
  if (::stat(final_.c_str(), &old) == 0) (void)::chmod(working_.c_str(), old.st_mode & 07777);
}

void DirectoryReplacement::commit() {
  for (const fs::path& file : entries_of(working_))
    if (!is_there(final_ / file.filename()) ||
        !fs::equivalent(file, final_ / file.filename()))  // what is kept is on the disk already
      synchronise(file);
  synchronise(working_);
  const auto whole = not_to_be_interrupted();
  exchange();
  undo_.reset();
  AllocationWatch watch;
  try {
    finish();
  } catch (const std::exception&) {  // memory that ran out has many names
    watch.forget();
    finish();
  }
}

/// The new directory is in its place.
void DirectoryReplacement::finish() const {
  try {
    synchronise(final_.parent_path());
  } catch (const InputError&) {
    // What is left to chance is a breakdown of the machine now.
  }
  for (const fs::path& old : {aside_, working_})
    if (is_there(old)) put_away(old);
}

}  // namespace geneva::base
