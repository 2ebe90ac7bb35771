# Tests of the programs that use the modules: examples, command line, package, Python modules, the sweep over real files.
set(sample_part "${PROJECT_SOURCE_DIR}/Examples/Models/sample_part.step")

solidmoments_add_test(NAME ExamplePrograms LABELS value error NODISPLAY
  COMMAND "${Python3_EXECUTABLE}" "${CMAKE_CURRENT_SOURCE_DIR}/Python/TestExamplePrograms.py"
    --pipeline "$<TARGET_FILE:MassPropertiesPipeline>" --sample "${sample_part}" --output "${SOLIDMOMENTS_TEST_OUTPUT}"
    "$<TARGET_FILE:solidmoments>" "$<TARGET_FILE:edit_part>" "$<TARGET_FILE:make_paper_parts>"
    "$<TARGET_FILE:occt_mass_properties>" "$<TARGET_FILE:paper_figures>")

# Numbers have a decimal point in every locale. MakeCommaLocale makes one with a comma, where the machine has its source.
solidmoments_add_test_program(TestExampleNumbers)
target_link_libraries(TestExampleNumbers PRIVATE smCommandLine)
solidmoments_add_test(NAME ExampleNumbers LABELS value error NODISPLAY COMMAND TestExampleNumbers)

solidmoments_add_test(NAME ExampleMassPropertiesPipeline LABELS gpu image NODISPLAY
  COMMAND MassPropertiesPipeline "${sample_part}" "${SOLIDMOMENTS_TEST_OUTPUT}/pipeline_headless.png")
solidmoments_add_test(NAME ExampleMassPropertiesPipelineDisplay LABELS gpu image XVFB
  COMMAND MassPropertiesPipeline "${sample_part}" "${SOLIDMOMENTS_TEST_OUTPUT}/pipeline_display.png")

# A display that does not answer (a number that nobody has), and a part with nothing in it: sentences, no crash, no picture.
solidmoments_add_test(NAME ExampleMassPropertiesPipelineDeadDisplay LABELS error NODISPLAY
  COMMAND "${CMAKE_COMMAND}" -E env DISPLAY=:50077 $<TARGET_FILE:MassPropertiesPipeline> "${sample_part}")
set_tests_properties(ExampleMassPropertiesPipelineDeadDisplay PROPERTIES
  PASS_REGULAR_EXPRESSION "Name a picture to write")
solidmoments_add_test(NAME ExampleMassPropertiesPipelineEmpty LABELS error NODISPLAY
  COMMAND MassPropertiesPipeline "${SOLIDMOMENTS_TEST_SOLIDS}/no_geometry.step"
    "${SOLIDMOMENTS_TEST_OUTPUT}/pipeline_empty.png")
set_tests_properties(ExampleMassPropertiesPipelineEmpty PROPERTIES
  PASS_REGULAR_EXPRESSION "There is nothing to show" FAIL_REGULAR_EXPRESSION "volume")

# The interactive example: a stream of events in, values and pictures out.
set(edit_part "${PROJECT_SOURCE_DIR}/Examples/Interactive")
set(free_form_part "${PROJECT_SOURCE_DIR}/Examples/Models/free_form_part.step")
solidmoments_add_test_program(TestEditPart VTK::TestingRendering VTK::InteractionStyle VTK::RenderingFreeType)
target_sources(TestEditPart PRIVATE "${CMAKE_CURRENT_SOURCE_DIR}/Solids/smGaussRule.cxx")
target_include_directories(TestEditPart PRIVATE "${CMAKE_CURRENT_SOURCE_DIR}/Solids")
target_link_libraries(TestEditPart PRIVATE smEditPart)
# Tests may run at the same time, so each has a folder of its own for its events.
foreach (mode IN ITEMS drag placed open record numbers)
  set(edit_folder "${SOLIDMOMENTS_TEST_OUTPUT}/edit_part_${mode}")
  file(MAKE_DIRECTORY "${edit_folder}")
  solidmoments_add_test(NAME EditPart_${mode} LABELS value image gpu XVFB
    COMMAND TestEditPart ${mode} "${free_form_part}" "${edit_part}/drag.events" "${edit_folder}"
      -T "${SOLIDMOMENTS_TEST_OUTPUT}" -V "${CMAKE_CURRENT_SOURCE_DIR}/Baselines/TestEditPart.png")
