# The one helper that registers tests.
find_program(SOLIDMOMENTS_XVFB_RUN xvfb-run)
if (NOT SOLIDMOMENTS_XVFB_RUN)
  message(FATAL_ERROR "The tests need xvfb-run (Debian: xvfb xauth). Configure with "
    "-DSOLIDMOMENTS_BUILD_TESTING=OFF to do without them.")
endif ()

# solidmoments_resolve_command(<variable>): puts the file of a target, or the driver of a test and the test's
# name, in place of the first word of a command. add_test itself finds a target only where no launcher stands
# before it.
function(solidmoments_resolve_command variable)
  list(GET ${variable} 0 program)
  list(REMOVE_AT ${variable} 0)
  get_property(driver GLOBAL PROPERTY solidmoments_driver_of_${program})
  if (driver)
    set(program "$<TARGET_FILE:${driver}>" ${program})
  elseif (TARGET "${program}")
    set(program "$<TARGET_FILE:${program}>")
  endif ()
  set(${variable} ${program} ${${variable}} PARENT_SCOPE)
endfunction ()

# solidmoments_add_test(NAME <name> LABELS <label>... [XVFB | NODISPLAY] [TIMEOUT <seconds>]
#   [ENVIRONMENT <NAME=value>...] [FIXTURE <setup>...] [STATUS <n> TEXT <regex> [WITHOUT <regex>]]
#   COMMAND <command>...)
#
# XVFB runs the command on a virtual X display of its own, NODISPLAY without any; neither leaves the display
# to the caller's environment, for programs that do not care. Where a word of the command is
# SOLIDMOMENTS_TEST_OUTPUT, the test gets the folder of its name there. Labels: value image error gpu plugin
# package robust. The command may begin with a target or with a test of a driver
# (solidmoments_add_test_driver). With STATUS and TEXT the command must end with that status and print a text
# that matches, and none that matches WITHOUT: PASS_REGULAR_EXPRESSION would ignore the status.
function(solidmoments_add_test)
  cmake_parse_arguments(test "XVFB;NODISPLAY" "NAME;TIMEOUT;STATUS;TEXT;WITHOUT" "LABELS;ENVIRONMENT;FIXTURE;COMMAND" ${ARGN})
  foreach (label IN LISTS test_LABELS)
    if (NOT label MATCHES "^(value|image|error|gpu|plugin|package|robust)$")
      message(FATAL_ERROR "Test ${test_NAME}: there is no label ${label}.")
    endif ()
  endforeach ()
  if (NOT test_LABELS)
    message(FATAL_ERROR "Test ${test_NAME} has no label.")
  endif ()
  set(launcher)
  if (test_XVFB)
    # A first display number for each test: xvfb-run -a alone lets two tests that start together choose the
    # same.
    get_property(number GLOBAL PROPERTY solidmoments_display)
    if (NOT number)
      set(number 200)
    endif ()
    math(EXPR next "${number} + 20")
    set_property(GLOBAL PROPERTY solidmoments_display "${next}")
    set(launcher "${SOLIDMOMENTS_XVFB_RUN}" -a -n "${number}" -s "-noreset -screen 0 1280x1024x24")
  elseif (test_NODISPLAY)
    set(launcher "${CMAKE_COMMAND}" -E env --unset=DISPLAY --unset=WAYLAND_DISPLAY)
  endif ()
  solidmoments_resolve_command(test_COMMAND)
  # Tests that run side by side must not write each other's files.
  if (SOLIDMOMENTS_TEST_OUTPUT IN_LIST test_COMMAND)
    file(MAKE_DIRECTORY "${SOLIDMOMENTS_TEST_OUTPUT}/${test_NAME}")
    list(TRANSFORM test_COMMAND REPLACE "^${SOLIDMOMENTS_TEST_OUTPUT}$" "${SOLIDMOMENTS_TEST_OUTPUT}/${test_NAME}")
  endif ()
  if (DEFINED test_STATUS)
    set(expectation "${Python3_EXECUTABLE}" "${SOLIDMOMENTS_TEST_SUPPORT}/expect_command.py"
      --status ${test_STATUS} --text "${test_TEXT}")
    if (test_WITHOUT)
      list(APPEND expectation --without "${test_WITHOUT}")
    endif ()
    set(test_COMMAND ${expectation} -- ${test_COMMAND})
  endif ()
  if (NOT test_TIMEOUT)
    set(test_TIMEOUT 300)
  endif ()
  add_test(NAME ${test_NAME} COMMAND ${launcher} ${test_COMMAND})
  set_tests_properties(${test_NAME} PROPERTIES
    LABELS "${test_LABELS}" ENVIRONMENT "${test_ENVIRONMENT}" SKIP_RETURN_CODE 77 TIMEOUT "${test_TIMEOUT}"
    FIXTURES_REQUIRED "${test_FIXTURE}")
