# Every target of this project links geneva_warnings; third-party headers come in as SYSTEM and stay quiet.
add_library(geneva_warnings INTERFACE)
target_compile_options(geneva_warnings INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion -Wnon-virtual-dtor -Wold-style-cast
  -Woverloaded-virtual -Wnull-dereference -Werror)
if(GENEVA_SANITIZE)
  target_compile_options(geneva_warnings INTERFACE -fsanitize=address,undefined -fno-omit-frame-pointer)
  target_link_options(geneva_warnings INTERFACE -fsanitize=address,undefined)
endif()

# A room: a static library whose headers are included as "room/header.h".
function(geneva_room name)
  cmake_parse_arguments(ROOM "" "" "SOURCES;LINK" ${ARGN})
  add_library(geneva_${name} STATIC ${ROOM_SOURCES})
  target_include_directories(geneva_${name} PUBLIC ${PROJECT_SOURCE_DIR})
  target_link_libraries(geneva_${name} PUBLIC ${ROOM_LINK} PRIVATE geneva_warnings)
endfunction()
