/**
 * @file smSelfCrossing.h
 * @brief Bodies whose boundary crosses itself, found by winding numbers
 */
#ifndef smSelfCrossing_h
#define smSelfCrossing_h

#include "smBodyIntegrals.h"
#include "smFiltersMassPropertiesModule.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

namespace sm
{
/// Result of FindSelfCrossing().
struct SelfCrossing
{
  /// A winding number other than 0 and 1; 0: none was found.
  int Winding = 0;
  /// Entity number of the face next to the point, and the point in coordinates of the part.
  std::int64_t Face = 0;
  std::array<double, 3> Point{};
  /// Number of points that were tested, and of the undecided ones among them.
  std::size_t Samples = 0;
  std::size_t Undecided = 0;
  /// Reason why nothing was checked; empty otherwise.
  std::string Unchecked;
  /// It if `shouldContinue` returned false.
  static constexpr const char* Stopped = "the run was stopped, or its time was over";
};

/**
 * Computes the winding number of the boundary of a solid, of one or several bodies in one placement, on both
 * sides of points on its display mesh. It is 0 or 1 about every point unless the boundary crosses itself.
 * There is a point in the middle of the largest triangle of every face, and others evenly over the area, one
 * for every eight triangles and at least 400. The triangles of each face are oriented as its exact vector
 * area and volume are, with the reversals of ReverseShells().
 *
 * Another winding number counts only if it is found again at a point off the mesh that is farther from every
 * triangle than the triangle may be from its surface (smWindingTree.h), plus the widest gap of the body:
 * about such a point mesh and surface have the same winding number. Crossings that are narrower than that, or
 * lie between the points, are not found.
 *
 * Whole spheres (smWholeSphere.h) are not meshed. That a point lies in one of them is decided by its distance
 * from the centre, pairs that cross are found by their radii, and one that meets nothing has the same winding
 * number all over. Spheres that touch do not cross.
 *
 * The bodies are closed, and have the integrals of GetMassIntegrands(). Unchecked has a reason if the mesh
 * lacks a face, or the area or vector area of a face on it differs from the exact one by more than a quarter
 * of the area. Runs on the threads of vtkSMPTools, with the same result for any number of them.
 * `shouldContinue` is called now and then by the calling thread; once it returns false, Unchecked reports it.
 */
SMFILTERSMASSPROPERTIES_EXPORT SelfCrossing FindSelfCrossing(
  const std::vector<const BodyIntegrals*>& parts, const std::function<bool()>& shouldContinue = {});

/// Results of FindSelfCrossing() that are kept from run to run.
class SMFILTERSMASSPROPERTIES_EXPORT SelfCrossingCheck
{
public:
  /**
   * Flags bodies that cross themselves as suspect, and adds a note to those that could not be checked. A body
   * that is already flagged, is open or has no volume is passed over. Bodies that were read from one solid of
   * a file are checked together. A body with the same faces as one of an earlier run has the same result. One
   * that shares some of them is an edit of it: where that one was sound, it is only checked with
   * `checkEdits`. Once `shouldContinue` returns false, the bodies that follow are not checked.
   */
  void Run(
    std::vector<BodyIntegrals>& bodies, bool checkEdits, const std::function<bool()>& shouldContinue = {});
  void Clear() { this->Known.clear(); }

private:
  struct Entry
  {
    std::vector<std::uint64_t> Faces;
    SelfCrossing Result;
  };
  using EntryPointer = std::shared_ptr<const Entry>;
  /// Returns the known result for a body with these faces, or with some of them where edits are not checked;
  /// null if the body must be checked.
  EntryPointer Find(const std::vector<std::uint64_t>& faces, bool checkEdits,
    const std::unordered_map<std::uint64_t, EntryPointer>& current) const;

  /// Entries of the last run by their faces.
  std::unordered_map<std::uint64_t, EntryPointer> Known;
};
}

#endif
