# Debian packages, made by `cpack` in a build that was configured by the preset `package`: libraries, what
# builds on them, Python, programs, plugin. Testing/packages.sh builds, installs, tries and removes them.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME solidmoments)
set(CPACK_PACKAGE_CONTACT "The SolidMoments authors")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_PRE_BUILD_SCRIPTS "${CMAKE_CURRENT_LIST_DIR}/SolidMomentsCompressManuals.cmake")
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION math)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS "${CMAKE_LIBRARY_OUTPUT_DIRECTORY}")
# The Debian release of a package is part of its version, because each release has its own ParaView and
# OpenCASCADE.
set(release 1)
if (EXISTS /etc/os-release)
  file(STRINGS /etc/os-release line REGEX "^VERSION_ID=")
  if (line MATCHES "([0-9]+)")
    set(release "1~deb${CMAKE_MATCH_1}")
  endif ()
endif ()
set(CPACK_DEBIAN_PACKAGE_RELEASE "${release}")
set(own "(= ${PROJECT_VERSION}-${release})")

# solidmoments_package(<component> <package> <summary> <depends>): the licence goes where Debian has it.
set(CPACK_COMPONENTS_ALL)
macro(solidmoments_package component package summary depends)
  list(APPEND CPACK_COMPONENTS_ALL ${component})
  string(TOUPPER "${component}" _name)
  set(CPACK_DEBIAN_${_name}_PACKAGE_NAME "${package}")
  set(CPACK_DEBIAN_${_name}_PACKAGE_DEPENDS "${depends}")
  set(CPACK_DEBIAN_${_name}_DESCRIPTION "${summary}
 SolidMoments computes volume, area, centre of mass and inertia of the exact
 solids in STEP files, each with an error bound, on the GPU or the CPU.")
  install(FILES "${PROJECT_SOURCE_DIR}/LICENSE" DESTINATION "${CMAKE_INSTALL_DATADIR}/doc/${package}" RENAME copyright
    COMPONENT ${component} EXCLUDE_FROM_ALL)
endmacro ()

# Users of the libraries need the packages with which the libraries were built, except the tools.
execute_process(COMMAND sh -c ". \"$0\"; solidmoments_library_packages" "${PROJECT_SOURCE_DIR}/Examples/install-packages.sh"
  OUTPUT_VARIABLE development OUTPUT_STRIP_TRAILING_WHITESPACE)
string(REGEX REPLACE "[ \n]+" ", " development "${development}")
solidmoments_package(Libraries libsolidmoments "mass properties of CAD solids (libraries)" "")
solidmoments_package(Development libsolidmoments-dev "mass properties of CAD solids (development files)"
  "libsolidmoments ${own}, python3-solidmoments ${own}, ${development}")
if (SOLIDMOMENTS_WRAP_PYTHON)
  set(python "${Python3_VERSION_MAJOR}.${Python3_VERSION_MINOR}")
  solidmoments_package(python python3-solidmoments "mass properties of CAD solids (Python modules)"
    "libsolidmoments ${own}, python3-paraview, python3 (>= ${python}), python3 (<< ${python}.99)")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA
    "${CMAKE_CURRENT_LIST_DIR}/python3-package/postinst" "${CMAKE_CURRENT_LIST_DIR}/python3-package/prerm")
endif ()
if (SOLIDMOMENTS_BUILD_EXAMPLES)
  solidmoments_package(Programs solidmoments "mass properties of CAD solids (programs)" "libsolidmoments ${own}")
  install(FILES README.md CHANGELOG.md DESTINATION "${CMAKE_INSTALL_DATADIR}/doc/solidmoments" COMPONENT Programs EXCLUDE_FROM_ALL)
  install(DIRECTORY Documentation DESTINATION "${CMAKE_INSTALL_DATADIR}/doc/solidmoments" COMPONENT Programs EXCLUDE_FROM_ALL)
endif ()
if (SOLIDMOMENTS_BUILD_PARAVIEW_PLUGIN)
  solidmoments_package(Plugin paraview-solidmoments "mass properties of CAD solids (ParaView plugin)"
    "libsolidmoments ${own}, paraview")
endif ()
include(CPack)
