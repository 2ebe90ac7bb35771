# What does not grow however often one applies, and what ends in any order.
solidmoments_add_test_program(TestApplyCycles VTK::glew VTK::opengl)
target_link_libraries(TestApplyCycles PRIVATE SolidMoments::RenderingNURBS)
solidmoments_add_test_program(TestClosingOrders)
target_link_libraries(TestClosingOrders PRIVATE SolidMoments::RenderingNURBS)

# Solids that take milliseconds, so that a thousand cycles take seconds; those that make contexts and windows are fewer here: a number as
# last argument makes them more.
foreach (context IN ITEMS own shared)
  foreach (mode_cycles IN ITEMS edit:1000 open:100 window:30)
    string(REPLACE ":" ";" mode_cycles "${mode_cycles}")
    list(GET mode_cycles 0 mode)
    list(GET mode_cycles 1 cycles)
    solidmoments_add_test(NAME ApplyCycles_${mode}_${context} LABELS gpu robust XVFB
      COMMAND TestApplyCycles ${mode} ${context} "${SOLIDMOMENTS_TEST_SOLIDS}" ${cycles})
  endforeach ()
endforeach ()
foreach (mode IN ITEMS own shared windows contexts exit exit-in-render)
  solidmoments_add_test(NAME ClosingOrders_${mode} LABELS gpu robust XVFB
    COMMAND TestClosingOrders ${mode} "${SOLIDMOMENTS_TEST_SOLIDS}")
endforeach ()

# The same in ParaView.
if (NOT SOLIDMOMENTS_BUILD_PARAVIEW_PLUGIN)
  return ()
endif ()
set(sample_part "${PROJECT_SOURCE_DIR}/Examples/Models/sample_part.step")
if (SOLIDMOMENTS_WRAP_PYTHON)
  # The filter itself is asked for its context, by the modules' Python wrappings.
  solidmoments_add_test(NAME PluginApplyCycles LABELS plugin gpu robust XVFB
    ENVIRONMENT "PYTHONPATH=${PROJECT_BINARY_DIR}/${SOLIDMOMENTS_PYTHON_DESTINATION}"
    COMMAND "${SOLIDMOMENTS_PVPYTHON}" "${CMAKE_CURRENT_SOURCE_DIR}/Python/TestPluginApplyCycles.py"
      "$<TARGET_FILE:SolidMoments>" "${sample_part}" 40)
endif ()
set(closing_test "${CMAKE_CURRENT_SOURCE_DIR}/Python/TestPluginClosing.py")
foreach (mode IN ITEMS orders reset exit)
  solidmoments_add_test(NAME PluginClosing_${mode} LABELS plugin robust XVFB
    COMMAND "${SOLIDMOMENTS_PVPYTHON}" "${closing_test}" ${mode} "$<TARGET_FILE:SolidMoments>" "${sample_part}")
endforeach ()
if (SOLIDMOMENTS_PVSERVER)
  solidmoments_add_test(NAME PluginClosing_server LABELS plugin robust XVFB
    COMMAND "${Python3_EXECUTABLE}" "${CMAKE_CURRENT_SOURCE_DIR}/Python/with_server.py" "${SOLIDMOMENTS_PVSERVER}"
      "${SOLIDMOMENTS_PVPYTHON}" "${closing_test}" server "$<TARGET_FILE:SolidMoments>" "${sample_part}")
  solidmoments_add_test(NAME PluginClosing_killed LABELS plugin robust XVFB
    COMMAND "${SOLIDMOMENTS_PVPYTHON}" "${closing_test}" killed "$<TARGET_FILE:SolidMoments>" "${sample_part}"
      "${SOLIDMOMENTS_PVSERVER}")
endif ()
if (SOLIDMOMENTS_PARAVIEW)
  solidmoments_add_test(NAME PluginWindowCloses LABELS plugin robust XVFB
    COMMAND "${SOLIDMOMENTS_PVPYTHON}" "${CMAKE_CURRENT_SOURCE_DIR}/Window/TestPluginWindowCloses.py" "${SOLIDMOMENTS_PARAVIEW}"
      "$<TARGET_FILE:SolidMoments>" "${PROJECT_SOURCE_DIR}" "${SOLIDMOMENTS_TEST_OUTPUT}")
endif ()
