#include "smSTEPGeometryModels.h"

#include "smTesting.h"

#include "smEntityGeometry.h"
#include "smMemoryBuffer.h"
#include "smOCCTFile.h"
#include "smSTEPCensus.h"
#include "smSTEPGeometry.h"

#include <Geom2d_Curve.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_SweptSurface.hxx>
#include <STEPControl_Reader.hxx>
#include <Standard_Failure.hxx>
#include <StepData_StepModel.hxx>
#include <StepGeom_Curve.hxx>
#include <StepGeom_Surface.hxx>
#include <XSControl_WorkSession.hxx>
#include <gp_Vec2d.hxx>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <filesystem>
#include <istream>
#include <map>
#include <unordered_set>

namespace
{
/// Rounding of both evaluations, relative to the coordinates. Most types need 1e-15; splines with narrow
/// spans 2e-13.
constexpr double Rounding = 1e-12;
/// OpenCASCADE replaces the last control points of splines whose ends are this close.
constexpr double Closing = 1e-6;
/// Range of parameters in which curves without an end are compared, in their own lengths.
constexpr double Far = 10.0;

/// What became of the entities of a type.
struct TypeCounts
{
  long long Both = 0;
  long long OnlyOurs = 0;
  long long OnlyKernel = 0;
  long long Neither = 0;
  /// Largest ratio of a difference to its limit.
  double Worst = 0.0;
  std::string WorstPlace;

