# The interactive example: a stream of events in, values and pictures out.
set(edit_part "${PROJECT_SOURCE_DIR}/Examples/Interactive")
set(free_form_part "${PROJECT_SOURCE_DIR}/Examples/Models/free_form_part.step")
solidmoments_add_test_program(TestEditPart
  LIBRARIES smEditPart smGaussRule SolidMoments::ReadersSTEP VTK::InteractionStyle VTK::TestingRendering)
vtk_module_autoinit(TARGETS TestEditPart MODULES VTK::InteractionStyle)
foreach (mode IN ITEMS drag placed open record)
  solidmoments_add_test(NAME EditPart_${mode} LABELS value image gpu XVFB
    COMMAND TestEditPart ${mode} "${free_form_part}" "${edit_part}/drag.events" "${SOLIDMOMENTS_TEST_OUTPUT}"
      -T "${SOLIDMOMENTS_TEST_OUTPUT}" -V "${SOLIDMOMENTS_TEST_BASELINES}/TestEditPart.png")
endforeach ()

set(edit_program "${Python3_EXECUTABLE}" "${CMAKE_CURRENT_SOURCE_DIR}/TestEditProgram.py"
  --program "$<TARGET_FILE:edit_part>" --events "${edit_part}/drag.events" --solids "${SOLIDMOMENTS_TEST_SOLIDS}"
  --output "${SOLIDMOMENTS_TEST_OUTPUT}")
solidmoments_add_test(NAME EditProgram LABELS value image error gpu NODISPLAY COMMAND ${edit_program})
set_tests_properties(EditProgram PROPERTIES FIXTURES_SETUP edit_program)
solidmoments_add_test(NAME EditProgramDisplay LABELS value image gpu XVFB FIXTURE edit_program
  COMMAND ${edit_program} --display)
