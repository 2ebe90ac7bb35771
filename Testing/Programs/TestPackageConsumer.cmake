# Installs the build tree BUILD into PREFIX, builds the project CONSUMER against it and runs it on PART: it
# must print VOLUME. Then runs what else is installed: the command line, the Python modules and the ParaView
# plugin.
cmake_policy(VERSION 3.16)

function(run_step what)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if (NOT result EQUAL 0)
    message(FATAL_ERROR "${what} failed (${result}):\n${output}")
  endif ()
  message(STATUS "${what}: done")
  set(output "${output}" PARENT_SCOPE)
endfunction ()

file(REMOVE_RECURSE "${PREFIX}" "${BUILD}/test-consumer")
run_step("install" "${CMAKE_COMMAND}" --install "${BUILD}" --prefix "${PREFIX}" --config "${CONFIG}")
# The metadata that an older version left for Python is removed by the next install; those of other packages
# stay.
file(GLOB metadata "${PREFIX}/lib*/python*/site-packages/solidmoments-*.dist-info/METADATA")
if (metadata)
  get_filename_component(folder "${metadata}" DIRECTORY)
  get_filename_component(folder "${folder}" DIRECTORY)
  file(WRITE "${folder}/solidmoments-0.0.1.dist-info/METADATA" "Version: 0.0.1\n")
  file(WRITE "${folder}/others-0.0.1.dist-info/METADATA" "Version: 0.0.1\n")
  run_step("install once more" "${CMAKE_COMMAND}" --install "${BUILD}" --prefix "${PREFIX}" --config "${CONFIG}")
  file(GLOB left RELATIVE "${folder}" "${folder}/*.dist-info")
  list(LENGTH left count)
  if (EXISTS "${folder}/solidmoments-0.0.1.dist-info" OR NOT count EQUAL 2 OR NOT EXISTS "${metadata}")
    message(FATAL_ERROR "after a second install there are ${left}")
  endif ()
  file(REMOVE_RECURSE "${folder}/others-0.0.1.dist-info")
endif ()
file(GLOB_RECURSE static "${PREFIX}/*.a")
if (static)
  message(FATAL_ERROR "static libraries are installed: ${static}")
endif ()
# Nothing in the install may point back into the build tree.
file(GLOB_RECURSE files "${PREFIX}/lib*/cmake/*.cmake")
if (NOT files)
  message(FATAL_ERROR "the install holds no CMake package")
endif ()
foreach (file IN LISTS files)
  file(READ "${file}" text)
  string(FIND "${text}" "${BUILD}/" position)
  file(RELATIVE_PATH below "${PREFIX}" "${file}")
  # The prefix of this test lies in the build tree itself.
  string(REPLACE "${PREFIX}" "" text "${text}")
  string(FIND "${text}" "${BUILD}/" position)
  if (NOT position EQUAL -1)
    message(FATAL_ERROR "${below} names the build tree")
  endif ()
endforeach ()

# The consumer includes every header that is installed in addition to its own.
file(COPY "${CONSUMER}/" DESTINATION "${BUILD}/test-consumer/source")
file(GLOB headers RELATIVE "${PREFIX}/include/solidmoments" "${PREFIX}/include/solidmoments/*.h")
if (NOT headers)
  message(FATAL_ERROR "no headers are installed")
endif ()
set(includes)
foreach (header IN LISTS headers)
  string(APPEND includes "#include <${header}>\n")
endforeach ()
file(WRITE "${BUILD}/test-consumer/source/headers.cxx" "${includes}")
file(APPEND "${BUILD}/test-consumer/source/CMakeLists.txt" "target_sources(consumer PRIVATE headers.cxx)\n")

run_step("configure" "${CMAKE_COMMAND}" -G "${GENERATOR}" -S "${BUILD}/test-consumer/source" -B "${BUILD}/test-consumer"
  "-DCMAKE_PREFIX_PATH=${PREFIX}" "-DCMAKE_C_COMPILER=${CC}" "-DCMAKE_CXX_COMPILER=${CXX}"
  "-DCMAKE_BUILD_TYPE=${CONFIG}" "-DCMAKE_CXX_FLAGS=${FLAGS}")
