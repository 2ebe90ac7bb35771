#include "smSTEPDirect.h"

#include "smFormat.h"
#include "smKernel.h"
#include "smLengthUnits.h"
#include "smSTEPAppearance.h"
#include "smSTEPAttributes.h"
#include "smSTEPCensusReport.h"
#include "smSTEPProductTree.h"
#include "smSTEPShapes.h"
#include "smShapeAdder.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <set>
#include <unordered_map>
#include <unordered_set>

namespace sm
{
namespace
{
/// Tolerance that the repair may give edges and vertices, in millimetres.
constexpr double MaxTolerance = 1.0;

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
  DirectReader(const Part21File& file, STEPCensus& census, Document& document, RepairLog& log)
    : Entities(file)
    , Census(census)
    , Result(document)
    , Log(log)
    , Shapes(this->Entities, census, this->Ledger)
  {
  }

  /// Returns false if `progress` stopped it.
  bool Read(RepairMode repair, HiddenMode hidden, const ProgressCallback& progress)
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
    const std::unordered_set<std::uint64_t> items = STEPAppearance(this->Entities).ReadHiddenItems();
    AddSTEPProducts(this->Entities, this->Census, this->Kind, this->Bodies, this->OccurrenceColors, items,
      hidden, this->Result);
    if (hidden == HiddenMode::Count)
    {
      this->ReportHidden(items);
    }
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
    std::vector<const CensusBody*> bodies;
    for (const CensusBody& body : this->Census.Bodies)
    {
      if (body.Instances > 0 && body.Kind == this->Kind)
      {
        bodies.push_back(&body);
      }
      else if (body.Instances > 0)
      {
        this->ReportKind(body);
      }
    }
    if (!this->Shapes.MakeGeometry(bodies, [&progress] { return progress(0.0); }))
    {
      return false;
    }
    std::uint64_t faces = 0;
    for (const CensusBody* body : bodies)
    {
      const auto index = static_cast<std::uint32_t>(body - this->Census.Bodies.data());
      this->Bodies[index].Shapes = this->Shapes.MakeBody(*body);
      faces += body->Faces;
      if (!progress(0.5 * static_cast<double>(faces) /
            static_cast<double>(std::max<std::uint64_t>(1, this->Census.CountFaces(this->Kind)))))
      {
        return false;
      }
    }
    return true;
  }

  /// Reports a body of a kind that is not read.
  void ReportKind(const CensusBody& body)
  {
    if (body.Kind == CensusBodyKind::OtherSolid)
    {
      this->Result.Defects.push_back("Solid " + NameEntity(body.Id, body.Name) +
        " of the file is of the type " + body.Type +
        ", which has no faces: it is left out. Export it as a boundary representation.");
    }
    else if (body.Kind == CensusBodyKind::Tessellated && !body.Alternative)
    {
      // Sets of triangles may be annotations.
      const bool isBody = body.Type.find("TESSELLATED_SOLID") != std::string::npos ||
        body.Type.find("TESSELLATED_SHELL") != std::string::npos;
      (isBody ? this->Result.Defects : this->Result.Messages)
        .push_back("Body " + NameEntity(body.Id, body.Name) + " of the file is of the type " + body.Type +
          ", of triangles instead of exact faces: it is left out. Export it as a boundary representation.");
    }
  }

