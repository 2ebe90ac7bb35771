# The parts of Table 1, of which other tests draw pictures.
add_test(NAME MakePaperParts COMMAND make_paper_parts "${SOLIDMOMENTS_PAPER_PARTS}")
set_tests_properties(MakePaperParts PROPERTIES LABELS value FIXTURES_SETUP paper_parts)
set(paper_programs --program "$<TARGET_FILE:solidmoments>" --occt "$<TARGET_FILE:occt_mass_properties>"
  --folder "${SOLIDMOMENTS_PAPER_PARTS}" --output "${SOLIDMOMENTS_TEST_OUTPUT}")
foreach (mode IN ITEMS values errors)
  solidmoments_add_test(NAME PaperParts_${mode} LABELS value error NODISPLAY FIXTURE paper_parts
    COMMAND "${Python3_EXECUTABLE}" -B "${CMAKE_CURRENT_SOURCE_DIR}/TestPaperParts.py"
      --make "$<TARGET_FILE:make_paper_parts>" ${paper_programs} ${mode})
endforeach ()
if (NOT TARGET paper_figures)
  return ()
endif ()

# The table.
foreach (mode IN ITEMS known parts)
  solidmoments_add_test(NAME PaperTable_${mode} LABELS value error NODISPLAY FIXTURE paper_parts
    COMMAND "${Python3_EXECUTABLE}" -B "${CMAKE_CURRENT_SOURCE_DIR}/TestPaperTable.py"
      --table "${PROJECT_SOURCE_DIR}/Examples/Paper/table.py" ${paper_programs} ${mode})
endforeach ()

# The paper's figures, computed with a display and without one; what is in them is judged once.
set(paper_figures "${SOLIDMOMENTS_TEST_OUTPUT}/paper_figures")
set(paper_models)
foreach (part IN ITEMS propeller crank engine_block gear_train free_form trefoil_tube)
  list(APPEND paper_models --model "${SOLIDMOMENTS_PAPER_PARTS}/${part}.step")
endforeach ()
solidmoments_add_test(NAME ComputePaperFigures LABELS image gpu NODISPLAY TIMEOUT 600 FIXTURE paper_parts
  COMMAND paper_figures "${paper_figures}" --part "${SOLIDMOMENTS_PAPER_PARTS}/free_form.step" ${paper_models})
set_tests_properties(ComputePaperFigures PROPERTIES FIXTURES_SETUP paper_tables)
solidmoments_add_test(NAME ComputePaperFiguresDisplay LABELS value gpu XVFB
  COMMAND paper_figures "${SOLIDMOMENTS_TEST_OUTPUT}/paper_figures_display")
add_test(NAME DrawPaperFigures COMMAND "${Python3_EXECUTABLE}" -B "${PROJECT_SOURCE_DIR}/Examples/Paper/draw_figures.py" "${paper_figures}")
set_tests_properties(DrawPaperFigures PROPERTIES LABELS image FIXTURES_REQUIRED paper_tables FIXTURES_SETUP paper_figures TIMEOUT 300)
solidmoments_add_test(NAME DrawPaperFiguresErrors LABELS error NODISPLAY STATUS 1 TEXT "has no CSV file of a figure"
  COMMAND "${Python3_EXECUTABLE}" -B "${PROJECT_SOURCE_DIR}/Examples/Paper/draw_figures.py" "${CMAKE_CURRENT_SOURCE_DIR}")
add_test(NAME PaperFigures COMMAND "${Python3_EXECUTABLE}" -B "${CMAKE_CURRENT_SOURCE_DIR}/TestPaperFigures.py" "${paper_figures}"
  "${SOLIDMOMENTS_TEST_BASELINES}/TestPaperFigures.png" "${PROJECT_SOURCE_DIR}/Examples/Paper/images/fig1.png")
set_tests_properties(PaperFigures PROPERTIES LABELS "value;image" FIXTURES_REQUIRED paper_figures)
# The page's sentences about the figures agree with their tables.
add_test(NAME PaperPage COMMAND "${Python3_EXECUTABLE}" -B "${PROJECT_SOURCE_DIR}/Examples/Paper/write_docs.py" --check "${paper_figures}")
set_tests_properties(PaperPage PROPERTIES LABELS robust FIXTURES_REQUIRED paper_tables)
solidmoments_add_test(NAME PaperFiguresErrors LABELS error NODISPLAY
  STATUS 1 TEXT "could not be read|has no volume"
  COMMAND paper_figures "${SOLIDMOMENTS_TEST_OUTPUT}/paper_figures_error" --part
    "${SOLIDMOMENTS_TEST_SOLIDS}/no_geometry.step")
