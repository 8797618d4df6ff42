# SPDX-License-Identifier: MIT
# Writes the texts of shaders as C++:
#   cmake -DOUT=shader_files.cpp -DFOLDER=render/gl -DFILES="a.glsl;b.glsl" -P write_shaders.cmake

set(text "// Made from ${FOLDER}/shaders by write_shaders.cmake.\n#include \"${FOLDER}/shader_files.h\"\n\n")
string(APPEND text "namespace pabd::shaders {\n")
foreach(path IN LISTS FILES)
  get_filename_component(file ${path} NAME)
  string(REGEX REPLACE "\\.glsl$" "" name ${file})
  string(REPLACE "." "_" name ${name})
  file(READ ${path} source)
  string(APPEND text "const ShaderPart ${name} = {\"${file}\", R\"glsl(${source})glsl\"};\n")
endforeach()
string(APPEND text "}  // namespace pabd::shaders\n")
file(WRITE ${OUT} "${text}")
