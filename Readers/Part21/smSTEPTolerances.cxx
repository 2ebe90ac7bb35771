#include "smSTEPTolerances.h"

#include "smPart21Values.h"
#include "smSTEPAttributes.h"
#include "smSTEPTopologyAttributes.h"
#include "smSTEPUnits.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <map>
#include <set>

namespace sm
{
namespace
{
using Index = Part21File::Index;

constexpr STEPAttribute ToleranceMagnitude = { "GEOMETRIC_TOLERANCE", 2, 2, "magnitude" };
constexpr STEPAttribute TolerancedAspect = { "GEOMETRIC_TOLERANCE", 3, 3, "toleranced shape aspect" };
constexpr STEPAttribute ToleranceDisplacement = { "UNEQUALLY_DISPOSED_GEOMETRIC_TOLERANCE", 0, 4,
  "displacement" };
constexpr STEPAttribute PlusMinusRange = { "PLUS_MINUS_TOLERANCE", 0, 0, "range" };
constexpr STEPAttribute PlusMinusDimension = { "PLUS_MINUS_TOLERANCE", 1, 1, "toleranced dimension" };
constexpr STEPAttribute RangeLower = { "TOLERANCE_VALUE", 0, 0, "lower bound" };
constexpr STEPAttribute RangeUpper = { "TOLERANCE_VALUE", 1, 1, "upper bound" };
constexpr STEPAttribute SizeAspect = { "DIMENSIONAL_SIZE", 0, 0, "applies to" };
constexpr STEPAttribute SizeName = { "DIMENSIONAL_SIZE", 1, 1, "name" };
constexpr STEPAttribute LocationName = { "SHAPE_ASPECT_RELATIONSHIP", 0, 0, "name" };
constexpr STEPAttribute RelatingAspect = { "SHAPE_ASPECT_RELATIONSHIP", 2, 2, "relating shape aspect" };
constexpr STEPAttribute RelatedAspect = { "SHAPE_ASPECT_RELATIONSHIP", 3, 3, "related shape aspect" };
constexpr STEPAttribute UsageDefinition = { "ITEM_IDENTIFIED_REPRESENTATION_USAGE", 2, 2, "definition" };
constexpr STEPAttribute UsageItem = { "ITEM_IDENTIFIED_REPRESENTATION_USAGE", 4, 4, "identified item" };
constexpr STEPAttribute RelatedTolerance = { "GEOMETRIC_TOLERANCE_RELATIONSHIP", 3, 3,
  "related geometric tolerance" };
constexpr STEPAttribute PositionOfSurface = { "ELEMENTARY_SURFACE", 0, 1, "position" };
constexpr STEPAttribute AxisOfPosition = { "AXIS2_PLACEMENT_3D", 0, 2, "axis" };
constexpr STEPAttribute RatiosOfDirection = { "DIRECTION", 0, 1, "direction ratios" };
/// Normals are opposite within this.
constexpr double OppositeNormals = 1e-6;

/// Reads the links from aspects to faces once, then the tolerances.
class ToleranceReader
{
public:
  explicit ToleranceReader(const Part21File& file)
    : File(file)
    , Entities(file)
  {
    for (Index i = 0; i < file.GetNumberOfInstances(); ++i)
    {
      if (this->Is(i, "GEOMETRIC_ITEM_SPECIFIC_USAGE"))
      {
        this->AddItems(
          this->Entities.Follow(this->Entities.Get(i, UsageDefinition)), this->Entities.Get(i, UsageItem), 0);
      }
      else if (this->Is(i, "GEOMETRIC_TOLERANCE_RELATIONSHIP"))
      {
        this->Refinements.insert(this->Entities.Follow(this->Entities.Get(i, RelatedTolerance)));
      }
      else if (this->Is(i, "PRODUCT"))
      {
        ++this->Products;
      }
      else if (this->Is(i, "SHAPE_ASPECT_RELATIONSHIP") && !file.IsComplex(i))
      {
        const Index relating = this->Entities.Follow(this->Entities.Get(i, RelatingAspect));
        const Index related = this->Entities.Follow(this->Entities.Get(i, RelatedAspect));
        if (relating != STEPAttributes::None && related != STEPAttributes::None)
        {
          this->Parts[relating].push_back(related);
        }
      }
    }
  }

