// paper_figures OUTDIR [--part FILE.step] [--model FILE.step]...: draws the figures of "Accurate Moment Computation Using the GPU" (SPM
// 2010) with this program's own numbers, each as PNG, SVG and CSV in OUTDIR: with models 1, which has no SVG; 3 to 6, 7a, 7b; and with a
// part 8. Needs no display.
// Exit status: 0 all drawn, 1 wrong usage or something failed.
#include "smGraphFigures.h"
#include "smModelPictures.h"
#include "smPointFigures.h"

#include <vtkComputeContext.h>
#include <vtkNew.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkPartitionedDataSetCollection.h>
#include <vtkSMPTools.h>
#include <vtkSTEPReader.h>
#include <vtksys/SystemTools.hxx>

#include <iostream>
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

bool Parse(int argc, char** argv, Arguments& arguments)
{
  for (int i = 1; i < argc; ++i)
  {
    const std::string argument = argv[i];
    if (argument == "--part" && i + 1 < argc)
    {
      arguments.Part = argv[++i];
    }
    else if (argument == "--model" && i + 1 < argc)
    {
      arguments.Models.emplace_back(argv[++i]);
    }
    else if (arguments.Folder.empty() && argument.compare(0, 1, "-") != 0)
    {
      arguments.Folder = argument;
    }
    else
    {
      return false;
    }
  }
  return !arguments.Folder.empty();
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
  vtkNew<vtkComputeContext> context; // its window draws off screen, with a display or without
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
  if (!Parse(argc, argv, arguments))
  {
    std::cerr << "usage: paper_figures OUTDIR [--part FILE.step] [--model FILE.step]...\n";
    return 1;
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
