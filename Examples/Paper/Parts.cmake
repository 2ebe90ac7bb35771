# The programs that make the parts of Table 1, and that compute mass properties by OpenCASCADE.
include(SolidMomentsFindOCCT)
if (NOT TARGET TKFillet OR NOT TARGET TKOffset)
  message(FATAL_ERROR "OpenCASCADE with fillets was not found. Install libocct-data-exchange-dev and "
    "libocct-modeling-algorithms-dev, set OpenCASCADE_DIR, or configure with -DSOLIDMOMENTS_BUILD_PAPER=OFF "
    "-DSOLIDMOMENTS_BUILD_TESTING=OFF.")
endif ()

add_executable(make_paper_parts
  make_paper_parts.cxx
  smCrank.cxx
  smEngineBlock.cxx
  smExactParts.cxx
  smFreeForm.cxx
  smGearTrain.cxx
  smGearTrainParts.cxx
  smModelling.cxx
  smPartFile.cxx
  smPropeller.cxx
  smTrefoilTube.cxx)
add_executable(occt_mass_properties occt_mass_properties.cxx)
foreach (program IN ITEMS make_paper_parts occt_mass_properties)
  target_include_directories(${program} SYSTEM PRIVATE "${OpenCASCADE_INCLUDE_DIR}")
  target_link_libraries(${program} PRIVATE
    smExampleText CLI11::CLI11 ${SOLIDMOMENTS_OCCT_STEP} TKXCAF TKLCAF TKCDF TKFillet TKOffset TKShHealing TKBool TKBO
    TKPrim TKTopAlgo TKGeomAlgo TKBRep TKGeomBase TKG3d TKG2d TKMath TKernel)
  solidmoments_warnings(${program})
endforeach ()
target_link_libraries(make_paper_parts PRIVATE SolidMoments::FiltersNURBS)
