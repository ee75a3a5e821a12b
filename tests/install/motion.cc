#include <geneva/api/design.h>
#include <geneva/api/kinematics.h>

#include <cstdio>

/// Prints the characteristic values of a mechanism, without any finite elements.
int main(int argc, char** argv) {
  if (argc != 2) return 1;
  const geneva::Case given = geneva::read_case(argv[1]);
  std::printf("%s", geneva::table(geneva::kinematics(given)).c_str());
  std::printf("%s", geneva::table({geneva::design(given)}).c_str());
  return 0;
}