  /// Accounts for the faces of a solid: each is in one of its shapes, or listed as lost, be it that it was
  /// not converted or that the repair has dropped it.
  void AccountFor(const CensusBody& body, STEPBody& read)
  {
    if (body.Kind != CensusBodyKind::Solid)
    {
      return;
    }
    read.Uncertainty = this->Shapes.GetUncertainty(body);
    const int solids = ShapeAdder::CountSolids(read.Shapes);
    if (solids == 0)
    {
      this->Result.Defects.push_back("Solid " + NameEntity(body.Id, body.Name) + " of the file was lost: " +
        FormatCount(body.Faces, "face", "faces") + ", " + CountInstances(body.Instances) + ".");
      return;
    }
    if (body.NumberOfShells > 1 && solids > 1)
    {
      this->Result.Defects.push_back("Solid " + NameEntity(body.Id, body.Name) +
        " has a void that does not lie inside its outer shell: it was read as " + std::to_string(solids) +
        " solids.");
    }
    std::unordered_set<std::uint64_t> present;
    const auto collect = [&present](const ShellUse& use)
    {
      for (const FaceUse& face : use.Shell->Faces)
      {
        present.insert(static_cast<std::uint64_t>(face.Face->Data.FileId));
      }
    };
    for (const SolidUse& solid : read.Shapes.Solids)
    {
      std::for_each(solid.Solid->Shells.begin(), solid.Solid->Shells.end(), collect);
    }
    for (const ShellUse& shell : read.Shapes.Shells)
    {
      if (shell.Shell->OpenSolid)
      {
        collect(shell);
      }
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
    if (!missing.empty())
    {
      read.LostFaces = static_cast<int>(missing.size());
      read.Messages.push_back("Solid " + NameEntity(body.Id, body.Name) + " has " +
        std::to_string(body.Faces) + " faces in the file, and " + std::to_string(missing.size()) +
        " of them were lost: " + ListEntities(missing) + ".");
    }
  }

  bool Repair(RepairMode repair, const ProgressCallback& progress)
  {
    std::size_t done = 0;
    for (auto& [index, body] : this->Bodies)
    {
      ShapeGroup& shapes = body.Shapes;
      const double precision = this->Shapes.GetPrecision(this->Census.Bodies[index]);
      const RepairLimits limits{ precision, std::max(precision, MaxTolerance) };
      const auto report = [&]
      { return progress(0.5 + 0.5 * static_cast<double>(done) / static_cast<double>(this->Bodies.size())); };
      ShapeGroup result;
      for (const SolidUse& solid : shapes.Solids)
      {
        this->RepairBody(repair, MakeBody(solid), solid.Solid->Data, limits, report, result);
      }
      for (const ShellUse& shell : shapes.Shells)
      {
        this->RepairBody(repair, MakeBody(shell), ShapeData(), limits, report, result);
      }
      shapes = std::move(result);
      this->AccountFor(this->Census.Bodies[index], body);
      ++done;
      if (!report())
      {
        return false;
      }
    }
    return true;
  }

  /// Adds the body, or what a repair makes of it, to `result`.
  void RepairBody(RepairMode repair, BodyShape body, const ShapeData& data, const RepairLimits& limits,
    const RepairWatch& watch, ShapeGroup& result)
  {
    const BodyShape original = body;
    // Faces of the body before may be gone, and others have their addresses.
    this->Log.SoundFaces.clear();
    const int repairedBodies = this->Log.RepairedBodies;
    const std::size_t reasons = this->Log.Reasons.size();
    bool isSound = false;
    if (repair == RepairMode::Always)
    {
      LogBeforeRepair(original, this->Log);
    }
    else
    {
      isSound = MakeSoundBody(body, this->Log,
        [&](const BodyShape& whole, const std::vector<const FaceShape*>& faces,
          std::vector<const FaceShape*>& repaired)
        {
          if (repair == RepairMode::Never)
          {
            return whole;
          }
          return RepairFaces(whole, faces, limits, watch, repaired);
        });
    }
    std::string failure;
    if (!isSound)
    {
      failure = CallRepair(repair, original, data, limits, watch, result);
      if (failure.empty())
      {
        return;
      }
      if (repair == RepairMode::Always)
      {
        // A body that needs no repair is taken as it is.
        isSound = MakeSoundBody(body, this->Log,
          [](const BodyShape& whole, const std::vector<const FaceShape*>&, std::vector<const FaceShape*>&)
          { return whole; });
        if (isSound)
        {
          this->Result.Messages.push_back(GetLabel(original, data) +
            " of the file was not repaired: " + failure + ". It needs no repair and is taken as it is.");
        }
      }
    }
    if (!isSound)
    {
      // The body was counted as a repaired one.
      const std::string reason =
        this->Log.Reasons.size() > reasons ? " (" + this->Log.Reasons.back() + ")" : std::string();
      this->Log.Reasons.resize(reasons);
      this->Log.RepairedBodies = repairedBodies;
      CompleteFaces(original, limits.Precision, this->Log);
      this->Result.Defects.push_back(GetLabel(original, data) + " of the file needs a repair" + reason +
        " and got none: " + failure +
        ". Those of its faces that are sound are taken. Export the file again.");
      body = original;
    }
    body.VisitFaces(
      [this](const FaceUse& use)
      {
        const auto sound = this->Log.SoundFaces.find(use.Face.get());
        use.Face->Completed = sound == this->Log.SoundFaces.end() ? nullptr : sound->second;
      });
    AddTo(body, data, result);
  }

  /// Adds what a repair makes of the body to `result`; or returns why there is no repair.
  static std::string CallRepair(RepairMode repair, const BodyShape& body, const ShapeData& data,
    const RepairLimits& limits, const RepairWatch& watch, ShapeGroup& result)
  {
    if (repair == RepairMode::Never)
    {
      return "repairs are switched off";
    }
    ShapeGroup repaired;
    const std::string reason = sm::RepairBody(body, data, limits, watch, repaired);
    if (!reason.empty())
    {
      return "OpenCASCADE failed (" + reason + ")";
    }
    result.Solids.insert(result.Solids.end(), repaired.Solids.begin(), repaired.Solids.end());
    result.Shells.insert(result.Shells.end(), repaired.Shells.begin(), repaired.Shells.end());
    result.Faces.insert(result.Faces.end(), repaired.Faces.begin(), repaired.Faces.end());
    return {};
  }

  static std::string GetLabel(const BodyShape& body, const ShapeData& data)
  {
    const std::int64_t id = body.IsSolid ? data.FileId : body.Shells.front().Shell->Data.FileId;
    return (body.IsSolid ? "Solid #" : "Shell #") + std::to_string(id);
  }

  static void AddTo(const BodyShape& body, const ShapeData& data, ShapeGroup& result)
  {
    if (body.IsSolid)
    {
      const auto solid = std::make_shared<SolidShape>();
      solid->Data = data;
      solid->Shells = body.Shells;
      result.Solids.push_back({ solid, false, {} });
    }
    else
    {
      result.Shells.insert(result.Shells.end(), body.Shells.begin(), body.Shells.end());
    }
  }

  /// Reports bodies and occurrences that the file hides.
  void ReportHidden(const std::unordered_set<std::uint64_t>& hidden)
  {
    std::vector<std::uint64_t> found;
    for (const auto& [index, read] : this->Bodies)
    {
      const CensusBody& body = this->Census.Bodies[index];
      if (hidden.count(body.Id) > 0 && !read.Shapes.IsEmpty())
      {
        found.push_back(body.Id);
      }
    }
    for (const CensusOccurrence& occurrence : this->Census.Occurrences)
    {
      if (hidden.count(occurrence.Id) > 0)
      {
        found.push_back(occurrence.Id);
      }
    }
    // A representation, or a mapped item, may be what is hidden.
    std::set<std::uint64_t> inside;
    for (const BodyInstance& instance : this->Result.Instances)
    {
      if (found.empty() && instance.IsHidden)
      {
        inside.insert(
          static_cast<std::uint64_t>(this->Result.Bodies[static_cast<std::size_t>(instance.Body)].FileId));
      }
    }
    found.insert(found.end(), inside.begin(), inside.end());
    if (!found.empty())
    {
      this->Result.Messages.push_back(
        FormatCount(found.size(), "body or occurrence is", "bodies or occurrences are") +
        " hidden in the file (INVISIBILITY), first #" + std::to_string(found.front()) +
        ": they count like the others. Leave out what is not a part of the product: --hidden skip, or Hidden "
        "of the reader.");
    }
  }

  void AddColors()
  {
    const STEPColors colors = STEPAppearance(this->Entities).ReadColors();
    const auto paint = [&colors](ShapeData& data)
    {
      const auto color = colors.Items.find(static_cast<std::uint64_t>(data.FileId));
      data.Color = color == colors.Items.end() ? data.Color : color->second;
    };
    const auto paintShell = [&paint](const ShellUse& use)
    {
      paint(use.Shell->Data);
      for (const FaceUse& face : use.Shell->Faces)
      {
        paint(face.Face->Data);
      }
    };
    for (auto& [index, body] : this->Bodies)
    {
      const ShapeGroup& shapes = body.Shapes;
      for (const SolidUse& solid : shapes.Solids)
      {
        paint(solid.Solid->Data);
        std::for_each(solid.Solid->Shells.begin(), solid.Solid->Shells.end(), paintShell);
      }
      std::for_each(shapes.Shells.begin(), shapes.Shells.end(), paintShell);
      for (const FaceUse& face : shapes.Faces)
      {
        paint(face.Face->Data);
      }
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
  STEPBodies Bodies;
};
}

bool ReadSTEPDirectly(const Part21File& file, STEPCensus& census, RepairMode repair, HiddenMode hidden,
  const ProgressCallback& progress, Document& document, RepairLog& log)
{
  return DirectReader(file, census, document, log).Read(repair, hidden, progress);
}
}