  std::vector<STEPTolerance> Read()
  {
    std::vector<STEPTolerance> tolerances;
    for (Index i = 0; i < this->File.GetNumberOfInstances(); ++i)
    {
      const std::string kind = this->FindKind(i);
      if (kind.empty())
      {
        continue;
      }
      STEPTolerance tolerance;
      tolerance.Id = this->File.GetId(i);
      tolerance.Kind = kind;
      if (this->File.IsDamaged(i))
      {
        tolerance.Problem = "it is damaged";
      }
      else if (kind == "plus minus")
      {
        this->ReadPlusMinus(i, tolerance);
      }
      else
      {
        this->ReadGeometric(i, tolerance);
      }
      if (tolerance.Problem.empty() && (tolerance.Lower > 0.0 || tolerance.Upper < 0.0))
      {
        tolerance.Problem = "its range leaves out the face of the model, for which no worst case is known";
      }
      if (!tolerance.Problem.empty())
      {
        tolerance.Problem += "; give the face a range with --face-tolerance";
      }
      tolerances.push_back(tolerance);
    }
    return tolerances;
  }

private:
  bool Is(Index i, std::string_view type) const
  {
    std::string_view parameters;
    return this->Entities.FindRecord(i, type, parameters);
  }

  /// Returns "surface profile" for SURFACE_PROFILE_TOLERANCE; empty for other entities.
  std::string FindKind(Index i) const
  {
    constexpr std::string_view end = "_TOLERANCE";
    std::string kind;
    for (std::size_t k = 0; k < this->File.GetNumberOfRecords(i); ++k)
    {
      const std::string& type = this->File.GetTypeNames()[this->File.GetType(i, k)];
      const bool isKind = type.size() > end.size() &&
        type.compare(type.size() - end.size(), end.size(), end.data()) == 0 &&
        type.find("GEOMETRIC_TOLERANCE") == std::string::npos && type != "MODIFIED_GEOMETRIC_TOLERANCE";
      if (isKind || (type == "GEOMETRIC_TOLERANCE" && kind.empty()))
      {
        kind = type.substr(0, type.size() - end.size());
      }
    }
    std::transform(kind.begin(), kind.end(), kind.begin(),
      [](unsigned char c) { return c == '_' ? ' ' : static_cast<char>(std::tolower(c)); });
    return kind;
  }

  /// Adds the faces among the items of a usage, which are a reference or a list of them.
  void AddItems(Index aspect, const Part21Value& value, int depth)
  {
    if (value.IsReference())
    {
      const Index item = this->Entities.Follow(value);
      if (item != STEPAttributes::None && (this->Is(item, "ADVANCED_FACE") || this->Is(item, "FACE_SURFACE")))
      {
        this->Faces[aspect].push_back(item);
      }
      else
      {
        this->Others.insert(aspect);
      }
    }
    else if ((value.IsList() || value.Kind == Part21Kind::Typed) && depth < 3)
    {
      Part21Values values(value.Text);
      for (Part21Value part; values.Next(part);)
      {
        this->AddItems(aspect, part, depth + 1);
      }
    }
  }

  /// Returns the faces of an aspect and of all its parts; `isWhole` becomes false if it has other items.
  std::vector<Index> CollectFaces(Index aspect, bool& isWhole) const
  {
    std::vector<Index> faces;
    std::set<Index> seen{ aspect };
    std::vector<Index> open{ aspect };
    while (!open.empty())
    {
      const Index at = open.back();
      open.pop_back();
      const auto own = this->Faces.find(at);
      if (own != this->Faces.end())
      {
        faces.insert(faces.end(), own->second.begin(), own->second.end());
      }
      isWhole = isWhole && this->Others.count(at) == 0;
      const auto parts = this->Parts.find(at);
      for (const Index part : parts != this->Parts.end() ? parts->second : std::vector<Index>())
      {
        if (seen.insert(part).second)
        {
          open.push_back(part);
        }
      }
    }
    std::sort(faces.begin(), faces.end());
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    return faces;
  }

  /// Reads a length in mm; false if it is not one.
  bool ReadLength(const Part21Value& reference, double& length) const
  {
    Index unit;
    std::vector<Index> used;
    if (!ReadSTEPMeasure(this->Entities, this->Entities.Follow(reference), length, unit))
    {
      return false;
    }
    length *= ReadSTEPUnit(this->Entities, unit, STEPUnitKind::Length, used).Factor;
    return std::isfinite(length);
  }