endforeach ()

if (TEST MakeCommaLocale)
  set(comma_locale "LOCPATH=${SOLIDMOMENTS_TEST_OUTPUT}/locales")
  solidmoments_add_test(NAME ExampleNumbers_commas LABELS value error NODISPLAY FIXTURE comma_locale
    ENVIRONMENT "${comma_locale}" COMMAND TestExampleNumbers commas)
  set_tests_properties(EditPart_numbers PROPERTIES FIXTURES_REQUIRED comma_locale ENVIRONMENT "${comma_locale}")
endif ()

set(edit_program "${Python3_EXECUTABLE}" "${CMAKE_CURRENT_SOURCE_DIR}/Python/TestEditProgram.py"
  --program "$<TARGET_FILE:edit_part>" --events "${edit_part}/drag.events" --solids "${SOLIDMOMENTS_TEST_SOLIDS}"
  --output "${SOLIDMOMENTS_TEST_OUTPUT}")
solidmoments_add_test(NAME EditProgram LABELS value image error gpu NODISPLAY COMMAND ${edit_program})
set_tests_properties(EditProgram PROPERTIES FIXTURES_SETUP edit_program)
solidmoments_add_test(NAME EditProgramDisplay LABELS value image gpu XVFB FIXTURE edit_program
  COMMAND ${edit_program} --display)

set(command_line_test "${Python3_EXECUTABLE}" "${CMAKE_CURRENT_SOURCE_DIR}/Python/TestCommandLine.py"
  --program "$<TARGET_FILE:solidmoments>" --solids "${SOLIDMOMENTS_TEST_SOLIDS}"
  --output "${SOLIDMOMENTS_TEST_OUTPUT}" --sample "${sample_part}")
solidmoments_add_test(NAME CommandLine LABELS value error NODISPLAY COMMAND ${command_line_test} results)
solidmoments_add_test(NAME CommandLineIntegrals LABELS value error gpu NODISPLAY COMMAND ${command_line_test} integrals)
solidmoments_add_test(NAME CommandLineStability LABELS value error gpu NODISPLAY COMMAND ${command_line_test} stability)
solidmoments_add_test(NAME CommandLineErrors LABELS error NODISPLAY COMMAND ${command_line_test} errors)
solidmoments_add_test(NAME CommandLineOutputs LABELS error NODISPLAY COMMAND ${command_line_test} outputs)
solidmoments_add_test(NAME CommandLinePackages LABELS package NODISPLAY COMMAND ${command_line_test} packages)
solidmoments_add_test(NAME CommandLinePicture LABELS image NODISPLAY COMMAND ${command_line_test} picture)
solidmoments_add_test(NAME CommandLinePictureDisplay LABELS image XVFB COMMAND ${command_line_test} picture)
solidmoments_add_test(NAME CommandLineNoContext LABELS error gpu NODISPLAY
  ENVIRONMENT MESA_GL_VERSION_OVERRIDE=3.3 MESA_GLSL_VERSION_OVERRIDE=330 COMMAND ${command_line_test} no-context)
solidmoments_add_test(NAME CommandLineSchemes LABELS value error gpu NODISPLAY
  COMMAND "${Python3_EXECUTABLE}" "${CMAKE_CURRENT_SOURCE_DIR}/Python/TestCommandLineSchemes.py"
    --program "$<TARGET_FILE:solidmoments>" --solids "${SOLIDMOMENTS_TEST_SOLIDS}" --output "${SOLIDMOMENTS_TEST_OUTPUT}")

