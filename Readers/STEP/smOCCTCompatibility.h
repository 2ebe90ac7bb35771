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
/// True from OpenCASCADE 7.7 on, which reads the entities of tessellated shapes. Earlier versions do not know their types, and take time
/// quadratic in their number.
extern const bool KernelReadsTessellations;

/**
 * During the lifetime of this object `isSound` is called for each shape of a STEP transfer before OpenCASCADE repairs it. If it returns
 * true, the shape, which it may exchange, is not repaired. The hook is global: hold a KernelSession. From OpenCASCADE 7.9 on it is never
 * called and all shapes are repaired, because the repair is no virtual function any more.
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
