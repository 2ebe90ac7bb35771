# A project outside the tree, against an install in the build folder; and everything else that is installed.
set(package_options)
if (SOLIDMOMENTS_WRAP_PYTHON)
  # Python's modules of the VTK that ours were built with: there may be others, Debian's ParaView has some on
  # the default path.
  set(vtk_python_path "${VTK_PREFIX_PATH}/${VTK_PYTHONPATH}")
  list(APPEND package_options "-DPYTHON=${Python3_EXECUTABLE}" "-DPYTHON_DESTINATION=${SOLIDMOMENTS_PYTHON_DESTINATION}"
    "-DVTK_PYTHON_PATH=${vtk_python_path}")
endif ()
if (SOLIDMOMENTS_BUILD_PARAVIEW_PLUGIN)
  list(APPEND package_options "-DPVPYTHON=${SOLIDMOMENTS_PVPYTHON}")
endif ()
# Optional modules of this build that the Python test uses.
set(python_modules)
foreach (module IN ITEMS NURBSEdit Stability)
  if (TARGET SolidMoments::Filters${module})
    list(APPEND python_modules ${module})
  endif ()
endforeach ()
string(REPLACE ";" "," package_modules "${python_modules}")
solidmoments_add_test(NAME PackageConsumer LABELS package NODISPLAY TIMEOUT 600
  COMMAND "${CMAKE_COMMAND}" "-DBUILD=${PROJECT_BINARY_DIR}" "-DPREFIX=${PROJECT_BINARY_DIR}/test-install"
    "-DCONSUMER=${PROJECT_SOURCE_DIR}/Examples/Consumer" "-DGENERATOR=${CMAKE_GENERATOR}"
    "-DCXX=${CMAKE_CXX_COMPILER}" "-DCC=${CMAKE_C_COMPILER}" "-DCONFIG=$<CONFIG>" "-DFLAGS=${CMAKE_CXX_FLAGS}"
    "-DSOLIDS=${SOLIDMOMENTS_TEST_SOLIDS}" "-DPART=${SOLIDMOMENTS_TEST_SOLIDS}/box-plain.step" -DVOLUME=6000
    "-DMODULES=${package_modules}" ${package_options} -P "${CMAKE_CURRENT_SOURCE_DIR}/TestPackageConsumer.cmake")

