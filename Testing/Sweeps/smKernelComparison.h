/**
 * @file smKernelComparison.h
 * @brief The faces, trim curves and edges that the reader makes of a file, point by point against
 * OpenCASCADE's own evaluation
 */
#ifndef smKernelComparison_h
#define smKernelComparison_h

#include "smDocument.h"

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace smtest
{
/// Largest distances that are allowed, relative to the size of the body plus its distance from the part's
/// origin, where OpenCASCADE rounds.
constexpr double SurfaceLimit = 2e-13;
/// A trim curve is fitted to 1e-13 of an arc; OpenCASCADE's own evaluation adds rounding.
constexpr double TrimLimit = 2e-12;
constexpr double EdgeLimit = 1e-13;

/// The faces of one type of surface.
struct FaceTally
{
  int Faces = 0;
  double Surface = 0.0;
  double Trim = 0.0;
};

struct KernelComparison
{
  /// Instances.
  int Solids = 0;
  int Shells = 0;
  /// Faces and open edges of all instances; free faces are counted, too.
  int Faces = 0;
  int OpenEdges = 0;
  /// Faces and defects of bodies, each body counted once.
  int MissingFaces = 0;
  int Defects = 0;
  std::size_t TrimPieces = 0;
  std::size_t EdgePieces = 0;
  /// Largest distances from OpenCASCADE's evaluation, relative as SurfaceLimit.
  double Surface = 0.0;
  double Trim = 0.0;
  double Edge = 0.0;
  /// Largest residual of the fitted trim curves.
  double TrimResidual = 0.0;
  /// Largest distance between a coedge on its face and its edge, at equal parameters, mm.
  double MaxGap = 0.0;
  /// Points that are farther from OpenCASCADE's than is allowed, or NaN.
  int AboveLimits = 0;
  /// By name of OpenCASCADE's class of surface.
  std::map<std::string, FaceTally> Tallies;
  /// Excesses over limits, and messages of the conversion.
  std::vector<std::string> Messages;
};

/// Converts every body of the document and compares.
KernelComparison CompareWithKernel(const sm::Document& document);
}

#endif
