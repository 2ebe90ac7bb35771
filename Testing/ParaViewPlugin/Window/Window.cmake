# ParaView's states, progress, and files written by a parallel server.
set(window_tests "${CMAKE_CURRENT_LIST_DIR}")
set(window_assembly "${SOLIDMOMENTS_TEST_SOLIDS}/assembly.step")
solidmoments_add_test(NAME PluginState LABELS plugin XVFB
  COMMAND "${SOLIDMOMENTS_PVPYTHON}" "${window_tests}/TestPluginState.py" "$<TARGET_FILE:SolidMoments>"
    "${SOLIDMOMENTS_TEST_OUTPUT}")
solidmoments_add_test(NAME PluginProgress LABELS plugin robust NODISPLAY
  COMMAND "${SOLIDMOMENTS_PVPYTHON}" "${window_tests}/TestPluginProgress.py" "$<TARGET_FILE:SolidMoments>" "${SOLIDMOMENTS_SAMPLE_PART}"
    "${window_assembly}")
if (SOLIDMOMENTS_PVSERVER AND TARGET SolidMoments::FiltersMomentSchemes)
  solidmoments_add_test(NAME PluginProgressOnServer LABELS plugin robust NODISPLAY
    COMMAND "${Python3_EXECUTABLE}" "${SOLIDMOMENTS_TEST_SUPPORT}/with_server.py" "${SOLIDMOMENTS_PVSERVER}"
      "${SOLIDMOMENTS_PVPYTHON}" "${window_tests}/TestPluginProgress.py" "$<TARGET_FILE:SolidMoments>" "${SOLIDMOMENTS_SAMPLE_PART}"
      "${window_assembly}")
endif ()
# A first session, and the pictures of it that the user guide shows. Its events count the unnamed buttons of
# ParaView 5.11's tool bar.
if (SOLIDMOMENTS_PARAVIEW AND ParaView_VERSION VERSION_GREATER_EQUAL 5.12)
  message(STATUS "PluginWalk was recorded with the buttons of ParaView 5.11: the test is left out")
elseif (SOLIDMOMENTS_PARAVIEW AND TARGET SolidMoments::FiltersSection AND TARGET SolidMoments::FiltersNURBSEdit)
  solidmoments_add_test(NAME PluginWalk LABELS plugin image XVFB TIMEOUT 600
    COMMAND "${SOLIDMOMENTS_PVPYTHON}" "${window_tests}/TestPluginWalk.py" "${SOLIDMOMENTS_PARAVIEW}" "$<TARGET_FILE:SolidMoments>"
      "${SOLIDMOMENTS_TEST_OUTPUT}")
  solidmoments_add_test(NAME PluginTicks LABELS plugin value XVFB TIMEOUT 600
    COMMAND "${SOLIDMOMENTS_PVPYTHON}" "${window_tests}/TestPluginTicks.py" "${SOLIDMOMENTS_PARAVIEW}" "$<TARGET_FILE:SolidMoments>"
      "${SOLIDMOMENTS_TEST_OUTPUT}")
  # With the data on a server of one and of two ranks.
  foreach (ranks IN ITEMS 1 2)
    if (SOLIDMOMENTS_PVSERVER AND (ranks EQUAL 1 OR SOLIDMOMENTS_MPIRUN))
      solidmoments_add_test(NAME PluginWalkServer_${ranks} LABELS plugin image XVFB TIMEOUT 600 ENVIRONMENT ${SOLIDMOMENTS_MPI_ENVIRONMENT}
        COMMAND "${SOLIDMOMENTS_PVPYTHON}" "${window_tests}/TestPluginWalk.py" "${SOLIDMOMENTS_PARAVIEW}" "$<TARGET_FILE:SolidMoments>"
          "${SOLIDMOMENTS_TEST_OUTPUT}" ${ranks} "${SOLIDMOMENTS_PVSERVER}" "${SOLIDMOMENTS_MPIRUN}")
      set_tests_properties(PluginWalkServer_${ranks} PROPERTIES PROCESSORS 2)
    endif ()
  endforeach ()
endif ()
if (SOLIDMOMENTS_PARAVIEW AND TARGET SolidMoments::FiltersSection)
  solidmoments_add_test(NAME PluginKeys LABELS plugin value XVFB TIMEOUT 1200
    COMMAND "${SOLIDMOMENTS_PVPYTHON}" "${window_tests}/TestPluginKeys.py" "${SOLIDMOMENTS_PARAVIEW}" "$<TARGET_FILE:SolidMoments>"
      "${SOLIDMOMENTS_TEST_OUTPUT}")
endif ()
# The run that Esc stops is one of the paper's schemes.
if (SOLIDMOMENTS_PARAVIEW AND TARGET SolidMoments::FiltersMomentSchemes)
  solidmoments_add_test(NAME PluginEscape LABELS plugin robust XVFB
    COMMAND "${Python3_EXECUTABLE}" "${window_tests}/TestPluginEscape.py" "${SOLIDMOMENTS_PARAVIEW}" "$<TARGET_FILE:SolidMoments>"
      "${SOLIDMOMENTS_SAMPLE_PART}" "${SOLIDMOMENTS_TEST_OUTPUT}")
endif ()
if (SOLIDMOMENTS_MPIRUN AND SOLIDMOMENTS_PVBATCH AND TARGET SolidMoments::FiltersNURBSEdit)
  solidmoments_add_test(NAME PluginWritersRanks LABELS plugin value NODISPLAY
    ENVIRONMENT ${SOLIDMOMENTS_MPI_ENVIRONMENT}
      "PYTHONPATH=${PROJECT_BINARY_DIR}/${SOLIDMOMENTS_PYTHON_DESTINATION}"
    COMMAND "${Python3_EXECUTABLE}" "${window_tests}/TestPluginWritersRanks.py" "$<TARGET_FILE:SolidMoments>" "${SOLIDMOMENTS_SAMPLE_PART}"
      "${SOLIDMOMENTS_TEST_OUTPUT}" "${SOLIDMOMENTS_PVPYTHON}" "${SOLIDMOMENTS_MPIRUN}" "${SOLIDMOMENTS_PVBATCH}")
  set_tests_properties(PluginWritersRanks PROPERTIES PROCESSORS 2)
endif ()
