# SPDX-License-Identifier: MIT
# What PABD_UNITY compiles a file at a time all the same: where files have names inside that others have, too, since
# each is one kind of the same thing (shapes, joints, panels, pairs of shapes, tests of one part).
foreach(target
  pabd_body pabd_joint pabd_collision pabd_device pabd_overlay pabd_python pabd_peers
  pabd_cli_program test_body test_collision test_device test_gl test_import test_plots test_trace)
  if(TARGET ${target})
    set_target_properties(${target} PROPERTIES UNITY_BUILD OFF)
  endif()
endforeach()
if(TARGET test_scene)
  set(apart inertia jointed_generators meshes read_joints touch tuning)
  list(TRANSFORM apart REPLACE "(.+)" "${PROJECT_SOURCE_DIR}/tests/scene/test_\\1.cpp")
  set_source_files_properties(${apart} TARGET_DIRECTORY test_scene PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
endif()
