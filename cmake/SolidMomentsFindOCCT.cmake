# Finds OpenCASCADE, and names the libraries that differ between its versions. Every folder that links it
# includes this: its package adds definitions to the folder.
find_package(OpenCASCADE QUIET)
if (NOT OpenCASCADE_FOUND)
  message(FATAL_ERROR
    "OpenCASCADE was not found. SolidMoments reads STEP files with it: install its development files "
    "(Debian: libocct-data-exchange-dev libocct-modeling-algorithms-dev libtbb-dev) or set OpenCASCADE_DIR "
    "to the folder that holds OpenCASCADEConfig.cmake.")
endif ()
# The translator of STEP files, with what other modules take from its libraries.
if (TARGET TKDESTEP)
  set(SOLIDMOMENTS_OCCT_STEP TKDESTEP TKXSBase)
else ()
  set(SOLIDMOMENTS_OCCT_STEP TKXDESTEP TKSTEP TKXSBase)
endif ()
