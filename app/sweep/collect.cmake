# SPDX-License-Identifier: MIT
find_package(nlohmann_json 3.11 REQUIRED)

# What comes out of a sweep: tables, pictures, a ranking and a report.
add_library(pabd_sweep_collect STATIC
  collect_grid.cpp
  collect_plots.cpp
  collect_ranking.cpp
  collect_read.cpp
  collect_report.cpp
  collect_sheet.cpp
  collect_sweep.cpp
  collect_table.cpp
  collect_write.cpp
  metrics.cpp)
target_link_libraries(pabd_sweep_collect PUBLIC pabd_base pabd_plot pabd_output pabd_trace pabd_flags nlohmann_json::nlohmann_json
  PRIVATE pabd_scene pabd_solver pabd_visual fmt::fmt)
target_compile_definitions(pabd_sweep_collect PRIVATE PABD_VERSION="${PROJECT_VERSION}")
