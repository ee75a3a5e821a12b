find_package(PkgConfig REQUIRED)
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(deal.II 9.4 REQUIRED)
find_package(CLI11 REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(fmt REQUIRED)
find_package(NLopt REQUIRED)
find_package(PNG REQUIRED)
find_package(MPI REQUIRED COMPONENTS CXX)
foreach(feature MPI P4EST TRILINOS HDF5)
  if(NOT DEAL_II_WITH_${feature})
    message(FATAL_ERROR "deal.II was built without ${feature}; install Debian's libdeal.ii-dev (scripts/setup does)")
  endif()
endforeach()

# deal.II's own CMake macro refuses keyword-style linking and RelWithDebInfo: wrap the library once, with its
# headers as SYSTEM, so that this project's warnings stay on.
add_library(geneva_dealii INTERFACE)
if(CMAKE_BUILD_TYPE STREQUAL "Debug")
  set(geneva_dealii_library ${DEAL_II_TARGET_DEBUG})
  target_compile_definitions(geneva_dealii INTERFACE DEBUG)
else()
  set(geneva_dealii_library ${DEAL_II_TARGET_RELEASE})
endif()
target_include_directories(geneva_dealii SYSTEM INTERFACE ${DEAL_II_INCLUDE_DIRS})
target_link_libraries(geneva_dealii INTERFACE ${geneva_dealii_library} Eigen3::Eigen)
# OpenMPI's C++ bindings, which nothing here uses, cost half a second in every source file.
target_compile_definitions(geneva_dealii INTERFACE OMPI_SKIP_MPICXX)
# deal.II's inline functions call into Trilinos and TBB, which only libdeal.ii.so itself is linked to.
target_link_options(geneva_dealii INTERFACE -Wl,--copy-dt-needed-entries)

find_path(GENEVA_GMSH_INCLUDE gmsh.h REQUIRED)
find_library(GENEVA_GMSH_LIBRARY gmsh REQUIRED)
add_library(geneva_gmsh INTERFACE)
target_include_directories(geneva_gmsh SYSTEM INTERFACE ${GENEVA_GMSH_INCLUDE})
target_link_libraries(geneva_gmsh INTERFACE ${GENEVA_GMSH_LIBRARY})

# The CAD kernel that Gmsh is built on. Its own configuration file needs all of its modules, also those for a screen.
find_path(GENEVA_OPENCASCADE_INCLUDE TopoDS_Shape.hxx PATH_SUFFIXES opencascade REQUIRED)
add_library(geneva_opencascade INTERFACE)
target_include_directories(geneva_opencascade SYSTEM INTERFACE ${GENEVA_OPENCASCADE_INCLUDE})
foreach(library IN ITEMS TKXDESTEP TKXCAF TKLCAF TKSTEP TKSTEPBase TKXSBase TKBO TKPrim TKShHealing TKTopAlgo TKGeomAlgo TKBRep TKGeomBase TKG3d TKMath TKernel)
  find_library(GENEVA_${library} ${library} REQUIRED)
  target_link_libraries(geneva_opencascade INTERFACE ${GENEVA_${library}})
endforeach()

pkg_check_modules(GENEVA_DXFLIB REQUIRED IMPORTED_TARGET dxflib)
add_library(geneva_dxflib INTERFACE)
target_link_libraries(geneva_dxflib INTERFACE PkgConfig::GENEVA_DXFLIB)

# Its header is where deal.II's are.
find_library(GENEVA_CHOLMOD_LIBRARY cholmod REQUIRED)
add_library(geneva_cholmod INTERFACE)
target_link_libraries(geneva_cholmod INTERFACE ${GENEVA_CHOLMOD_LIBRARY})

find_path(GENEVA_UDUNITS_INCLUDE udunits2.h REQUIRED)
find_library(GENEVA_UDUNITS_LIBRARY udunits2 REQUIRED)
add_library(geneva_udunits INTERFACE)
target_include_directories(geneva_udunits SYSTEM INTERFACE ${GENEVA_UDUNITS_INCLUDE})
target_link_libraries(geneva_udunits INTERFACE ${GENEVA_UDUNITS_LIBRARY})

find_path(GENEVA_SECCOMP_INCLUDE seccomp.h REQUIRED)
find_library(GENEVA_SECCOMP_LIBRARY seccomp REQUIRED)
add_library(geneva_seccomp INTERFACE)
target_include_directories(geneva_seccomp SYSTEM INTERFACE ${GENEVA_SECCOMP_INCLUDE})
target_link_libraries(geneva_seccomp INTERFACE ${GENEVA_SECCOMP_LIBRARY})
