# Finds the VTK to build against: ParaView's own by default, a plain VTK when the plugin is off.
set(_vtk_components
  ChartsCore CommonColor CommonCore CommonDataModel CommonExecutionModel CommonMath CommonSystem CommonTransforms
  FiltersCore FiltersGeneral FiltersSources IOCore IOGeometry IOImage IOPLY IOXML ImagingCore InteractionStyle ParallelCore
  RenderingAnnotation RenderingContext2D RenderingContextOpenGL2 RenderingCore RenderingFreeType RenderingOpenGL2 RenderingUI TestingRendering vtksys
  zlib)
if (SOLIDMOMENTS_WRAP_PYTHON)
  if (NOT Python3_EXECUTABLE AND EXISTS /usr/bin/python3)
    # VTK's wrappers are built for the system's Python, which need not be the first one on PATH.
    set(Python3_EXECUTABLE /usr/bin/python3 CACHE FILEPATH "The Python that VTK was built for")
  endif ()
  list(APPEND _vtk_components Python WrappingPythonCore)
endif ()

include(SolidMomentsPythonModules)
if (SOLIDMOMENTS_BUILD_PARAVIEW_PLUGIN)
  solidmoments_accept_python_modules(ParaView)
  # Without COMPONENTS ParaView requires everything it was built with (Qt, GDAL, FFmpeg).
  find_package(ParaView 5.11 QUIET
    COMPONENTS RemotingCore RemotingServerManager RemotingViews VTKExtensionsFiltersRendering)
  if (NOT ParaView_FOUND)
    message(FATAL_ERROR "ParaView 5.11 or later was not found (${ParaView_NOT_FOUND_MESSAGE}). Install paraview-dev and "
      "python3-paraview, set ParaView_DIR, or configure with -DSOLIDMOMENTS_BUILD_PARAVIEW_PLUGIN=OFF and VTK_DIR "
      "to build the modules against a plain VTK.")
  endif ()
  set(VTK_DIR "${ParaView_DIR}/vtk" CACHE PATH "ParaView's own VTK" FORCE)
endif ()
solidmoments_accept_python_modules(VTK)
# The loader of OpenGL is GLEW before VTK 9.4, and glad from then on. Only tests need MPI itself (ParallelMPI)
# and a filter that communicates between ranks (FiltersParallel).
find_package(VTK 9.1 QUIET COMPONENTS ${_vtk_components} OPTIONAL_COMPONENTS ParallelMPI FiltersParallel nlohmannjson
  glad glew opengl)
if (NOT VTK_FOUND)
  message(FATAL_ERROR "VTK 9.1 or later was not found (${VTK_NOT_FOUND_MESSAGE}). Set VTK_DIR.")
endif ()
set(SOLIDMOMENTS_OPENGL_LOADER)
foreach (module IN ITEMS VTK::glad VTK::glew VTK::opengl)
  if (TARGET ${module})
    list(APPEND SOLIDMOMENTS_OPENGL_LOADER ${module})
  endif ()
endforeach ()
message(STATUS "VTK ${VTK_VERSION} from ${VTK_DIR}")

# VTK's own JSON library where it has one, because another one cannot be loaded in addition to it.
set(SOLIDMOMENTS_JSON VTK::nlohmannjson)
if (NOT TARGET VTK::nlohmannjson)
  find_package(nlohmann_json QUIET)
  if (NOT nlohmann_json_FOUND)
    message(FATAL_ERROR "nlohmann_json was not found (Debian: nlohmann-json3-dev). Install it, or set nlohmann_json_DIR.")
  endif ()
  set(SOLIDMOMENTS_JSON nlohmann_json::nlohmann_json)
endif ()