endfunction ()

# solidmoments_add_mpi_test(NAME <name> RANKS <n> LABELS ... COMMAND <command>...): without a display, on `n`
# ranks of Open MPI, which share the cores that there are, root or not. `mpirun` must be in
# SOLIDMOMENTS_MPIRUN.
function(solidmoments_add_mpi_test)
  cmake_parse_arguments(mpi "" "NAME;RANKS" "COMMAND;ENVIRONMENT" ${ARGN})
  solidmoments_resolve_command(mpi_COMMAND)
  solidmoments_add_test(NAME ${mpi_NAME} NODISPLAY ${mpi_UNPARSED_ARGUMENTS}
    ENVIRONMENT ${SOLIDMOMENTS_MPI_ENVIRONMENT} ${mpi_ENVIRONMENT}
    COMMAND "${SOLIDMOMENTS_MPIRUN}" -np ${mpi_RANKS} ${mpi_COMMAND})
  set_tests_properties(${mpi_NAME} PROPERTIES PROCESSORS ${mpi_RANKS})
endfunction ()
# Open MPI needs this to run as root, with more ranks than cores, waiting without taking a core, and in a
# container.
set(SOLIDMOMENTS_MPI_ENVIRONMENT OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
  OMPI_MCA_rmaps_base_oversubscribe=1 OMPI_MCA_hwloc_base_binding_policy=none OMPI_MCA_mpi_yield_when_idle=1
  OMPI_MCA_btl_vader_single_copy_mechanism=none
  PRTE_MCA_rmaps_default_mapping_policy=:oversubscribe PRTE_MCA_hwloc_default_binding_policy=none)

# Gives a test executable the headers of Testing/Support, VTK's OpenGL classes and the precompiled header of
# all tests. The latter requires the same definitions everywhere: VTK's registration of OpenGL is therefore an
# object of its own.
function(solidmoments_set_up_test_executable name)
  target_include_directories(${name} PRIVATE "${CMAKE_CURRENT_SOURCE_DIR}")
  target_link_libraries(${name} PRIVATE
    smTestSupport smTestOpenGL VTK::CommonMath VTK::CommonSystem VTK::CommonTransforms)
  set_target_properties(${name} PROPERTIES POSITION_INDEPENDENT_CODE OFF)
  target_precompile_headers(${name} REUSE_FROM smTestPrecompiled)
  add_dependencies(${name} smTestSolids)
  solidmoments_warnings(${name})
endfunction ()

# solidmoments_add_test_program(<name> [SOURCES <file>...] LIBRARIES <target>...): <name>.cxx is a program
# with a main of its own.
function(solidmoments_add_test_program name)
  cmake_parse_arguments(program "" "" "SOURCES;LIBRARIES" ${ARGN})
  add_executable(${name} ${name}.cxx ${program_SOURCES})
  target_link_libraries(${name} PRIVATE ${program_LIBRARIES})
  solidmoments_set_up_test_executable(${name})
endfunction ()

# solidmoments_add_test_driver(<name> TESTS <test>... [SOURCES <file>...] LIBRARIES <target>...): one
# executable for the tests of a room. <test>.cxx defines `int <test>(int argc, char* argv[])`; `bin/<name>
# <test> <arguments>` runs it.
function(solidmoments_add_test_driver name)
  cmake_parse_arguments(driver "" "" "TESTS;SOURCES;LIBRARIES" ${ARGN})
  set(files ${driver_TESTS})
  list(TRANSFORM files APPEND .cxx)
  create_test_sourcelist(sources ${name}.cxx ${files})
  add_executable(${name} ${sources} ${driver_SOURCES})
  target_link_libraries(${name} PRIVATE ${driver_LIBRARIES})
  solidmoments_set_up_test_executable(${name})
  foreach (test IN LISTS driver_TESTS)
    set_property(GLOBAL PROPERTY solidmoments_driver_of_${test} ${name})
  endforeach ()
endfunction ()

# solidmoments_add_test_library(<name> LIBRARIES <target>...): <name>.cxx holds checks that executables of
# several rooms link.
function(solidmoments_add_test_library name)
  cmake_parse_arguments(library "" "" "LIBRARIES" ${ARGN})
  add_library(${name} STATIC ${name}.cxx)
  target_include_directories(${name} PUBLIC "${CMAKE_CURRENT_SOURCE_DIR}")
  target_link_libraries(${name} PUBLIC smTestSupport ${library_LIBRARIES})
  solidmoments_warnings(${name})
endfunction ()
