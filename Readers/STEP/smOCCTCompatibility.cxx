#include "smOCCTCompatibility.h"

#include <cstring>
#include <utility>

#if !__has_include(<XSAlgo_ShapeProcessor.hxx>)
#include <XSAlgo.hxx>
#include <XSAlgo_AlgoContainer.hxx>
#endif

namespace sm
{
#if __has_include(<StepVisual_TessellatedSolid.hxx>)
const bool KernelReadsTessellations = true;
#else
const bool KernelReadsTessellations = false;
#endif

#if __has_include(<XSAlgo_ShapeProcessor.hxx>)
TransferFilter::TransferFilter(std::function<bool(TopoDS_Shape&)>) {}

TransferFilter::~TransferFilter() = default;
#else
namespace
{
/// From 7.8 on ProcessShape() has an additional parameter. The trailing parameters (`Last`) are forwarded.
template <typename... Last>
class FilteringContainer : public XSAlgo_AlgoContainer
{
public:
  explicit FilteringContainer(std::function<bool(TopoDS_Shape&)> isSound)
    : IsSound(std::move(isSound))
  {
  }

  TopoDS_Shape ProcessShape(const TopoDS_Shape& original, Standard_Real precision, Standard_Real maximum,
    Standard_CString resource, Standard_CString sequence, Handle(Standard_Transient) & info,
    const Message_ProgressRange& progress, Standard_Boolean nonManifold, Last... last) const override
  {
    TopoDS_Shape shape = original;
    if (!nonManifold && std::strncmp(sequence, "read.", 5) == 0 && this->IsSound(shape))
    {
      return shape;
    }
    return this->XSAlgo_AlgoContainer::ProcessShape(
      original, precision, maximum, resource, sequence, info, progress, nonManifold, last...);
  }

private:
  std::function<bool(TopoDS_Shape&)> IsSound;
};

/// Makes a container whose ProcessShape() has the parameters of the given method.
template <typename... Last>
Handle(XSAlgo_AlgoContainer)
  MakeContainer(TopoDS_Shape (XSAlgo_AlgoContainer::*)(const TopoDS_Shape&, Standard_Real, Standard_Real,
                  Standard_CString, Standard_CString, Handle(Standard_Transient) &,
                  const Message_ProgressRange&, Standard_Boolean, Last...) const,
    std::function<bool(TopoDS_Shape&)> isSound)
{
  return new FilteringContainer<Last...>(std::move(isSound));
}
}

TransferFilter::TransferFilter(std::function<bool(TopoDS_Shape&)> isSound)
  : Previous(XSAlgo::AlgoContainer())
{
  XSAlgo::SetAlgoContainer(MakeContainer(&XSAlgo_AlgoContainer::ProcessShape, std::move(isSound)));
}

TransferFilter::~TransferFilter()
{
  XSAlgo::SetAlgoContainer(Handle(XSAlgo_AlgoContainer)::DownCast(this->Previous));
}
#endif
}
