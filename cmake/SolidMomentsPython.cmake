# Python package `solidmoments` with one extension module per VTK module.
if (NOT SOLIDMOMENTS_WRAP_PYTHON)
  return ()
endif ()
find_package(Python3 REQUIRED COMPONENTS Interpreter Development.Module)
set(SOLIDMOMENTS_PYTHON_DESTINATION
  "${CMAKE_INSTALL_LIBDIR}/python${Python3_VERSION_MAJOR}.${Python3_VERSION_MINOR}/site-packages" CACHE STRING
  "Folder of the Python package in an install and in the build tree")
mark_as_advanced(SOLIDMOMENTS_PYTHON_DESTINATION)
# The extension modules lie three folders below the libraries.
set(solidmoments_install_rpath "${CMAKE_INSTALL_RPATH}")
list(APPEND CMAKE_INSTALL_RPATH "$ORIGIN/../../..")
vtk_module_wrap_python(
  MODULES             ${solidmoments_modules}
  INSTALL_EXPORT      SolidMoments
  INSTALL_HEADERS     OFF
  PYTHON_PACKAGE      "solidmoments"
  MODULE_DESTINATION  "${SOLIDMOMENTS_PYTHON_DESTINATION}"
  CMAKE_DESTINATION   "${SOLIDMOMENTS_CMAKE_DESTINATION}"
  WRAPPED_MODULES     solidmoments_python_modules
  TARGET              SolidMoments::Python)
set(CMAKE_INSTALL_RPATH "${solidmoments_install_rpath}")
# The pure Python part of the package: mass_properties() and others, which use those modules.
set(solidmoments_vtk_folder "${VTK_PREFIX_PATH}/${VTK_PYTHONPATH}")
# The name of the interpreter with its version is used if it exists, because the name without it may be
# another Python later.
set(solidmoments_python "${Python3_EXECUTABLE}")
get_filename_component(solidmoments_python_bin "${Python3_EXECUTABLE}" DIRECTORY)
set(solidmoments_versioned_python "${solidmoments_python_bin}/python${Python3_VERSION_MAJOR}.${Python3_VERSION_MINOR}")
if (EXISTS "${solidmoments_versioned_python}")
  set(solidmoments_python "${solidmoments_versioned_python}")
endif ()
set(solidmoments_python_folder "${CMAKE_BINARY_DIR}/${SOLIDMOMENTS_PYTHON_DESTINATION}/solidmoments")
configure_file("${CMAKE_CURRENT_SOURCE_DIR}/Python/solidmoments/_version.py.in" "${solidmoments_python_folder}/_version.py" @ONLY)
foreach (file IN ITEMS __init__ _arguments _arrays _gradient _hessian _mesh _model _products _pyvista _results _run _variants _write_mesh autodiff)
  configure_file("${CMAKE_CURRENT_SOURCE_DIR}/Python/solidmoments/${file}.py" "${solidmoments_python_folder}/${file}.py" COPYONLY)
  install(FILES "${CMAKE_CURRENT_SOURCE_DIR}/Python/solidmoments/${file}.py"
    DESTINATION "${SOLIDMOMENTS_PYTHON_DESTINATION}/solidmoments" COMPONENT python)
endforeach ()
install(FILES "${solidmoments_python_folder}/_version.py"
  DESTINATION "${SOLIDMOMENTS_PYTHON_DESTINATION}/solidmoments" COMPONENT python)
# PyVista finds the reader by these entry points, without an import of the package.
set(solidmoments_distribution "solidmoments-${PROJECT_VERSION}.dist-info")
set(solidmoments_distribution_folder "${CMAKE_BINARY_DIR}/${SOLIDMOMENTS_PYTHON_DESTINATION}/${solidmoments_distribution}")
configure_file("${CMAKE_CURRENT_SOURCE_DIR}/Python/METADATA.in" "${solidmoments_distribution_folder}/METADATA" @ONLY)
configure_file("${CMAKE_CURRENT_SOURCE_DIR}/Python/entry_points.txt" "${solidmoments_distribution_folder}/entry_points.txt" COPYONLY)
# Removes the entry points of other versions, which would be found, too.
install(CODE "file(GLOB others \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${SOLIDMOMENTS_PYTHON_DESTINATION}/solidmoments-*.dist-info\")
  list(FILTER others EXCLUDE REGEX \"/${solidmoments_distribution}\\$\")
  if (others)
    file(REMOVE_RECURSE \${others})
  endif ()" COMPONENT python)
install(DIRECTORY "${solidmoments_distribution_folder}" DESTINATION "${SOLIDMOMENTS_PYTHON_DESTINATION}" COMPONENT python)
