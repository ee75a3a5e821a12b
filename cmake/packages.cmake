# Debian packages, made by `cpack -G DEB` in the build directory: geneva, what programs and Python share
# (libgeneva0.2, with the mesher that it starts), its headers, and the Python package.
set(CPACK_GENERATOR DEB)
# each package has its own
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")
set(CPACK_PACKAGE_CONTACT "${PROJECT_NAME} maintainers")
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${PROJECT_BINARY_DIR}/app)
set(CPACK_COMPONENTS_ALL program library development)
if(GENEVA_BUILD_PYTHON)
  list(APPEND CPACK_COMPONENTS_ALL python)
endif()

# @param part component; package, summary, text: of Debian; DEPENDS and RECOMMENDS: beside what its libraries need
function(geneva_package part package summary text)
  cmake_parse_arguments(PACKAGE "" "SECTION" "DEPENDS;RECOMMENDS" ${ARGN})
  string(TOUPPER ${part} part_name)
  list(JOIN PACKAGE_DEPENDS ", " depends)
  list(JOIN PACKAGE_RECOMMENDS ", " recommends)
  set(CPACK_DEBIAN_${part_name}_PACKAGE_NAME ${package} PARENT_SCOPE)
  set(CPACK_DEBIAN_${part_name}_PACKAGE_SECTION ${PACKAGE_SECTION} PARENT_SCOPE)
  set(CPACK_COMPONENT_${part_name}_DESCRIPTION "${summary}\n${text}" PARENT_SCOPE)
  set(CPACK_DEBIAN_${part_name}_DESCRIPTION "${summary}\n${text}" PARENT_SCOPE)
  set(CPACK_DEBIAN_${part_name}_PACKAGE_DEPENDS "${depends}" PARENT_SCOPE)
  set(CPACK_DEBIAN_${part_name}_PACKAGE_RECOMMENDS "${recommends}" PARENT_SCOPE)
  install(FILES ${PROJECT_SOURCE_DIR}/cmake/debian/copyright DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${package} COMPONENT ${part} EXCLUDE_FROM_ALL)
endfunction()

set(soname libgeneva${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
# The linear algebra of all that solves; the reference BLAS takes many times as long.
set(solving libopenblas0-pthread)
geneva_package(program geneva "Contact stress analysis of Geneva mechanisms"
  "Finds the contact stress between the pin and the slotted wheel of a Geneva\nmechanism, and the stress at the bottom of the slot, by finite elements with an\nerror bar, beside the closed forms of Hertz and Johnson."
  SECTION science DEPENDS "${soname} (= ${PROJECT_VERSION})" ${solving} openmpi-bin
  RECOMMENDS libjs-chart.js libjs-three)
geneva_package(library ${soname} "Contact stress analysis of Geneva mechanisms, shared libraries"
  "What programs against Geneva and its Python package need at run time: the\nlibraries, and the mesher that they start."
  SECTION libs DEPENDS ${solving} RECOMMENDS libjs-chart.js libjs-three)
geneva_package(development libgeneva-dev "Contact stress analysis of Geneva mechanisms, headers"
  "What programs against Geneva need to be built: find_package(geneva)."
  SECTION libdevel DEPENDS "${soname} (= ${PROJECT_VERSION})" libopenmpi-dev nlohmann-json3-dev)
if(GENEVA_BUILD_PYTHON)
  math(EXPR next_minor "${Python_VERSION_MINOR} + 1")
  geneva_package(python python3-geneva "Contact stress analysis of Geneva mechanisms, from Python"
    "Cases, runs, closed forms and sweeps as a module of Python, with arrays of numpy."
    SECTION python
    DEPENDS "${soname} (= ${PROJECT_VERSION})" "python3 (>= ${Python_VERSION_MAJOR}.${Python_VERSION_MINOR})"
            "python3 (<< ${Python_VERSION_MAJOR}.${next_minor})" python3-numpy
    RECOMMENDS python3-mpi4py)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA
    ${PROJECT_SOURCE_DIR}/cmake/debian/postinst ${PROJECT_SOURCE_DIR}/cmake/debian/prerm)
endif()
include(CPack)
