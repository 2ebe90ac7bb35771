# Pictures against baselines: of the filter's outputs in C++, and of what Apply shows in ParaView.
set(picture_folders "${SOLIDMOMENTS_TEST_SOLIDS}" "${paper_parts}" "${PROJECT_SOURCE_DIR}/Examples/Models"
  "${SOLIDMOMENTS_TEST_OUTPUT}" "${CMAKE_CURRENT_SOURCE_DIR}/Baselines")

solidmoments_add_test_program(TestMassPropertiesPictures VTK::IOImage)
foreach (mode IN ITEMS parts assembly axes flagged colors)
  solidmoments_add_test(NAME MassPropertiesPictures_${mode} LABELS image gpu XVFB FIXTURE paper_parts
    COMMAND TestMassPropertiesPictures ${mode} ${picture_folders})
endforeach ()

if (SOLIDMOMENTS_BUILD_PARAVIEW_PLUGIN)
  foreach (mode IN ITEMS part assembly flagged share volume)
    solidmoments_add_test(NAME PluginPictures_${mode} LABELS plugin image XVFB FIXTURE paper_parts
      COMMAND "${SOLIDMOMENTS_PVPYTHON}" "${CMAKE_CURRENT_SOURCE_DIR}/Python/TestPluginPictures.py" ${mode}
        "$<TARGET_FILE:SolidMoments>" ${picture_folders})
  endforeach ()
endif ()
