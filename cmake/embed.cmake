# Writes a source file that holds text files as strings: cmake -D OUTPUT=... -D HEADER=... -D NAMESPACE=...
# -D ASSETS=name=file;... -P embed.cmake
set(source "#include \"${HEADER}\"\n\nnamespace ${NAMESPACE} {\n\n")
foreach(asset IN LISTS ASSETS)
  string(REGEX MATCH "^([^=]+)=(.+)$" matched "${asset}")
  set(name ${CMAKE_MATCH_1})
  file(READ ${CMAKE_MATCH_2} text)
  string(APPEND source "const std::string_view ${name} = R\"asset(${text})asset\";\n\n")
endforeach()
file(WRITE ${OUTPUT} "${source}}  // namespace ${NAMESPACE}\n")
