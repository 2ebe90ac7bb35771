# The one helper that registers tests.
find_program(SOLIDMOMENTS_XVFB_RUN xvfb-run)
if (NOT SOLIDMOMENTS_XVFB_RUN)
  message(FATAL_ERROR "The tests need xvfb-run (Debian: xvfb xauth). Configure with "
    "-DSOLIDMOMENTS_BUILD_TESTING=OFF to do without them.")
endif ()

# solidmoments_add_test(NAME <name> LABELS <label>... [XVFB | NODISPLAY] [TIMEOUT <seconds>]
#   [ENVIRONMENT <NAME=value>...] [FIXTURE <setup>...] COMMAND <command>...)
#
# XVFB runs the command on a virtual X display of its own, NODISPLAY without any; neither leaves the display to the
# caller's environment, for programs that do not care. Labels: value image error gpu plugin package robust.
function(solidmoments_add_test)
  cmake_parse_arguments(test "XVFB;NODISPLAY" "NAME;TIMEOUT" "LABELS;ENVIRONMENT;FIXTURE;COMMAND" ${ARGN})
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
    # A first display number for each test: xvfb-run -a alone lets two tests that start together choose the same.
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
  # add_test itself finds a target only where no launcher stands before it.
  list(GET test_COMMAND 0 program)
  if (TARGET "${program}")
    list(REMOVE_AT test_COMMAND 0)
    list(INSERT test_COMMAND 0 "$<TARGET_FILE:${program}>")
  endif ()
  if (NOT test_TIMEOUT)
    set(test_TIMEOUT 300)
  endif ()
  add_test(NAME ${test_NAME} COMMAND ${launcher} ${test_COMMAND})
  set_tests_properties(${test_NAME} PROPERTIES
    LABELS "${test_LABELS}" ENVIRONMENT "${test_ENVIRONMENT}" SKIP_RETURN_CODE 77 TIMEOUT "${test_TIMEOUT}"
    FIXTURES_REQUIRED "${test_FIXTURE}")
endfunction ()

# solidmoments_add_mpi_test(NAME <name> RANKS <n> LABELS ... COMMAND <command>...): without a display, on `n` ranks of Open
# MPI, which share the cores that there are, root or not. `mpirun` must be in SOLIDMOMENTS_MPIRUN.
function(solidmoments_add_mpi_test)
  cmake_parse_arguments(mpi "" "NAME;RANKS" "COMMAND;ENVIRONMENT" ${ARGN})
  list(GET mpi_COMMAND 0 program)
  if (TARGET "${program}")
    list(REMOVE_AT mpi_COMMAND 0)
    list(INSERT mpi_COMMAND 0 "$<TARGET_FILE:${program}>")
  endif ()
  solidmoments_add_test(NAME ${mpi_NAME} NODISPLAY ${mpi_UNPARSED_ARGUMENTS}
    ENVIRONMENT ${SOLIDMOMENTS_MPI_ENVIRONMENT} ${mpi_ENVIRONMENT}
    COMMAND "${SOLIDMOMENTS_MPIRUN}" -np ${mpi_RANKS} ${mpi_COMMAND})
  set_tests_properties(${mpi_NAME} PROPERTIES PROCESSORS ${mpi_RANKS})
endfunction ()
# What Open MPI needs to run as root, with more ranks than cores, waiting without taking a core, and in a container.
set(SOLIDMOMENTS_MPI_ENVIRONMENT OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
  OMPI_MCA_rmaps_base_oversubscribe=1 OMPI_MCA_hwloc_base_binding_policy=none OMPI_MCA_mpi_yield_when_idle=1
  OMPI_MCA_btl_vader_single_copy_mechanism=none)

# A test program with its libraries; VTK's OpenGL objects are registered in it.
function(solidmoments_add_test_program name)
  add_executable(${name} ${name}.cxx)
  target_link_libraries(${name} PRIVATE
    SolidMoments::FiltersStability SolidMoments::FiltersNURBSEdit SolidMoments::ReadersSTEP
    SolidMoments::RenderingCompute
    VTK::RenderingOpenGL2 nlohmann_json::nlohmann_json ${ARGN})
  target_include_directories(${name} PRIVATE "${CMAKE_CURRENT_SOURCE_DIR}")
  vtk_module_autoinit(TARGETS ${name} MODULES VTK::RenderingOpenGL2 ${ARGN})
  add_dependencies(${name} smTestSolids)
  solidmoments_warnings(${name})
endfunction ()
