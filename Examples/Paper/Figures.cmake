# Draws the paper's figures with this program's numbers.
foreach (component IN ITEMS ChartsCore IOExport RenderingContext2D RenderingContextOpenGL2 ViewsContext2D)
  if (NOT TARGET VTK::${component})
    message(FATAL_ERROR "The figures need VTK's module ${component}. Build VTK with it, or configure with "
      "-DSOLIDMOMENTS_BUILD_PAPER=OFF -DSOLIDMOMENTS_BUILD_TESTING=OFF.")
  endif ()
endforeach ()

# The solids of the figures, which are also integrated by a test.
add_library(smPaperSolids STATIC smPaperSolid.cxx smSolidBuilder.cxx)
target_include_directories(smPaperSolids PUBLIC "${CMAKE_CURRENT_SOURCE_DIR}")
target_link_libraries(smPaperSolids PUBLIC SolidMoments::FiltersNURBS)
solidmoments_warnings(smPaperSolids)

# Figures by VTK's charts.
add_library(smFigures STATIC smFigure.cxx smFigureText.cxx)
target_include_directories(smFigures PUBLIC "${CMAKE_CURRENT_SOURCE_DIR}")
target_link_libraries(smFigures PUBLIC
  smExampleCommon
  VTK::ChartsCore
  VTK::IOExport
  VTK::ImagingCore
  VTK::RenderingContextOpenGL2
  VTK::RenderingFreeType
  VTK::RenderingOpenGL2
  VTK::ViewsContext2D)
vtk_module_autoinit(TARGETS smFigures
  MODULES VTK::RenderingContextOpenGL2 VTK::RenderingFreeType VTK::RenderingOpenGL2)
solidmoments_warnings(smFigures)

add_executable(paper_figures
  paper_figures.cxx
  smGraphFigures.cxx
  smModelPictures.cxx
  smPaperRun.cxx
  smPointFigures.cxx)
target_link_libraries(paper_figures PRIVATE
  smFigures
  smPaperSolids
  CLI11::CLI11
  SolidMoments::FiltersMomentSchemes
  SolidMoments::ReadersSTEP
  SolidMoments::RenderingCompute
  VTK::vtksys)
solidmoments_warnings(paper_figures)
