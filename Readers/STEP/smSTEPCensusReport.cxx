#include "smSTEPCensusReport.h"

#include "smFormat.h"

#include <algorithm>
#include <cstddef>

namespace sm
{
namespace
{
/// Largest number of entity numbers in a message.
constexpr std::size_t MaxIds = 10;

/// Appends what the census found to a document.
class CensusReport
{
public:
  CensusReport(const STEPCensus& census, Document& document)
    : Census(census)
    , Result(document)
  {
  }

  void Run()
  {
    this->ReportDensities();
    this->ReportQuantities();
    this->ReportShapeless();
    this->ReportProblems();
  }

private:
  void ReportQuantities()
  {
    for (const CensusQuantity& usage : this->Census.Quantities)
    {
      if (usage.Quantity != static_cast<double>(usage.Placed))
      {
        this->Result.Defects.push_back("Product " + NameEntity(usage.Child, usage.ChildName) + " occurs " +
          FormatDigits(usage.Quantity, 15) + " times in product #" + std::to_string(usage.Parent) +
          " by the quantity #" + std::to_string(usage.Id) + " of the file, which places it " +
          FormatCount(usage.Placed, "time", "times") + ": only these are counted.");
      }
    }
  }

  /// Reports parts of assemblies that the file does not have.
  void ReportShapeless()
  {
    std::vector<std::uint64_t> without;
    std::size_t elsewhere = 0;
    for (const CensusShapelessProduct& product : this->Census.ShapelessProducts)
    {
      if (product.File.empty())
      {
        without.push_back(product.Id);
      }
      else if (++elsewhere <= MaxIds)
      {
        this->Result.Defects.push_back("Product " + NameEntity(product.Id, product.Name) +
          " of an assembly has its shape in another file, " + product.File +
          ", which is not read: the part is missing. Put the file into the folder of this one, name its "
          "folder "
          "(--search), or export the assembly as one file.");
      }
    }
    if (elsewhere > MaxIds)
    {
      this->Result.Defects.push_back(
        std::to_string(elsewhere - MaxIds) + " more products have their shapes in other files.");
    }
    if (!without.empty())
    {
      this->Result.Messages.push_back(FormatCount(without.size(), "product", "products") +
        " in assemblies of the file without a shape: " + ListEntities(without) + ".");
    }
  }

  /// Reports contradictions in the file itself. A missing unit is not one of them.
  void ReportProblems()
  {
    const std::size_t lines = this->Census.GetNumberOfProblems(CensusDefect::ReversedLine);
    std::size_t counted = this->Census.GetNumberOfProblems(CensusDefect::MissingUnit) + lines;
    std::vector<std::uint64_t> reversed;
    std::size_t listed = 0;
    std::size_t all = 0;
    for (const std::size_t count : this->Census.Counts)
    {
      all += count;
    }
    for (const CensusProblem& problem : this->Census.Problems)
    {
      if (problem.Defect == CensusDefect::MissingUnit)
      {
        this->ReportMissingUnit(problem);
      }
      else if (problem.Defect == CensusDefect::ReversedLine)
      {
        reversed.push_back(problem.Id);
      }
      else if (problem.Defect == CensusDefect::MissingPlacement && !this->Census.MappedItems.empty())
      {
        // A mapped item may place the occurrence instead.
        ++counted;
        this->Result.Messages.push_back(Describe(problem));
      }
      else if (listed < MaxIds)
      {
        ++listed;
        ++counted;
        this->Result.Defects.push_back(Describe(problem));
      }
    }
    this->ReportReversedLines(lines, reversed);
    if (counted < all)
    {
      this->Result.Defects.push_back(
        std::to_string(all - counted) + " more entities of the file are damaged or contradict others.");
    }
  }

  /// Reports open edges that run the wrong way, which changes no result: they have the same points in both
  /// directions.
  void ReportReversedLines(std::size_t count, const std::vector<std::uint64_t>& first)
  {
    if (count > 0)
    {
      this->Result.Messages.push_back(
        "Edges of the file run against their loops or their curves, with the same points, in " +
        FormatCount(static_cast<int>(count), "entity", "entities") + ", first " +
        ListEntities({ first.begin(), first.begin() + std::min<std::size_t>(first.size(), 3) }) +
        ". Their vertices count, in the order of the loops; correct their directions, or export the file "
        "again.");
    }
  }

  static std::string Describe(const CensusProblem& problem)
  {
    const std::string place = problem.Place;
    const std::string other = problem.Other > 0 ? "#" + std::to_string(problem.Other) : "";
    return "Entity #" + std::to_string(problem.Id) + " of the file: " + GetName(problem.Defect) +
      (place.empty() && other.empty()
          ? ""
          : " (" + place + (place.empty() || other.empty() ? "" : ", ") + other + ")") +
      (problem.Defect == CensusDefect::CurveOffVertex
          ? ". Which of the two is meant is not known; correct the curve or the vertices, or export it again."
          : ".");
  }

  /// Reports densities that cannot be used, since the parts have no mass then, and those that others
  /// contradict.
  void ReportDensities()
  {
    for (const STEPDensity& density : this->Census.Densities)
    {
      if (!density.Problem.empty())
      {
        this->Result.Messages.push_back("The density of product #" + std::to_string(density.Product) + " (#" +
          std::to_string(density.Id) + ") is not used: " + density.Problem + ".");
      }
      if (!density.Others.empty())
      {
        this->Result.Messages.push_back("Product #" + std::to_string(density.Product) + " has the density " +
          FormatDigits(density.Density, 10) + " kg/m^3 (#" + std::to_string(density.Id) + ")." +
          density.Others);
      }
    }
    for (const CensusBody& body : this->Census.Bodies)
    {
      if (body.DensitiesDiffer && body.Instances > 0)
      {
        this->Result.Messages.push_back("Solid " + NameEntity(body.Id, body.Name) +
          " of the file occurs in assemblies of different densities, or of none: it has no mass.");
      }
    }
  }

  void ReportMissingUnit(const CensusProblem& problem)
  {
    const bool isAngle = std::string(problem.Place).find("angle") != std::string::npos;
    const std::string message = std::string("The file states no unit of ") +
      (isAngle ? "angles" : "lengths") + " (context #" + std::to_string(problem.Id) +
      "): " + (isAngle ? "radians are" : "mm is") + " assumed.";
    this->Result.Messages.push_back(message);
  }

  const STEPCensus& Census;
  Document& Result;
};
}

void ReportCensus(const STEPCensus& census, Document& document)
{
  CensusReport(census, document).Run();
}

std::string NameEntity(std::uint64_t id, const std::string& name)
{
  return "#" + std::to_string(id) + (name.empty() ? "" : " \"" + name + "\"");
}

std::string ListEntities(const std::vector<std::uint64_t>& ids)
{
  std::string list;
  for (std::size_t i = 0; i < std::min(ids.size(), MaxIds); ++i)
  {
    list += (i ? ", #" : "#") + std::to_string(ids[i]);
  }
  return list + (ids.size() > MaxIds ? " and " + std::to_string(ids.size() - MaxIds) + " more" : "");
}

std::string CountInstances(CensusCount count)
{
  return (count == CensusMaximum ? "more than " + std::to_string(count - 1) : std::to_string(count)) +
    (count == 1 ? " instance" : " instances");
}
}
