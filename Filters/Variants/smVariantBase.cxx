#include "Detail/smVariantBase.h"

#include "smIntegralEngine.h"
#include "smMassAnalysis.h"
#include "smMassIntegrands.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <numeric>

namespace sm
{
namespace
{
/// Enough for the sign of a shell's volume.
constexpr double ShellTolerance = 1e-6;
// Control points coincide within this part of the net's size, and move alike within this part of the largest
// displacement: some hundred roundings of coordinates.
constexpr double SameControlPoint = 1e-12;

BodyIntegrals MakeBody(vtkTrimmedNURBSModel& model)
{
  BodyIntegrals body;
  body.Model = &model;
  body.Placement = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 };
  return body;
}

/// Returns the index of each face's shell; shells that share an edge are one.
std::vector<std::size_t> GetShellOfFace(vtkTrimmedNURBSModel& model)
{
  const std::vector<std::vector<int>>& shells = model.GetShells();
  std::vector<std::size_t> shellOfFace(model.GetFaces().size(), shells.size());
  for (std::size_t s = 0; s < shells.size(); ++s)
  {
    for (const int face : shells[s])
    {
      shellOfFace[face] = s;
    }
  }
  std::map<const Edge*, std::size_t> shellOfEdge;
  for (std::size_t f = 0; f < shellOfFace.size(); ++f)
  {
    for (const Loop& loop : model.GetFaces()[f]->Loops)
    {
      for (const Coedge& coedge : loop.Coedges)
      {
        const std::size_t own = shellOfFace[f];
        const std::size_t other = shellOfEdge.emplace(coedge.Use.get(), own).first->second;
        if (other != own)
        {
          std::replace(shellOfFace.begin(), shellOfFace.end(), own, other);
          for (auto& [edge, shell] : shellOfEdge)
          {
            shell = shell == own ? other : shell;
          }
        }
      }
    }
  }
  return shellOfFace;
}

/// Returns why the volumes of several shells are not those of a solid and its voids.
std::string FindShellProblem(vtkTrimmedNURBSModel& model)
{
  std::vector<BodyIntegrals> bodies{ MakeBody(model) };
  IntegralEngine engine;
  engine.SetController(nullptr);
  const Tolerance tolerance{ ShellTolerance, 0.0 };
  IntegralRequest request = MakeMassRequest({ tolerance, tolerance, tolerance, tolerance });
  request.MeasureSpread = false;
  IntegralLimits limits;
  limits.Backend = BackendChoice::CPU;
  limits.CacheFaceResults = false;
  if (!engine.Integrate(request, limits, bodies))
  {
    return "the volumes of its shells could not be computed: " + engine.GetReport().Reason;
  }
  const std::vector<std::size_t> shellOfFace = GetShellOfFace(model);
  std::map<std::size_t, std::array<double, 2>> shells;
  for (std::size_t f = 0; f < shellOfFace.size(); ++f)
  {
    const FaceIntegrals& face = (*bodies[0].Faces)[f];
    if (!face.Error.empty())
    {
      return "face " + std::to_string(f) + " cannot be integrated (" + face.Error + "): edit it";
    }
    std::array<double, 2>& shell = shells[shellOfFace[f]];
    shell[0] += face.Face[MassVolume] + face.Closing[MassVolume];
    shell[1] += face.GetBound(MassVolume);
  }
  std::array<double, 2> outer{};
  for (const auto& [index, shell] : shells)
  {
    if (!(std::abs(shell[0]) > shell[1]))
    {
      return "the volume of shell " + std::to_string(index) +
        " is zero within its bound, so that its side is unknown: remove the shell";
    }
    outer = std::abs(shell[0]) > std::abs(outer[0]) ? shell : outer;
  }
  for (const auto& [index, shell] : shells)
  {
    if (shell[0] != outer[0] && (shell[0] > 0.0) == (outer[0] > 0.0))
    {
      return "shell " + std::to_string(index) +
        " encloses volume on the same side as the largest one, as a void that is inside out or a second "
        "outer shell does: its variants would be wrong; correct the file, or give each shell as a model";
    }
  }
  const bool areTwo = std::count_if(shells.begin(), shells.end(),
                        [&](const auto& shell) { return shell.second[0] == outer[0]; }) > 1;
  return areTwo ? "two of its shells enclose equal volumes on one side: give each shell as a model" : "";
}
}