  void Add(double ratio, const std::string& place)
  {
    ++this->Both;
    if (!(ratio <= this->Worst))
    {
      this->Worst = ratio;
      this->WorstPlace = place;
    }
  }
};

struct Totals
{
  std::map<std::string, TypeCounts> Types;
  std::map<std::string, long long> Reasons;
  std::vector<std::string> Lost;
  /// Files that OpenCASCADE's parser does not read.
  std::vector<std::string> Unread;
  /// Seconds of the processor for our values of all entities.
  double Seconds = 0.0;
};

double Clip(double t, double other)
{
  return std::isfinite(t) && std::abs(t) < 1e50 ? t : other;
}

/// Parameter at a fraction of a range; ends that are infinite are replaced.
double GetAt(double low, double high, double fraction)
{
  const double a = Clip(low, std::isfinite(high) && std::abs(high) < 1e50 ? high - 2.0 * Far : -Far);
  const double b = Clip(high, a + 2.0 * Far);
  return a + fraction * (b - a);
}

/// The difference of a point and derivatives from OpenCASCADE's, as the ratio to what rounding allows.
template <int Dimension>
double GetRatio(const std::array<double, Dimension>& own, const std::array<double, Dimension>& other,
  double size, double slack)
{
  double square = 0.0;
  for (int c = 0; c < Dimension; ++c)
  {
    square += (own[c] - other[c]) * (own[c] - other[c]);
  }
  return std::sqrt(square) / (Rounding * size + slack);
}

template <int Dimension>
double GetSize(const std::array<double, Dimension>& v)
{
  double largest = 0.0;
  for (const double x : v)
  {
    largest = std::max(largest, std::abs(x));
  }
  return largest;
}

sm::Vector3 ToArray(const gp_XYZ& v)
{
  return { v.X(), v.Y(), v.Z() };
}

std::array<double, 2> ToArray(const gp_XY& v)
{
  return { v.X(), v.Y() };
}

void EvaluateKernel(const Handle(Geom_Curve) & curve, double t, sm::Vector3 d[2])
{
  gp_Pnt p;
  gp_Vec v;
  curve->D1(t, p, v);
  d[0] = ToArray(p.XYZ());
  d[1] = ToArray(v.XYZ());
}

void EvaluateKernel(const Handle(Geom2d_Curve) & curve, double t, std::array<double, 2> d[2])
{
  gp_Pnt2d p;
  gp_Vec2d v;
  curve->D1(t, p, v);
  d[0] = ToArray(p.XY());
  d[1] = ToArray(v.XY());
}

/// Compares over the whole ranges, in the direction of the entity, so that the parameters of trimmed curves
/// do not matter.
template <int Dimension, class Curve>
double CompareCurves(const sm::STEPCurve<Dimension>& own, const Handle(Curve) & curve)
{
  double worst = 0.0;
  const double slack = curve->IsPeriodic() && own.Value->GetPeriod() == 0.0 ? Closing : 0.0;
  const bool isForward = own.Parameter.Scale > 0.0;
  for (const double fraction : { 0.0, 0.11, 0.37, 0.5, 0.73, 1.0 })
  {
    const double t = GetAt(own.Range.Low, own.Range.High, isForward ? fraction : 1.0 - fraction);
    typename sm::GeometricCurve<Dimension>::Derivatives d;
    own.Value->Evaluate(t, 1, d);
    std::array<double, Dimension> expected[2];
    EvaluateKernel(curve, GetAt(curve->FirstParameter(), curve->LastParameter(), fraction), expected);
    const double width = std::min(20.0, own.Range.High - own.Range.Low);
    const double size = std::max(GetSize<Dimension>(d[0]), width * GetSize<Dimension>(d[1]));
    worst = std::max(worst, GetRatio<Dimension>(d[0], expected[0], size, slack));
    if (!isForward)
    {
      for (double& x : d[1])
      {
        x = -x;
      }
    }
    // A knot at an end of a fraction may belong to either span: such a derivative is not compared.
    const double step = 1e-9 * width;
    const bool isSmooth = own.Value->GetBreaks(t - step, t + step).size() == 2;
    worst = std::max(
      worst, isSmooth ? GetRatio<Dimension>(d[1], expected[1], size / width, 10.0 * slack / width) : 0.0);
  }
  return worst;
}

double CompareSurfaces(const sm::STEPSurface& own, const Handle(Geom_Surface) & surface)
{
  double low[2];
  double high[2];
  surface->Bounds(low[0], high[0], low[1], high[1]);
  const bool isPeriodic[2] = { static_cast<bool>(surface->IsUPeriodic()),
    static_cast<bool>(surface->IsVPeriodic()) };
  double slack = 0.0;
  for (int d = 0; d < 2; ++d)
  {
    slack = isPeriodic[d] && own.Value->GetPeriod(d) == 0.0 ? Closing : slack;
  }
  double worst = 0.0;
  for (const double x : { 0.0, 0.21, 0.5, 0.83, 1.0 })
  {
    for (const double y : { 0.0, 0.13, 0.5, 0.77, 1.0 })
    {
      const double fractions[2] = { x, y };
      double at[2];
      double width[2];
      bool isSmooth = true;
      for (int d = 0; d < 2; ++d)
      {
        const bool isForward = own.Parameters[d].Scale > 0.0;
        at[d] = GetAt(own.Range[d].Low, own.Range[d].High, isForward ? fractions[d] : 1.0 - fractions[d]);
        width[d] = std::min(20.0, own.Range[d].High - own.Range[d].Low);
        isSmooth =
          isSmooth && own.Value->GetBreaks(d, at[d] - 1e-9 * width[d], at[d] + 1e-9 * width[d]).size() == 2;
      }
      sm::GeometricSurface::Derivatives d;
      own.Value->Evaluate(at[0], at[1], 1, d);
      gp_Pnt p;
      gp_Vec du;
      gp_Vec dv;
      // OpenCASCADE takes the absolute value of a negative major radius: the same points at (u + pi, pi - v).
      const auto* elementary = own.Value->GetIf<sm::ElementarySurface>();
      const bool isNegative =
        elementary && elementary->Kind == sm::ElementarySurface::Type::Torus && elementary->Radii[0] < 0.0;
      const double pi = std::acos(-1.0);
      surface->D1(isNegative ? at[0] + pi : GetAt(low[0], high[0], x),
        isNegative ? pi - at[1] : GetAt(low[1], high[1], y), p, du, dv);
      const double size =
        std::max({ GetSize<3>(d[0][0]), width[0] * GetSize<3>(d[1][0]), width[1] * GetSize<3>(d[0][1]) });
      worst = std::max(worst, GetRatio<3>(d[0][0], ToArray(p.XYZ()), size, slack));
      const double signs[2] = { own.Parameters[0].Scale > 0.0 ? 1.0 : -1.0,
        (own.Parameters[1].Scale > 0.0) != isNegative ? 1.0 : -1.0 };
      const sm::Vector3 slopes[2] = { ToArray((signs[0] * du).XYZ()), ToArray((signs[1] * dv).XYZ()) };
      for (int k = 0; isSmooth && k < 2; ++k)
      {
        worst = std::max(worst,
          GetRatio<3>(k == 0 ? d[1][0] : d[0][1], slopes[k], size / width[k], 10.0 * slack / width[k]));
      }
    }
  }
  return worst;
}

/// Returns the number of coordinates of the first point on which a curve depends. Curves on surfaces are in
/// space.
int FindDimension(const sm::STEPAttributes& entities, sm::Part21File::Index entity)
{
  for (const char* const name : { "SURFACE_CURVE", "SEAM_CURVE", "INTERSECTION_CURVE", "PCURVE" })
  {
    std::string_view record;
    if (entities.FindRecord(entity, name, record))
    {
      return 3;
    }
  }
  std::vector<sm::Part21File::Index> open{ entity };
  std::unordered_set<sm::Part21File::Index> seen;
  while (!open.empty())
  {
    const sm::Part21File::Index i = open.back();
    open.pop_back();
    std::string_view record;
    if (entities.FindRecord(i, "CARTESIAN_POINT", record))
    {
      int count = 0;
      sm::Part21Values values(sm::GetPart21Value(record, 1).Text);
      for (sm::Part21Value value; values.Next(value);)
      {
        ++count;
      }
      return count;
    }
    for (const sm::Part21File::Index other : entities.File.GetReferences(i))
    {
      if (other != sm::Part21File::None && seen.insert(other).second)
      {
        open.push_back(other);
      }
    }
  }
  return 0;
}

/// Returns the text with the reference directions that placements omit: OpenCASCADE takes others than ISO
/// 10303-42 does.
std::string MakePlacementsExplicit(const sm::Part21File& file, const sm::STEPAttributes& entities)
{
  std::uint64_t next = 0;
  for (sm::Part21File::Index i = 0; i < file.GetNumberOfInstances(); ++i)
  {
    next = std::max(next, file.GetId(i) + 1);
  }
  const std::string_view text = file.GetText();
  std::string result;
  std::size_t done = 0;
  for (sm::Part21File::Index i = 0; i < file.GetNumberOfInstances(); ++i)
  {
    std::string_view record;
    sm::STEPFrame frame;
    if (!entities.FindRecord(i, sm::ReferenceOfPlacement.Record, record) ||
      entities.Get(i, sm::ReferenceOfPlacement).Kind != sm::Part21Kind::Omitted ||
      !sm::ReadSTEPFrame(entities, i, frame))
    {
      continue;
    }
    const std::string name = "#" + std::to_string(next++);
    result += text.substr(done, file.GetOffset(i) - done);
    result += name + "=DIRECTION('',(";
    for (int c = 0; c < 3; ++c)
    {
      result += (c > 0 ? "," : "") + sm::FormatPart21Real(frame.Axes[0][c]);
    }
    result += "));\n";
    done = entities.Get(i, sm::ReferenceOfPlacement).Text.data() - text.data();
    result += text.substr(file.GetOffset(i), done - file.GetOffset(i));
    result += name;
    ++done;
  }
  return result + std::string(text.substr(done));
}

template <class Make>
auto TryKernel(const Make& make) -> decltype(make())
{
  try
  {
    return make();
  }
  catch (const Standard_Failure&)
  {
    return {};
  }
}

class FileComparison
{
public:
  FileComparison(const std::string& path, Totals& totals)
    : Name(std::filesystem::path(path).filename().string())
    , Result(totals)
  {
    this->File.Read(path);
    this->Entities = std::make_unique<sm::STEPAttributes>(this->File);
    for (const sm::CensusContext& context : sm::TakeSTEPCensus(this->File).Contexts)
    {
      this->Units.Angle =
        context.Used && std::isfinite(context.Angle.Factor) ? context.Angle.Factor : this->Units.Angle;
    }
    this->Geometry = std::make_unique<sm::STEPGeometry>(*this->Entities, this->Units, this->Ledger);
    const std::clock_t start = std::clock();
    this->ConvertAll();
    this->Result.Seconds += static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    this->Compare();
    for (const sm::LedgerRow& row : this->Ledger.Rows)
    {
      ++this->Result.Reasons[row.Type + ": " + row.Reason];
    }
  }

private:
  void ConvertAll()
  {
    for (sm::Part21File::Index i = 0; i < this->File.GetNumberOfInstances(); ++i)
    {
      if (this->Entities->Has(i, sm::STEPRole::Surface))
      {
        this->Geometry->GetSurface(i);
      }
      else if (this->Entities->Has(i, sm::STEPRole::Curve) && FindDimension(*this->Entities, i) != 2)
      {
        this->Geometry->GetCurve(i);
      }
    }
  }

