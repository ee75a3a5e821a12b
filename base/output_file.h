#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

namespace geneva::base {

/// Opens a file for writing. @throws InputError naming it and why if that fails
std::ofstream open_output(const std::filesystem::path& file);

/// Closes a file that was written. @throws InputError naming it if not everything arrived
void close_output(std::ofstream& stream, const std::filesystem::path& file);

/// Writes a text into a file of a directory that nobody else writes to.
/// @throws InputError as above
void write_text(const std::filesystem::path& file, std::string_view text);

/// Sees that a file or a directory's list of names is on the disk.
/// @throws InputError naming it and why if it does not get there
void synchronise(const std::filesystem::path& path);

/// Replaces a file whole: under another name first, which nobody can have prepared, then renamed.
/// @throws InputError if that fails; the file is then as it was
void replace_file(const std::filesystem::path& file, const std::string& text);

/// The same where one process at a time writes, as the holder of a lock: what a kill leaves beside
/// the file has a name of its own, FILE.partial, and is replaced the next time.
/// @throws InputError if that fails; the file is then as it was
void replace_own_file(const std::filesystem::path& file, const std::string& text);

/// "cannot write FILE" and the system's reason, from errno.
std::string with_reason(const std::string& what);

/// @param what was tried
/// @throws InputError with that and the system's reason
[[noreturn]] void refuse_by_system(const std::string& what);

}  // namespace geneva::base
