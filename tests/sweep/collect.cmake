# SPDX-License-Identifier: MIT
pabd_add_test(test_sweep_collect
  test_collect_pictures.cpp
  test_collect_ranking.cpp
  test_collect_read.cpp
  test_collect_report.cpp
  test_collect_table.cpp
  LIBS pabd_sweep_collect pabd_scene)
