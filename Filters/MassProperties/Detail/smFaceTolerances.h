/**
 * @file smFaceTolerances.h
 * @brief Tolerances of faces, and what they leave open in mass properties
 */
#ifndef smFaceTolerances_h
#define smFaceTolerances_h

#include "smDrawingTolerances.h"
#include "smFiltersMassPropertiesModule.h"
#include "smMassTable.h"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace sm
{
class BodyOffsets;
struct BodyIntegrals;
struct Face;

/// Gives offsets along outward normals, from Lower to Upper, to faces. Patterns are those of
/// MatchesPattern().
struct FaceToleranceRule
{
  enum class Kind
  {
    /// "#123", the number of the face in the file, or a pattern of its name.
    Face,
    /// A pattern of the name of the solid.
    Part,
    /// "#rrggbb", the colour of the face.
    Color
  };

  Kind By = Kind::Part;
  std::string Pattern;
  double Lower = 0.0;
  double Upper = 0.0;
};

/// Returns the kind of that name, "face", "part" or "colour" ("color"); false if there is none.
SMFILTERSMASSPROPERTIES_EXPORT bool FindToleranceKind(const std::string& name, FaceToleranceRule::Kind& kind);

struct FaceToleranceOptions
{
  /// The first rule that fits a face counts; the tolerance of all others.
  std::vector<FaceToleranceRule> Rules;
  double Lower = 0.0;
  double Upper = 0.0;
  /// False: offsets are distributed evenly between their limits, with a deviation of half the difference over
  /// the root of 3. True: normally, with limits at three deviations.
  bool IsNormal = false;
};

/// Returns rules for the tolerances of the drawing whose ranges are known: of faces, where several are for
/// one face the narrowest, then the narrowest that is for all faces.
SMFILTERSMASSPROPERTIES_EXPORT std::vector<FaceToleranceRule> MakeDrawingRules(
  const std::vector<DrawingTolerance>& tolerances);

/// The range of the offsets of a face.
struct OffsetRange
{
  double Lower = 0.0;
  double Upper = 0.0;
  double GetLargest() const;
};

/// What tolerances leave open in a body, or in all bodies together; NaN where not known. The worst case is
/// that of every body between the one with all faces at their lower and the one with all at their upper
/// limits. Deviations are those of independent rigid offsets of the faces, to first order.
struct SMFILTERSMASSPROPERTIES_EXPORT ToleranceRow
{
  double VolumeLower, VolumeUpper, VolumeDeviation;
  double MassLower, MassUpper, MassDeviation;
  /// Reach: no coordinate, entry or principal moment is farther from the nominal one in the worst case.
  double CenterReach;
  std::array<double, 3> CenterDeviation;
  double InertiaReach;
  std::array<double, 9> InertiaDeviation;
  double PrincipalReach;
  std::array<double, 3> PrincipalDeviation;

  /// Sets all values to NaN.
  ToleranceRow();
};

/// The results for bodies in their order, and for all together.
struct FaceToleranceResults
{
  std::vector<ToleranceRow> Rows;
  ToleranceRow Total;
  /// By body and face.
  std::vector<std::vector<OffsetRange>> Ranges;
  /// Sentences about faces for which the worst case is wide, about rules that fit no face, and about bodies
  /// of which nothing is known.
  std::vector<std::string> Messages;
};

/// Computes what tolerances leave open. `rows` and `total` have the mass properties, of the integrals of
/// GetSensitivityIntegrands().
SMFILTERSMASSPROPERTIES_EXPORT FaceToleranceResults ComputeFaceTolerances(
  const std::vector<BodyIntegrals>& bodies, const std::vector<MassRow>& rows, const MassRow& total,
  const BodyOffsets& offsets, const FaceToleranceOptions& options);
}

#endif
