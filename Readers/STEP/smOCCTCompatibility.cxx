#include "smOCCTCompatibility.h"

#include <BRep_Builder.hxx>
#include <Message_ProgressRange.hxx>
#include <ShapeBuild_ReShape.hxx>
#include <ShapeProcess_ShapeContext.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_DataMapIteratorOfDataMapOfShapeShape.hxx>
#include <TopoDS_Shell.hxx>

#if __has_include(<XSAlgo_ShapeProcessor.hxx>)
#include <Resource_Manager.hxx>
#include <ShapeProcess.hxx>
#else
#include <XSAlgo_AlgoContainer.hxx>
#endif

#include <type_traits>

namespace sm
{
namespace
{
using Context = Handle(ShapeProcess_ShapeContext);

#if __has_include(<XSAlgo_ShapeProcessor.hxx>)
/// Name of OpenCASCADE's resource file, and of the sequence of operators in it.
constexpr const char* RepairResource = "STEP";
constexpr const char* RepairSequence = "FromSTEP";

TopoDS_Shape Process(const TopoDS_Shape& shape, double precision, double maximum, Context& context)
{
  if (context.IsNull())
  {
    context = new ShapeProcess_ShapeContext(shape, RepairResource);
    context->SetDetalisation(TopAbs_EDGE);
  }
  context->ResourceManager()->SetResource("Runtime.Tolerance", precision);
  context->ResourceManager()->SetResource("Runtime.MaxTolerance", maximum);
  return ShapeProcess::Perform(context, RepairSequence) ? context->Result() : shape;
}
#else
/// Parameters of OpenCASCADE with the names of its resource file and of the sequence of operators in it.
constexpr const char* RepairResource = "read.step.resource.name";
constexpr const char* RepairSequence = "read.step.sequence";

/// From 7.8 on ProcessShape() has an additional parameter. The trailing parameters (`Last`) have their
/// defaults.
template <typename... Last>
TopoDS_Shape Call(TopoDS_Shape (XSAlgo_AlgoContainer::*method)(const TopoDS_Shape&, Standard_Real,
                    Standard_Real, Standard_CString, Standard_CString, Handle(Standard_Transient) &,
                    const Message_ProgressRange&, Standard_Boolean, Last...) const,
  const TopoDS_Shape& shape, double precision, double maximum, Handle(Standard_Transient) & info)
{
  const Handle(XSAlgo_AlgoContainer) algorithms = new XSAlgo_AlgoContainer();
  return ((*algorithms).*method)(shape, precision, maximum, RepairResource, RepairSequence, info,
    Message_ProgressRange(), false, std::decay_t<Last>()...);
}

TopoDS_Shape Process(const TopoDS_Shape& shape, double precision, double maximum, Context& context)
{
  Handle(Standard_Transient) info(context);
  const TopoDS_Shape result = Call(&XSAlgo_AlgoContainer::ProcessShape, shape, precision, maximum, info);
  context = Context::DownCast(info);
  return result;
}
#endif

/// Repairs faces one by one. `changes` gets what was replaced.
TopoDS_Shape RepairFaces(const TopoDS_Shape& whole, const std::vector<TopoDS_Shape>& faces, double precision,
  double maximum, std::vector<TopoDS_Shape>& repaired, Context& changes)
{
  const Handle(ShapeBuild_ReShape) substitution = new ShapeBuild_ReShape();
  for (const TopoDS_Shape& face : faces)
  {
    // By itself a face would be repaired with other settings than in a shell.
    TopoDS_Shell shell;
    BRep_Builder().MakeShell(shell);
    BRep_Builder().Add(shell, substitution->Apply(face));
    // A context made there would not record vertices.
    Context own = new ShapeProcess_ShapeContext(shell, RepairResource);
    own->SetDetalisation(TopAbs_VERTEX);
    Process(shell, precision, maximum, own);
    for (TopTools_DataMapIteratorOfDataMapOfShapeShape it(own->Map()); it.More(); it.Next())
    {
      if (it.Key().ShapeType() > TopAbs_SHELL && !it.Value().IsNull())
      {
        substitution->Replace(it.Key(), it.Value());
      }
    }
  }
  const TopoDS_Shape result = substitution->Apply(whole);
  for (const TopoDS_Shape& face : faces)
  {
    for (TopExp_Explorer it(substitution->Apply(face), TopAbs_FACE); it.More(); it.Next())
    {
      repaired.push_back(it.Current());
    }
  }
  changes = new ShapeProcess_ShapeContext(whole, RepairResource);
  changes->SetDetalisation(TopAbs_EDGE);
  changes->RecordModification(substitution);
  return result;
}
}

TopoDS_Shape RepairOnDemand(const TopoDS_Shape& shape, double precision, double maximum,
  const RepairFilter& isSound, ShapeChanges& changes)
{
  Context context;
  TopoDS_Shape result = shape;
  const bool isDone = isSound(result,
    [&](
      const TopoDS_Shape& whole, const std::vector<TopoDS_Shape>& faces, std::vector<TopoDS_Shape>& repaired)
    { return RepairFaces(whole, faces, precision, maximum, repaired, context); });
  if (!isDone)
  {
    context.Nullify();
    result = Process(shape, precision, maximum, context);
  }
  changes = [context](const std::function<void(const TopoDS_Shape&, const TopoDS_Shape&)>& visit)
  {
    if (context.IsNull())
    {
      return;
    }
    for (TopTools_DataMapIteratorOfDataMapOfShapeShape it(context->Map()); it.More(); it.Next())
    {
      visit(it.Key(), it.Value());
    }
  };
  return result;
}
}
