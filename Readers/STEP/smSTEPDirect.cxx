#include "smSTEPDirect.h"

#include "smLengthUnits.h"
#include "smOCCTCompatibility.h"
#include "smOCCTFailure.h"
#include "smSTEPAppearance.h"
#include "smSTEPAttributes.h"
#include "smSTEPProductTree.h"
#include "smSTEPShapes.h"

#include <BRep_Builder.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Iterator.hxx>

#include <algorithm>
#include <cctype>
#include <iterator>
#include <map>
#include <memory>
#include <unordered_map>

namespace sm
{
namespace
{
/// Tolerance that OpenCASCADE's repair may give edges and vertices, in millimetres.
constexpr double LargestTolerance = 1.0;

using Index = Part21File::Index;

/// Returns the name of a length unit as messages have it: "millimetre" for "MILLI METRE".
std::string GetUnitWord(const CensusUnit& unit)
{
  std::string word;
  for (const char c : unit.Name)
  {
    const bool isSI = unit.Name.find("METRE") != std::string::npos;
    word += isSI ? (c == ' ' ? std::string() : std::string(1, static_cast<char>(std::tolower(c))))
                 : std::string(1, c);
  }
  return word;
}

/// Defects that change no shape and no place: they are reported, and nothing else follows from them.
constexpr CensusDefect HarmlessDefects[] = { CensusDefect::MissingUnit, CensusDefect::UnusedEntity,
  CensusDefect::SurfaceProduct, CensusDefect::AlternativeShape, CensusDefect::RepeatedProduct,
  CensusDefect::PlacedTwice, CensusDefect::VertexOffSurface };

class DirectReader
{
public:
  DirectReader(const Part21File& file, const STEPCensus& census, Document& document, RepairLog& log)
    : Entities(file)
    , Census(census)
    , Result(document)
    , Log(log)
    , Shapes(this->Entities, census, this->Ledger, document.Table)
  {
  }

  void Read(RepairMode repair, const ProgressCallback& progress, bool& isAborted)
  {
    this->CheckStructure();
    this->ReadUnit();
    this->MakeShapes(progress, isAborted);
    if (!isAborted)
    {
      this->Repair(repair, progress, isAborted);
    }
    if (!isAborted)
    {
      this->Shapes.Report(this->Result.Messages, this->Result.Defects);
      this->AddColors();
      AddSTEPProducts(
        this->Entities, this->Census, this->Kind, this->Bodies, this->OccurrenceColors, this->Result);
    }
  }

private:
  /// Throws the reason if the file has structure that is not read here.
  void CheckStructure()
  {
    RequireDirect(!this->Census.HasOrientedFaces, "it has faces that shells use against their sense");
    for (std::size_t k = 0; k < this->Census.Counts.size(); ++k)
    {
      const auto defect = static_cast<CensusDefect>(k);
      const bool isHarmless = std::find(std::begin(HarmlessDefects), std::end(HarmlessDefects), defect) !=
        std::end(HarmlessDefects);
      RequireDirect(
        isHarmless || this->Census.Counts[k] == 0, "its entities are damaged or contradict each other");
    }
    for (const CensusOccurrence& occurrence : this->Census.Occurrences)
    {
      RequireDirect(!occurrence.HasSolids || occurrence.IsMapped ||
          (occurrence.Transformation != 0 && occurrence.ChildShape != 0),
        "it has occurrences without a placement");
    }
    RequireDirect(this->Census.CountBodies(CensusBodyKind::Tessellated) == 0, "it has triangles");
    this->Kind = this->Census.CountBodies(CensusBodyKind::Solid) > 0 ? CensusBodyKind::Solid
                                                                     : CensusBodyKind::SurfaceModel;
    RequireDirect(this->Census.CountBodies(this->Kind) > 0, "it has no solid, shell or face");
  }

  void ReadUnit()
  {
    const auto used = std::find_if(this->Census.Contexts.begin(), this->Census.Contexts.end(),
      [](const CensusContext& context)
      { return context.Used && context.Length.Status == CensusUnit::State::Stated; });
    RequireDirect(used != this->Census.Contexts.end(), "it states no unit of lengths");
    this->Result.FileUnit = GetUnitWord(used->Length);
    const double known = GetUnitInMillimetres(this->Result.FileUnit);
    this->Result.FileUnitInMillimetres = known > 0.0 ? known : used->Length.Factor;
  }

  void MakeShapes(const ProgressCallback& progress, bool& isAborted)
  {
    std::uint64_t faces = 0;
    for (std::size_t k = 0; k < this->Census.Bodies.size() && !isAborted; ++k)
    {
      const CensusBody& body = this->Census.Bodies[k];
      if (body.Kind != this->Kind || body.Instances == 0)
      {
        continue;
      }
      const TopoDS_Shape shape = this->Shapes.MakeBody(body);
      if (shape.IsNull())
      {
        RequireDirect(!this->Ledger.Rows.empty(), "one of its bodies is not read");
        const LedgerRow& row = this->Ledger.Rows.front();
        throw STEPNotDirect{ "its entity #" + std::to_string(row.Id) + " (" + row.Type +
          ") is not read: " + row.Reason };
      }
      this->Bodies.emplace(static_cast<std::uint32_t>(k), shape);
      faces += body.Faces;
      isAborted = !progress(
        0.5 * static_cast<double>(faces) / static_cast<double>(this->Census.CountFaces(this->Kind)));
    }
  }