if (SOLIDMOMENTS_WRAP_PYTHON)
  set(python_path
    "PYTHONPATH=${PROJECT_BINARY_DIR}/${SOLIDMOMENTS_PYTHON_DESTINATION}:${vtk_python_path}")
  solidmoments_add_test(NAME PythonModules LABELS package NODISPLAY ENVIRONMENT "${python_path}"
    COMMAND "${Python3_EXECUTABLE}" "${CMAKE_CURRENT_SOURCE_DIR}/TestModules.py"
      "${SOLIDMOMENTS_TEST_SOLIDS}" ${python_modules})
  solidmoments_add_test(NAME PythonPackage LABELS value error package NODISPLAY ENVIRONMENT "${python_path}"
    COMMAND "${Python3_EXECUTABLE}" -B "${CMAKE_CURRENT_SOURCE_DIR}/TestPythonPackage.py" "$<TARGET_FILE:solidmoments>"
      "${SOLIDMOMENTS_TEST_SOLIDS}" "${SOLIDMOMENTS_SAMPLE_PART}" "${PROJECT_VERSION}")
  solidmoments_add_test(NAME PythonArguments LABELS error package NODISPLAY ENVIRONMENT "${python_path}"
    COMMAND "${Python3_EXECUTABLE}" -B "${CMAKE_CURRENT_SOURCE_DIR}/TestPythonArguments.py" "${SOLIDMOMENTS_SAMPLE_PART}"
      "${SOLIDMOMENTS_TEST_SOLIDS}/box-plain.step" "${SOLIDMOMENTS_TEST_OUTPUT}")
  solidmoments_add_test(NAME PythonProducts LABELS value package NODISPLAY ENVIRONMENT "${python_path}"
    COMMAND "${Python3_EXECUTABLE}" -B "${CMAKE_CURRENT_SOURCE_DIR}/TestPythonProducts.py" "$<TARGET_FILE:solidmoments>" "${SOLIDMOMENTS_TEST_OUTPUT}")
  # The counts are those that the filter states.
  solidmoments_add_test(NAME CountDispatches LABELS value gpu NODISPLAY ENVIRONMENT "${python_path}" "CC=${CMAKE_C_COMPILER}"
    STATUS 0 TEXT "sample_part.step [^#]* [0-9]+ \\| [0-9]+ \\| [1-9]" WITHOUT "wrong"
    COMMAND "${Python3_EXECUTABLE}" -B "${PROJECT_SOURCE_DIR}/Testing/Benchmarks/CountDispatches.py" "${PROJECT_BINARY_DIR}" --runs 1
      --files "${SOLIDMOMENTS_SAMPLE_PART}")
  solidmoments_add_test(NAME DisplayMesh LABELS value error package NODISPLAY ENVIRONMENT "${python_path}"
    COMMAND "${Python3_EXECUTABLE}" -B "${CMAKE_CURRENT_SOURCE_DIR}/TestDisplayMesh.py" "${SOLIDMOMENTS_TEST_SOLIDS}"
      "${SOLIDMOMENTS_SAMPLE_PART}")
  # Saved solids in other programs, where these are installed: gmsh (Debian: python3-gmsh), FreeCAD
  # (freecad-python3), and npm's occt-import-js, with
  # -DSOLIDMOMENTS_OCCT_IMPORT_JS=.../node_modules/occt-import-js/dist/occt-import-js.js.
  set(SOLIDMOMENTS_OCCT_IMPORT_JS "" CACHE FILEPATH "occt-import-js.js of npm's occt-import-js, for tests; empty: without")
  find_path(SOLIDMOMENTS_FREECAD FreeCAD.so PATHS /usr/lib/freecad-python3/lib NO_DEFAULT_PATH)
  mark_as_advanced(SOLIDMOMENTS_FREECAD)
  execute_process(COMMAND "${Python3_EXECUTABLE}" -c "import gmsh" RESULT_VARIABLE gmsh_is_missing OUTPUT_QUIET ERROR_QUIET)
  set(solid_readers)
  if (NOT gmsh_is_missing)
    list(APPEND solid_readers gmsh)
    set(gmsh_program module)
  endif ()
  if (SOLIDMOMENTS_FREECAD)
    list(APPEND solid_readers freecad)
    set(freecad_program "${SOLIDMOMENTS_FREECAD}")
  endif ()
  if (SOLIDMOMENTS_OCCT_IMPORT_JS)
    list(APPEND solid_readers occt-import-js)
    set(occt-import-js_program "${SOLIDMOMENTS_OCCT_IMPORT_JS}")
  endif ()
  foreach (reader IN LISTS solid_readers)
    solidmoments_add_test(NAME SavedSolids_${reader} LABELS value package NODISPLAY TIMEOUT 900 ENVIRONMENT "${python_path}"
      COMMAND "${Python3_EXECUTABLE}" -B "${CMAKE_CURRENT_SOURCE_DIR}/TestSavedSolids.py" "${SOLIDMOMENTS_TEST_SOLIDS}"
        "${SOLIDMOMENTS_TEST_OUTPUT}/saved-solids" ${reader} "${${reader}_program}")
  endforeach ()
  if (SOLIDMOMENTS_FREECAD)
    solidmoments_add_test(NAME MirroredTwin LABELS value package NODISPLAY COMMAND "${Python3_EXECUTABLE}" -B
      "${CMAKE_CURRENT_SOURCE_DIR}/TestMirroredTwin.py" "$<TARGET_FILE:solidmoments>" "${SOLIDMOMENTS_TEST_OUTPUT}/mirrored-twin" "${SOLIDMOMENTS_FREECAD}")
  endif ()
  if (SOLIDMOMENTS_FREECAD AND EXISTS "${SOLIDMOMENTS_MODELS_DIR}/reference.jsonl")
    solidmoments_add_test(NAME CompareSaved LABELS value package NODISPLAY FIXTURE models ENVIRONMENT "${python_path}"
      COMMAND "${Python3_EXECUTABLE}" -B "${PROJECT_SOURCE_DIR}/Testing/Sweeps/CompareSaved.py" --freecad "${SOLIDMOMENTS_FREECAD}"
        --folder "${SOLIDMOMENTS_UNPACKED_MODELS}" --output "${SOLIDMOMENTS_TEST_OUTPUT}/compare-saved"
        --only gmsh_part odri_motor nodeocc_vention nist_ctc_03 gmsh_crankshaft caxif_as1_tu_203 prusa_mini_xcarriage)
  endif ()
  # STEP against BREP, of our writer and of gmsh, which reads STEP by OpenCASCADE.
  if (EXISTS "${SOLIDMOMENTS_MODELS_DIR}/reference.jsonl")
    foreach (writer IN ITEMS own gmsh)
      if (writer STREQUAL "own" OR NOT gmsh_is_missing)
        solidmoments_add_test(NAME CompareFormats_${writer} LABELS value package NODISPLAY FIXTURE models ENVIRONMENT "${python_path}"
          COMMAND "${Python3_EXECUTABLE}" -B "${PROJECT_SOURCE_DIR}/Testing/Sweeps/CompareFormats.py" --program "$<TARGET_FILE:solidmoments>"
            --folder "${SOLIDMOMENTS_UNPACKED_MODELS}" --writer ${writer} --output "${SOLIDMOMENTS_TEST_OUTPUT}/formats"
            --only gmsh_part axom_sliced_cylinder caxif_as1_pe_203 gmsh_cube_filet nist_ctc_01)
      endif ()
    endforeach ()
  endif ()
  # With PyVista itself, where it is installed.
  execute_process(COMMAND "${Python3_EXECUTABLE}" -c "import pyvista; pyvista.register_reader" RESULT_VARIABLE pyvista_is_missing
    OUTPUT_QUIET ERROR_QUIET)
  if (NOT pyvista_is_missing)
    solidmoments_add_test(NAME PyVistaReader LABELS value package NODISPLAY
      ENVIRONMENT "PYTHONPATH=${PROJECT_BINARY_DIR}/${SOLIDMOMENTS_PYTHON_DESTINATION}"
      COMMAND "${Python3_EXECUTABLE}" -B "${CMAKE_CURRENT_SOURCE_DIR}/TestDisplayMesh.py" "${SOLIDMOMENTS_TEST_SOLIDS}"
        "${SOLIDMOMENTS_SAMPLE_PART}" pyvista)
  else ()
    message(STATUS "PyVista is not installed: the test PyVistaReader is left out")
  endif ()
  # pvpython has ParaView's VTK: modules that were built with another do not load there.
  if (SOLIDMOMENTS_PVPYTHON AND SOLIDMOMENTS_BUILD_PARAVIEW_PLUGIN)
    solidmoments_add_test(NAME PythonModulesPvpython LABELS package NODISPLAY ENVIRONMENT "${python_path}"
      COMMAND "${SOLIDMOMENTS_PVPYTHON}" "${CMAKE_CURRENT_SOURCE_DIR}/TestModules.py"
        "${SOLIDMOMENTS_TEST_SOLIDS}" ${python_modules})
  endif ()
endif ()
