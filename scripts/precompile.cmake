# SPDX-License-Identifier: MIT
# Headers that nearly every file reads, compiled once for each set of flags: for what is optimised, for what
# is quick to compile (the command line, the window, …), and with Catch2 for the tests.

file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/precompiled.cpp CONTENT "")
set(headers
  <Eigen/Dense> <algorithm> <array> <cmath> <cstdint> <filesystem> <fmt/format.h> <fstream> <functional> <limits> <map>
  <memory> <optional> <set> <span> <sstream> <string> <string_view> <utility> <variant> <vector>)

# pabd_sum_precompiled(NAME HEADERS…): what ccache looks at in place of what the compiler makes of the headers, which are
# 170 MB and others in every checkout.
function(pabd_sum_precompiled name)
  set(source ${PROJECT_BINARY_DIR}/CMakeFiles/${name}.dir/headers.cpp)
  list(TRANSFORM ARGN PREPEND "#include ")
  list(JOIN ARGN "\n" text)
  file(CONFIGURE OUTPUT ${source} CONTENT "${text}\n")
  get_target_property(folders Eigen3::Eigen INTERFACE_INCLUDE_DIRECTORIES)
  list(TRANSFORM folders PREPEND -isystem)
  set(preprocess ${CMAKE_CXX_COMPILER} -std=c++20 ${folders})
  execute_process(COMMAND ${preprocess} -E -P ${source} OUTPUT_VARIABLE text COMMAND_ERROR_IS_FATAL ANY)
  string(SHA256 sum "${text}")
  if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
    set(made gch)
  else()
    set(made pch)
  endif()
  file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/CMakeFiles/${name}.dir/cmake_pch.hxx.${made}.sum CONTENT "${sum}\n")
  execute_process(COMMAND ${preprocess} -M ${source} OUTPUT_VARIABLE used COMMAND_ERROR_IS_FATAL ANY)
  string(REGEX MATCHALL "/usr/[^ \n]+" used "${used}")
  set(paths "")
  foreach(path IN LISTS used)  # clang writes some with "/../" and "/./"
    cmake_path(NORMAL_PATH path)
    list(APPEND paths ${path})
  endforeach()
  list(REMOVE_DUPLICATES paths)
  set_property(DIRECTORY ${PROJECT_SOURCE_DIR} APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${paths})
endfunction()

# pabd_precompile(NAME LINKS libraries… OPTIONS flags… HEADERS more headers…)
function(pabd_precompile name)
  cmake_parse_arguments(ARG "" "" "LINKS;OPTIONS;HEADERS" ${ARGN})
  add_library(${name} OBJECT ${PROJECT_BINARY_DIR}/precompiled.cpp)
  target_link_libraries(${name} PRIVATE pabd_flags ${ARG_LINKS})
  target_compile_options(${name} PRIVATE ${ARG_OPTIONS})
  target_precompile_headers(${name} PRIVATE ${headers} ${ARG_HEADERS})
  if(CCACHE)
    pabd_sum_precompiled(${name} ${headers} ${ARG_HEADERS})
  endif()
endfunction()

# Every target of a folder and of those below it.
function(pabd_reuse_precompiled folder from)
  get_property(targets DIRECTORY ${folder} PROPERTY BUILDSYSTEM_TARGETS)
  foreach(target IN LISTS targets)
    get_target_property(type ${target} TYPE)
    get_target_property(own ${target} PABD_OWN_HEADERS)
    if(type MATCHES "LIBRARY|EXECUTABLE" AND NOT type STREQUAL INTERFACE_LIBRARY AND NOT own)
      target_precompile_headers(${target} REUSE_FROM ${from})
    endif()
  endforeach()
  get_property(folders DIRECTORY ${folder} PROPERTY SUBDIRECTORIES)
  foreach(below IN LISTS folders)
    pabd_reuse_precompiled(${below} ${from})
  endforeach()
endfunction()

pabd_precompile(pabd_precompiled OPTIONS ${PABD_MODULE_CODE})
foreach(folder sim render)
  pabd_reuse_precompiled(${PROJECT_SOURCE_DIR}/${folder} pabd_precompiled)
endforeach()

if(PABD_APP)
  find_package(nlohmann_json 3.11 REQUIRED)
  pabd_precompile(pabd_precompiled_quick LINKS nlohmann_json::nlohmann_json OPTIONS ${PABD_QUICK_TO_COMPILE}
    HEADERS <nlohmann/json.hpp>)
  foreach(folder plots overlay session workbench frames)
    pabd_reuse_precompiled(${PROJECT_SOURCE_DIR}/app/${folder} pabd_precompiled)
  endforeach()
  set(quick export gui sweep cli)
  if(PABD_SERVE)
    list(APPEND quick serve)
  endif()
  foreach(folder IN LISTS quick)
    pabd_reuse_precompiled(${PROJECT_SOURCE_DIR}/app/${folder} pabd_precompiled_quick)
  endforeach()
endif()

if(PABD_TESTS)
  find_package(Catch2 2.13 REQUIRED)
  pabd_precompile(pabd_precompiled_tests LINKS Catch2::Catch2 nlohmann_json::nlohmann_json
    OPTIONS ${PABD_TEST_OPTIONS} HEADERS <catch2/catch.hpp> <nlohmann/json.hpp>)
  pabd_reuse_precompiled(${PROJECT_SOURCE_DIR}/tests pabd_precompiled_tests)
endif()
