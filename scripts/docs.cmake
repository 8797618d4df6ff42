# SPDX-License-Identifier: MIT
# cmake --build … --target docs: pages of the public headers, opening with the architecture on one page. Not a part of
# the build: Doxygen is looked for, and missed only by who asks for the pages.
find_program(PABD_DOXYGEN doxygen DOC "makes the pages of target docs")
if(PABD_DOXYGEN)
  get_property(headers GLOBAL PROPERTY PABD_PUBLIC_HEADERS)
  list(TRANSFORM headers REPLACE "(.+)" "\"${PROJECT_SOURCE_DIR}/\\1\"")
  list(JOIN headers " " PABD_DOCUMENTED)
  configure_file(scripts/Doxyfile.in Doxyfile @ONLY)
  add_custom_target(docs
    COMMAND ${PABD_DOXYGEN} ${PROJECT_BINARY_DIR}/Doxyfile
    COMMAND ${CMAKE_COMMAND} -E echo "${PROJECT_BINARY_DIR}/docs/html/index.html"
    WORKING_DIRECTORY ${PROJECT_SOURCE_DIR} VERBATIM)
else()
  add_custom_target(docs
    COMMAND ${CMAKE_COMMAND} -E echo "doxygen was not found: install it (apt-get install doxygen) and configure again"
    COMMAND ${CMAKE_COMMAND} -E false VERBATIM)
endif()
