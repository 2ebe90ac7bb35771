# The certified set of solids, and the script that runs programs over it.
set(certified_test "${Python3_EXECUTABLE}" -B "${CMAKE_CURRENT_SOURCE_DIR}/TestCertifiedSet.py"
  --folder "${PROJECT_SOURCE_DIR}/Examples/Certified" --output "${SOLIDMOMENTS_TEST_OUTPUT}"
  --program "$<TARGET_FILE:solidmoments>")
solidmoments_add_test(NAME CertifiedSet_made LABELS value NODISPLAY COMMAND ${certified_test} made)
solidmoments_add_test(NAME CertifiedSet_formulas LABELS value NODISPLAY COMMAND ${certified_test} formulas)
solidmoments_add_test(NAME CertifiedSet_checker LABELS value error NODISPLAY COMMAND ${certified_test} checker)
solidmoments_add_test(NAME CertifiedSet_program LABELS value NODISPLAY COMMAND ${certified_test} program)
solidmoments_add_test(NAME CertifiedSet_few LABELS value gpu NODISPLAY COMMAND ${certified_test} few)
if (TARGET occt_mass_properties)
  solidmoments_add_test(NAME CertifiedSet_occt LABELS value NODISPLAY
    COMMAND ${certified_test} --other "$<TARGET_FILE:occt_mass_properties>" other)
endif ()
