#include "smSTEPExtent.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <unordered_set>
#include <vector>

namespace sm
{
namespace
{
constexpr STEPAttribute CoordinatesOfTessellation = { "COORDINATES_LIST", 0, 2, "coordinates" };
constexpr STEPAttribute CoordinatesOfPlace = { "CARTESIAN_POINT", 0, 1, "coordinates" };

/// Curves and surfaces with radii; their points are that far from their placements at most.
constexpr std::string_view RoundTypes[] = { "CIRCLE", "ELLIPSE", "CONICAL_SURFACE", "CYLINDRICAL_SURFACE",
  "DEGENERATE_TOROIDAL_SURFACE", "SPHERICAL_SURFACE", "TOROIDAL_SURFACE" };

void AddCoordinates(std::string_view coordinates, STEPExtent& extent)
{
  Part21Values values(coordinates);
  double p[3];
  std::size_t count = 0;
  for (Part21Value value; count < 3 && values.Next(value) && value.GetNumber(p[count]); ++count)
  {
  }
  for (std::size_t c = 0; count == 3 && c < 3; ++c)
  {
    extent.Low[c] = std::min(extent.Low[c], p[c]);
    extent.High[c] = std::max(extent.High[c], p[c]);
  }
}

/// Returns the sum of the numbers of a curve or surface with radii; 0 for other entities.
double GetRadii(const STEPAttributes& entities, Part21File::Index i)
{
  double radii = 0.0;
  for (const std::string_view type : RoundTypes)
  {
    std::string_view parameters;
    if (entities.FindRecord(i, type, parameters))
    {
      Part21Values values(parameters);
      double number = 0.0;
      for (Part21Value value; values.Next(value);)
      {
        radii += value.GetNumber(number) ? std::abs(number) : 0.0;
      }
    }
  }
  return radii;
}
}

double STEPExtent::GetDiagonal() const
{
  return std::hypot(this->High[0] - this->Low[0], this->High[1] - this->Low[1], this->High[2] - this->Low[2]);
}

void AddExtent(const STEPAttributes& entities, Part21File::Index start, STEPExtent& extent)
{
  using Index = Part21File::Index;
  std::vector<Index> open{ start };
  std::unordered_set<Index> seen;
  while (!open.empty())
  {
    const Index i = open.back();
    open.pop_back();
    if (i == Part21File::None || !seen.insert(i).second)
    {
      continue;
    }
    const Part21Value point = entities.Get(i, CoordinatesOfPlace);
    const Part21Value list = entities.Get(i, CoordinatesOfTessellation);
    if (point.IsList())
    {
      AddCoordinates(point.Text, extent);
    }
    Part21Values points(list.IsList() ? list.Text : std::string_view());
    for (Part21Value value; points.Next(value);)
    {
      AddCoordinates(value.Text, extent);
    }
    extent.Reach = std::max(extent.Reach, GetRadii(entities, i));
    std::string_view parameters;
    extent.IsRevolved = extent.IsRevolved || entities.FindRecord(i, "SURFACE_OF_REVOLUTION", parameters);
    for (const Index to : entities.File.GetReferences(i))
    {
      open.push_back(to);
    }
  }
}
}
