#include "smSTEPDirect.h"

#include "smLengthUnits.h"
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
#include <map>
#include <unordered_map>

namespace sm
{
namespace
{
/// Tolerance that OpenCASCADE's repair may give edges and vertices, in millimetres.
constexpr double LargestTolerance = 1.0;

using Index = Part21File::Index;

/// Returns the name of a length unit as messages have it: "millimetre" for "MILLI METRE", "INCH" for "INCH of
/// MILLI METRE".
std::string GetUnitWord(const CensusUnit& unit)
{
  const std::size_t base = unit.Name.find(" of ");
  if (base != std::string::npos || unit.Name.find("METRE") == std::string::npos)
  {
    return unit.Name.substr(0, base);
  }
  std::string word;
  for (const char c : unit.Name)
  {
    word += c == ' ' ? std::string() : std::string(1, static_cast<char>(std::tolower(c)));
  }
  return word;
}

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

  /// Returns false if `progress` stopped it.
  bool Read(RepairMode repair, const ProgressCallback& progress)
  {
    this->Kind = this->Census.CountBodies(CensusBodyKind::Solid) > 0 ? CensusBodyKind::Solid
                                                                     : CensusBodyKind::SurfaceModel;
    this->ReadUnit();
    if (!this->MakeShapes(progress) || !this->Repair(repair, progress))
    {
      return false;
    }
    this->Shapes.Report(this->Result.Messages, this->Result.Defects);
    this->Result.ReversedFaces = this->Shapes.GetReversedFaces();
    this->AddColors();
    AddSTEPProducts(
      this->Entities, this->Census, this->Kind, this->Bodies, this->OccurrenceColors, this->Result);
    return true;
  }

private:
  /// Reads the unit of the first body, or else of anything in the file.
  void ReadUnit()
  {
    for (const bool isUsed : { true, false })
    {
      for (const CensusContext& context : this->Census.Contexts)
      {
        if (context.Length.Status == CensusUnit::State::Stated && (context.Used || !isUsed))
        {
          this->Result.FileUnit = GetUnitWord(context.Length);
          const double known = GetUnitInMillimetres(this->Result.FileUnit);
          this->Result.FileUnitInMillimetres = known > 0.0 ? known : context.Length.Factor;
          return;
        }
      }
    }
  }

  bool MakeShapes(const ProgressCallback& progress)
  {
    std::uint64_t faces = 0;
    for (std::size_t k = 0; k < this->Census.Bodies.size(); ++k)
    {
      const CensusBody& body = this->Census.Bodies[k];
      if (body.Kind != this->Kind || body.Instances == 0)
      {
        continue;
      }
      const TopoDS_Shape shape = this->Shapes.MakeBody(body);
      if (!shape.IsNull())
      {
        this->Bodies.emplace(static_cast<std::uint32_t>(k), shape);
      }
      faces += body.Faces;
      if (!progress(0.5 * static_cast<double>(faces) /
            static_cast<double>(std::max<std::uint64_t>(1, this->Census.CountFaces(this->Kind)))))
      {
        return false;
      }
    }
    return true;
  }

  bool Repair(RepairMode repair, const ProgressCallback& progress)
  {
    const ShapeLabel label = [this](const TopoDS_Shape& shape) { return this->Shapes.GetLabel(shape); };
    const RepairFilter isSound = [&](TopoDS_Shape& shape, const FaceRepair& repairFaces)
    {
      if (repair == RepairMode::OnNeed)
      {
        return IsSoundBody(shape, this->Log, label, repairFaces);
      }
      LogBeforeRepair(shape, this->Log, label);
      return false;
    };
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
          builder.Add(parts, this->RepairShape(it.Value(), precision, isSound));
        }
        shape = parts;
      }
      else
      {
        shape = this->RepairShape(shape, precision, isSound);
      }
      if (!progress(0.5 + 0.5 * static_cast<double>(++done) / static_cast<double>(this->Bodies.size())))
      {
        return false;
      }
    }
    for (const auto& [shape, face] : this->Log.SoundFaces)
    {
      AddShapeInfo(this->Result.Table, face->Face).AsInFile = face;
    }
    return true;
  }

  TopoDS_Shape RepairShape(const TopoDS_Shape& original, double precision, const RepairFilter& isSound)
  {
    const TopoDS_Shape shape = RepairOnDemand(original, precision, std::max(precision, LargestTolerance),
      isSound, [this](const TopoDS_Shape& from, const TopoDS_Shape& to) { this->PassInfo(from, to); });
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
      ShapeInfo& own = AddShapeInfo(this->Result.Table, it.Current());
      if (own.FileId == 0)
      {
        info.Owner = own.Owner;
        info.AsInFile = own.AsInFile;
        own = info;
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

bool ReadSTEPDirectly(const Part21File& file, const STEPCensus& census, RepairMode repair,
  const ProgressCallback& progress, Document& document, RepairLog& log)
{
  return DirectReader(file, census, document, log).Read(repair, progress);
}
}
