# SPDX-License-Identifier: MIT
# pabd_embed_shaders(FOLDER names...): GLSL becomes part of the program. FOLDER/shaders/ground.frag.glsl, named
# "ground.frag", is shaders::ground_frag of FOLDER/shader_files.h. The header knows only names, so that another text
# compiles one file, shader_files.cpp. A name with a folder, "sim/collision/box_box.inl", is a text that C++ compiles too:
# write_shaders.cmake translates it.
function(pabd_embed_shaders folder)
  set(writer ${PROJECT_SOURCE_DIR}/render/gl/write_shaders.cmake)
  foreach(shader IN LISTS ARGN)
    if(shader MATCHES "^(.*/)([a-z_]+)\\.inl$")
      list(APPEND shader_files ${PROJECT_SOURCE_DIR}/${shader})
      set(name ${CMAKE_MATCH_2})
    else()
      list(APPEND shader_files ${CMAKE_CURRENT_SOURCE_DIR}/shaders/${shader}.glsl)
      string(REPLACE "." "_" name ${shader})
    endif()
    string(APPEND shader_constants "extern const ShaderPart ${name};\n")
  endforeach()
  file(CONFIGURE OUTPUT shader_files.h CONTENT "// The files of @folder@/shaders.
#pragma once

#include \"render/gl/shader_stage.h\"

namespace pabd::shaders {
@shader_constants@}  // namespace pabd::shaders
" @ONLY)
  add_custom_command(OUTPUT shader_files.cpp
    COMMAND ${CMAKE_COMMAND} -DOUT=shader_files.cpp -DFOLDER=${folder} "-DFILES=${shader_files}" -P ${writer}
    DEPENDS ${shader_files} ${writer} VERBATIM)
endfunction()