# The parts of Table 1, and the table.
set(paper_parts "${SOLIDMOMENTS_TEST_OUTPUT}/paper_parts")
add_test(NAME MakePaperParts COMMAND make_paper_parts "${paper_parts}")
set_tests_properties(MakePaperParts PROPERTIES LABELS value FIXTURES_SETUP paper_parts)
set(paper_programs --program "$<TARGET_FILE:solidmoments>" --occt "$<TARGET_FILE:occt_mass_properties>"
  --folder "${paper_parts}" --output "${SOLIDMOMENTS_TEST_OUTPUT}")
foreach (mode IN ITEMS values errors)
  solidmoments_add_test(NAME PaperParts_${mode} LABELS value error NODISPLAY FIXTURE paper_parts
    COMMAND "${Python3_EXECUTABLE}" -B "${CMAKE_CURRENT_SOURCE_DIR}/Python/TestPaperParts.py"
      --make "$<TARGET_FILE:make_paper_parts>" ${paper_programs} ${mode})
endforeach ()
foreach (mode IN ITEMS known parts)
  solidmoments_add_test(NAME PaperTable_${mode} LABELS value error NODISPLAY FIXTURE paper_parts
    COMMAND "${Python3_EXECUTABLE}" -B "${CMAKE_CURRENT_SOURCE_DIR}/Python/TestPaperTable.py"
      --table "${PROJECT_SOURCE_DIR}/Examples/Paper/table.py" ${paper_programs} ${mode})
endforeach ()

# The paper's figures, of a display and of none; what is in them is judged once.
set(paper_figures "${SOLIDMOMENTS_TEST_OUTPUT}/paper_figures")
set(paper_models)
foreach (part IN ITEMS propeller crank engine_block gear_train free_form trefoil_tube)
  list(APPEND paper_models --model "${paper_parts}/${part}.step")
endforeach ()
solidmoments_add_test(NAME DrawPaperFigures LABELS image gpu NODISPLAY TIMEOUT 600 FIXTURE paper_parts
  COMMAND paper_figures "${paper_figures}" --part "${paper_parts}/free_form.step" ${paper_models})
set_tests_properties(DrawPaperFigures PROPERTIES FIXTURES_SETUP paper_figures)
solidmoments_add_test(NAME DrawPaperFiguresDisplay LABELS image gpu XVFB
  COMMAND paper_figures "${SOLIDMOMENTS_TEST_OUTPUT}/paper_figures_display")
set_tests_properties(DrawPaperFiguresDisplay PROPERTIES FIXTURES_SETUP paper_figures)
solidmoments_add_test_program(TestPaperFigures VTK::IOImage VTK::ImagingCore)
solidmoments_add_test(NAME PaperFigures LABELS value image NODISPLAY FIXTURE paper_figures
  COMMAND TestPaperFigures "${paper_figures}" "${CMAKE_CURRENT_SOURCE_DIR}/Baselines/TestPaperFigures.png"
    "${PROJECT_SOURCE_DIR}/Examples/Paper/images/fig1.png")
# The solids of the figures are compiled in.
solidmoments_add_test_program(TestTrimTextureOrder)
foreach (source IN ITEMS smPaperSolid smSolidBuilder)
  target_sources(TestTrimTextureOrder PRIVATE "${PROJECT_SOURCE_DIR}/Examples/Paper/${source}.cxx")
endforeach ()
target_include_directories(TestTrimTextureOrder PRIVATE "${PROJECT_SOURCE_DIR}/Examples/Paper")
solidmoments_add_test(NAME TrimTextureOrder LABELS value NODISPLAY COMMAND TestTrimTextureOrder)
solidmoments_add_test(NAME PaperFiguresErrors LABELS error NODISPLAY
  COMMAND paper_figures "${SOLIDMOMENTS_TEST_OUTPUT}/paper_figures_error" --part
    "${SOLIDMOMENTS_TEST_SOLIDS}/no_geometry.step")
set_tests_properties(PaperFiguresErrors PROPERTIES PASS_REGULAR_EXPRESSION "could not be read|has no volume")

