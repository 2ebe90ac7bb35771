// Computes the figures of "Accurate Moment Computation Using the GPU" (SPM 2010); draw_figures.py draws them.
#include "smGraphTables.h"
#include "smModelPictures.h"
#include "smOptions.h"
#include "smPointTables.h"

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
  CLI::App app(
    "Compute the figures of \"Accurate Moment Computation Using the GPU\" (SPM 2010) with this "
    "program's own\n"
    "results, as CSV files for draw_figures.py: 3 to 6, 7a and 7b, with --part 8; with --model draw "
    "Figure 1.\n"
    "Needs no display.",
    "paper_figures");
  app.footer("Exit status: 0 all figures are written; 1 wrong usage, or a figure failed.");
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

bool AddFigure8(const std::string& path, std::vector<smfigure::FigureTable>& tables)
{
  vtkNew<vtkSTEPReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  if (reader->GetStatus() != vtkSTEPReader::OK)
  {
    std::cerr << path << " could not be read\n";
    return false;
  }
  tables.push_back(smfigure::MakeFigure8(reader->GetOutputDataObject(0)));
  if (tables.back().Rows.empty())
  {
    std::cerr << path << " has no volume\n";
    return false;
  }
  return true;
}

bool MakeTables(const Arguments& arguments, std::vector<smfigure::FigureTable>& tables)
{
  tables = smfigure::MakePointTables();
  if (tables.empty())
  {
    std::cerr << "Figure 6: the filter gave no trim texture\n";
    return false;
  }
  tables.push_back(smfigure::MakeFigure7a());
  tables.push_back(smfigure::MakeFigure7b());
  if (arguments.Models.empty())
  {
    std::cout << "Figure 1 needs models: --model FILE.step for each\n";
  }
  if (arguments.Part.empty())
  {
    std::cout << "Figure 8 needs a part: --part FILE.step\n";
    return true;
  }
  return AddFigure8(arguments.Part, tables);
}

/// Draws Figure 1. Returns an error message, empty when it is written.
std::string DrawModels(const Arguments& arguments)
{
  vtkNew<vtkComputeContext> context; // its window draws off screen and needs no display
  return context->Start() == vtkComputeContext::READY
    ? smfigure::WriteFigure1(arguments.Models, arguments.Folder, context->GetRenderWindow())
    : context->GetReason();
}

bool WriteAll(const Arguments& arguments, const std::vector<smfigure::FigureTable>& tables)
{
  for (const smfigure::FigureTable& table : tables)
  {
    const std::string error = smfigure::WriteTable(table, arguments.Folder);
    if (!error.empty())
    {
      std::cerr << error << "\n";
      return false;
    }
    std::cout << arguments.Folder << "/" << table.Name << ".csv\n";
  }
  if (!arguments.Models.empty())
  {
    const std::string error = DrawModels(arguments);
    if (!error.empty())
    {
      std::cerr << "Figure 1: " << error << "\n";
      return false;
    }
    std::cout << arguments.Folder << "/fig1.png\n";
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
  std::vector<smfigure::FigureTable> tables;
  return MakeTables(arguments, tables) && WriteAll(arguments, tables) ? 0 : 1;
}