std::string FindBaseProblem(vtkTrimmedNURBSModel& model)
{
  BodyIntegrals body = MakeBody(model);
  CheckTopology(body);
  if (body.OpenEdges > 0 || body.Status > Status::Ok)
  {
    const std::string reason = !body.Reason.empty()
      ? body.Reason
      : "it is not closed (" + std::to_string(body.OpenEdges) + " open edges)";
    return "the base model has no volume that is known: " + reason +
      ". Its moments would depend on where the origin is: close it first";
  }
  const std::string problem = model.GetShells().size() < 2 ? std::string() : FindShellProblem(model);
  return problem.empty() ? problem : "the base model has several shells: " + problem;
}

bool OpensFace(const NURBSSurface& surface, const std::vector<std::array<double, 3>>& displacements)
{
  double size = 0.0;
  double largest = 0.0;
  const auto getDistance = [&](std::size_t a, std::size_t b, bool isMove)
  {
    double distance = 0.0;
    for (int c = 0; c < 3; ++c)
    {
      const double x = isMove ? displacements[a][c] : surface.ControlPoints[a][c];
      const double y = isMove ? displacements[b][c] : surface.ControlPoints[b][c];
      distance =
        std::max(distance, std::abs(x / surface.ControlPoints[a][3] - y / surface.ControlPoints[b][3]));
    }
    return distance;
  };
  const auto getMove = [&](std::size_t a)
  {
    const std::array<double, 3>& move = displacements[a];
    return std::max({ std::abs(move[0]), std::abs(move[1]), std::abs(move[2]) }) /
      surface.ControlPoints[a][3];
  };
  for (std::size_t i = 0; i < displacements.size(); ++i)
  {
    size = std::max(size, getDistance(0, i, false));
    largest = std::max(largest, getMove(i));
  }
  const auto coincide = [&](std::size_t a, std::size_t b)
  { return getDistance(a, b, false) <= SameControlPoint * size; };
  const auto moveAlike = [&](std::size_t a, std::size_t b)
  { return getDistance(a, b, true) <= SameControlPoint * largest; };
  for (int direction = 0; direction < 2; ++direction)
  {
    // Rows across the direction: the first and the last ones are borders. Where knots are not clamped as many
    // rows as the degree form a border, and those of both ends are compared in their order.
    const std::vector<double>& knots = surface.Knots[direction];
    const int degree = surface.Degree[direction];
    const int length = surface.NumberOfControlPoints[direction];
    const int width = surface.NumberOfControlPoints[1 - direction];
    const bool isClamped =
      knots[1] == knots[degree] && knots[knots.size() - 2] == knots[knots.size() - 1 - degree];
    const int rows = std::min(isClamped ? 1 : degree, length);
    const auto at = [&](int row, int k)
    {
      const int i = direction == 0 ? row : k;
      const int j = direction == 0 ? k : row;
      return i + static_cast<std::size_t>(j) * surface.NumberOfControlPoints[0];
    };
    bool isClosed = true;
    bool closesAlike = true;
    bool isPole[2] = { rows == 1, rows == 1 };
    bool movesAlike[2] = { true, true };
    bool moves = false;
    for (int row = 0; row < rows; ++row)
    {
      for (int k = 0; k < width; ++k)
      {
        const int ends[2] = { row, length - rows + row };
        isClosed = isClosed && coincide(at(ends[0], k), at(ends[1], k));
        closesAlike = closesAlike && moveAlike(at(ends[0], k), at(ends[1], k));
        for (int end = 0; end < 2; ++end)
        {
          isPole[end] = isPole[end] && coincide(at(ends[end], 0), at(ends[end], k));
          movesAlike[end] = movesAlike[end] && moveAlike(at(ends[end], 0), at(ends[end], k));
        }
      }
    }
    for (int end = 0; end < 2; ++end)
    {
      moves = false;
      for (int row = 0; row < rows; ++row)
      {
        for (int k = 0; k < width; ++k)
        {
          moves = moves || getMove(at(end == 0 ? row : length - rows + row, k)) > 0.0;
        }
      }
      if (moves && (isClosed ? !closesAlike : isPole[end] ? !movesAlike[end] : true))
      {
        return true;
      }
    }
  }
  return false;
}
}