# A project outside the tree, against an install in the build folder; and everything else that is installed.
set(package_options)
if (SOLIDMOMENTS_WRAP_PYTHON)
  # Python's modules of the VTK that ours were built with: there may be others, Debian's ParaView has some on the default path.
  set(vtk_python_path "${VTK_PREFIX_PATH}/${VTK_PYTHONPATH}")
  list(APPEND package_options "-DPYTHON=${Python3_EXECUTABLE}" "-DPYTHON_DESTINATION=${SOLIDMOMENTS_PYTHON_DESTINATION}"
    "-DVTK_PYTHON_PATH=${vtk_python_path}")
endif ()
if (SOLIDMOMENTS_BUILD_PARAVIEW_PLUGIN)
  list(APPEND package_options "-DPVPYTHON=${SOLIDMOMENTS_PVPYTHON}")
endif ()
solidmoments_add_test(NAME PackageConsumer LABELS package NODISPLAY TIMEOUT 600
  COMMAND "${CMAKE_COMMAND}" "-DBUILD=${PROJECT_BINARY_DIR}" "-DPREFIX=${PROJECT_BINARY_DIR}/test-install"
    "-DCONSUMER=${PROJECT_SOURCE_DIR}/Examples/Consumer" "-DGENERATOR=${CMAKE_GENERATOR}"
    "-DCXX=${CMAKE_CXX_COMPILER}" "-DCC=${CMAKE_C_COMPILER}" "-DCONFIG=$<CONFIG>" "-DFLAGS=${CMAKE_CXX_FLAGS}"
    "-DSOLIDS=${SOLIDMOMENTS_TEST_SOLIDS}" "-DPART=${SOLIDMOMENTS_TEST_SOLIDS}/box-plain.step" -DVOLUME=6000
    ${package_options} -P "${CMAKE_CURRENT_SOURCE_DIR}/TestPackageConsumer.cmake")

if (SOLIDMOMENTS_WRAP_PYTHON)
  set(python_path
    "PYTHONPATH=${PROJECT_BINARY_DIR}/${SOLIDMOMENTS_PYTHON_DESTINATION}:${vtk_python_path}")
  solidmoments_add_test(NAME PythonModules LABELS package NODISPLAY ENVIRONMENT "${python_path}"
    COMMAND "${Python3_EXECUTABLE}" "${CMAKE_CURRENT_SOURCE_DIR}/Python/TestModules.py"
      "${SOLIDMOMENTS_TEST_SOLIDS}")
  # pvpython has ParaView's VTK: modules that were built with another do not load there.
  if (SOLIDMOMENTS_PVPYTHON AND SOLIDMOMENTS_BUILD_PARAVIEW_PLUGIN)
    solidmoments_add_test(NAME PythonModulesPvpython LABELS package NODISPLAY ENVIRONMENT "${python_path}"
      COMMAND "${SOLIDMOMENTS_PVPYTHON}" "${CMAKE_CURRENT_SOURCE_DIR}/Python/TestModules.py"
        "${SOLIDMOMENTS_TEST_SOLIDS}")
  endif ()
endif ()

if (EXISTS "${SOLIDMOMENTS_MODELS_DIR}/reference.jsonl")
  solidmoments_add_test(NAME SweepModels LABELS value robust NODISPLAY TIMEOUT 3600 FIXTURE models
    COMMAND "${Python3_EXECUTABLE}" -B "${CMAKE_CURRENT_SOURCE_DIR}/SweepModels.py"
      --program "$<TARGET_FILE:solidmoments>" --models "${SOLIDMOMENTS_MODELS_DIR}"
      --exceptions "${CMAKE_CURRENT_SOURCE_DIR}/SweepExceptions.json"
      --folder "${SOLIDMOMENTS_UNPACKED_MODELS}" --markdown "${SOLIDMOMENTS_TEST_OUTPUT}/models.md"
      --csv "${SOLIDMOMENTS_TEST_OUTPUT}/models.csv")
  set_tests_properties(SweepModels PROPERTIES RUN_SERIAL ON)
endif ()
