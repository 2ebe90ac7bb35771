#include "smFlaggedPlaces.h"

#include "smBodyScales.h"
#include "smEdgeLines.h"
#include "smFormat.h"
#include "smIntegralNames.h"
#include "smMeshTriangles.h"
#include "smVector.h"
#include "smWholeSphere.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkTypeInt64Array.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <utility>

namespace sm
{
namespace
{
/// Largest number of edges that a text names.
constexpr std::size_t MaxNames = 5;
/// Largest number of characters of the lines of a list.
constexpr std::size_t LengthOfLines = 64;

/// Returns the world coordinates of a point in stored coordinates.
Vector3 PlacePoint(const BodyIntegrals& body, const Vector3& stored)
{
  return sm::PlacePoint(*body.Model, body.Placement.data(), stored);
}

/// Returns the length of the vector area of closed chains of edges, in their signed directions; NaN if they
/// do not close.
double GetVectorArea(const std::vector<const EdgeGap*>& edges)
{
  const Vector3 origin = edges.front()->Source->StartVertex;
  Vector3 twice{};
  std::map<Vector3, int> ends;
  for (const EdgeGap* edge : edges)
  {
    ends[edge->Source->StartVertex] -= edge->SignedUses;
    ends[edge->Source->EndVertex] += edge->SignedUses;
    const std::vector<Vector3> points = SampleEdge(*edge->Source);
    for (std::size_t i = 1; i < points.size(); ++i)
    {
      const Vector3 part = Cross(Subtract(points[i - 1], origin), Subtract(points[i], origin));
      for (int d = 0; d < 3; ++d)
      {
        twice[d] += edge->SignedUses * part[d];
      }
    }
  }
  const bool isClosed =
    std::all_of(ends.begin(), ends.end(), [](const auto& end) { return end.second == 0; });
  return isClosed ? 0.5 * Norm(twice) : std::numeric_limits<double>::quiet_NaN();
}

/// Divides the open edges of a body into sets that are connected by vertices.
std::vector<std::vector<const EdgeGap*>> FindOpenings(const std::vector<EdgeGap>& edges)
{
  std::map<Vector3, std::vector<const EdgeGap*>> atVertex;
  for (const EdgeGap& edge : edges)
  {
    if (edge.IsOpen())
    {
      atVertex[edge.Source->StartVertex].push_back(&edge);
      atVertex[edge.Source->EndVertex].push_back(&edge);
    }
  }
  std::vector<std::vector<const EdgeGap*>> openings;
  for (const EdgeGap& first : edges)
  {
    if (!first.IsOpen() || atVertex[first.Source->StartVertex].empty())
    {
      continue;
    }
    // The edges at a vertex are taken from the map when the search comes there.
    openings.emplace_back();
    std::vector<const EdgeGap*>& opening = openings.back();
    std::vector<Vector3> reached{ first.Source->StartVertex };
    while (!reached.empty())
    {
      const std::vector<const EdgeGap*> here = std::move(atVertex[reached.back()]);
      atVertex[reached.back()].clear();
      reached.pop_back();
      for (const EdgeGap* edge : here)
      {
        opening.push_back(edge);
        reached.push_back(edge->Source->StartVertex);
        reached.push_back(edge->Source->EndVertex);
      }
    }
    // An edge was found from both of its ends.
    std::sort(opening.begin(), opening.end(),
      [](const EdgeGap* a, const EdgeGap* b)
      { return std::make_pair(a->Source->Id, a) < std::make_pair(b->Source->Id, b); });
    opening.erase(std::unique(opening.begin(), opening.end()), opening.end());
  }
  return openings;
}

/// "edge #12", "7 faces #3, #5, ..."; `get` returns the edge or face at an index.
template <typename GetEntity>
std::string NameEntities(const std::string& kind, std::size_t count, GetEntity get)
{
  std::string list;
  for (std::size_t i = 0; i < std::min(count, MaxNames); ++i)
  {
    list += (i > 0 ? ", #" : " #") + std::to_string(get(i).FileId) +
      (get(i).Name.empty() ? std::string() : " \"" + get(i).Name + "\"");
  }
  return (count == 1 ? kind : std::to_string(count) + " " + kind + "s") + list +
    (count > MaxNames ? ", ..." : "");
}

std::string NameEdges(const std::vector<const EdgeGap*>& edges)
{
  return NameEntities(
    "edge", edges.size(), [&edges](std::size_t i) -> const Edge& { return *edges[i]->Source; });
}

void AddEdges(const BodyIntegrals& body, std::size_t index, std::vector<FlaggedPlace>& places)
{
  const std::array<double, 6> box = GetBox(*body.Model);
  const auto reach = [&box](int d) { return std::max(std::abs(box[2 * d]), std::abs(box[2 * d + 1])); };
  const double radius = std::hypot(reach(0), reach(1), reach(2));
  for (std::vector<const EdgeGap*>& opening : FindOpenings(*body.Edges))
  {
    FlaggedPlace place;
    place.Body = index;
    place.Reason = (body.IsSolid() ? "opening at " : "border of a surface, ") + NameEdges(opening);
    if (body.IsSolid())
    {
      place.AreaInDoubt = GetVectorArea(opening);
      place.VolumeInDoubt = place.AreaInDoubt * radius / 3.0;
    }
    place.Edges = std::move(opening);
    places.push_back(std::move(place));
  }
  for (const EdgeGap& edge : *body.Edges)
  {
    if (edge.MaxGap > body.ExcusedGap && !edge.IsOpen())
    {
      FlaggedPlace place;
      place.Body = index;
      place.Edges = { &edge };
      place.Reason = "gap of " + FormatDigits(edge.MaxGap, 2) + " " + body.Model->GetLengthUnit() + " at " +
        NameEdges(place.Edges);
      place.AreaInDoubt = edge.GapArea;
      place.VolumeInDoubt = std::isnan(edge.Spread) ? edge.GapSquared : edge.Spread;
      places.push_back(std::move(place));
    }
  }
}

/// Area of a face's display mesh, and its flux of x.n/3 about the placed origin of the model.
struct FaceExtent
{
  double Area = 0.0;
  double Volume = 0.0;
};

void AddFaces(const BodyIntegrals& body, std::size_t index, std::vector<FlaggedPlace>& places)
{
  std::vector<FaceExtent> extents(static_cast<std::size_t>(body.Model->GetNumberOfFaces()));
  const Vector3 origin = PlacePoint(body, {});
  VisitTriangles(body.Mesh, body.FaceDefects.empty() ? 0 : extents.size(),
    [&extents, &origin](std::size_t face, const auto& corners, const auto&)
    {
      const Vector3 twice = Cross(Subtract(corners[1], corners[0]), Subtract(corners[2], corners[0]));
      extents[face].Area += 0.5 * Norm(twice);
      extents[face].Volume += Dot(Subtract(corners[0], origin), twice) / 6.0;
    });
  // Whole spheres have few triangles. The sign of the volume is that of the mesh.
  const std::vector<WholeSphere> spheres =
    body.FaceDefects.empty() ? std::vector<WholeSphere>() : FindWholeSpheres(body.Model->GetFaces());
  for (std::size_t face = 0; face < spheres.size(); ++face)
  {
    if (spheres[face])
    {
      extents[face] = { spheres[face].GetArea(),
        std::copysign(spheres[face].GetSignedVolume(), extents[face].Volume) };
    }
  }
  for (const FaceDefect& defect : body.FaceDefects)
  {
    if (defect.Faces.empty())
    {
      continue;
    }
    FlaggedPlace place;
    place.Body = index;
    place.Faces = defect.Faces;
    place.Reason = NameEntities("face", defect.Faces.size(),
                     [&](std::size_t i) -> const Face& { return *body.Model->GetFaces()[defect.Faces[i]]; }) +
      ": " + defect.Reason;
    FaceExtent all;
    for (const std::size_t face : defect.Faces)
    {
      all.Area += extents[face].Area;
      all.Volume += extents[face].Volume;
    }
    // Faces without triangles have an unknown extent.
    const bool isWhole = defect.IsWhole && all.Area > 0.0;
    place.AreaInDoubt = isWhole ? all.Area : defect.Area;
    place.VolumeInDoubt = isWhole ? std::abs(all.Volume) : defect.Volume;
    places.push_back(std::move(place));
  }
}

std::string Describe(const FlaggedPlace& place, const BodyIntegrals& body)
{
  const std::string unit = body.Model->GetLengthUnit();
  std::string figures;
  if (std::isfinite(place.AreaInDoubt))
  {
    figures += FormatDigits(place.AreaInDoubt, 4) + " " + unit + "^2";
  }
  if (std::isfinite(place.VolumeInDoubt))
  {
    figures += (figures.empty() ? "" : " and ") + FormatDigits(place.VolumeInDoubt, 4) + " " + unit + "^3";
  }
  return (body.Name.empty() ? "" : body.Name + ": ") + place.Reason +
    (figures.empty() ? "" : ", about " + figures + " in doubt");
}

/// The columns of the cell data of port 6.
class CellColumns
{
public:
  CellColumns()
  {
    this->Flag->SetName(names::Flag);
    this->Solid->SetName(names::Solid);
    this->Name->SetName(names::Name);
    this->FaceId->SetName(names::FaceId);
    this->EdgeId->SetName(names::EdgeId);
    this->MaxGap->SetName(names::MaxGap);
    this->Area->SetName(names::AreaInDoubt);
    this->Volume->SetName(names::VolumeInDoubt);
    this->Text->SetName(names::Text);
  }
  /// Either `edge` or `face` is not null.
  void Append(std::size_t flag, const FlaggedPlace& place, const BodyIntegrals& body, const std::string& text,
    const EdgeGap* edge, const Face* face)
  {
    this->Flag->InsertNextValue(static_cast<int>(flag) + 1);
    this->Solid->InsertNextValue(static_cast<int>(place.Body));
    this->Name->InsertNextValue(body.Name);
    this->FaceId->InsertNextValue(face ? face->FileId : 0);
    this->EdgeId->InsertNextValue(edge ? edge->Source->FileId : 0);
    this->MaxGap->InsertNextValue(edge ? edge->MaxGap : std::numeric_limits<double>::quiet_NaN());
    this->Area->InsertNextValue(place.AreaInDoubt);
    this->Volume->InsertNextValue(place.VolumeInDoubt);
    this->Text->InsertNextValue(text);
  }
  void AddTo(vtkCellData* data) const
  {
    data->AddArray(this->Flag);
    data->AddArray(this->Solid);
    data->AddArray(this->Name);
    data->AddArray(this->FaceId);
    data->AddArray(this->EdgeId);
    data->AddArray(this->MaxGap);
    data->AddArray(this->Area);
    data->AddArray(this->Volume);
    data->AddArray(this->Text);
  }

private:
  vtkNew<vtkIntArray> Flag;
  vtkNew<vtkIntArray> Solid;
  vtkNew<vtkStringArray> Name;
  vtkNew<vtkTypeInt64Array> FaceId;
  vtkNew<vtkTypeInt64Array> EdgeId;
  vtkNew<vtkDoubleArray> MaxGap;
  vtkNew<vtkDoubleArray> Area;
  vtkNew<vtkDoubleArray> Volume;
  vtkNew<vtkStringArray> Text;
};

/// Inserts the points of an edge in world coordinates. Returns their indices.
std::vector<vtkIdType> InsertEdge(const Edge& edge, const BodyIntegrals& body, vtkPoints* points)
{
  std::vector<vtkIdType> ids;
  for (const Vector3& stored : SampleEdge(edge))
  {
    ids.push_back(points->InsertNextPoint(PlacePoint(body, stored).data()));
  }
  return ids;
}
}

std::vector<FlaggedPlace> FindFlaggedPlaces(const std::vector<BodyIntegrals>& bodies)
{
  std::vector<FlaggedPlace> places;
  for (std::size_t i = 0; i < bodies.size(); ++i)
  {
    if (bodies[i].Status >= Status::Suspect && bodies[i].Edges)
    {
      AddEdges(bodies[i], i, places);
      AddFaces(bodies[i], i, places);
    }
  }
  std::stable_sort(places.begin(), places.end(),
    [](const FlaggedPlace& a, const FlaggedPlace& b)
    {
      return !std::isnan(a.VolumeInDoubt) &&
        (std::isnan(b.VolumeInDoubt) || a.VolumeInDoubt > b.VolumeInDoubt);
    });
  return places;
}

std::string ListFlaggedPlaces(
  const std::vector<FlaggedPlace>& places, const std::vector<BodyIntegrals>& bodies, std::size_t maximum)
{
  std::string list;
  for (std::size_t i = 0; i < std::min(places.size(), maximum); ++i)
  {
    list += WrapText(
      "[" + std::to_string(i + 1) + "] " + Describe(places[i], bodies[places[i].Body]), LengthOfLines);
  }
  return list +
    (places.size() > maximum ? "and " + std::to_string(places.size() - maximum) + " more flagged places\n"
                             : "");
}

void DrawFlaggedPlaces(
  const std::vector<FlaggedPlace>& places, const std::vector<BodyIntegrals>& bodies, vtkPolyData* output)
{
  if (places.empty())
  {
    return;
  }
  CellColumns columns;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkCellArray> triangles;
  std::vector<std::string> texts;
  // In the cell data of a polydata, lines come before polygons.
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    const BodyIntegrals& body = bodies[places[i].Body];
    texts.push_back(Describe(places[i], body));
    for (const EdgeGap* edge : places[i].Edges)
    {
      const std::vector<vtkIdType> ids = InsertEdge(*edge->Source, body, points);
      lines->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
      columns.Append(i, places[i], body, texts[i], edge, nullptr);
    }
  }
  // The triangles of a face belong to the worst of its places.
  std::map<std::size_t, std::map<std::size_t, std::size_t>> placesOfBodies;
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    for (const std::size_t face : places[i].Faces)
    {
      placesOfBodies[places[i].Body].emplace(face, i);
    }
  }
  for (const auto& [index, placeOfFace] : placesOfBodies)
  {
    const BodyIntegrals& body = bodies[index];
    const std::vector<FacePointer>& sources = body.Model->GetFaces();
    // The display mesh is drawn where there is one, else the scale mesh.
    const auto& visitFaces = body.Mesh->GetNumberOfPolys() > 0 ? VisitShownTriangles : VisitTriangles;
    visitFaces(body.Mesh, sources.size(),
      [&, placeOfFace = std::cref(placeOfFace)](std::size_t face, const auto& corners, const auto&)
      {
        const auto found = placeOfFace.get().find(face);
        if (found != placeOfFace.get().end())
        {
          vtkIdType ids[3];
          for (int c = 0; c < 3; ++c)
          {
            ids[c] = points->InsertNextPoint(corners[c].data());
          }
          triangles->InsertNextCell(3, ids);
          const FlaggedPlace& place = places[found->second];
          columns.Append(found->second, place, body, texts[found->second], nullptr, sources[face].get());
        }
      });
  }
  output->SetPoints(points);
  output->SetLines(lines);
  output->SetPolys(triangles);
  columns.AddTo(output->GetCellData());
}
}
