// TestSTEPGeometry: curves and surfaces of a file as values, by the definitions of ISO 10303-42: parameters,
// units, trims, replicas, and the ledger. TestSTEPGeometry models FOLDER compares every curve and surface of
// real files with OpenCASCADE's.
#include "smSTEPGeometry.h"
#include "smTesting.h"

#include "smSTEPGeometryModels.h"

#include <cmath>
#include <cstring>
#include <memory>

namespace
{
using namespace smtest;
using sm::Vector3;

constexpr double Quarter = 1.5707963267948966;
/// Rounding of coordinates of about 100.
constexpr double Limit = 1e-12;

/// A file with the entities of a test behind common ones: points #1 (0,0,0), #2 (1,2,3); directions #3 x, #4
/// y, #5 z; #6 a frame at #2 with its axis along x and its reference direction along y; in the plane point #7
/// (3,4), direction #8 (0,1) and frame #9.
class Sample
{
public:
  explicit Sample(const std::string& entities, const sm::STEPUnitSizes& units = {})
  {
    this->File.Parse(
      "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\nFILE_NAME('','',(''),(''),'','','');\n"
      "FILE_SCHEMA(('AUTOMOTIVE_DESIGN'));\nENDSEC;\nDATA;\n"
      "#1=CARTESIAN_POINT('',(0.,0.,0.));\n#2=CARTESIAN_POINT('',(1.,2.,3.));\n"
      "#3=DIRECTION('',(1.,0.,0.));\n#4=DIRECTION('',(0.,1.,0.));\n#5=DIRECTION('',(0.,0.,1.));\n"
      "#6=AXIS2_PLACEMENT_3D('',#2,#3,#4);\n"
      "#7=CARTESIAN_POINT('',(3.,4.));\n#8=DIRECTION('',(0.,1.));\n#9=AXIS2_PLACEMENT_2D('',#7,#8);\n" +
      entities + "ENDSEC;\nEND-ISO-10303-21;\n");
    this->Entities = std::make_unique<sm::STEPAttributes>(this->File);
    this->Geometry = std::make_unique<sm::STEPGeometry>(*this->Entities, units, this->Ledger);
  }

  const sm::STEPCurve<3>* GetCurve(std::uint64_t id) { return this->Geometry->GetCurve(this->File.Find(id)); }
  const sm::STEPCurve<2>* GetPlaneCurve(std::uint64_t id)
  {
    return this->Geometry->GetPlaneCurve(this->File.Find(id));
  }
  const sm::STEPSurface* GetSurface(std::uint64_t id)
  {
    return this->Geometry->GetSurface(this->File.Find(id));
  }

