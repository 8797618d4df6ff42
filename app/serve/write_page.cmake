# SPDX-License-Identifier: MIT
# Writes the files of the page as C++:
#   cmake -DOUT=page_files.cpp -DFILES="index.html;page.css" -P write_page.cmake

set(type_html "text/html; charset=utf-8")
set(type_css "text/css; charset=utf-8")
set(type_js "text/javascript; charset=utf-8")
set(type_svg "image/svg+xml")
set(text "// Made from app/serve/page by write_page.cmake.\n#include \"app/serve/page_files.h\"\n\n#include <algorithm>\n")
string(APPEND text "#include <iterator>\n\nnamespace pabd {\nnamespace {\n\nconstexpr PageFile kFiles[] = {\n")
foreach(path IN LISTS FILES)
  get_filename_component(name ${path} NAME)
  get_filename_component(ending ${path} LAST_EXT)
  string(SUBSTRING ${ending} 1 -1 ending)
  if(NOT DEFINED type_${ending})
    message(FATAL_ERROR "${path}: no type for .${ending}")
  endif()
  # A literal has a limit of length; those side by side are one.
  file(READ ${path} hex HEX)
  string(REGEX REPLACE "(................................................................)" "\\1\"\n    \"" hex "${hex}")
  string(REGEX REPLACE "([0-9a-f][0-9a-f])" "\\\\x\\1" hex "${hex}")
  file(SIZE ${path} size)
  string(APPEND text "    {\"${name}\", \"${type_${ending}}\",\n    {\"${hex}\", ${size}}},\n")
endforeach()
string(APPEND text "};\n\n}  // namespace\n\nconst PageFile* find_page_file(std::string_view name) {\n")
string(APPEND text "  const auto* found = std::find_if(std::begin(kFiles), std::end(kFiles), [&](const PageFile& f) { return f.name == name; });\n")
string(APPEND text "  return found == std::end(kFiles) ? nullptr : found;\n}\n\n}  // namespace pabd\n")
file(WRITE ${OUT} "${text}")
