# Every target of this project links geneva_warnings; third-party headers come in as SYSTEM and stay quiet.
add_library(geneva_warnings INTERFACE)
target_compile_options(geneva_warnings INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion -Wnon-virtual-dtor -Wold-style-cast
  -Woverloaded-virtual -Wnull-dereference -Werror)
if(GENEVA_SANITIZE)
  target_compile_options(geneva_warnings INTERFACE -fsanitize=address,undefined -fno-omit-frame-pointer -g1)
  target_link_options(geneva_warnings INTERFACE -fsanitize=address,undefined)
  # As in Gmsh, whose inlined parts of Eigen would otherwise free what ours have allocated, or the reverse.
  target_compile_definitions(geneva_warnings INTERFACE EIGEN_MALLOC_ALREADY_ALIGNED=1)
endif()
if(GENEVA_FUZZ)
  if(NOT CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
    message(FATAL_ERROR "GENEVA_FUZZ needs clang++: cmake --preset fuzz, or scripts/fuzz")
  endif()
  # The warnings are those of GCC; frames for the reports.
  target_compile_options(geneva_warnings INTERFACE
    -fsanitize=fuzzer-no-link,address,undefined -fno-sanitize-recover=undefined -fno-omit-frame-pointer -g1 -Wno-error)
  target_link_options(geneva_warnings INTERFACE -fsanitize=address,undefined)
endif()

# For code whose speed does not matter: half of the compile time of optimised template code is its optimisation.
add_library(geneva_cold INTERFACE)
target_compile_options(geneva_cold INTERFACE $<$<CONFIG:Release>:-O1> -Wno-null-dereference)

# A room: a static library whose headers are included as "room/header.h". DEALII: its sources need deal.II's headers.
# COLD: its speed does not matter.
function(geneva_room name)
  cmake_parse_arguments(ROOM "DEALII;COLD" "" "SOURCES;LINK" ${ARGN})
  add_library(geneva_${name} STATIC ${ROOM_SOURCES})
  target_include_directories(geneva_${name} PUBLIC ${PROJECT_SOURCE_DIR})
  target_link_libraries(geneva_${name} PUBLIC ${ROOM_LINK} PRIVATE geneva_warnings)
  if(ROOM_COLD)
    target_link_libraries(geneva_${name} PRIVATE geneva_cold)
  endif()
  if(ROOM_DEALII)
    target_precompile_headers(geneva_${name} REUSE_FROM geneva_dealii_pch)
  endif()
endfunction()

# deal.II's headers take 10 s a translation unit; precompiled once for all rooms, they take 1.5.
file(WRITE ${PROJECT_BINARY_DIR}/generated/pch.cc "")
add_library(geneva_dealii_pch OBJECT ${PROJECT_BINARY_DIR}/generated/pch.cc)
target_link_libraries(geneva_dealii_pch PRIVATE geneva_dealii geneva_warnings fmt::fmt)
target_precompile_headers(geneva_dealii_pch PRIVATE
  <deal.II/distributed/tria.h> <deal.II/dofs/dof_handler.h> <deal.II/dofs/dof_tools.h>
  <deal.II/fe/fe_system.h> <deal.II/fe/fe_values.h> <deal.II/lac/affine_constraints.h>
  <deal.II/lac/la_parallel_vector.h> <Eigen/Core> <fmt/format.h>)
