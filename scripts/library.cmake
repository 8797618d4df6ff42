# SPDX-License-Identifier: MIT
# What others link: pabd::sim, pabd::visual, pabd::output and pabd::render, in this build and, installed, for
# find_package(pabd) and pkg-config.
#
# Inside, every folder is a library of its own, so that the layers hold; outside there are four archives of the same
# objects. They ask of their users C++20, Eigen and one definition (PABD_ALIGNMENT), and for nothing that pabd is
# compiled with: no instructions of one processor, no warnings, no precompiled headers. The libraries behind them are
# linked, their headers are not needed.
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

find_package(PNG REQUIRED)
find_package(Threads REQUIRED)
find_package(ZLIB REQUIRED)
pkg_check_modules(QHULL REQUIRED IMPORTED_TARGET qhull_r)
pkg_check_modules(DEFLATE REQUIRED IMPORTED_TARGET libdeflate)

set(PABD_PACKAGE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/pabd)
set(PABD_PKGCONFIG_DIR ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
set(PABD_HEADER_DIR ${CMAKE_INSTALL_INCLUDEDIR}/pabd)
file(RELATIVE_PATH PABD_PREFIX_FROM_PKGCONFIG /prefix/${PABD_PKGCONFIG_DIR} /prefix)

# pabd_public_library(NAME ABOUT "one line" PARTS libraries of this build… USES public libraries…
#                     LINKS targets behind it… FLAGS the same for a linker… HEADERS files…)
function(pabd_public_library name)
  cmake_parse_arguments(ARG "" "ABOUT" "PARTS;USES;LINKS;FLAGS;HEADERS" ${ARGN})
  set(target pabd_public_${name})
  list(TRANSFORM ARG_PARTS REPLACE "(.+)" "$<TARGET_OBJECTS:\\1>" OUTPUT_VARIABLE objects)
  list(TRANSFORM ARG_HEADERS PREPEND ${PROJECT_SOURCE_DIR}/ OUTPUT_VARIABLE headers)
  add_library(${target} STATIC ${objects})
  add_library(pabd::${name} ALIAS ${target})
  set_target_properties(${target} PROPERTIES LINKER_LANGUAGE CXX
    OUTPUT_NAME pabd_${name} EXPORT_NAME ${name} ARCHIVE_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/lib)
  target_sources(${target} PUBLIC FILE_SET HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR} FILES ${headers})
  target_compile_features(${target} PUBLIC cxx_std_20)
  target_compile_definitions(${target} PUBLIC ${PABD_ALIGNMENT})
  list(TRANSFORM ARG_USES PREPEND pabd_public_ OUTPUT_VARIABLE uses)
  target_link_libraries(${target} PUBLIC ${uses} Eigen3::Eigen PRIVATE ${ARG_LINKS})
  set_property(GLOBAL APPEND PROPERTY PABD_PUBLIC_HEADERS ${ARG_HEADERS})

  if(PABD_INSTALL)
    install(TARGETS ${target} EXPORT pabd
            ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} FILE_SET HEADERS DESTINATION ${PABD_HEADER_DIR})
    list(TRANSFORM ARG_USES PREPEND pabd- OUTPUT_VARIABLE requires)
    list(JOIN requires " " requires)
    list(JOIN ARG_FLAGS " " flags)
    configure_file(scripts/pabd.pc.in pabd-${name}.pc @ONLY)
    install(FILES ${PROJECT_BINARY_DIR}/pabd-${name}.pc DESTINATION ${PABD_PKGCONFIG_DIR})
  endif()
endfunction()

pabd_public_library(sim ABOUT "Projective Affine Body Dynamics: scenes, time steps, reports"
  PARTS pabd_base pabd_math pabd_body pabd_potential pabd_bond pabd_joint pabd_collision pabd_solver pabd_scene pabd_trace
  LINKS PkgConfig::QHULL Threads::Threads fmt::fmt
  FLAGS -lqhull_r -lfmt -pthread
  HEADERS
    sim/base/error.h
    sim/base/output_path.h
    sim/base/utf8.h
    sim/body/body_look.h
    sim/body/collision_groups.h
    sim/body/external_force.h
    sim/body/force_table.h
    sim/body/compound.h
    sim/body/convex_hull.h
    sim/body/hull.h
    sim/body/joint.h
    sim/body/keyed.h
    sim/body/line_cut.h
    sim/body/mass_properties.h
    sim/body/model.h
    sim/body/rare.h
    sim/body/shape.h
    sim/body/shape_kind.h
    sim/body/state.h
    sim/body/surface_friction.h
    sim/collision/ray_cast.h
    sim/joint/attach.h
    sim/math/types.h
    sim/potential/barrier.h
    sim/scene/body_entry.h
    sim/scene/builder.h
    sim/scene/field.h
    sim/scene/generator_entries.h
    sim/scene/joint_entry.h
    sim/scene/scene.h
    sim/scene/tuning.h
    sim/scene/write_scene.h
    sim/solver/parameter_table.h
    sim/solver/params.h
    sim/solver/report.h
    sim/solver/time_step.h
    sim/trace/trace.h)

pabd_public_library(visual ABOUT "what is to be seen of a simulation, without OpenGL"
  PARTS pabd_visual
  USES sim
  HEADERS
    render/visual/bounds.h
    render/visual/build_visual.h
    render/visual/camera_control.h
    render/visual/camera_path.h
    render/visual/framing.h
    render/visual/picture_theme.h
    render/visual/value_map.h
    render/visual/visual_scene.h)

pabd_public_library(output ABOUT "images, videos, comparison of images"
  PARTS pabd_output
  USES sim
  LINKS PNG::PNG ZLIB::ZLIB PkgConfig::DEFLATE Threads::Threads fmt::fmt
  FLAGS -lpng -lz -ldeflate -lfmt -pthread
  HEADERS
    render/output/async_sink.h
    render/output/compare_images.h
    render/output/frame_sink.h
    render/output/video_options.h
    render/output/image.h
    render/output/png.h)

set(window)
set(window_flags)
if(PABD_WINDOW)
  find_package(glfw3 3.3 REQUIRED)
  set(window glfw)
  set(window_flags -lglfw)
endif()
pabd_public_library(render ABOUT "draws what is to be seen, with OpenGL, on a screen or without one"
  PARTS pabd_context pabd_render
  USES visual output
  LINKS ${window} ${CMAKE_DL_LIBS} fmt::fmt
  FLAGS ${window_flags} -ldl -lfmt
  HEADERS
    render/context/context.h
    render/gl/quality.h
    render/gl/renderer.h)

if(PABD_INSTALL)
  install(EXPORT pabd NAMESPACE pabd:: DESTINATION ${PABD_PACKAGE_DIR} FILE pabd-targets.cmake)
  configure_package_config_file(scripts/pabd-config.cmake.in pabd-config.cmake INSTALL_DESTINATION ${PABD_PACKAGE_DIR})
  write_basic_package_version_file(pabd-config-version.cmake COMPATIBILITY SameMinorVersion)
  install(FILES ${PROJECT_BINARY_DIR}/pabd-config.cmake ${PROJECT_BINARY_DIR}/pabd-config-version.cmake
          DESTINATION ${PABD_PACKAGE_DIR})
endif()
