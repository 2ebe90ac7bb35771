#!/bin/sh
# OpenCASCADE 7.6.3 (Debian 12): the default STEP writer reports success for a valid prism on an offset curve (Geom_OffsetCurve, as sketches
# with offsets have it), and the file has the product but no solid, face or edge. The BREP file of the same prism is complete.
# Guess: what BRepCheck finds valid is in the file, or Transfer() or Write() does not return IFSelect_RetDone.
# Seen: a prism on a closed spline has its solid in the file, the prism on the offset curve of this spline has none; both calls report done.
# Needs: apt-get of Debian 12, g++, the C++ library. Installs nothing; fails if the behaviour or the version changes.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
version=7.6.3+dfsg1-7
for part in foundation modeling-data modeling-algorithms data-exchange ocaf visualization; do
  apt-get download -qq "libocct-$part-dev=$version" "libocct-$part-7.6=$version" 2>/dev/null
done
apt-get download -qq libtbb12=2021.8.0-2+deb12u1 libtbbmalloc2=2021.8.0-2+deb12u1 2>/dev/null
for package in *.deb; do
  dpkg -x "$package" root
done
cat >prism.cxx <<'END'
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepTools.hxx>
#include <GeomConvert.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_Ellipse.hxx>
#include <Geom_OffsetCurve.hxx>
#include <STEPControl_Writer.hxx>
#include <Standard_Version.hxx>
#include <gp.hxx>
#include <gp_Vec.hxx>

#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>

static bool Contains(const char* name, const char* word)
{
  std::ifstream file(name);
  return std::string(std::istreambuf_iterator<char>(file), {}).find(word) != std::string::npos;
}

int main()
{
  const Handle(Geom_Curve) spline =
    GeomConvert::CurveToBSplineCurve(new Geom_Ellipse(gp::XOY(), 5.0, 3.0), Convert_RationalC1);
  bool isRight[2];
  for (int i = 0; i < 2; ++i)
  {
    const Handle(Geom_Curve) curve = i == 0 ? spline : new Geom_OffsetCurve(spline, 0.5, -gp::DZ());
    const TopoDS_Wire wire = BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(curve).Edge()).Wire();
    const TopoDS_Shape prism = BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(wire, true).Face(), gp_Vec(0.0, 0.0, 2.0)).Shape();
    STEPControl_Writer writer;
    const bool isDone = writer.Transfer(prism, STEPControl_AsIs) == IFSelect_RetDone && writer.Write("prism.step") == IFSelect_RetDone;
    const bool isValid = BRepCheck_Analyzer(prism).IsValid() && BRepTools::Write(prism, "prism.brep") && Contains("prism.brep", "So\n");
    const bool hasSolid = Contains("prism.step", "MANIFOLD_SOLID_BREP");
    std::printf("OpenCASCADE %s, prism on a spline%s: valid %d, writer done %d, product in the file %d, solid %d, face %d\n",
      OCC_VERSION_COMPLETE, i == 0 ? "" : "'s offset curve", isValid, isDone, Contains("prism.step", "PRODUCT_DEFINITION_SHAPE"), hasSolid,
      Contains("prism.step", "ADVANCED_FACE"));
    isRight[i] = isValid && isDone && hasSolid == (i == 0);
  }
  return isRight[0] && isRight[1] ? 0 : 1;
}
END
libraries=root/usr/lib/x86_64-linux-gnu
g++ -std=c++17 -O1 -w -I root/usr/include/opencascade prism.cxx -o prism -L "$libraries" -lTKSTEP -lTKXSBase -lTKPrim -lTKTopAlgo -lTKBRep -lTKGeomBase \
  -lTKG3d -lTKMath -lTKernel -Wl,-rpath-link,"$libraries:/usr/lib/x86_64-linux-gnu"
LD_LIBRARY_PATH=$libraries ./prism | grep OpenCASCADE
LD_LIBRARY_PATH=$libraries ./prism >/dev/null
