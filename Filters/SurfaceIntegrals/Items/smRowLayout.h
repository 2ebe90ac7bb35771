/**
 * @file smRowLayout.h
 * @brief Columns of the result row of one item of integration
 */
#ifndef smRowLayout_h
#define smRowLayout_h

#include "smFiltersSurfaceIntegralsModule.h"
#include "smIntegrand.h"

#include <vector>

namespace sm
{
/**
 * A row has the largest gap and the integrals of the squared gap and of the gap; a value and an error per
 * integrand; the roundings, one per different magnitude, which several integrands may share; and per
 * integrand the last difference between orders. The layout is that of glsl/smWorkStorage.glsl.
 */
class SMFILTERSSURFACEINTEGRALS_EXPORT RowLayout
{
public:
  static constexpr int MaxGap = 0;
  static constexpr int SquaredGap = 1;
  static constexpr int GapArea = 2;
  static constexpr int FirstValue = 3;

  RowLayout() = default;
  explicit RowLayout(const std::vector<Integrand>& integrands);

  int GetStride() const { return this->GetDifference(this->Integrands); }
  int GetValue(int integrand) const { return FirstValue + integrand; }
  int GetError(int integrand) const { return FirstValue + this->Integrands + integrand; }
  int GetFirstRounding() const { return FirstValue + 2 * this->Integrands; }
  int GetRounding(int integrand) const { return this->GetFirstRounding() + this->RoundingOf[integrand]; }
  int GetDifference(int integrand) const
  {
    return this->GetFirstRounding() + this->GetNumberOfRoundings() + integrand;
  }

  int GetNumberOfIntegrands() const { return this->Integrands; }
  int GetNumberOfRoundings() const { return static_cast<int>(this->Magnitudes.size()); }
  /// Returns the index of the rounding that belongs to each integrand.
  const std::vector<int>& GetRoundingOf() const { return this->RoundingOf; }
  /// Returns the index of the first integrand of each different magnitude.
  const std::vector<int>& GetMagnitudes() const { return this->Magnitudes; }

private:
  int Integrands = 0;
  std::vector<int> RoundingOf;
  std::vector<int> Magnitudes;
};
}

#endif
