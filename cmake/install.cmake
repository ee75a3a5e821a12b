# Geneva as a library: libgeneva-core with cases and everything that is computed without finite elements, libgeneva with
# the contact analysis. Their users need no library of ours but these, and MPI's and nlohmann-json's headers.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

function(geneva_library name file)
  cmake_parse_arguments(LIBRARY "" "" "ROOMS;PUBLIC;PRIVATE" ${ARGN})
  set(objects "")
  foreach(room IN LISTS LIBRARY_ROOMS)
    list(APPEND objects $<TARGET_OBJECTS:geneva_${room}>)
  endforeach()
  add_library(${name} SHARED ${objects})
  add_library(geneva::${file} ALIAS ${name})
  target_link_libraries(${name} PUBLIC ${LIBRARY_PUBLIC} PRIVATE ${LIBRARY_PRIVATE})
  target_include_directories(${name} INTERFACE
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}> $<BUILD_INTERFACE:${PROJECT_BINARY_DIR}/generated>
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/geneva>)
  set_target_properties(${name} PROPERTIES
    LINKER_LANGUAGE CXX EXPORT_NAME ${file} VERSION ${PROJECT_VERSION}
    SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR} INSTALL_RPATH "$ORIGIN"
    # beside the mesher, which they look for there
    LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/app)
endfunction()

geneva_library(geneva_core_library core
  ROOMS base loads mesh_data case tables report api
  PUBLIC nlohmann_json::nlohmann_json
  PRIVATE fmt::fmt PNG::PNG NLopt::nlopt geneva_udunits ${CMAKE_DL_LIBS})
set_target_properties(geneva_core_library PROPERTIES OUTPUT_NAME geneva-core)
geneva_library(geneva_library geneva
  ROOMS mesh fem model post api_analysis
  PUBLIC geneva_core_library MPI::MPI_CXX
  PRIVATE fmt::fmt geneva_dealii geneva_cholmod ${CMAKE_DL_LIBS})
set_target_properties(geneva_library PROPERTIES OUTPUT_NAME geneva)

# The headers of api/ and what they include, so that no list of them grows stale.
function(geneva_public_headers result)
  set(found "")
  set(waiting api/geneva.h)
  while(waiting)
    list(POP_FRONT waiting header)
    if(header IN_LIST found OR NOT EXISTS ${PROJECT_SOURCE_DIR}/${header})
      continue()
    endif()
    list(APPEND found ${header})
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${header})
    file(STRINGS ${PROJECT_SOURCE_DIR}/${header} includes REGEX "^#include \"")
    list(TRANSFORM includes REPLACE "^#include \"([^\"]+)\".*" "\\1")
    list(APPEND waiting ${includes})
  endwhile()
  set(${result} ${found} PARENT_SCOPE)
endfunction()
geneva_public_headers(headers)
foreach(header IN LISTS headers)
  get_filename_component(folder ${header} DIRECTORY)
  install(FILES ${header} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/geneva/${folder} COMPONENT development)
endforeach()
install(FILES ${PROJECT_BINARY_DIR}/generated/api/version.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/geneva/api
  COMPONENT development)

# What geneva starts is found from where it lies itself, see base/installed_program.h.
install(TARGETS geneva DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program)
install(TARGETS geneva-solver geneva-cad DESTINATION ${CMAKE_INSTALL_LIBEXECDIR}/geneva COMPONENT program)
install(TARGETS geneva-mesher DESTINATION ${CMAKE_INSTALL_LIBEXECDIR}/geneva COMPONENT library)
install(TARGETS geneva_core_library geneva_library EXPORT genevaTargets
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT library NAMELINK_COMPONENT development)
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/geneva)
install(EXPORT genevaTargets NAMESPACE geneva:: DESTINATION ${package_folder} COMPONENT development)
configure_package_config_file(cmake/genevaConfig.cmake.in ${PROJECT_BINARY_DIR}/generated/genevaConfig.cmake
  INSTALL_DESTINATION ${package_folder})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/generated/genevaConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/generated/genevaConfig.cmake ${PROJECT_BINARY_DIR}/generated/genevaConfigVersion.cmake
  DESTINATION ${package_folder} COMPONENT development)

install(DIRECTORY ${PROJECT_BINARY_DIR}/documents/ DESTINATION ${CMAKE_INSTALL_MANDIR}/man1
  COMPONENT program FILES_MATCHING PATTERN "*.1.gz")
install(FILES ${PROJECT_BINARY_DIR}/documents/geneva.bash RENAME geneva
  DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions COMPONENT program)
install(FILES ${PROJECT_BINARY_DIR}/documents/_geneva DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/site-functions
  COMPONENT program)
install(FILES ${PROJECT_BINARY_DIR}/documents/geneva.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d
  COMPONENT program)
install(FILES model/input/materials.prm DESTINATION ${CMAKE_INSTALL_DATADIR}/geneva COMPONENT program)
install(DIRECTORY cases DESTINATION ${CMAKE_INSTALL_DATADIR}/geneva COMPONENT program
  PATTERN results EXCLUDE PATTERN ".results*" EXCLUDE)
install(DIRECTORY doc DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program)
install(FILES ${PROJECT_SOURCE_DIR}/build/web/calculator.html DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program OPTIONAL)  # scripts/calculator
install(FILES README.md CHANGELOG.md LICENSE CITATION.cff DESTINATION ${CMAKE_INSTALL_DOCDIR}
  COMPONENT program)
