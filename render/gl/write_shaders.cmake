# SPDX-License-Identifier: MIT
# Writes the texts of shaders as C++:
#   cmake -DOUT=shader_files.cpp -DFOLDER=render/gl -DFILES="a.glsl;b.glsl" -P write_shaders.cmake
# Texts *.inl are translated from what they have in common with C++ (sim/collision/pair_text.h): numbers with a point become
# `wide`, `T&` becomes `inout T`, `static constexpr` becomes `const`, and what tells a compiler to inline goes.

set(text "// Made from ${FOLDER}/shaders by write_shaders.cmake.\n#include \"${FOLDER}/shader_files.h\"\n\n")
string(APPEND text "namespace pabd::shaders {\n")
foreach(path IN LISTS FILES)
  get_filename_component(file ${path} NAME)
  string(REGEX REPLACE "\\.(glsl|inl)$" "" name ${file})
  string(REPLACE "." "_" name ${name})
  file(READ ${path} source)
  if(path MATCHES "\\.inl$")
    string(REGEX REPLACE "([0-9]+\\.[0-9]+(e-?[0-9]+)?)" "wide(\\1lf)" source "${source}")
    string(REGEX REPLACE "([A-Za-z0-9_]+)& " "inout \\1 " source "${source}")
    string(REPLACE "static constexpr" "const" source "${source}")
    string(REPLACE "[[gnu::always_inline]] static inline " "" source "${source}")
  endif()
  string(APPEND text "const ShaderPart ${name} = {\"${file}\", R\"glsl(${source})glsl\"};\n")
endforeach()
string(APPEND text "}  // namespace pabd::shaders\n")
file(WRITE ${OUT} "${text}")