  sm::Part21File File;
  std::unique_ptr<sm::STEPAttributes> Entities;
  sm::STEPLedger Ledger;
  std::unique_ptr<sm::STEPGeometry> Geometry;
};

double GetGap(const Vector3& a, const Vector3& b)
{
  return sm::Norm(sm::Subtract(a, b));
}

/// Checks the point of a curve at a parameter of the file.
void CheckPoint(const std::string& what, const sm::STEPCurve<3>* curve, double u, const Vector3& expected)
{
  Check(what, 0.0, curve ? GetGap(curve->Value->Evaluate(curve->Parameter(u)), expected) : std::nan(""),
    Limit, "rounding");
}

void CheckPoint(
  const std::string& what, const sm::STEPSurface* surface, double u, double v, const Vector3& expected)
{
  Check(what, 0.0,
    surface ? GetGap(surface->Value->Evaluate(surface->Parameters[0](u), surface->Parameters[1](v)), expected)
            : std::nan(""),
    Limit, "rounding");
}

/// Parameters of curves in a file in inches and degrees. The frame #6 has X = y, Y = z, Z = x.
void TestCurves()
{
  const double inch = 25.4;
  Sample s(
    "#10=VECTOR('',#4,3.);\n#11=LINE('',#2,#10);\n#12=CIRCLE('',#6,2.);\n#13=ELLIPSE('',#6,2.,3.);\n"
    "#14=PARABOLA('',#6,0.5);\n#15=HYPERBOLA('',#6,2.,3.);\n"
    "#16=CARTESIAN_POINT('',(4.,4.,0.));\n#17=POLYLINE('',(#1,#2,#16));\n"
    "#18=OFFSET_CURVE_3D('',#11,0.5,.F.,#5);\n"
    "#19=TRIMMED_CURVE('',#12,(PARAMETER_VALUE(350.)),(PARAMETER_VALUE(80.)),.T.,.PARAMETER.);\n"
    "#20=TRIMMED_CURVE('',#12,(PARAMETER_VALUE(80.)),(PARAMETER_VALUE(350.)),.F.,.PARAMETER.);\n"
    "#21=CARTESIAN_POINT('',(1.,11.,3.));\n"
    "#22=TRIMMED_CURVE('',#11,(#2,PARAMETER_VALUE(7.)),(#21),.T.,.CARTESIAN.);\n"
    "#23=COMPOSITE_CURVE_SEGMENT(.CONTINUOUS.,.F.,#19);\n#24=COMPOSITE_CURVE_SEGMENT(.CONTINUOUS.,.T.,#22);\n"
    "#25=COMPOSITE_CURVE('',(#23,#24),.F.);\n"
    "#26=CARTESIAN_TRANSFORMATION_OPERATOR_3D('','',#4,#31,#2,2.,$);\n#31=DIRECTION('',(-1.,0.,0.));\n#27="
    "CURVE_REPLICA('',#14,#26);\n"
    "#28=SURFACE_CURVE('',#12,(),.CURVE_3D.);\n"
    "#29=TRIMMED_CURVE('',#20,(PARAMETER_VALUE(10.)),(PARAMETER_VALUE(30.)),.T.,.PARAMETER.);\n"
    "#30=OFFSET_CURVE_3D('',#20,0.5,.F.,#3);\n",
    { inch, Quarter / 90.0 });
  const auto scaled = [inch](double x, double y, double z) {
    return Vector3{ inch * x, inch * y, inch * z };
  };
  CheckPoint("LINE: P + u V", s.GetCurve(11), 2.0, scaled(1.0, 8.0, 3.0));
  CheckPoint("CIRCLE", s.GetCurve(12), 90.0, scaled(1.0, 2.0, 5.0));
  CheckPoint("ELLIPSE with the longer axis second", s.GetCurve(13), 90.0, scaled(1.0, 2.0, 6.0));
  CheckPoint("PARABOLA: C + F (u^2 x + 2 u y)", s.GetCurve(14), 3.0, scaled(1.0, 2.0 + 4.5, 3.0 + 3.0));
  CheckPoint(
    "HYPERBOLA", s.GetCurve(15), 0.7, scaled(1.0, 2.0 + 2.0 * std::cosh(0.7), 3.0 + 3.0 * std::sinh(0.7)));
  CheckPoint("POLYLINE", s.GetCurve(17), 1.5, scaled(2.5, 3.0, 1.5));
  CheckPoint("OFFSET_CURVE_3D: along V x T", s.GetCurve(18), 2.0, scaled(0.5, 8.0, 3.0));
  const double ten = Quarter / 9.0;
  CheckPoint("TRIMMED_CURVE over the start of its circle", s.GetCurve(19), 20.0,
    scaled(1.0, 2.0 + 2.0 * std::cos(ten), 3.0 + 2.0 * std::sin(ten)));
  CheckPoint("TRIMMED_CURVE against its basis", s.GetCurve(20), 20.0,
    scaled(1.0, 2.0 + 2.0 * std::cos(6.0 * ten), 3.0 + 2.0 * std::sin(6.0 * ten)));
  Check("its length in degrees", 90.0,
    s.GetCurve(20) ? (s.GetCurve(20)->Range.High - s.GetCurve(20)->Range.Low) * 90.0 / Quarter : 0.0, Limit);
  CheckPoint("a trimmed trim counts from its start", s.GetCurve(29), 0.0,
    scaled(1.0, 2.0 + 2.0 * std::cos(7.0 * ten), 3.0 + 2.0 * std::sin(7.0 * ten)));
  CheckPoint("an offset of a curve against its basis", s.GetCurve(30), 80.0, scaled(1.0, 2.0 + 2.5, 3.0));
  CheckPoint("TRIMMED_CURVE by points", s.GetCurve(22), 0.5, scaled(1.0, 3.5, 3.0));
  CheckPoint("COMPOSITE_CURVE: the first segment, reversed", s.GetCurve(25), 80.0, scaled(1.0, 4.0, 3.0));
  CheckPoint("COMPOSITE_CURVE: the second one", s.GetCurve(25), 91.0, scaled(1.0, 5.0, 3.0));
  // The operator has X = y, Y = -x, and Z = z by default.
  const Vector3 p{ 1.0, 6.5, 6.0 };
  CheckPoint("CURVE_REPLICA of a parabola", s.GetCurve(27), 3.0,
    scaled(1.0 - 2.0 * p[1], 2.0 + 2.0 * p[0], 3.0 + 2.0 * p[2]));
  CheckPoint("SURFACE_CURVE is its curve in space", s.GetCurve(28), 90.0, scaled(1.0, 2.0, 5.0));
  for (const sm::LedgerRow& row : s.Ledger.Rows)
  {
    std::printf("#%llu: %s\n", static_cast<unsigned long long>(row.Id), row.Reason.c_str());
  }
  CheckEqual("all curves are converted", 0, static_cast<long long>(s.Ledger.Rows.size()));
}

/// A cubic of four control points is the same in all forms of splines without own knots, except for its
/// parameter.
void TestSplines()
{
  const std::string common = "#16=CARTESIAN_POINT('',(4.,4.,0.));\n#17=CARTESIAN_POINT('',(6.,0.,1.));\n";
  const std::string list = "3,(#1,#2,#16,#17),.UNSPECIFIED.,.F.,.F.";
  Sample s(common + "#20=BEZIER_CURVE(''," + list + ");\n#21=QUASI_UNIFORM_CURVE(''," + list +
    ");\n#22=UNIFORM_CURVE(''," + list + ");\n#23=B_SPLINE_CURVE_WITH_KNOTS(''," + list +
    ",(4,4),(2.,6.),.UNSPECIFIED.);\n"
    "#24=(BOUNDED_CURVE()B_SPLINE_CURVE(" +
    list +
    ")BEZIER_CURVE()CURVE()GEOMETRIC_REPRESENTATION_ITEM()RATIONAL_B_SPLINE_CURVE((1.,2.,2.,1.))"
    "REPRESENTATION_ITEM(''));\n"
    "#25=BEZIER_CURVE('',1,(#1,#2,#16,#17),.UNSPECIFIED.,.F.,.F.);\n"
    "#26=B_SPLINE_SURFACE_WITH_KNOTS('',1,2,((#1,#2,#16),(#17,#2,#1)),.UNSPECIFIED.,.F.,.F.,.F.,(2,2),(3,3),("
    "0.,2."
    "),(1.,5.),.UNSPECIFIED.);\n"
    "#27=(BOUNDED_SURFACE()B_SPLINE_SURFACE(1,1,((#1,#2),(#16,#17)),.UNSPECIFIED.,.F.,.F.,.F.)BEZIER_SURFACE("
    ")"
    "GEOMETRIC_REPRESENTATION_ITEM()RATIONAL_B_SPLINE_SURFACE(((1.,1.),(3.,1.)))REPRESENTATION_ITEM('')"
    "SURFACE());\n");
  // At the middle of a Bézier curve: (P0 + 3 P1 + 3 P2 + P3) / 8.
  const Vector3 middle{ 21.0 / 8.0, 18.0 / 8.0, 10.0 / 8.0 };
  CheckPoint("BEZIER_CURVE", s.GetCurve(20), 0.5, middle);
  CheckPoint("QUASI_UNIFORM_CURVE", s.GetCurve(21), 0.5, middle);
  CheckPoint("B_SPLINE_CURVE_WITH_KNOTS", s.GetCurve(23), 4.0, middle);
  // A uniform cubic begins at (P0 + 4 P1 + P2) / 6.
  CheckPoint("UNIFORM_CURVE", s.GetCurve(22), 0.0, { 8.0 / 6.0, 12.0 / 6.0, 12.0 / 6.0 });
  Check("its domain is one span", 1.0, s.GetCurve(22) ? s.GetCurve(22)->Range.High : 0.0, 0.0);
  CheckPoint("rational Bezier", s.GetCurve(24), 0.5, { 36.0 / 14.0, 36.0 / 14.0, 19.0 / 14.0 });
  CheckPoint("piecewise Bezier of degree 1", s.GetCurve(25), 1.5, { 2.5, 3.0, 1.5 });
  CheckPoint("B_SPLINE_SURFACE_WITH_KNOTS", s.GetSurface(26), 0.0, 3.0, { 1.5, 2.0, 1.5 });
  CheckPoint("its other border", s.GetSurface(26), 2.0, 1.0, { 6.0, 0.0, 1.0 });
  CheckPoint("rational BEZIER_SURFACE", s.GetSurface(27), 0.5, 0.0, { 3.0, 3.0, 0.0 });
  CheckEqual("all are converted", 0, static_cast<long long>(s.Ledger.Rows.size()));
}

void TestSurfaces()
{
  const double inch = 25.4;
  Sample s("#10=PLANE('',#6);\n#11=CYLINDRICAL_SURFACE('',#6,2.);\n#12=CONICAL_SURFACE('',#6,2.,45.);\n"
           "#13=SPHERICAL_SURFACE('',#6,2.);\n#14=TOROIDAL_SURFACE('',#6,3.,1.);\n"
           "#15=DEGENERATE_TOROIDAL_SURFACE('',#6,1.,2.,.F.);\n"
           "#16=VECTOR('',#3,3.);\n#17=PARABOLA('',#6,0.5);\n#18=SURFACE_OF_LINEAR_EXTRUSION('',#17,#16);\n"
           "#19=AXIS1_PLACEMENT('',#1,$);\n#20=LINE('',#2,#16);\n#21=SURFACE_OF_REVOLUTION('',#20,#19);\n"
           "#22=RECTANGULAR_TRIMMED_SURFACE('',#11,350.,80.,2.,5.,.T.,.T.);\n"
           "#23=RECTANGULAR_TRIMMED_SURFACE('',#11,80.,350.,2.,5.,.F.,.T.);\n"
           "#24=OFFSET_SURFACE('',#11,0.5,.F.);\n#25=OFFSET_SURFACE('',#23,0.5,.F.);\n"
           "#26=CARTESIAN_TRANSFORMATION_OPERATOR_3D('','',#4,#31,#2,2.,$);\n#31=DIRECTION('',(-1.,0.,0.));"
           "\n#27=SURFACE_REPLICA('',#12,#26);\n"
           "#28=CURVE_BOUNDED_SURFACE('',#11,(),.T.);\n"
           "#29=AXIS2_PLACEMENT_3D('',#2,#3,$);\n#30=PLANE('',#29);\n#32=AXIS2_PLACEMENT_3D('',#2,$,$);\n"
           "#33=PLANE('',#32);\n",
    { inch, Quarter / 90.0 });
  const auto scaled = [inch](double x, double y, double z) {
    return Vector3{ inch * x, inch * y, inch * z };
  };
  CheckPoint("PLANE", s.GetSurface(10), 2.0, 5.0, scaled(1.0, 4.0, 8.0));
  CheckPoint("without a reference direction, along x", s.GetSurface(30), 2.0, 5.0, scaled(1.0, 4.0, 8.0));
  CheckPoint("without an axis", s.GetSurface(33), 2.0, 5.0, scaled(3.0, 7.0, 3.0));
  CheckPoint("CYLINDRICAL_SURFACE", s.GetSurface(11), 90.0, 4.0, scaled(5.0, 2.0, 5.0));
  CheckPoint("CONICAL_SURFACE: v is the height", s.GetSurface(12), 90.0, 4.0, scaled(5.0, 2.0, 9.0));
  CheckPoint("SPHERICAL_SURFACE", s.GetSurface(13), 90.0, 90.0, scaled(3.0, 2.0, 3.0));
  CheckPoint("TOROIDAL_SURFACE", s.GetSurface(14), 0.0, 90.0, scaled(2.0, 5.0, 3.0));
  CheckPoint("DEGENERATE_TOROIDAL_SURFACE", s.GetSurface(15), 0.0, 180.0, scaled(1.0, 1.0, 3.0));
  Check(
    "its inner part", 4.0 * Quarter / 3.0, s.GetSurface(15) ? s.GetSurface(15)->Range[1].Low : 0.0, Limit);
  CheckPoint("SURFACE_OF_LINEAR_EXTRUSION", s.GetSurface(18), 3.0, 2.0, scaled(7.0, 6.5, 6.0));
  CheckPoint(
    "SURFACE_OF_REVOLUTION, about z by default", s.GetSurface(21), 90.0, 1.0, scaled(-2.0, 4.0, 3.0));
  CheckPoint("RECTANGULAR_TRIMMED_SURFACE counts from its borders", s.GetSurface(22), 10.0, 1.0,
    scaled(4.0, 4.0, 3.0));
  CheckPoint("and in its sense", s.GetSurface(23), 80.0, 1.0, scaled(4.0, 4.0, 3.0));
  CheckTrue("which turns the normal",
    s.GetSurface(23) && s.GetSurface(23)->IsReversed() && s.GetSurface(22) &&
      !s.GetSurface(22)->IsReversed());
  CheckPoint("OFFSET_SURFACE", s.GetSurface(24), 0.0, 4.0, scaled(5.0, 4.5, 3.0));
  CheckPoint("of a reversed surface", s.GetSurface(25), 80.0, 2.0, scaled(5.0, 3.5, 3.0));
  const Vector3 p{ 5.0, 2.0, 9.0 };
  CheckPoint("SURFACE_REPLICA of a cone", s.GetSurface(27), 90.0, 4.0,
    scaled(1.0 - 2.0 * p[1], 2.0 + 2.0 * p[0], 3.0 + 2.0 * p[2]));
  CheckPoint("CURVE_BOUNDED_SURFACE is its basis", s.GetSurface(28), 90.0, 4.0, scaled(5.0, 2.0, 5.0));
  CheckEqual("all surfaces are converted", 0, static_cast<long long>(s.Ledger.Rows.size()));
}

/// A PCURVE of a cylinder has degrees and inches; the circle there keeps its parameter.
void TestParameterCurves()
{
  const double inch = 25.4;
  Sample s("#10=CYLINDRICAL_SURFACE('',#6,2.);\n#11=CIRCLE('',#9,2.);\n#12=PCURVE('',#10,#13);\n"
           "#13=DEFINITIONAL_REPRESENTATION('',(#11),#14);\n"
           "#14=(GEOMETRIC_REPRESENTATION_CONTEXT(2)PARAMETRIC_REPRESENTATION_CONTEXT()REPRESENTATION_"
           "CONTEXT('',''));\n"
           "#15=VECTOR('',#8,2.);\n#16=LINE('',#7,#15);\n#17=OFFSET_CURVE_2D('',#16,1.,.F.);\n",
    { inch, Quarter / 90.0 });
  // The frame #9 has X = (0,1): at 90 degrees the circle is at (3,4) + 2 (-1,0), u = 1 degree and v = 4
  // inches.
  const double one = Quarter / 90.0;
  CheckPoint("PCURVE in space", s.GetCurve(12), 90.0,
    { inch * 5.0, inch * (2.0 + 2.0 * std::cos(one)), inch * (3.0 + 2.0 * std::sin(one)) });
  const sm::STEPCurve<2>* offset = s.GetPlaneCurve(17);
  const auto p = offset ? offset->Value->Evaluate(offset->Parameter(1.0)) : std::array<double, 2>{};
  Check("OFFSET_CURVE_2D is to the left", 0.0, std::hypot(p[0] - 2.0, p[1] - 6.0), Limit);
  std::string problem;
  const sm::STEPSurface* cylinder = s.GetSurface(10);
  const sm::STEPCurve<2>* line = s.GetPlaneCurve(16);
  if (cylinder && line && offset)
  {
    const sm::STEPCurve<2> natural = s.Geometry->MapToNatural(*line, *cylinder, problem);
    const auto q = natural.Value->Evaluate(natural.Parameter(1.0));
    Check("a line in natural parameters", 0.0, std::hypot(q[0] - 3.0 * one, q[1] - 6.0 * inch), Limit);
    CheckTrue("an offset has no image in them",
      !s.Geometry->MapToNatural(*offset, *cylinder, problem).Value && !problem.empty(), problem);
  }
  CheckEqual("all are converted", 0, static_cast<long long>(s.Ledger.Rows.size()));
}

void CheckRow(Sample& s, std::size_t row, std::uint64_t id, const std::string& reason)
{
  const bool exists = row < s.Ledger.Rows.size();
  CheckEqual("entity in the ledger", static_cast<long long>(id),
    exists ? static_cast<long long>(s.Ledger.Rows[row].Id) : 0);
  CheckTrue("its reason", exists && s.Ledger.Rows[row].Reason.find(reason) != std::string::npos,
    exists ? s.Ledger.Rows[row].Reason : "");
  CheckTrue("its consequence", exists && !s.Ledger.Rows[row].Consequence.empty());
}

void TestLedger()
{
  Sample s("#10=CYLINDRICAL_SURFACE('',#6,0.);\n#11=OFFSET_SURFACE('',#10,1.,.F.);\n"
           "#12=CLOTHOID('',#6,1.);\n#13=OFFSET_CURVE_3D('',#13,0.5,.F.,#5);\n"
           "#14=B_SPLINE_CURVE_WITH_KNOTS('',3,(#1,#2),.UNSPECIFIED.,.F.,.F.,(4,4),(2.,6.),.UNSPECIFIED.);\n"
           "#15=AXIS2_PLACEMENT_3D('',#2,#3,#3);\n#16=PLANE('',#15);\n#17=CIRCLE('',#9,1.);\n"
           "#18=RECTANGULAR_COMPOSITE_SURFACE('',((#10)));\n#19=LINE('',#2,$);\n"
           "#20=VECTOR('',#3,1.);\n#21=LINE('',#2,#20);\n"
           "#22=TRIMMED_CURVE('',#21,(PARAMETER_VALUE(3.)),(PARAMETER_VALUE(1.)),.T.,.PARAMETER.);\n");
  CheckTrue("an offset of a cylinder of radius 0", !s.GetSurface(11));
  CheckRow(s, 0, 10, "radii");
  CheckRow(s, 1, 11, "missing or left out");
  CheckTrue("is asked for twice", !s.GetSurface(11) && !s.GetSurface(10) && s.Ledger.Rows.size() == 2);
  CheckTrue("a clothoid", !s.GetCurve(12));
  CheckRow(s, 2, 12, "not a curve of a kind that can be read");
  CheckTrue("an offset of itself", !s.GetCurve(13));
  CheckRow(s, 3, 13, "missing or left out");
  CheckTrue("control points are missing", !s.GetCurve(14));
  CheckRow(s, 4, 14, "do not fit together");
  CheckTrue("parallel axes: the default", s.GetSurface(16) != nullptr);
  CheckTrue("a circle in the plane is none in space", !s.GetCurve(17));
  CheckRow(s, 5, 17, "AXIS2_PLACEMENT_3D");
  CheckTrue("but one in the plane", s.GetPlaneCurve(17) != nullptr);
  CheckTrue("several patches", !s.GetSurface(18));
  CheckRow(s, 6, 18, "several patches");
  CheckTrue("a line without a vector", !s.GetCurve(19));
  CheckRow(s, 7, 19, "direction");
  CheckTrue("a trim that ends before it begins", !s.GetCurve(22));
  CheckRow(s, 8, 22, "ends before it begins");
  CheckTrue("nothing at all", !s.GetCurve(99));
}
}

int TestSTEPGeometry(int argc, char* argv[])
{
  if (argc > 2 && !std::strcmp(argv[1], "models"))
  {
    CompareGeometryWithKernel({ argv + 2, argv + argc });
    return Finish();
  }
  TestCurves();
  TestSplines();
  TestSurfaces();
  TestParameterCurves();
  TestLedger();
  return Finish();
}
