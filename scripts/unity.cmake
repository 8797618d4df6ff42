# SPDX-License-Identifier: MIT
# What PABD_UNITY does: eight files of a target are compiled as one that includes them by their paths in the project, so
# that a compiler cache knows them in every checkout (CMake's own UNITY_BUILD writes whole paths).

# Compiled a file at a time all the same: where files have names inside that others have, too, since each is one kind of
# the same thing (shapes, joints, panels, pairs of shapes, tests of one part).
set(apart
  pabd_body pabd_joint pabd_collision pabd_device pabd_overlay pabd_python pabd_peers
  pabd_cli_program test_body test_collision test_device test_gl test_import test_plots test_trace)
set(files_apart
  tests/scene/test_inertia.cpp tests/scene/test_jointed_generators.cpp tests/scene/test_meshes.cpp
  tests/scene/test_read_joints.cpp tests/scene/test_touch.cpp tests/scene/test_tuning.cpp)

# pabd_together(TARGET files of the project…): one file more, which includes these.
function(pabd_together target)
  get_target_property(folder ${target} BINARY_DIR)
  list(TRANSFORM ARGN REPLACE "(.+)" "#include \"\\1\"" OUTPUT_VARIABLE lines)
  list(JOIN lines "\n" text)
  string(MD5 name "${ARGN}")
  string(SUBSTRING ${name} 0 8 name)
  file(CONFIGURE OUTPUT ${folder}/unity/${target}_${name}.cpp CONTENT "${text}\n" @ONLY)
  target_sources(${target} PRIVATE ${folder}/unity/${target}_${name}.cpp)
  list(TRANSFORM ARGN PREPEND ${PROJECT_SOURCE_DIR}/)
  set_source_files_properties(${ARGN} TARGET_DIRECTORY ${target} PROPERTIES HEADER_FILE_ONLY ON)
endfunction()

function(pabd_unite target)
  get_target_property(folder ${target} SOURCE_DIR)
  get_target_property(sources ${target} SOURCES)
  set(batch "")
  foreach(source IN LISTS sources)
    cmake_path(ABSOLUTE_PATH source BASE_DIRECTORY ${folder} NORMALIZE)
    get_source_file_property(definitions ${source} TARGET_DIRECTORY ${target} COMPILE_DEFINITIONS)
    cmake_path(IS_PREFIX PROJECT_BINARY_DIR ${source} made)
    cmake_path(RELATIVE_PATH source BASE_DIRECTORY ${PROJECT_SOURCE_DIR})
    if(definitions OR made OR NOT source MATCHES "\\.cpp$" OR source IN_LIST files_apart
       OR NOT EXISTS ${PROJECT_SOURCE_DIR}/${source})  # shaders and pages are made
      continue()
    endif()
    list(APPEND batch ${source})
    list(LENGTH batch size)
    if(size EQUAL 8)
      pabd_together(${target} ${batch})
      set(batch "")
    endif()
  endforeach()
  list(LENGTH batch size)
  if(size GREATER 1)
    pabd_together(${target} ${batch})
  endif()
endfunction()

function(pabd_unite_below folder)
  get_property(targets DIRECTORY ${folder} PROPERTY BUILDSYSTEM_TARGETS)
  foreach(target IN LISTS targets)
    get_target_property(type ${target} TYPE)
    if(type MATCHES "(STATIC|OBJECT|MODULE)_LIBRARY|EXECUTABLE" AND NOT target IN_LIST apart AND NOT target MATCHES "^pabd_public_")
      pabd_unite(${target})
    endif()
  endforeach()
  get_property(folders DIRECTORY ${folder} PROPERTY SUBDIRECTORIES)
  foreach(below IN LISTS folders)
    pabd_unite_below(${below})
  endforeach()
endfunction()
foreach(folder sim render app tests)
  if(IS_DIRECTORY ${PROJECT_BINARY_DIR}/${folder})
    pabd_unite_below(${PROJECT_SOURCE_DIR}/${folder})
  endif()
endforeach()
