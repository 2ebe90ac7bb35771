# Draws the paper's figures with this program's numbers.
foreach (component IN ITEMS ChartsCore IOExport RenderingContext2D RenderingContextOpenGL2 ViewsContext2D)
  if (NOT TARGET VTK::${component})
    message(FATAL_ERROR "The figures need VTK's module ${component}. Build VTK with it, or configure with "
      "-DSOLIDMOMENTS_BUILD_EXAMPLES=OFF -DSOLIDMOMENTS_BUILD_TESTING=OFF.")
  endif ()
endforeach ()

add_executable(paper_figures
  paper_figures.cxx
  smFigure.cxx
  smFigureText.cxx
  smGraphFigures.cxx
  smModelPictures.cxx
  smPaperRun.cxx
  smPaperSolid.cxx
  smPointFigures.cxx
  smSolidBuilder.cxx)
target_link_libraries(paper_figures PRIVATE
  smExampleCommon
  CLI11::CLI11
  SolidMoments::FiltersMomentSchemes
  SolidMoments::ReadersSTEP
  SolidMoments::RenderingCompute
  VTK::ChartsCore
  VTK::IOExport
  VTK::IOImage
  VTK::ImagingCore
  VTK::RenderingContextOpenGL2
  VTK::RenderingFreeType
  VTK::RenderingOpenGL2
  VTK::ViewsContext2D
  VTK::vtksys)
vtk_module_autoinit(TARGETS paper_figures
  MODULES VTK::RenderingContextOpenGL2 VTK::RenderingFreeType VTK::RenderingOpenGL2)
solidmoments_warnings(paper_figures)
