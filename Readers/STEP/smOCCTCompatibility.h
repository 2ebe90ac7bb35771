/**
 * @file smOCCTCompatibility.h
 * @brief Differences between versions of OpenCASCADE (7.6 to 8.0), found by the headers that exist and by the compiler
 */
#ifndef smOCCTCompatibility_h
#define smOCCTCompatibility_h

#include <Standard_Transient.hxx>
#include <TopoDS_Shape.hxx>

#include <functional>

namespace sm
{
/// OpenCASCADE reads the entities of tessellated shapes, from 7.7 on. Before, each takes a time that grows with their number.
extern const bool KernelReadsTessellations;

/**
 * While this exists, each shape that a transfer from STEP has made is shown to `isSound` before OpenCASCADE repairs it. True keeps the
 * shape, which `isSound` may exchange, as it is. The switch is global: hold a KernelSession. From 7.9 on nothing is shown and all is
 * repaired, since the repair is no virtual function any more.
 */
class TransferFilter
{
public:
  explicit TransferFilter(std::function<bool(TopoDS_Shape&)> isSound);
  ~TransferFilter();
  TransferFilter(const TransferFilter&) = delete;
  void operator=(const TransferFilter&) = delete;

private:
  Handle(Standard_Transient) Previous;
};
}

#endif