  std::vector<Index> LinkFaces(Index aspect, STEPTolerance& tolerance) const
  {
    bool isWhole = true;
    const std::vector<Index> faces = this->CollectFaces(aspect, isWhole);
    for (const Index face : faces)
    {
      tolerance.Faces.push_back(this->File.GetId(face));
    }
    tolerance.IsForAll = faces.empty() && this->Is(aspect, "PRODUCT_DEFINITION_SHAPE");
    if (faces.empty() && !tolerance.IsForAll)
    {
      tolerance.Problem = "no face is linked to it";
    }
    else if (!isWhole)
    {
      tolerance.Problem = "it is also about other things than faces";
    }
    else if (tolerance.IsForAll && this->Products > 1)
    {
      tolerance.Problem = "it is for one product, and the file has several";
    }
    return faces;
  }

  void ReadGeometric(Index i, STEPTolerance& tolerance) const
  {
    double width = 0.0;
    this->LinkFaces(this->Entities.Follow(this->Entities.Get(i, TolerancedAspect)), tolerance);
    if (!this->ReadLength(this->Entities.Get(i, ToleranceMagnitude), width) || !(width >= 0.0))
    {
      tolerance.Problem = "its value is not a length";
      return;
    }
    tolerance.Lower = -0.5 * width;
    tolerance.Upper = 0.5 * width;
    if (this->Is(i, "UNEQUALLY_DISPOSED_GEOMETRIC_TOLERANCE"))
    {
      double shift = 0.0;
      if (!this->ReadLength(this->Entities.Get(i, ToleranceDisplacement), shift))
      {
        tolerance.Problem = "its displacement is not a length";
      }
      tolerance.Lower = shift - width;
      tolerance.Upper = shift + 0.5 * width;
    }
    if (tolerance.Problem.empty() && this->Refinements.count(i) > 0)
    {
      tolerance.Problem =
        "it refines another tolerance of a composite one, and does not say where the face is";
    }
    const bool hasDatum = this->Is(i, "GEOMETRIC_TOLERANCE_WITH_DATUM_REFERENCE");
    if (tolerance.Problem.empty() && tolerance.Kind != "surface profile")
    {
      tolerance.Problem = "it does not say how far a face may be off along its normal";
    }
    else if (tolerance.Problem.empty() && !hasDatum)
    {
      tolerance.Problem = "without a datum it is about the form of the face, not about where it is";
    }
  }

  /// Returns 1 if the outward normal of a face on a surface of this type is that of the surface, -1 if it is
  /// reversed, 0 for other surfaces.
  int GetSense(Index face, std::string_view surface) const
  {
    if (!this->Is(this->Entities.Follow(this->Entities.Get(face, SurfaceOfFace)), surface))
    {
      return 0;
    }
    return this->Entities.Get(face, SenseOfFace).Text == "F" ? -1 : 1;
  }

  bool ReadNormal(Index face, std::array<double, 3>& normal) const
  {
    const Index plane = this->Entities.Follow(this->Entities.Get(face, SurfaceOfFace));
    const Index position = this->Entities.Follow(this->Entities.Get(plane, PositionOfSurface));
    const Index axis = this->Entities.Follow(this->Entities.Get(position, AxisOfPosition));
    const int sense = this->GetSense(face, "PLANE");
    const Part21Value ratios = this->Entities.Get(axis, RatiosOfDirection);
    double length = 0.0;
    for (std::size_t d = 0; d < 3; ++d)
    {
      if (sense == 0 || !GetPart21Value(ratios.Text, d).GetNumber(normal[d]))
      {
        return false;
      }
      length = std::hypot(length, normal[d]);
    }
    for (double& component : normal)
    {
      component *= sense / length;
    }
    return length > 0.0;
  }

  void ReadPlusMinus(Index i, STEPTolerance& tolerance) const
  {
    const Index range = this->Entities.Follow(this->Entities.Get(i, PlusMinusRange));
    const Index dimension = this->Entities.Follow(this->Entities.Get(i, PlusMinusDimension));
    double lower = 0.0;
    double upper = 0.0;
    if (!this->Is(range, "TOLERANCE_VALUE"))
    {
      tolerance.Problem = "its limits are those of a fit, which are in a table of a standard";
      return;
    }
    if (!this->ReadLength(this->Entities.Get(range, RangeLower), lower) ||
      !this->ReadLength(this->Entities.Get(range, RangeUpper), upper) || !(lower <= upper))
    {
      tolerance.Problem = "its limits are not lengths, the lower one first";
      return;
    }
    if (this->Is(dimension, "DIMENSIONAL_SIZE"))
    {
      this->ReadSize(dimension, lower, upper, tolerance);
    }
    else if (this->Is(dimension, "DIMENSIONAL_LOCATION"))
    {
      this->ReadThickness(dimension, lower, upper, tolerance);
    }
    else
    {
      tolerance.Problem = "it is of an angle, or of another dimension than a size or a distance";
    }
  }

