/**
 * @file smKernel.h
 * @brief What the reader asks of OpenCASCADE: to repair bodies, and to read BREP files
 */
#ifndef smKernel_h
#define smKernel_h

#include "smDocument.h"
#include "smReadersSTEPModule.h"

#include <string>
#include <string_view>
#include <vector>

namespace sm
{
struct RepairLimits
{
  /// Accuracy of coordinates that the file states, in millimetres.
  double Precision = DefaultTolerance;
  /// Largest tolerance that edges and vertices may get, in millimetres.
  double Maximum = 1.0;
};

/// OpenCASCADE. One thread of the process uses it at a time; others wait. The functions throw only
/// std::bad_alloc.
class SMREADERSSTEP_EXPORT Kernel
{
public:
  virtual ~Kernel();

  /// Repairs a solid or shell. `data` is that of the solid. Faces, edges and shells of the result have the
  /// data of those that they come from, and faces their Source. Returns why it failed; empty: it did not.
  virtual std::string RepairBody(
    const BodyShape& body, const ShapeData& data, const RepairLimits& limits, ShapeGroup& result) const = 0;
  /// Repairs some faces of a body as the repair of the whole body would. `repaired` gets what became of them.
  /// Returns the body as it is if that fails.
  virtual BodyShape RepairFaces(const BodyShape& body, const std::vector<const FaceShape*>& faces,
    const RepairLimits& limits, std::vector<const FaceShape*>& repaired) const = 0;
  /// Reads the bytes of a BREP file. `progress` gets a fraction in [0,1] and returns false to stop.
  virtual Document ReadBREP(std::string_view bytes, const ProgressCallback& progress) const = 0;
};

/// Returns the kernel, which is loaded when it is needed first; null if it cannot be loaded.
SMREADERSSTEP_EXPORT const Kernel* GetKernel();
}

#endif
