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
    "$<TARGET_FILE:SolidMoments>" "${SOLIDMOMENTS_TEST_SOLIDS}/slanted_hole-moved.step")
solidmoments_add_test(NAME PluginDefaults LABELS plugin NODISPLAY
  ENVIRONMENT "PYTHONPATH=${PROJECT_BINARY_DIR}/${SOLIDMOMENTS_PYTHON_DESTINATION}"
  COMMAND "${SOLIDMOMENTS_PVPYTHON}" "${CMAKE_CURRENT_SOURCE_DIR}/Python/TestPluginDefaults.py"
    "$<TARGET_FILE:SolidMoments>")

# Several ranks and a remote server, without a display: values, no pictures.
find_program(SOLIDMOMENTS_PVBATCH pvbatch)
find_program(SOLIDMOMENTS_PVSERVER pvserver)
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
      --script "${PROJECT_SOURCE_DIR}/Examples/Batch/mass_properties_batch.py" --pvbatch "${SOLIDMOMENTS_PVBATCH}"
      --mpirun "${SOLIDMOMENTS_MPIRUN}" --solids "${SOLIDMOMENTS_TEST_SOLIDS}"
      --sample "${PROJECT_SOURCE_DIR}/Examples/Models/sample_part.step" --output "${SOLIDMOMENTS_TEST_OUTPUT}")
  set_tests_properties(ExampleBatch PROPERTIES PROCESSORS 3)
endif ()
