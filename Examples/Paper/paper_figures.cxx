// Draws the figures of "Accurate Moment Computation Using the GPU" (SPM 2010) with this program's own
// results.
#include "smGraphFigures.h"
#include "smModelPictures.h"
#include "smOptions.h"
#include "smPointFigures.h"

#include <vtkComputeContext.h>
#include <vtkNew.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkPartitionedDataSetCollection.h>
#include <vtkSMPTools.h>
#include <vtkSTEPReader.h>
#include <vtksys/SystemTools.hxx>

#include <iostream>
#include <optional>
#include <string>
#include <vector>

namespace
{
struct Arguments
{
  std::string Folder;
  std::string Part;
  std::vector<std::string> Models;
};

/// Reads the arguments; an exit status when there is nothing more to do.
std::optional<int> Parse(int argc, char** argv, Arguments& arguments)
{
  CLI::App app("Draw the figures of \"Accurate Moment Computation Using the GPU\" (SPM 2010) with this "
               "program's own results,\n"
               "each as PNG, SVG and CSV: 3 to 6, 7a and 7b, with --model 1, which has no SVG, and with "
               "--part 8. Needs no\n"
               "display.",
    "paper_figures");
  app.footer("Exit status: 0 all figures are drawn; 1 wrong usage, or a figure failed.");
  app.add_option("FOLDER", arguments.Folder, "Folder to write to")->required()->type_name("");
  sm::AddFileOption(app, "--part", arguments.Part, "STEP file of the part of Figure 8");
  app.add_option("--model", arguments.Models, "STEP file of a model of Figure 1; may be given several times")
    ->type_name("FILE")
    ->check(sm::CheckFileName)
    ->take_all()
    ->expected(1);
  try
  {
    app.parse(argc, argv);
  }
  catch (const CLI::ParseError& error)
  {
    return app.exit(error) == 0 ? 0 : 1;
  }
  return std::nullopt;
}

bool AddFigure8(const std::string& path, std::vector<smfigure::Figure>& figures)
{
  vtkNew<vtkSTEPReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  if (reader->GetStatus() != vtkSTEPReader::OK)
  {
    std::cerr << path << " could not be read\n";
    return false;
  }
  const std::vector<smfigure::Figure> made = smfigure::MakeFigure8(reader->GetOutputDataObject(0));
  if (made.empty())
  {
    std::cerr << path << " has no volume\n";
  }
  figures.insert(figures.end(), made.begin(), made.end());
  return !made.empty();
}

bool MakeFigures(const Arguments& arguments, std::vector<smfigure::Figure>& figures)
{
  figures = { smfigure::MakeFigure3(), smfigure::MakeFigure4(), smfigure::MakeFigure5() };
  figures.emplace_back();
  const std::string error = smfigure::MakeFigure6(figures.back());
  if (!error.empty())
  {
    std::cerr << "Figure 6: " << error << "\n";
    return false;
  }
  for (const auto& made : { smfigure::MakeFigure7a(), smfigure::MakeFigure7b() })
  {
    figures.insert(figures.end(), made.begin(), made.end());
  }
  if (arguments.Models.empty())
  {
    std::cout << "Figure 1 needs models: --model FILE.step for each\n";
  }
  if (arguments.Part.empty())
  {
    std::cout << "Figure 8 needs a part: --part FILE.step\n";
    return true;
  }
  return AddFigure8(arguments.Part, figures);
}

bool WriteFigures(const Arguments& arguments, const std::vector<smfigure::Figure>& figures)
{
  const std::string& folder = arguments.Folder;
  vtkNew<vtkComputeContext> context; // its window draws off screen and needs no display
  if (context->Start() != vtkComputeContext::READY)
  {
    std::cerr << context->GetReason() << "\n";
    return false;
  }
  for (const smfigure::Figure& figure : figures)
  {
    const std::string error = smfigure::WriteFigure(figure, folder, context->GetRenderWindow());
    if (!error.empty())
    {
      std::cerr << error << "\n";
      return false;
    }
    std::cout << folder << "/" << figure.Name << ".png\n";
  }
  if (!arguments.Models.empty())
  {
    const std::string error = smfigure::WriteFigure1(arguments.Models, folder, context->GetRenderWindow());
    if (!error.empty())
    {
      std::cerr << "Figure 1: " << error << "\n";
      return false;
    }
    std::cout << folder << "/fig1.png\n";
  }
  return true;
}
}

int main(int argc, char** argv)
{
  Arguments arguments;
  if (const std::optional<int> done = Parse(argc, argv, arguments))
  {
    return *done;
  }
  vtkSMPTools::SetBackend("STDThread");
  if (!vtksys::SystemTools::MakeDirectory(arguments.Folder))
  {
    std::cerr << arguments.Folder << " could not be made\n";
    return 1;
  }
  std::vector<smfigure::Figure> figures;
  return MakeFigures(arguments, figures) && WriteFigures(arguments, figures) ? 0 : 1;
}
