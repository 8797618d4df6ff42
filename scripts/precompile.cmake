# Headers that nearly every file reads, compiled twice: for the program, and with Catch2 for the tests.

file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/precompiled.cpp CONTENT "")
set(headers
  <Eigen/Dense> <algorithm> <array> <cmath> <cstdint> <filesystem> <fmt/format.h> <fstream> <functional> <limits> <map>
  <memory> <optional> <set> <span> <sstream> <string> <string_view> <utility> <variant> <vector>)

add_library(pabd_precompiled OBJECT ${PROJECT_BINARY_DIR}/precompiled.cpp)
target_link_libraries(pabd_precompiled PRIVATE pabd_flags)
target_precompile_headers(pabd_precompiled PRIVATE ${headers})

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

foreach(folder sim render app)
  pabd_reuse_precompiled(${PROJECT_SOURCE_DIR}/${folder} pabd_precompiled)
endforeach()

if(PABD_TESTS)
  find_package(Catch2 2.13 REQUIRED)
  add_library(pabd_precompiled_tests OBJECT ${PROJECT_BINARY_DIR}/precompiled.cpp)
  target_link_libraries(pabd_precompiled_tests PRIVATE pabd_flags Catch2::Catch2)
  target_compile_options(pabd_precompiled_tests PRIVATE $<$<NOT:$<CONFIG:Debug>>:-O1>)
  target_precompile_headers(pabd_precompiled_tests PRIVATE ${headers} <catch2/catch.hpp>)
  pabd_reuse_precompiled(${PROJECT_SOURCE_DIR}/tests pabd_precompiled_tests)
endif()
