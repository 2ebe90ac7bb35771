# The package that find_package(SolidMoments) finds, in the build tree and in an install.
include(CMakePackageConfigHelpers)
configure_package_config_file(
  "${CMAKE_CURRENT_SOURCE_DIR}/cmake/SolidMomentsConfig.cmake.in"
  "${CMAKE_BINARY_DIR}/${SOLIDMOMENTS_CMAKE_DESTINATION}/SolidMomentsConfig.cmake"
  INSTALL_DESTINATION "${SOLIDMOMENTS_CMAKE_DESTINATION}")
write_basic_package_version_file(
  "${CMAKE_BINARY_DIR}/${SOLIDMOMENTS_CMAKE_DESTINATION}/SolidMomentsConfigVersion.cmake"
  VERSION "${PROJECT_VERSION}" COMPATIBILITY SameMinorVersion)
file(COPY "${CMAKE_CURRENT_SOURCE_DIR}/cmake/SolidMomentsPythonModules.cmake"
  DESTINATION "${CMAKE_BINARY_DIR}/${SOLIDMOMENTS_CMAKE_DESTINATION}")
export(EXPORT SolidMoments NAMESPACE SolidMoments::
  FILE "${CMAKE_BINARY_DIR}/${SOLIDMOMENTS_CMAKE_DESTINATION}/SolidMomentsTargets.cmake")
install(EXPORT SolidMoments NAMESPACE SolidMoments:: FILE SolidMomentsTargets.cmake
  DESTINATION "${SOLIDMOMENTS_CMAKE_DESTINATION}" COMPONENT Development)
install(FILES
  "${CMAKE_BINARY_DIR}/${SOLIDMOMENTS_CMAKE_DESTINATION}/SolidMomentsConfig.cmake"
  "${CMAKE_BINARY_DIR}/${SOLIDMOMENTS_CMAKE_DESTINATION}/SolidMomentsConfigVersion.cmake"
  "${CMAKE_CURRENT_SOURCE_DIR}/cmake/SolidMomentsPythonModules.cmake"
  DESTINATION "${SOLIDMOMENTS_CMAKE_DESTINATION}" COMPONENT Development)
