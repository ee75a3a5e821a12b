#pragma once

#include <functional>
#include <string>
#include <vector>

namespace geneva::mesher {

/// Gmsh from start to end: silent, without windows, without the user's configuration, on one
/// thread.
///
/// Only one may exist at a time.
class GmshSession {
 public:
  GmshSession();
  ~GmshSession();
  GmshSession(const GmshSession&) = delete;
  GmshSession& operator=(const GmshSession&) = delete;
  GmshSession(GmshSession&&) = delete;
  GmshSession& operator=(GmshSession&&) = delete;

  /// Runs some of Gmsh's functions and returns the errors that they reported, none if all went
  /// well.
  std::vector<std::string> errors_of(const std::function<void()>& action);

 private:
  std::size_t messages_seen_ = 0;
};

/// Quadrilaterals: frontal-Delaunay triangles, recombined by Blossom.
void set_quadrilateral_options();

}  // namespace geneva::mesher
