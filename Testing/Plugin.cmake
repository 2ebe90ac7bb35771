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
solidmoments_add_test(NAME PluginStability LABELS plugin value XVFB
  COMMAND "${SOLIDMOMENTS_PVPYTHON}" "${CMAKE_CURRENT_SOURCE_DIR}/Python/TestPluginStability.py"
    "$<TARGET_FILE:SolidMoments>" "${SOLIDMOMENTS_TEST_SOLIDS}")
