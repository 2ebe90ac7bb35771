# Tests of the ParaView plugin, in pvpython.
if (NOT SOLIDMOMENTS_BUILD_PARAVIEW_PLUGIN)
  return ()
endif ()
if (NOT SOLIDMOMENTS_PVPYTHON)
  message(FATAL_ERROR "The plugin's tests need pvpython (Debian: python3-paraview). Configure with "
    "-DSOLIDMOMENTS_BUILD_PARAVIEW_PLUGIN=OFF to do without the plugin.")
endif ()
solidmoments_add_test(NAME PluginMassProperties LABELS plugin value XVFB
  COMMAND "${SOLIDMOMENTS_PVPYTHON}" "${CMAKE_CURRENT_SOURCE_DIR}/Python/TestPluginMassProperties.py"
    "$<TARGET_FILE:SolidMoments>" "${SOLIDMOMENTS_TEST_SOLIDS}")
solidmoments_add_test(NAME PluginApply LABELS plugin XVFB
  COMMAND "${SOLIDMOMENTS_PVPYTHON}" "${CMAKE_CURRENT_SOURCE_DIR}/Python/TestPluginApply.py"
    "$<TARGET_FILE:SolidMoments>" "${SOLIDMOMENTS_TEST_SOLIDS}")
solidmoments_add_test(NAME PluginDefaults LABELS plugin NODISPLAY
  ENVIRONMENT "PYTHONPATH=${PROJECT_BINARY_DIR}/${SOLIDMOMENTS_PYTHON_DESTINATION}"
  COMMAND "${SOLIDMOMENTS_PVPYTHON}" "${CMAKE_CURRENT_SOURCE_DIR}/Python/TestPluginDefaults.py"
    "$<TARGET_FILE:SolidMoments>")
if (TARGET SolidMoments::FiltersStability)
  solidmoments_add_test(NAME PluginStability LABELS plugin value XVFB
    COMMAND "${SOLIDMOMENTS_PVPYTHON}" "${CMAKE_CURRENT_SOURCE_DIR}/Python/TestPluginStability.py"
      "$<TARGET_FILE:SolidMoments>" "${SOLIDMOMENTS_TEST_SOLIDS}")
endif ()
solidmoments_add_test(NAME PluginWriters LABELS plugin value XVFB
  COMMAND "${SOLIDMOMENTS_PVPYTHON}" "${CMAKE_CURRENT_SOURCE_DIR}/Python/TestPluginWriters.py"
    "$<TARGET_FILE:SolidMoments>" "${SOLIDMOMENTS_TEST_SOLIDS}" "${SOLIDMOMENTS_TEST_OUTPUT}")
solidmoments_add_test(NAME PluginFilters LABELS plugin value NODISPLAY
  COMMAND "${SOLIDMOMENTS_PVPYTHON}" "${CMAKE_CURRENT_SOURCE_DIR}/Python/TestPluginFilters.py"
    "$<TARGET_FILE:SolidMoments>" "${SOLIDMOMENTS_TEST_SOLIDS}")
solidmoments_add_test(NAME PluginCycles LABELS plugin robust XVFB
  COMMAND "${SOLIDMOMENTS_PVPYTHON}" "${CMAKE_CURRENT_SOURCE_DIR}/Python/TestPluginCycles.py"
    "$<TARGET_FILE:SolidMoments>" "${PROJECT_SOURCE_DIR}/Examples/Models/sample_part.step" 12)
find_program(SOLIDMOMENTS_PVSERVER pvserver)
if (SOLIDMOMENTS_PVSERVER)
  solidmoments_add_test(NAME PluginFiltersOnServer LABELS plugin value NODISPLAY
    COMMAND "${Python3_EXECUTABLE}" "${CMAKE_CURRENT_SOURCE_DIR}/Python/with_server.py" "${SOLIDMOMENTS_PVSERVER}"
      "${SOLIDMOMENTS_PVPYTHON}" "${CMAKE_CURRENT_SOURCE_DIR}/Python/TestPluginFilters.py"
      "$<TARGET_FILE:SolidMoments>" "${SOLIDMOMENTS_TEST_SOLIDS}")
  solidmoments_add_test(NAME PluginWritersRemote LABELS plugin value XVFB
    COMMAND "${SOLIDMOMENTS_PVPYTHON}" "${CMAKE_CURRENT_SOURCE_DIR}/Python/TestPluginWriters.py"
      "$<TARGET_FILE:SolidMoments>" "${SOLIDMOMENTS_TEST_SOLIDS}" "${SOLIDMOMENTS_TEST_OUTPUT}" "${SOLIDMOMENTS_PVSERVER}")