  void Compare()
  {
    const std::string text = MakePlacementsExplicit(this->File, *this->Entities);
    sm::Part21File completed;
    completed.Parse(text);
    STEPControl_Reader reader;
    sm::MemoryBuffer buffer(text);
    std::istream stream(&buffer);
    const bool isRead = reader.ReadStream("", stream) == IFSelect_RetDone;
    const Handle(StepData_StepModel) model = Handle(StepData_StepModel)::DownCast(reader.WS()->Model());
    if (!isRead || model.IsNull())
    {
      this->Result.Unread.push_back(this->Name);
      return;
    }
    // The lengths stay in the unit of the file.
    const sm::EntityGeometry kernel(this->Units.Angle);
    std::map<std::uint64_t, Handle(Standard_Transient)> byId;
    for (int i = 1; i <= model->NbEntities(); ++i)
    {
      byId[model->IdentLabel(model->Value(i))] = model->Value(i);
    }
    for (sm::Part21File::Index i = 0; i < this->File.GetNumberOfInstances(); ++i)
    {
      const auto found = byId.find(this->File.GetId(i));
      const Handle(Standard_Transient) entity = found == byId.end() ? nullptr : found->second;
      if (this->Entities->Has(i, sm::STEPRole::Surface))
      {
        const auto source = Handle(StepGeom_Surface)::DownCast(entity);
        const Handle(Geom_Surface) surface =
          source.IsNull() ? nullptr : TryKernel([&] { return kernel.MakeSurface(source); });
        this->Count(i, this->Geometry->GetSurface(i), surface,
          [](const auto& own, const auto& other) { return CompareSurfaces(own, other); });
      }
      else if (this->Entities->Has(i, sm::STEPRole::Curve))
      {
        const auto source = Handle(StepGeom_Curve)::DownCast(entity);
        if (FindDimension(*this->Entities, i) == 2)
        {
          const Handle(Geom2d_Curve) curve =
            source.IsNull() ? nullptr : TryKernel([&] { return kernel.MakePlaneCurve(source); });
          this->Count(i, this->Geometry->GetPlaneCurve(i), curve,
            [](const auto& own, const auto& other) { return CompareCurves<2>(own, other); });
        }
        else
        {
          const Handle(Geom_Curve) curve =
            source.IsNull() ? nullptr : TryKernel([&] { return kernel.MakeCurve(source); });
          this->Count(i, this->Geometry->GetCurve(i), curve,
            [](const auto& own, const auto& other) { return CompareCurves<3>(own, other); });
        }
      }
    }
  }

