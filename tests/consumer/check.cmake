# SPDX-License-Identifier: MIT
# Installs the build into an empty folder, and uses what is there as a stranger would: by find_package(), by
# pkg-config, and by the program. Run by ctest with BUILD, SOURCE, WORK, COMPILER, LIBRARIES (a folder) and VERSION.

# run(DESCRIPTION command…): its standard output in `output`.
function(run what)
  execute_process(COMMAND ${ARGN} WORKING_DIRECTORY ${WORK} RESULT_VARIABLE status OUTPUT_VARIABLE text
                  ERROR_VARIABLE complaint)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${what}: ${status}\n${text}\n${complaint}")
  endif()
  set(output "${text}" PARENT_SCOPE)
endfunction()

# expect(PATTERN): in what the last command said.
function(expect pattern)
  if(NOT output MATCHES "${pattern}")
    message(FATAL_ERROR "expected '${pattern}', got:\n${output}")
  endif()
endfunction()

set(prefix ${WORK}/prefix)
file(REMOVE_RECURSE ${WORK})
file(MAKE_DIRECTORY ${WORK})
run("installing" ${CMAKE_COMMAND} --install ${BUILD} --prefix ${prefix})

# What users are asked to compile with: C++20, the alignment, and nothing else.
file(READ ${prefix}/${LIBRARIES}/cmake/pabd/pabd-targets.cmake targets)
if(targets MATCHES "-march|-W[a-z]|-std|-ffp|-fno|${BUILD}|nlohmann|INTERFACE_PRECOMPILE")
  message(FATAL_ERROR "the installed targets ask for '${CMAKE_MATCH_0}'")
endif()

# As the compiler comes, and with every instruction of this machine: types have the same layout.
foreach(flags "-O1" "-O1 -march=native")
  run("configuring" ${CMAKE_COMMAND} -S ${SOURCE} -B ${WORK}/build -G Ninja -DCMAKE_PREFIX_PATH=${prefix}
      -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_CXX_FLAGS=${flags})
  run("building" ${CMAKE_COMMAND} --build ${WORK}/build)
  run("running" ${WORK}/build/consumer ${WORK}/picture.png)
  expect("^5 bodies, joint error [0-9.]+e-")
  file(SIZE ${WORK}/picture.png bytes)
  if(bytes LESS 5000)
    message(FATAL_ERROR "the picture has ${bytes} bytes")
  endif()
endforeach()

set(ENV{PKG_CONFIG_PATH} ${prefix}/${LIBRARIES}/pkgconfig)
run("pkg-config" pkg-config --modversion pabd-sim)
expect("^${VERSION}\n")
run("pkg-config" pkg-config --cflags --libs pabd-sim)
separate_arguments(flags UNIX_COMMAND "${output}")
run("compiling" ${COMPILER} -std=c++20 ${SOURCE}/steps.cpp -o ${WORK}/steps ${flags})
run("running" ${WORK}/steps)
expect("^95\\.095\n$")  # 100 − ½ g t²
run("pkg-config" pkg-config --cflags --libs pabd-render)
separate_arguments(flags UNIX_COMMAND "${output}")
run("compiling" ${COMPILER} -std=c++20 ${SOURCE}/consumer.cpp -o ${WORK}/consumer ${flags})
run("running" ${WORK}/consumer ${WORK}/other.png)

# The program finds the scenes that were installed with it: one that the sources do not have.
file(RENAME ${prefix}/share/pabd/scenes/two_boxes.json ${prefix}/share/pabd/scenes/only_here.json)
run("pabd" ${prefix}/bin/pabd run only_here --steps 1)

# What desktops and shells look for.
foreach(file applications/pabd.desktop icons/hicolor/scalable/apps/pabd.svg bash-completion/completions/pabd
        zsh/site-functions/_pabd fish/vendor_completions.d/pabd.fish man/man1/pabd-render.1)
  if(NOT EXISTS ${prefix}/share/${file})
    message(FATAL_ERROR "share/${file} was not installed")
  endif()
endforeach()
file(READ ${prefix}/share/applications/pabd.desktop entry)
foreach(line "Type=Application" "Exec=pabd view %f" "Icon=pabd" "Terminal=false" "StartupWMClass=pabd")
  if(NOT entry MATCHES "\n${line}\n")
    message(FATAL_ERROR "the desktop entry lacks '${line}'")
  endif()
endforeach()
