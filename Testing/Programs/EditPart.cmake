# The interactive example: a stream of events in, values and pictures out.
set(edit_part "${PROJECT_SOURCE_DIR}/Examples/edit_part")
set(free_form_part "${PROJECT_SOURCE_DIR}/Examples/Models/free_form_part.step")
solidmoments_add_test_program(TestEditPart
  SOURCES smDragChecks.cxx smHoldChecks.cxx smPlacedChecks.cxx
  LIBRARIES smEditPart smGaussRule SolidMoments::ReadersKernel SolidMoments::ReadersSTEP VTK::InteractionStyle VTK::TestingRendering)
vtk_module_autoinit(TARGETS TestEditPart MODULES VTK::InteractionStyle)
# Tests may run at the same time, so each has a folder of its own for its events.
foreach (mode IN ITEMS drag hold placed open record numbers)
  set(edit_folder "${SOLIDMOMENTS_TEST_OUTPUT}/edit_part_${mode}")
  file(MAKE_DIRECTORY "${edit_folder}")
  solidmoments_add_test(NAME EditPart_${mode} LABELS value image gpu XVFB
    COMMAND TestEditPart ${mode} "${free_form_part}" "${edit_part}/drag.events" "${edit_folder}"
      -T "${SOLIDMOMENTS_TEST_OUTPUT}" -V "${SOLIDMOMENTS_TEST_BASELINES}/TestEditPart.png")
endforeach ()
if (SOLIDMOMENTS_COMMA_LOCALES)
  set_tests_properties(EditPart_numbers PROPERTIES
    FIXTURES_REQUIRED comma_locale ENVIRONMENT "LOCPATH=${SOLIDMOMENTS_COMMA_LOCALES}")
endif ()

# The second of them reads what the first one wrote.
file(MAKE_DIRECTORY "${SOLIDMOMENTS_TEST_OUTPUT}/edit_program")
set(edit_program "${Python3_EXECUTABLE}" "${CMAKE_CURRENT_SOURCE_DIR}/TestEditProgram.py"
  --program "$<TARGET_FILE:edit_part>" --events "${edit_part}/drag.events" --solids "${SOLIDMOMENTS_TEST_SOLIDS}"
  --output "${SOLIDMOMENTS_TEST_OUTPUT}/edit_program")
solidmoments_add_test(NAME EditProgram LABELS value image error gpu NODISPLAY COMMAND ${edit_program})
set_tests_properties(EditProgram PROPERTIES FIXTURES_SETUP edit_program)
solidmoments_add_test(NAME EditProgramDisplay LABELS value image gpu XVFB FIXTURE edit_program
  COMMAND ${edit_program} --display)
