#include "smCensusText.h"

#include <sstream>

namespace smtest
{
namespace
{
std::string GetText(sm::CensusCount count)
{
  return (count == sm::CensusMaximum ? "at least " : "") + std::to_string(count);
}

const char* GetName(sm::CensusBodyKind kind)
{
  switch (kind)
  {
    case sm::CensusBodyKind::Solid:
      return "solid";
    case sm::CensusBodyKind::OtherSolid:
      return "solid without faces";
    case sm::CensusBodyKind::SurfaceModel:
      return "surfaces";
    case sm::CensusBodyKind::GeometricSet:
      return "curves or points";
    default:
      return "triangles";
  }
}

std::string DescribeUnit(const char* what, const sm::CensusUnit& unit)
{
  static const char* const states[] = { "missing", "stated", "wrong", "absurd" };
  std::ostringstream text;
  text << " " << what << " " << states[static_cast<int>(unit.Status)];
  if (unit.Id != 0)
  {
    text << " #" << unit.Id << " \"" << unit.Name << "\" " << unit.Factor;
  }
  return text.str();
}

void DescribeBodies(const sm::STEPCensus& census, std::ostream& text)
{
  for (const sm::CensusBody& body : census.Bodies)
  {
    text << GetName(body.Kind) << " #" << body.Id << " " << body.Type << " '" << body.Name << "' x"
         << GetText(body.Instances) << ", faces " << body.Faces
         << (body.Alternative ? ", next to exact faces" : "") << "\n";
    for (std::uint32_t k = 0; k < body.NumberOfShells; ++k)
    {
      const sm::CensusShellUse& use = census.ShellUses[body.FirstShell + k];
      const sm::CensusShell& shell = census.Shells[use.Shell];
      text << "  " << (use.Void ? "void #" : "shell #") << use.Id << " faces " << shell.NumberOfFaces << ":";
      for (std::uint32_t f = 0; f < shell.NumberOfFaces; ++f)
      {
        const sm::CensusFace& face = census.Faces[census.FaceUses[shell.FirstFace + f]];
        text << " #" << face.Id;
      }
      text << "\n";
    }
  }
}
}

std::string DescribeProblems(const sm::Part21File& file, const sm::STEPCensus& census, std::size_t places)
{
  std::ostringstream text;
  for (std::size_t k = 0; k < static_cast<std::size_t>(sm::CensusDefect::Count); ++k)
  {
    const sm::CensusDefect defect = static_cast<sm::CensusDefect>(k);
    if (census.GetNumberOfProblems(defect) == 0)
    {
      continue;
    }
    text << (text.str().empty() ? "" : "; ") << sm::GetName(defect) << ": "
         << census.GetNumberOfProblems(defect);
    std::size_t written = 0;
    for (const sm::CensusProblem& problem : census.Problems)
    {
      if (problem.Defect != defect || written == places)
      {
        continue;
      }
      const auto entity = file.Find(problem.Id);
      text << (written++ == 0 ? " (" : ", ") << "#" << problem.Id << " "
           << file.GetTypeNames()[file.GetType(entity)] << (*problem.Place ? " " : "") << problem.Place;
      if (problem.Other != 0)
      {
        text << " #" << problem.Other;
      }
    }
    text << (written > 0 ? ")" : "");
  }
  return text.str();
}

std::string DescribeCounts(const sm::STEPCensus& census)
{
  std::ostringstream text;
  text << "solids " << census.CountBodies(sm::CensusBodyKind::Solid) << ", instances "
       << GetText(census.CountInstances(sm::CensusBodyKind::Solid)) << ", faces "
       << census.CountFaces(sm::CensusBodyKind::Solid) << ", surface models "
       << census.CountBodies(sm::CensusBodyKind::SurfaceModel) << " with faces "
       << census.CountFaces(sm::CensusBodyKind::SurfaceModel) << ", other solids "
       << census.CountBodies(sm::CensusBodyKind::OtherSolid) << ", occurrences " << census.Occurrences.size()
       << ", mapped " << census.MappedItems.size();
  return text.str();
}

std::string DescribeCensus(const sm::Part21File& file, const sm::STEPCensus& census)
{
  std::ostringstream text;
  text << "instances in the file: " << file.GetNumberOfInstances() << "\n";
  for (const sm::Part21Problem& problem : file.GetProblems())
  {
    text << "text: " << sm::Part21File::GetName(problem.Defect) << ", line " << file.GetLine(problem.Offset)
         << ", #" << problem.Id << (problem.Other != 0 ? " -> #" + std::to_string(problem.Other) : "")
         << "\n";
  }
  text << DescribeCounts(census) << (census.WithoutProducts ? ", no products" : "") << "\n";
  DescribeBodies(census, text);
  for (const sm::CensusOccurrence& occurrence : census.Occurrences)
  {
    text << "occurrence #" << occurrence.Id << " '" << occurrence.Name << "' of product #" << occurrence.Child
         << " in #" << occurrence.Parent << " x" << GetText(occurrence.Instances) << ", placement #"
         << occurrence.Placement << " by #" << occurrence.Transformation
         << (occurrence.HasSolids ? "" : ", no solids") << "\n";
  }
  for (const sm::CensusMappedItem& item : census.MappedItems)
  {
    text << "mapped item #" << item.Id << " of representation #" << item.Child << " in #" << item.Parent
         << " x" << GetText(item.Instances) << (item.HasSolids ? "" : ", no solids") << "\n";
  }
  for (const sm::CensusShapelessProduct& product : census.ShapelessProducts)
  {
    text << "product #" << product.Id << " '" << product.Name << "' without a shape"
         << (product.File.empty() ? "" : ", in the file " + product.File) << "\n";
  }
  for (const sm::CensusQuantity& usage : census.Quantities)
  {
    text << "quantity #" << usage.Id << ": " << usage.Quantity << " of product #" << usage.Child << " in #"
         << usage.Parent << ", placed " << usage.Placed << "\n";
  }
  for (const sm::CensusContext& context : census.Contexts)
  {
    text << "context #" << context.Id << ":" << DescribeUnit("length", context.Length) << ","
         << DescribeUnit("angle", context.Angle) << ", uncertainty " << context.Uncertainty << " mm"
         << (context.Used ? "" : ", not used by solids") << "\n";
  }
  text << "problems: " << DescribeProblems(file, census, 5) << "\n";
  return text.str();
}
}
