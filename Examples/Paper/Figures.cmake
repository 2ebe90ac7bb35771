# Computes the paper's figures with this program's numbers; draw_figures.py draws them.

# The solids of the figures, which are also integrated by a test.
add_library(smPaperSolids STATIC smPaperSolid.cxx smSolidBuilder.cxx)
target_include_directories(smPaperSolids PUBLIC "${CMAKE_CURRENT_SOURCE_DIR}")
target_link_libraries(smPaperSolids PUBLIC SolidMoments::FiltersNURBS)
solidmoments_warnings(smPaperSolids)

add_executable(paper_figures
  paper_figures.cxx
  smFigureTable.cxx
  smGraphTables.cxx
  smModelPictures.cxx
  smPaperRun.cxx
  smPointTables.cxx)
target_link_libraries(paper_figures PRIVATE
  smExampleCommon
  smPaperSolids
  CLI11::CLI11
  SolidMoments::FiltersMomentSchemes
  SolidMoments::ReadersSTEP
  SolidMoments::RenderingCompute
  VTK::ImagingCore
  VTK::vtksys)
vtk_module_autoinit(TARGETS paper_figures MODULES VTK::RenderingFreeType VTK::RenderingOpenGL2)
solidmoments_warnings(paper_figures)
