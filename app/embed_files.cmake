# SPDX-License-Identifier: MIT
# pabd_embed_files(OUT.cpp FUNCTION files…): files become part of the program. OUT.cpp, in the build folder, defines
#   std::string_view pabd::FUNCTION(std::string_view name);   // its bytes; without data: there is no such file
if(NOT CMAKE_SCRIPT_MODE_FILE)
  set(PABD_EMBED_FILES ${CMAKE_CURRENT_LIST_FILE} CACHE INTERNAL "")
  function(pabd_embed_files out function)
    add_custom_command(OUTPUT ${out}
      COMMAND ${CMAKE_COMMAND} -DOUT=${out} -DFUNCTION=${function} "-DFILES=${ARGN}" -P ${PABD_EMBED_FILES}
      DEPENDS ${ARGN} ${PABD_EMBED_FILES} VERBATIM)
  endfunction()
  return()
endif()

set(text "// Made by embed_files.cmake.\n#include <string_view>\n\nnamespace pabd {\n\n")
string(APPEND text "std::string_view ${FUNCTION}(std::string_view name);\n\nstd::string_view ${FUNCTION}(std::string_view name) {\n")
foreach(path IN LISTS FILES)
  get_filename_component(name ${path} NAME)
  # A literal has a limit of length; those side by side are one.
  file(READ ${path} hex HEX)
  string(REGEX REPLACE "(................................................................)" "\\1\"\n    \"" hex "${hex}")
  string(REGEX REPLACE "([0-9a-f][0-9a-f])" "\\\\x\\1" hex "${hex}")
  file(SIZE ${path} size)
  string(APPEND text "  if (name == \"${name}\") return {\n    \"${hex}\", ${size}};\n")
endforeach()
string(APPEND text "  return {};\n}\n\n}  // namespace pabd\n")
file(WRITE ${OUT} "${text}")