  void Repair(RepairMode repair, const ProgressCallback& progress, bool& isAborted)
  {
    const auto label = [this](const TopoDS_Shape& shape) { return this->Shapes.GetLabel(shape); };
    const std::unique_ptr<RepairOnNeed> selective =
      repair == RepairMode::OnNeed ? std::make_unique<RepairOnNeed>(this->Log, label) : nullptr;
    const std::unique_ptr<RepairAlways> full =
      repair == RepairMode::Always ? std::make_unique<RepairAlways>(this->Log, label) : nullptr;
    std::size_t done = 0;
    for (auto& [index, shape] : this->Bodies)
    {
      const double precision = this->Shapes.GetPrecision(this->Census.Bodies[index]);
      if (shape.ShapeType() == TopAbs_COMPOUND)
      {
        TopoDS_Compound parts;
        BRep_Builder builder;
        builder.MakeCompound(parts);
        for (TopoDS_Iterator it(shape); it.More(); it.Next())
        {
          builder.Add(parts, this->RepairShape(it.Value(), precision));
        }
        shape = parts;
      }
      else
      {
        shape = this->RepairShape(shape, precision);
      }
      isAborted =
        !progress(0.5 + 0.5 * static_cast<double>(++done) / static_cast<double>(this->Bodies.size()));
      if (isAborted)
      {
        return;
      }
    }
    for (const auto& [shape, face] : this->Log.SoundFaces)
    {
      this->Result.Table[shape].AsInFile = face;
    }
  }

  TopoDS_Shape RepairShape(const TopoDS_Shape& original, double precision)
  {
    ShapeChanges changes;
    const TopoDS_Shape shape =
      RepairTransferred(original, precision, std::max(precision, LargestTolerance), changes);
    if (changes)
    {
      changes([this](const TopoDS_Shape& from, const TopoDS_Shape& to) { this->PassInfo(from, to); });
    }
    this->PassInfo(original, shape);
    return shape;
  }

  /// Gives what became of a shape its number, name and colour.
  void PassInfo(const TopoDS_Shape& from, const TopoDS_Shape& to)
  {
    const auto known = this->Result.Table.find(from.TShape().get());
    if (known == this->Result.Table.end() || to.IsNull() || from.TShape() == to.TShape())
    {
      return;
    }
    ShapeInfo info = known->second;
    info.AsInFile = nullptr;
    const bool isOpen = from.ShapeType() == TopAbs_SOLID && !TopExp_Explorer(to, TopAbs_SOLID).More();
    info.OpenSolid = isOpen;
    for (TopExp_Explorer it(to, isOpen ? TopAbs_SHELL : from.ShapeType()); it.More(); it.Next())
    {
      const auto [place, isNew] = this->Result.Table.emplace(it.Current().TShape().get(), info);
      if (!isNew && place->second.FileId == 0)
      {
        const auto sound = place->second.AsInFile;
        place->second = info;
        place->second.AsInFile = sound;
      }
    }
  }

  void AddColors()
  {
    const STEPColors colors = STEPAppearance(this->Entities).ReadColors();
    for (auto& [shape, info] : this->Result.Table)
    {
      const auto color = colors.Items.find(static_cast<std::uint64_t>(info.FileId));
      info.Color = color == colors.Items.end() ? info.Color : color->second;
    }
    this->OccurrenceColors = colors.Occurrences;
  }

  STEPAttributes Entities;
  const STEPCensus& Census;
  Document& Result;
  RepairLog& Log;
  STEPLedger Ledger;
  STEPShapes Shapes;
  std::unordered_map<std::uint64_t, Vector3> OccurrenceColors;
  /// The kind of bodies that are read: solids, if the file has any.
  CensusBodyKind Kind = CensusBodyKind::Solid;
  /// Shapes by the index of their body in the census.
  std::map<std::uint32_t, TopoDS_Shape> Bodies;
};
}

std::string ReadSTEPDirectly(const Part21File& file, const STEPCensus& census, RepairMode repair,
  const ProgressCallback& progress, Document& document, RepairLog& log, bool& isAborted)
{
  Document direct = document;
  std::string reason;
  const std::string failure = CatchFailure(
    [&]
    {
      try
      {
        DirectReader(file, census, direct, log).Read(repair, progress, isAborted);
      }
      catch (const STEPNotDirect& other)
      {
        reason = other.Reason;
      }
    });
  reason = failure.empty() ? reason : failure;
  if (reason.empty())
  {
    document = std::move(direct);
  }
  else
  {
    log = RepairLog();
  }
  return reason;
}
}
