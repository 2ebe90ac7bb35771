/**
 * @file smKernel.h
 * @brief What OpenCASCADE does for the readers, in a process of its own: repairs of bodies, and BREP files
 *
 * The program solidmoments-kernel, which alone links OpenCASCADE, is started when it is needed first, and
 * serves later requests, too. If it ends, does not answer in time or is not there, the request fails with the
 * reason, and the next one starts it again. A request may take 60 seconds, and 20 more for each megabyte that
 * it sends. All functions may be called by several threads, also while `watch` or `progress` is running;
 * each then has a process. They throw only std::bad_alloc and what their callbacks throw, which ends
 * the process of the request.
 */
#ifndef smKernel_h
#define smKernel_h

#include "smProgressCallback.h"
#include "smReadersKernelModule.h"
#include "smShapeBytes.h"

#include <functional>
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

/// Called about ten times a second while a repair is running; returns false to stop it.
using RepairWatch = std::function<bool()>;

/// Repairs a solid or shell. `data` is that of the solid. Faces, edges and shells of the result have the data
/// of those that they come from, and faces their Source. Returns a sentence why there is no repair; empty if
/// there is one.
SMREADERSKERNEL_EXPORT std::string RepairBody(const BodyShape& body, const ShapeData& data,
  const RepairLimits& limits, const RepairWatch& watch, ShapeGroup& result);

/// Repairs some faces of a body as the repair of the whole body would. `repaired` gets what became of them.
/// Returns the body as it is if that fails.
SMREADERSKERNEL_EXPORT BodyShape RepairFaces(const BodyShape& body,
  const std::vector<const FaceShape*>& faces, const RepairLimits& limits, const RepairWatch& watch,
  std::vector<const FaceShape*>& repaired);

/// The shapes of a BREP file.
struct BREPContent
{
  /// The reason why there are none: a clause without the file's name; empty if there are.
  std::string Problem;
  bool IsStopped = false;
  /// True if the reason may not be in the file: the program is missing, was ended from outside, or did not
  /// answer.
  bool HasFailed = false;
  /// What the file has and Root lacks; a sentence each.
  std::vector<std::string> Defects;
  /// All shapes of the file.
  ShapeGroup Shapes;
  /// A node without a name, whose children are the roots of the file.
  ShapeNode Root;
};

/// Reads the bytes of a BREP file. `progress` gets a fraction in [0,1] and returns false to stop.
SMREADERSKERNEL_EXPORT BREPContent ReadBREPShapes(std::string_view bytes, const ProgressCallback& progress);
}

#endif
