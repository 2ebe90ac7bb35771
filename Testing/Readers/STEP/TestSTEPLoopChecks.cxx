// TestSTEPLoopChecks: edges that run against their loop or their curve, curves off the vertices of their
// edges, and vertices off their surfaces, are reported where the faces are made; sound ones are not.
#include "smCensusSamples.h"
#include "smTesting.h"

#include "vtkNew.h"
#include "vtkSTEPReader.h"

#include <string>
#include <vector>

namespace
{
using namespace smtest;

struct Case
{
  const char* Name;
  std::string Text;
  /// A part of the only message about vertices and directions; empty if there must be none.
  std::string Said;
};

std::vector<Case> GetCases()
{
  // Half a disc.
  const std::string half =
    "#71=FACE_BOUND('',#74,.T.);\n#72=ADVANCED_FACE('',(#71),#73,.T.);\n#73=PLANE('',#23);\n"
    "#74=EDGE_LOOP('',(#75,#76));\n#75=ORIENTED_EDGE('',*,*,#79,.T.);\n#76=ORIENTED_EDGE('',*,*,#81,.T.);\n"
    "#77=VERTEX_POINT('',#83);\n#78=VERTEX_POINT('',#84);\n#79=EDGE_CURVE('',#77,#78,#80,.T.);\n"
    "#80=CIRCLE('',#23,5.);\n#81=EDGE_CURVE('',#78,#77,#82,.T.);\n#82=LINE('',#83,#85);\n"
    "#83=CARTESIAN_POINT('',(5.,0.,0.));\n#84=CARTESIAN_POINT('',(-5.,0.,0.));\n#85=VECTOR('',#86,1.);\n"
    "#86=DIRECTION('',(1.,0.,0.));\n";
  return {
    { "a vertex off its sphere", ChangeBall("(0.,0.,5.)", "(0.,0.,5.05)"),
      "Entity #27 of the file: a vertex is off the surface of its face (vertex, #24)." },
    { "a vertex near its sphere", ChangeBall("(0.,0.,5.)", "(0.,5.01,0.)"), "" },
    { "a vertex on a torus", ChangeBall("SPHERICAL_SURFACE('',#23,5.)", "TOROIDAL_SURFACE('',#23,3.,2.)"),
      "Entity #27 of the file: a vertex is off the surface of its face (vertex, #24)." },
    { "a vertex on its torus",
      MakeStepText(
        Replace(Replace(GetBallText(), "SPHERICAL_SURFACE('',#23,5.)", "TOROIDAL_SURFACE('',#23,3.,2.)"),
          "(0.,0.,5.)", "(0.,3.,-2.)")),
      "" },
    { "a vertex on the inner part of a torus",
      MakeStepText(Replace(Replace(GetBallText(), "SPHERICAL_SURFACE('',#23,5.)",
                             "DEGENERATE_TOROIDAL_SURFACE('',#23,3.,5.,.F.)"),
        "(0.,0.,5.)", "(0.,0.,4.)")),
      "" },
    { "a loop of an arc and a line", ExtendBall("(#29))", "(#29,#72))", half), "" },
    { "an arc that runs against the line",
      ExtendBall("(#29))", "(#29,#72))", Replace(half, "#77,#78,#80", "#78,#77,#80")),
      "Entity #74 of the file: a curved edge runs against its neighbours (edges, #79)." },
    { "lines in any direction",
      ExtendBall("(#29))", "(#29,#72))",
        Replace(
          Replace(half, "#77,#78,#80", "#78,#77,#80"), "#80=CIRCLE('',#23,5.)", "#80=LINE('',#83,#85)")),

      "with the same points, in 1 entity, first #74." },
    { "a line against its edge",
      ExtendBall("(#29))", "(#29,#72))", Replace(half, "(1.,0.,0.)", "(-2.,0.,0.)")),
      "with the same points, in 1 entity, first #81." },
    { "a line that leads elsewhere",
      ExtendBall("(#29))", "(#29,#72))", Replace(half, "(1.,0.,0.)", "(1.,0.1,0.)")),
      "Entity #81 of the file: a curve does not pass through the vertices of its edge (curve, #82)." },
    { "a line off its vertices, on a surface",
      ExtendBall("(#29))", "(#29,#72))",
        Replace(half, "#82=LINE('',#83,#85);",
          "#82=SURFACE_CURVE('',#87,(#73),.CURVE_3D.);\n#87=LINE('',#88,#85);"
          "\n#88=CARTESIAN_POINT('',(0.,0.,0.3));")),

      "Entity #81 of the file: a curve does not pass through the vertices of its edge (curve, #87)." },
    { "a circle off its vertices",
      ExtendBall("(#29))", "(#29,#72))", Replace(half, "#80=CIRCLE('',#23,5.)", "#80=CIRCLE('',#23,5.3)")),

      "Entity #79 of the file: a curve does not pass through the vertices of its edge (curve, #80)." },
    { "an open spline",
      ExtendBall("(#29))", "(#29,#72))",
        Replace(half, "#80=CIRCLE('',#23,5.)",
          "#87=CARTESIAN_POINT('',(0.,5.,0.));\n#80=B_SPLINE_CURVE_WITH_KNOTS('',2,(#83,#87,#84),"
          ".UNSPECIFIED.,.F.,.F.,(3,3),(0.,1.),.UNSPECIFIED.)")),
      "" },
    { "an open spline against its edge",
      ExtendBall("(#29))", "(#29,#72))",
        Replace(half, "#80=CIRCLE('',#23,5.)",
          "#87=CARTESIAN_POINT('',(0.,5.,0.));\n#80=B_SPLINE_CURVE_WITH_KNOTS('',2,(#84,#87,#83),"
          ".UNSPECIFIED.,.F.,.F.,(3,3),(0.,1.),.UNSPECIFIED.)")),

      "with the same points, in 1 entity, first #79." },
    { "an ellipse through its vertices",
      ExtendBall("(#29))", "(#29,#72))", Replace(half, "#80=CIRCLE('',#23,5.)", "#80=ELLIPSE('',#23,5.,2.)")),
      "" },
    { "an ellipse off its vertices",
      ExtendBall("(#29))", "(#29,#72))", Replace(half, "#80=CIRCLE('',#23,5.)", "#80=ELLIPSE('',#23,2.,5.)")),

      "Entity #79 of the file: a curve does not pass through the vertices of its edge (curve, #80)." },
  };
}

/// Returns the messages about vertices and directions.
std::string FindMessages(const std::string& text)
{
  vtkNew<vtkSTEPReader> reader;
  reader->SetRepair(vtkSTEPReader::NEVER);
  reader->SetContent(text);
  reader->Update();
  std::string found;
  for (int i = 0; i < reader->GetNumberOfMessages(); ++i)
  {
    const std::string message = reader->GetMessage(i);
    for (const char* words : { "a vertex is off", "runs against", "run against", "does not pass through" })
    {
      found += message.find(words) == std::string::npos ? std::string() : message + "\n";
    }
  }
  return found;
}
}

int TestSTEPLoopChecks(int, char*[])
{
  for (const Case& each : GetCases())
  {
    const std::string found = FindMessages(each.Text);
    const bool isSaid = each.Said.empty()
      ? found.empty()
      : found.find(each.Said) != std::string::npos && found.find('\n') + 1 == found.size();
    CheckTrue(each.Name, isSaid, "\"" + found + "\", expected \"" + each.Said + "\"");
  }
  return Finish();
}
