# SPDX-License-Identifier: MIT
# Writes the texts of shaders as C++: cmake -DOUT=shader_files.cpp -DFILES="a.glsl;b.glsl" -P embed_shaders.cmake

set(text "// Made from render/gl/shaders by embed_shaders.cmake.\n#include \"render/gl/shader_files.h\"\n\n")
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