  template <class Own, class Other, class CompareBoth>
  void Count(sm::Part21File::Index i, const Own* own, const Other& other, const CompareBoth& compare)
  {
    std::string type;
    for (std::size_t k = 0; k < this->File.GetNumberOfRecords(i); ++k)
    {
      type += (k > 0 ? " " : "") + this->File.GetTypeNames()[this->File.GetType(i, k)];
    }
    type += std::is_same_v<Own, sm::STEPCurve<2>> ? ", in the plane" : "";
    TypeCounts& counts = this->Result.Types[type];
    const std::string place = this->Name + " #" + std::to_string(this->File.GetId(i));
    if (own && !other.IsNull())
    {
      double ratio = 1e300;
      TryKernel(
        [&]
        {
          ratio = compare(*own, other);
          return true;
        });
      counts.Add(ratio, place);
    }
    else if (!own && !other.IsNull())
    {
      ++counts.OnlyKernel;
      this->Result.Lost.push_back(place + " " + type);
    }
    else
    {
      ++(own ? counts.OnlyOurs : counts.Neither);
    }
  }

  std::string Name;
  Totals& Result;
  sm::Part21File File;
  std::unique_ptr<sm::STEPAttributes> Entities;
  sm::STEPUnitSizes Units;
  sm::STEPLedger Ledger;
  std::unique_ptr<sm::STEPGeometry> Geometry;
};
}

void CompareGeometryWithKernel(const std::vector<std::string>& paths)
{
  sm::SetUpKernel();
  std::vector<std::string> files;
  for (const std::string& path : paths)
  {
    if (!std::filesystem::is_directory(path))
    {
      files.push_back(path);
      continue;
    }
    for (const auto& entry : std::filesystem::directory_iterator(path))
    {
      if (entry.path().extension() == ".step")
      {
        files.push_back(entry.path().string());
      }
    }
  }
  std::sort(files.begin(), files.end());
  Totals totals;
  for (const std::string& file : files)
  {
    FileComparison comparison(file, totals);
  }
  std::printf("%.2f s of the processor for all surfaces and curves in space\n", totals.Seconds);
  std::printf("%10s %10s %10s %10s  type\n", "both", "only ours", "only OCCT", "neither");
  long long compared = 0;
  for (const auto& [type, counts] : totals.Types)
  {
    std::printf("%10lld %10lld %10lld %10lld  %s\n", counts.Both, counts.OnlyOurs, counts.OnlyKernel,
      counts.Neither, type.c_str());
    compared += counts.Both;
    if (counts.Both > 0)
    {
      smtest::CheckRange(type, 0.0, counts.Worst, 1.0, counts.WorstPlace.c_str());
    }
  }
  for (const auto& [reason, count] : totals.Reasons)
  {
    std::printf("%10lld in the ledger: %s\n", count, reason.c_str());
  }
  for (std::size_t k = 0; k < std::min<std::size_t>(20, totals.Lost.size()); ++k)
  {
    std::printf("only OpenCASCADE converts %s\n", totals.Lost[k].c_str());
  }
  smtest::CheckEqual(
    "entities that only OpenCASCADE converts", 0, static_cast<long long>(totals.Lost.size()));
  smtest::CheckRange("files that OpenCASCADE does not parse", 0.0, static_cast<double>(totals.Unread.size()),
    0.02 * static_cast<double>(files.size()), totals.Unread.empty() ? "" : totals.Unread[0].c_str());
  smtest::CheckRange("entities compared", 1.0, static_cast<double>(compared), 1e9);
}