  void ReadSize(Index dimension, double lower, double upper, STEPTolerance& tolerance) const
  {
    const std::string_view name = this->Entities.Get(dimension, SizeName).Text;
    const bool isDiameter = name.find("diameter") != std::string_view::npos;
    const bool isRadius = name.find("radius") != std::string_view::npos;
    const std::vector<Index> faces =
      this->LinkFaces(this->Entities.Follow(this->Entities.Get(dimension, SizeAspect)), tolerance);
    tolerance.Kind = isDiameter ? "diameter" : isRadius ? "radius" : "size";
    if (!tolerance.Problem.empty())
    {
      return;
    }
    const int sense = faces.empty() ? 0 : this->GetSense(faces.front(), "CYLINDRICAL_SURFACE");
    if ((!isDiameter && !isRadius) || sense == 0 ||
      !std::all_of(faces.begin(), faces.end(),
        [&](Index face) { return this->GetSense(face, "CYLINDRICAL_SURFACE") == sense; }))
    {
      tolerance.Problem = "it is not the diameter or radius of cylinders that are all outside, or all inside";
      return;
    }
    const double factor = isDiameter ? 0.5 : 1.0;
    tolerance.Lower = factor * (sense > 0 ? lower : -upper);
    tolerance.Upper = factor * (sense > 0 ? upper : -lower);
  }

  void ReadThickness(Index dimension, double lower, double upper, STEPTolerance& tolerance) const
  {
    tolerance.Kind = "thickness";
    std::array<std::array<double, 3>, 2> normals;
    const STEPAttribute ends[2] = { RelatingAspect, RelatedAspect };
    for (int k = 0; k < 2; ++k)
    {
      const std::vector<Index> faces =
        this->LinkFaces(this->Entities.Follow(this->Entities.Get(dimension, ends[k])), tolerance);
      if (faces.size() != 1 || !this->ReadNormal(faces.front(), normals[k]))
      {
        tolerance.Problem = "it is not a distance between two planes";
        return;
      }
    }
    double sum = 0.0;
    for (int d = 0; d < 3; ++d)
    {
      sum = std::hypot(sum, normals[0][d] + normals[1][d]);
    }
    if (!(sum <= OppositeNormals) || this->Entities.Get(dimension, LocationName).Text != "linear distance")
    {
      tolerance.Problem = "it is not a distance between two planes with opposite normals";
      return;
    }
    // A thickness or a width: the sign depends on which plane is in front of the other.
    const double distance = this->GetSignedDistance(tolerance.Faces, normals[0]);
    if (distance == 0.0)
    {
      tolerance.Problem = "its planes coincide";
      return;
    }
    tolerance.Lower = 0.5 * (distance < 0.0 ? lower : -upper);
    tolerance.Upper = 0.5 * (distance < 0.0 ? upper : -lower);
  }

  /// Returns how far the second plane is in front of the first, whose outward normal is given.
  double GetSignedDistance(const std::vector<std::uint64_t>& faces, const std::array<double, 3>& normal) const
  {
    constexpr STEPAttribute location = { "PLACEMENT", 0, 1, "location" };
    constexpr STEPAttribute coordinates = { "CARTESIAN_POINT", 0, 1, "coordinates" };
    double distance = 0.0;
    for (int k = 0; k < 2; ++k)
    {
      const Index plane = this->Entities.Follow(this->Entities.Get(this->File.Find(faces[k]), SurfaceOfFace));
      const Index position = this->Entities.Follow(this->Entities.Get(plane, PositionOfSurface));
      const Part21Value point =
        this->Entities.Get(this->Entities.Follow(this->Entities.Get(position, location)), coordinates);
      for (std::size_t d = 0; d < 3; ++d)
      {
        double coordinate = 0.0;
        GetPart21Value(point.Text, d).GetNumber(coordinate);
        distance += (k == 0 ? -1.0 : 1.0) * coordinate * normal[d];
      }
    }
    return distance;
  }

  const Part21File& File;
  STEPAttributes Entities;
  /// Of aspects: faces, parts, and whether other items are linked.
  std::map<Index, std::vector<Index>> Faces;
  std::map<Index, std::vector<Index>> Parts;
  std::set<Index> Others;
  /// Tolerances that refine others.
  std::set<Index> Refinements;
  std::size_t Products = 0;
};
}

std::vector<STEPTolerance> ReadSTEPTolerances(const Part21File& file)
{
  return ToleranceReader(file).Read();
}
}