file(STRINGS "${BUILD}/test-consumer/CMakeCache.txt" found REGEX "^SolidMoments_DIR:")
if (NOT found MATCHES "${PREFIX}")
  message(FATAL_ERROR "find_package took another package: ${found}")
endif ()
run_step("build" "${CMAKE_COMMAND}" --build "${BUILD}/test-consumer" --config "${CONFIG}")

set(program "${BUILD}/test-consumer/consumer")
if (NOT EXISTS "${program}")
  set(program "${BUILD}/test-consumer/${CONFIG}/consumer")
endif ()
execute_process(COMMAND "${program}" "${PART}"
  RESULT_VARIABLE result OUTPUT_VARIABLE printed ERROR_VARIABLE errors OUTPUT_STRIP_TRAILING_WHITESPACE)
message(STATUS "consumer: status ${result}, printed ${printed}, expected ${VOLUME}\n${errors}")
# CMake has no floating point: the value is VOLUME to 9 digits when it prints as 5999.999999… or 6000.000000….
math(EXPR below "${VOLUME} - 1")
if (NOT result EQUAL 0 OR NOT printed MATCHES "^(${VOLUME}(\\.0000000[0-9]*)?|${below}\\.9999999[0-9]*)$")
  message(FATAL_ERROR "the consumer did not print the volume")
endif ()

# The other installed programs and modules run on their own.
if (EXISTS "${PREFIX}/bin/solidmoments")
  run_step("installed solidmoments" "${PREFIX}/bin/solidmoments" "${PART}")
  # What it loads on demand is found in the install, and in one that was moved.
  foreach (place IN ITEMS "${PREFIX}" "${BUILD}/test-moved")
    file(REMOVE_RECURSE "${BUILD}/test-moved")
    if (NOT place STREQUAL PREFIX)
      file(RENAME "${PREFIX}" "${place}")
    endif ()
    run_step("solidmoments in ${place}, OpenGL and triangles" "${place}/bin/solidmoments" --backend opengl
      --mesh "${BUILD}/test-consumer/part.stl" "${PART}")
    if (NOT place STREQUAL PREFIX)
      file(RENAME "${place}" "${PREFIX}")
    endif ()
  endforeach ()
endif ()
if (EXISTS "${PREFIX}/bin/edit_part")
  # Without a file it opens the installed part: its name is in the JSON.
  file(WRITE "${BUILD}/test-consumer/none.events" "MouseMoveEvent 5 5 0 0 0 0\n")
  run_step("installed edit_part" "${PREFIX}/bin/edit_part" --play "${BUILD}/test-consumer/none.events" --json -)
  string(FIND "${output}" "${PREFIX}/share/solidmoments/free_form_part.step" position)
  if (position EQUAL -1)
    message(FATAL_ERROR "edit_part did not open the installed part:\n${output}")
  endif ()
endif ()
if (PYTHON)
  string(REPLACE "," ";" MODULES "${MODULES}")
  run_step("installed Python modules" "${CMAKE_COMMAND}" -E env
    "PYTHONPATH=${PREFIX}/${PYTHON_DESTINATION}:${VTK_PYTHON_PATH}"
    "${PYTHON}" "${CMAKE_CURRENT_LIST_DIR}/TestModules.py" "${SOLIDS}" ${MODULES})
  run_step("installed mass_properties()" "${CMAKE_COMMAND}" -E env
    "PYTHONPATH=${PREFIX}/${PYTHON_DESTINATION}:${VTK_PYTHON_PATH}"
    "${PYTHON}" -B "${CMAKE_CURRENT_LIST_DIR}/../../Examples/Python/one_call.py" "${PART}")
endif ()
if (PVPYTHON)
  file(GLOB_RECURSE plugin "${PREFIX}/lib*/SolidMoments.so")
  run_step("installed ParaView plugin" "${PVPYTHON}" "${CMAKE_CURRENT_LIST_DIR}/../ParaViewPlugin/TestPluginLoads.py"
    "${plugin}" "${PART}" "${VOLUME}")
endif ()
