# Debian's python3, of which pybind11-dev, numpy and mpi4py are, and not one that stands before it on the path.
find_program(GENEVA_PYTHON NAMES python3 PATHS /usr/bin NO_DEFAULT_PATH)
find_program(GENEVA_PYTHON NAMES python3)
set(Python_EXECUTABLE ${GENEVA_PYTHON})
find_package(Python COMPONENTS Interpreter Development.Module)
find_package(pybind11 2.10 CONFIG)
set(GENEVA_BUILD_PYTHON AUTO CACHE STRING "The Python package: ON, OFF, or AUTO, where pybind11 or tests want it")
if(GENEVA_BUILD_PYTHON STREQUAL "AUTO")
  set(GENEVA_BUILD_PYTHON OFF)
  # A sanitizer's runtime must be loaded before the interpreter is.
  if((GENEVA_BUILD_TESTS OR pybind11_FOUND) AND NOT GENEVA_SANITIZE AND NOT GENEVA_FUZZ)
    set(GENEVA_BUILD_PYTHON ON)
  endif()
endif()
if(GENEVA_BUILD_PYTHON AND NOT pybind11_FOUND)
  message(FATAL_ERROR "The Python package needs Debian's pybind11-dev and python3-dev (scripts/setup installs them); "
                      "or configure with -D GENEVA_BUILD_PYTHON=OFF")
endif()
