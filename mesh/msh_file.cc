#include "mesh/msh_file.h"

#include <fmt/format.h>

#include <set>
#include <sstream>
#include <utility>

#include "base/errors.h"

namespace geneva::mesh {

namespace {

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& what) {
  throw base::InputError(fmt::format("{}: {}", file.string(), what));
}

/// Position after a line that consists of the keyword, from a position on.
/// @throws base::InputError if there is none
std::size_t after_line(const std::string& content, const std::string& keyword, std::size_t from,
                       const std::filesystem::path& file) {
  for (std::size_t at = content.find(keyword, from); at != content.npos;
       at = content.find(keyword, at + 1)) {
    const std::size_t end = at + keyword.size();
    const bool begins_line = at == 0 || content[at - 1] == '\n';
    // in a binary file the block of numbers may run up to the keyword that ends it
    const bool may_follow_numbers = keyword.rfind("$End", 0) == 0;
    const bool ends_line = end == content.size() || content[end] == '\n' || content[end] == '\r';
    if ((begins_line || may_follow_numbers) && ends_line) return end;
  }
  refuse(file, fmt::format("{} is missing: the file was cut short; write it again", keyword));
}

void check_format_line(const std::string& line, const std::filesystem::path& file) {
  std::istringstream stream(line);
  std::string version;
  int binary = -1;
  int real_size = 0;
  stream >> version >> binary >> real_size;
  if (version != "2.2" && version != "4.1")
    refuse(file, fmt::format("its format is MSH {}: 2.2 and 4.1 can be read; save it again with "
                             "Mesh.MshFileVersion = 4.1",
                             version.substr(0, 20)));
  if ((binary != 0 && binary != 1) || real_size != 8)
    refuse(file, fmt::format("the line '{}' after $MeshFormat must be '{} 0 8' (text) or '{} 1 8' "
                             "(binary)",
                             line.substr(0, 40), version, version));
}

/// Gmsh drops a name that is used before, and the group with it seems to have none.
void check_names(const std::string& content, const std::filesystem::path& file) {
  const std::string start = "\n$PhysicalNames";
  const std::size_t at = content.find(start);
  if (at == content.npos) return;
  std::istringstream stream(content.substr(at, content.find("$EndPhysicalNames", at) - at));
  std::set<std::pair<int, std::string>> seen;
  int dimension = 0;
  int tag = 0;
  std::string line;
  while (std::getline(stream, line)) {
    std::istringstream fields(line);
    std::string name;
    if (!(fields >> dimension >> tag) || !std::getline(fields, name)) continue;
    if (!seen.insert({dimension, name}).second)
      refuse(file, fmt::format("the name{} is used for more than one {}: give each its own, or "
                               "list all entities in one group",
                               name, dimension == 1 ? "Physical Curve" : "Physical Surface"));
  }
}

}  // namespace

void check_msh(const std::string& content, const std::filesystem::path& file) {
  const std::string start = "$MeshFormat";
  if (content.rfind(start + "\n", 0) != 0 && content.rfind(start + "\r\n", 0) != 0)
    refuse(file, "it does not begin with $MeshFormat: this is no Gmsh mesh");
  const std::size_t line = content.find('\n') + 1;
  const std::size_t end = content.find('\n', line);
  if (end == content.npos) refuse(file, "the file ends in its first lines: it was cut short");
  check_format_line(content.substr(line, end - line), file);
  std::size_t at = end;
  for (const char* const keyword :
       {"$EndMeshFormat", "$Nodes", "$EndNodes", "$Elements", "$EndElements"})
    at = after_line(content, keyword, at, file);
  check_names(content, file);
}

}  // namespace geneva::mesh
