#include "saved_mesh.h"

#include <gmsh.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "case_directory.h"
#include "mesher/gmsh_session.h"

namespace geneva::mesh::test {

std::string saved(const std::string& geo, double version, bool binary, int dimension) {
  const CaseDirectory directory;
  const auto source = directory.write("source.geo", geo + "\n");
  const auto target = directory.path() / "saved.msh";
  mesher::GmshSession session;
  mesher::set_quadrilateral_options();
  const auto errors = session.errors_of([&] {
    gmsh::option::setNumber("Mesh.MshFileVersion", version);
    gmsh::option::setNumber("Mesh.Binary", binary ? 1 : 0);
    gmsh::open(source.string());
    gmsh::model::mesh::generate(dimension);
    gmsh::write(target.string());
  });
  EXPECT_TRUE(errors.empty());
  std::ostringstream content;
  content << std::ifstream(target, std::ios::binary).rdbuf();
  return content.str();
}

}  // namespace geneva::mesh::test
