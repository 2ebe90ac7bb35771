# The scripts of Examples/Python, in every interpreter that runs them, with and without a display.
#
# solidmoments_add_python_example(<name> <flavour of TestPythonExamples.py> <interpreter> [MODES <option>...]
# <more of
#   solidmoments_add_test>...)
function(solidmoments_add_python_example name flavour interpreter)
  cmake_parse_arguments(example "" "" "MODES" ${ARGN})
  solidmoments_add_test(NAME PythonExamples_${name} LABELS value image error ${example_UNPARSED_ARGUMENTS}
    ENVIRONMENT "${python_path}"
    COMMAND "${Python3_EXECUTABLE}" -B "${CMAKE_CURRENT_SOURCE_DIR}/TestPythonExamples.py" ${flavour} ${example_MODES}
      --interpreter "${interpreter}" --examples "${PROJECT_SOURCE_DIR}/Examples" --plugin "${example_plugin}"
      --program "$<TARGET_FILE:solidmoments>" --solids "${SOLIDMOMENTS_TEST_SOLIDS}"
      --output "${SOLIDMOMENTS_TEST_OUTPUT}" --baselines "${SOLIDMOMENTS_TEST_BASELINES}")
endfunction ()

set(example_plugin none)
if (SOLIDMOMENTS_WRAP_PYTHON)
  solidmoments_add_python_example(python3 vtk "${Python3_EXECUTABLE}" gpu package NODISPLAY)
  solidmoments_add_python_example(python3_display vtk "${Python3_EXECUTABLE}" gpu package XVFB MODES --without-errors)
  set(small_example "${Python3_EXECUTABLE}" -B "${CMAKE_CURRENT_SOURCE_DIR}/TestSmallExamples.py"
    --solids "${SOLIDMOMENTS_TEST_SOLIDS}")
  solidmoments_add_test(NAME PythonExamples_build_by_hand LABELS value error gpu package NODISPLAY ENVIRONMENT "${python_path}"
    COMMAND ${small_example} half-ball "${Python3_EXECUTABLE}" "${PROJECT_SOURCE_DIR}/Examples/Python/build_by_hand.py")
  solidmoments_add_test(NAME PythonExamples_volume LABELS value error gpu package NODISPLAY ENVIRONMENT "${python_path}"
    COMMAND ${small_example} volume "${Python3_EXECUTABLE}" "${PROJECT_SOURCE_DIR}/Examples/Python/volume.py")
  solidmoments_add_test(NAME PythonExamples_one_call LABELS value package NODISPLAY ENVIRONMENT "${python_path}"
    COMMAND ${small_example} one-call "${Python3_EXECUTABLE}" "${PROJECT_SOURCE_DIR}/Examples/Python/one_call.py")
  solidmoments_add_test(NAME PythonExamples_three_lines LABELS value package NODISPLAY ENVIRONMENT "${python_path}"
    COMMAND ${small_example} three-lines "${Python3_EXECUTABLE}" "${PROJECT_SOURCE_DIR}/Examples/Python/three_lines.py")
  solidmoments_add_test(NAME PythonExamples_tolerance_parts LABELS value error package NODISPLAY ENVIRONMENT "${python_path}"
    COMMAND ${small_example} tolerance "${Python3_EXECUTABLE}" "${PROJECT_SOURCE_DIR}/Examples/Python/tolerance_parts.py")
  solidmoments_add_test(NAME CertifiedSet_vtk LABELS value package NODISPLAY ENVIRONMENT "${python_path}"
    COMMAND ${certified_test} --other "${Python3_EXECUTABLE} -B ${PROJECT_SOURCE_DIR}/Examples/Certified/vtk_mass_properties.py" other)
  # pvpython has ParaView's VTK.
  if (SOLIDMOMENTS_PVPYTHON AND SOLIDMOMENTS_BUILD_PARAVIEW_PLUGIN)
    solidmoments_add_python_example(pvpython vtk "${SOLIDMOMENTS_PVPYTHON}" gpu package NODISPLAY MODES --without-errors)
  endif ()
endif ()
if (SOLIDMOMENTS_BUILD_PARAVIEW_PLUGIN)
  set(example_plugin "$<TARGET_FILE:SolidMoments>")
  solidmoments_add_python_example(paraview paraview "${SOLIDMOMENTS_PVPYTHON}" plugin XVFB)
endif ()

# pvbatch under MPI.
if (NOT SOLIDMOMENTS_BUILD_PARAVIEW_PLUGIN)
  return ()
endif ()
if (SOLIDMOMENTS_MPIRUN AND SOLIDMOMENTS_PVBATCH AND SOLIDMOMENTS_WRAP_PYTHON)
  solidmoments_add_test(NAME ExampleBatch LABELS plugin value error NODISPLAY
    ENVIRONMENT ${SOLIDMOMENTS_MPI_ENVIRONMENT} "PYTHONPATH=${PROJECT_BINARY_DIR}/${SOLIDMOMENTS_PYTHON_DESTINATION}"
      PYTHONDONTWRITEBYTECODE=1
    COMMAND "${Python3_EXECUTABLE}" "${CMAKE_CURRENT_SOURCE_DIR}/TestBatch.py"
      --script "${PROJECT_SOURCE_DIR}/Examples/Python/mass_properties_batch.py" --pvbatch "${SOLIDMOMENTS_PVBATCH}"
      --mpirun "${SOLIDMOMENTS_MPIRUN}" --solids "${SOLIDMOMENTS_TEST_SOLIDS}"
      --sample "${SOLIDMOMENTS_SAMPLE_PART}" --output "${SOLIDMOMENTS_TEST_OUTPUT}")
  set_tests_properties(ExampleBatch PROPERTIES PROCESSORS 3)
endif ()
