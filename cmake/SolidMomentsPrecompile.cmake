# Precompiled headers of the modules, one for those that are mostly mathematics and one for those that are
# mostly VTK. A precompiled header for each module would take longer than it saves. Every file includes the
# headers it uses and compiles without precompiled ones, too (-DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON).
set(solidmoments_standard_headers
  <algorithm> <array> <cmath> <functional> <limits> <map> <memory> <string> <utility> <vector>)

# solidmoments_precompile(<owner> HEADERS <header>... LIBRARIES <target>... TARGETS <target>...): the owner
# must be compiled with the same options as the targets.
function(solidmoments_precompile owner)
  cmake_parse_arguments(precompile "" "" "HEADERS;LIBRARIES;TARGETS" ${ARGN})
  add_library(${owner} OBJECT "${PROJECT_SOURCE_DIR}/cmake/smPrecompiled.cxx")
  target_link_libraries(${owner} PRIVATE ${precompile_LIBRARIES})
  target_precompile_headers(${owner} PRIVATE ${solidmoments_standard_headers} ${precompile_HEADERS})
  foreach (target IN LISTS precompile_TARGETS)
    if (TARGET ${target})
      target_precompile_headers(${target} REUSE_FROM ${owner})
    endif ()
  endforeach ()
endfunction ()

solidmoments_precompile(smPrecompiledStandard
  TARGETS FiltersCommon FiltersBezier FiltersNURBS FiltersQuadrature FiltersStability ReadersFaces ReadersPart21 RenderingCompute RenderingNURBS RenderingOpenGL)
solidmoments_precompile(smPrecompiledVTK
  HEADERS <vtkDoubleArray.h> <vtkNew.h> <vtkPolyData.h> <vtkSmartPointer.h>
  LIBRARIES VTK::CommonDataModel
  TARGETS FiltersSurfaceIntegrals FiltersMassProperties FiltersBuoyancy FiltersMomentSchemes FiltersNURBSEdit FiltersMomentGradient FiltersVariants)
