#include "smSTEPReconciliation.h"

#include "smFormat.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <unordered_set>
#include <vector>

namespace sm
{
namespace
{
/// Largest number of entity numbers in a message.
constexpr std::size_t MostIds = 10;

std::string ListIds(const std::vector<std::uint64_t>& ids)
{
  std::string list;
  for (std::size_t i = 0; i < std::min(ids.size(), MostIds); ++i)
  {
    list += (i ? ", #" : "#") + std::to_string(ids[i]);
  }
  return list + (ids.size() > MostIds ? " and " + std::to_string(ids.size() - MostIds) + " more" : "");
}

std::string Name(std::uint64_t id, const std::string& name)
{
  return "#" + std::to_string(id) + (name.empty() ? "" : " \"" + name + "\"");
}

std::string Name(const CensusBody& body)
{
  return Name(body.Id, body.Name);
}

std::string Count(CensusCount count)
{
  return count == CensusMaximum ? "more than " + std::to_string(count - 1) : std::to_string(count);
}

class Reconciliation
{
public:
  Reconciliation(const STEPCensus& census, Document& document)
    : Census(census)
    , Result(document)
    , Instances(document.Bodies.size(), 0)
    , HasMappedItems(!census.MappedItems.empty())
  {
    for (std::size_t i = 0; i < document.Bodies.size(); ++i)
    {
      this->Read[static_cast<std::uint64_t>(document.Bodies[i].FileId)].push_back(i);
    }
    for (const BodyInstance& instance : document.Instances)
    {
      ++this->Instances[instance.Body];
    }
  }

  void Run()
  {
    this->ReportDensities();
    this->CheckDeclared();
    for (const CensusBody& body : this->Census.Bodies)
    {
      for (const std::size_t i : this->Read[body.Id])
      {
        this->Result.Bodies[i].Density = body.Density;
      }
      if (body.DensitiesDiffer && body.Instances > 0)
      {
        this->Result.Messages.push_back("Solid " + Name(body) +
          " of the file occurs in assemblies of different densities, or of none: it has no mass.");
      }
      if (body.Instances == 0)
      {
        continue;
      }
      if (body.Kind == CensusBodyKind::Solid)
      {
        this->CheckSolid(body);
      }
      else if (body.Kind == CensusBodyKind::OtherSolid)
      {
        this->Result.Defects.push_back("Solid " + Name(body) + " of the file is of the type " + body.Type +
          ", which has no faces: it is left out. Export it as a boundary representation.");
      }
      else if (body.Kind == CensusBodyKind::Tessellated && !body.Alternative)
      {
        this->ReportTriangles(body);
      }
    }
    this->ReportQuantities();
    this->ReportShapeless();
    // Messages about missing bodies come first.
    this->ReportProblems();
  }

private:
  void ReportTriangles(const CensusBody& body)
  {
    // Sets of triangles may be annotations.
    const bool isBody = body.Type.find("TESSELLATED_SOLID") != std::string::npos ||
      body.Type.find("TESSELLATED_SHELL") != std::string::npos;
    (isBody ? this->Result.Defects : this->Result.Messages)
      .push_back("Body " + Name(body) + " of the file is of the type " + body.Type +
        ", of triangles instead of exact faces: it is left out. Export it as a boundary representation.");
  }

