// The kernel that the reader loads when it needs one (smKernel.h).

#include "smKernel.h"
#include "smOCCTFailure.h"
#include "smOCCTFile.h"
#include "smOCCTFixShape.h"
#include "smOCCTImport.h"
#include "smOCCTMakeShape.h"
#include "smOCCTReadBREP.h"
#include "smReadersKernelModule.h"

#include <unordered_set>

namespace sm
{
namespace
{
class OpenCASCADE : public Kernel
{
public:
  std::string RepairBody(const BodyShape& body, const ShapeData& data, const RepairLimits& limits,
    ShapeGroup& result) const override
  {
    std::string failure = CatchKernelFailure(
      [&]
      {
        const KernelSession session;
        MadeShapes made;
        std::unordered_map<const FaceShape*, TopoDS_Shape> faces;
        const TopoDS_Shape shape = MakeKernelShape(body, made, faces);
        ShapeImport import(&made);
        const TopoDS_Shape repaired = FixShape(shape, limits.Precision, limits.Maximum,
          [&import](const TopoDS_Shape& from, const TopoDS_Shape& to) { import.AddReplacement(from, to); });
        result = import.MakeGroup(repaired);
      });
    if (!failure.empty() || result.IsEmpty())
    {
      return failure.empty() ? "it left nothing" : failure;
    }
    for (const SolidUse& solid : result.Solids)
    {
      solid.Solid->Data = data;
    }
    for (const ShellUse& shell : result.Shells)
    {
      shell.Shell->OpenSolid = body.IsSolid && result.Solids.empty();
      if (shell.Shell->Data.FileId == 0 || shell.Shell->OpenSolid)
      {
        shell.Shell->Data = body.IsSolid ? data : body.Shells.front().Shell->Data;
      }
    }
    return {};
  }

  BodyShape RepairFaces(const BodyShape& body, const std::vector<const FaceShape*>& faces,
    const RepairLimits& limits, std::vector<const FaceShape*>& repaired) const override
  {
    BodyShape result = body;
    const std::unordered_set<const FaceShape*> chosen(faces.begin(), faces.end());
    const std::string failure = CatchKernelFailure(
      [&]
      {
        const KernelSession session;
        MadeShapes made;
        std::unordered_map<const FaceShape*, TopoDS_Shape> known;
        const TopoDS_Shape shape = MakeKernelShape(body, made, known);
        std::vector<TopoDS_Shape> damaged;
        body.VisitFaces(
          [&](const FaceUse& use)
          {
            if (chosen.count(use.Face.get()) > 0)
            {
              damaged.push_back(
                known.at(use.Face.get()).Oriented(use.Reversed ? TopAbs_REVERSED : TopAbs_FORWARD));
            }
          });
        ShapeImport import(&made);
        std::vector<TopoDS_Shape> fixed;
        const TopoDS_Shape whole = FixFaces(
          shape, damaged, limits.Precision, limits.Maximum,
          [&import](const TopoDS_Shape& from, const TopoDS_Shape& to) { import.AddReplacement(from, to); },
          fixed);
        import.KeepFacesExcept(fixed);
        const ShapeGroup group = import.MakeGroup(whole);
        if (group.Solids.size() == (body.IsSolid ? 1u : 0u) &&
          group.Shells.size() == (body.IsSolid ? 0u : 1u))
        {
          result = body.IsSolid ? MakeBody(group.Solids.front()) : MakeBody(group.Shells.front());
          for (const TopoDS_Shape& face : fixed)
          {
            repaired.push_back(import.Find(face.Oriented(TopAbs_FORWARD)).get());
          }
        }
      });
    return failure.empty() ? result : body;
  }

  Document ReadBREP(std::string_view bytes, const ProgressCallback& progress) const override
  {
    return ReadKernelBREP(bytes, progress);
  }
};
}
}

extern "C" SMREADERSKERNEL_EXPORT const sm::Kernel* SolidMomentsGetKernel()
{
  static const sm::OpenCASCADE kernel;
  return &kernel;
}