endif ()
# The window itself, played back.
find_program(SOLIDMOMENTS_PARAVIEW paraview)
if (SOLIDMOMENTS_PARAVIEW)
  solidmoments_add_test(NAME PluginWindow LABELS plugin image XVFB
    COMMAND "${SOLIDMOMENTS_PVPYTHON}" "${CMAKE_CURRENT_SOURCE_DIR}/Window/TestPluginWindow.py" "${SOLIDMOMENTS_PARAVIEW}"
      "$<TARGET_FILE:SolidMoments>" "${PROJECT_SOURCE_DIR}" "${SOLIDMOMENTS_TEST_OUTPUT}")
endif ()

# Several ranks and a remote server, without a display: values, no pictures.
find_program(SOLIDMOMENTS_PVBATCH pvbatch)
set(ranks_files "${PROJECT_SOURCE_DIR}/Examples/Models/sample_part.step" "${SOLIDMOMENTS_TEST_SOLIDS}/slanted_hole-moved.step"
  "${SOLIDMOMENTS_TEST_SOLIDS}/two_solids.step")
set(ranks_modes)
if (SOLIDMOMENTS_PVSERVER)
  list(APPEND ranks_modes server)
endif ()
if (SOLIDMOMENTS_MPIRUN AND SOLIDMOMENTS_PVBATCH AND SOLIDMOMENTS_PVSERVER)
  list(APPEND ranks_modes ranks server-ranks)
endif ()
foreach (mode IN LISTS ranks_modes)
  solidmoments_add_test(NAME PluginRanks_${mode} LABELS plugin value NODISPLAY
    ENVIRONMENT ${SOLIDMOMENTS_MPI_ENVIRONMENT}
    COMMAND "${Python3_EXECUTABLE}" "${CMAKE_CURRENT_SOURCE_DIR}/Python/TestPluginRanks.py" ${mode}
      --plugin "$<TARGET_FILE:SolidMoments>" --solidmoments "$<TARGET_FILE:solidmoments>"
      --pvpython "${SOLIDMOMENTS_PVPYTHON}" --pvbatch "${SOLIDMOMENTS_PVBATCH}" --pvserver "${SOLIDMOMENTS_PVSERVER}"
      --mpirun "${SOLIDMOMENTS_MPIRUN}" --output "${SOLIDMOMENTS_TEST_OUTPUT}" ${ranks_files})
  set_tests_properties(PluginRanks_${mode} PROPERTIES PROCESSORS 2)
endforeach ()
if (SOLIDMOMENTS_MPIRUN AND SOLIDMOMENTS_PVBATCH AND SOLIDMOMENTS_WRAP_PYTHON)
  solidmoments_add_test(NAME ExampleBatch LABELS plugin value error NODISPLAY
    ENVIRONMENT ${SOLIDMOMENTS_MPI_ENVIRONMENT} "PYTHONPATH=${PROJECT_BINARY_DIR}/${SOLIDMOMENTS_PYTHON_DESTINATION}"
      PYTHONDONTWRITEBYTECODE=1
    COMMAND "${Python3_EXECUTABLE}" "${CMAKE_CURRENT_SOURCE_DIR}/Python/TestBatch.py"
      --script "${PROJECT_SOURCE_DIR}/Examples/Python/mass_properties_batch.py" --pvbatch "${SOLIDMOMENTS_PVBATCH}"
      --mpirun "${SOLIDMOMENTS_MPIRUN}" --solids "${SOLIDMOMENTS_TEST_SOLIDS}"
      --sample "${PROJECT_SOURCE_DIR}/Examples/Models/sample_part.step" --output "${SOLIDMOMENTS_TEST_OUTPUT}")
  set_tests_properties(ExampleBatch PROPERTIES PROCESSORS 3)
endif ()