  void ReportQuantities()
  {
    for (const CensusQuantity& usage : this->Census.Quantities)
    {
      if (usage.Quantity != static_cast<double>(usage.Placed))
      {
        this->Result.Defects.push_back("Product " + Name(usage.Child, usage.ChildName) + " occurs " +
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
      else if (++elsewhere <= MostIds)
      {
        this->Result.Defects.push_back("Product " + Name(product.Id, product.Name) +
          " of an assembly has its shape in another file, " + product.File +
          ", which is not read: the part is missing. Put the file into the folder of this one, name its "
          "folder "
          "(--search), or export the assembly as one file.");
      }
    }
    if (elsewhere > MostIds)
    {
      this->Result.Defects.push_back(
        std::to_string(elsewhere - MostIds) + " more products have their shapes in other files.");
    }
    if (!without.empty())
    {
      this->Result.Messages.push_back(FormatCount(without.size(), "product", "products") +
        " in assemblies of the file without a shape: " + ListIds(without) + ".");
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
      else if (listed < MostIds)
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
        ListIds({ first.begin(), first.begin() + std::min<std::size_t>(first.size(), 3) }) +
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
  }

  void ReportMissingUnit(const CensusProblem& problem)
  {
    const bool isAngle = std::string(problem.Place).find("angle") != std::string::npos;
    const std::string message = std::string("The file states no unit of ") +
      (isAngle ? "angles" : "lengths") + " (context #" + std::to_string(problem.Id) +
      "): " + (isAngle ? "radians are" : "mm is") + " assumed.";
    this->Result.Messages.push_back(message);
  }

  /// Reports a file that is read but that the census cannot interpret: nothing is known about its
  /// completeness.
  void CheckDeclared()
  {
    std::set<std::uint64_t> declared;
    for (const CensusBody& body : this->Census.Bodies)
    {
      declared.insert(body.Id);
    }
    std::vector<std::uint64_t> unknown;
    for (const auto& [id, parts] : this->Read)
    {
      const bool hasSolid = std::any_of(
        parts.begin(), parts.end(), [this](std::size_t i) { return this->Result.Bodies[i].Solid; });
      if (hasSolid && declared.count(id) == 0)
      {
        unknown.push_back(id);
      }
    }
    if (!unknown.empty())
    {
      this->Result.Defects.push_back(
        "The file's text is damaged so that its entities cannot be counted: of the solids " +
        ListIds(unknown) + " it is not known whether they are complete. Export the file again.");
    }
  }

  void CheckSolid(const CensusBody& body)
  {
    const std::vector<std::size_t>& parts = this->Read[body.Id];
    if (parts.empty())
    {
      this->Result.Defects.push_back("Solid " + Name(body) +
        " of the file was lost: " + std::to_string(body.Faces) + " faces, " + Count(body.Instances) +
        (body.Instances == 1 ? " instance." : " instances.") + "");
      return;
    }
    this->CheckFaces(body, parts);
    this->CheckInstances(body, parts);
    for (const std::size_t i : parts)
    {
      PartBody& part = this->Result.Bodies[i];
      const double uncertainty = body.Context < 0 ? 0.0 : this->Census.Contexts[body.Context].Uncertainty;
      part.Uncertainty = uncertainty > 0.0 ? uncertainty : 0.0;
    }
  }

  void CheckFaces(const CensusBody& body, const std::vector<std::size_t>& parts)
  {
    std::set<std::uint64_t> present;
    for (const std::size_t i : parts)
    {
      this->Result.Bodies[i].Shape.VisitFaces([&present](const FaceUse& use)
        { present.insert(static_cast<std::uint64_t>(use.Face->Data.FileId)); });
    }
    std::vector<std::uint64_t> missing;
    for (std::uint32_t s = body.FirstShell; s < body.FirstShell + body.NumberOfShells; ++s)
    {
      const CensusShell& shell = this->Census.Shells[this->Census.ShellUses[s].Shell];
      for (std::uint32_t f = shell.FirstFace; f < shell.FirstFace + shell.NumberOfFaces; ++f)
      {
        const std::uint64_t id = this->Census.Faces[this->Census.FaceUses[f]].Id;
        if (present.count(id) == 0)
        {
          missing.push_back(id);
        }
      }
    }
    if (missing.empty())
    {
      return;
    }
    for (const std::size_t i : parts)
    {
      this->Result.Bodies[i].LostFaces = static_cast<int>(missing.size());
      this->Result.Bodies[i].Messages.push_back("Solid " + Name(body) + " has " + std::to_string(body.Faces) +
        " faces in the file, and " + std::to_string(missing.size()) +
        " of them were lost: " + ListIds(missing) + ".");
    }
  }

  void CheckInstances(const CensusBody& body, const std::vector<std::size_t>& parts)
  {
    // A solid may be read as several bodies: its parts, and copies with a scale or a reflection. Each part
    // must have as many instances as the solid.
    std::map<const void*, CensusCount> counts;
    for (const std::size_t i : parts)
    {
      const BodyShape& shape = this->Result.Bodies[i].Shape;
      const void* key = shape.Shells.empty() ? nullptr : shape.Shells.front().Shell.get();
      counts[key] += this->Instances[i];
    }
    if (body.NumberOfShells > 1 && counts.size() > 1)
    {
      // The repair makes a separate solid of a void that is not inside the outer shell.
      this->Result.Defects.push_back("Solid " + Name(body) +
        " has a void that does not lie inside its outer shell: it was read as " +
        std::to_string(counts.size()) + " solids.");
    }
    CensusCount least = CensusMaximum;
    CensusCount most = 0;
    for (const auto& [shape, count] : counts)
    {
      least = std::min(least, count);
      most = std::max(most, count);
    }
    const CensusCount read = most > body.Instances ? most : least;
    if (read != body.Instances)
    {
      // Mapped items in addition to occurrences of products may place one solid at the same place, and then
      // only too many instances are a certain contradiction. A solid of several products is in each of them.
      const bool isCertain = most > body.Instances || !this->HasMappedItems;
      (isCertain ? this->Result.Defects : this->Result.Messages)
        .push_back("Solid " + Name(body) + " occurs " + Count(body.Instances) +
          (body.Instances == 1 ? " time" : " times") + " in the file, and was read " + std::to_string(read) +
          (read == 1 ? " time." : " times."));
    }
  }

  const STEPCensus& Census;
  Document& Result;
  /// Bodies of the document by the entity number of their solid, and the numbers of their instances.
  std::map<std::uint64_t, std::vector<std::size_t>> Read;
  std::vector<CensusCount> Instances;
  bool HasMappedItems;
};
}

void Reconcile(const STEPCensus& census, Document& document)
{
  Reconciliation(census, document).Run();
}

CensusCount CountDeclaredInstances(const STEPCensus& census)
{
  CensusCount count = census.CountInstances(CensusBodyKind::Solid);
  if (count == 0)
  {
    count = census.CountInstances(CensusBodyKind::SurfaceModel);
  }
  for (const CensusOccurrence& occurrence : census.Occurrences)
  {
    count = AddCounts(count, occurrence.Instances);
  }
  for (const CensusMappedItem& item : census.MappedItems)
  {
    count = AddCounts(count, item.Instances);
  }
  return count;
}
}
