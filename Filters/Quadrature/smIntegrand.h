/**
 * @file smIntegrand.h
 * @brief An integrand: a formula of position and normal, for the GPU as text and for the CPU as structure
 */
#ifndef smIntegrand_h
#define smIntegrand_h

#include "smFiltersQuadratureModule.h"
#include "smUserExpression.h"

#include <array>
#include <memory>
#include <string>

namespace sm
{
struct SMFILTERSQUADRATURE_EXPORT Integrand
{
  enum class Kind
  {
    /// Factor * dot(position, normal) * x^i y^j z^k.
    VolumeMoment,
    /// length(normal) * x^i y^j z^k.
    AreaMoment,
    /// The component of the normal whose power is 1.
    VectorArea,
    /// Factor * normal.z * x^i y^j z^k: a HeightMoment or SectionMoment.
    HeightMoment,
    /// An expression of the user's: Source.
    User
  };

  std::string Name;
  /// GLSL expression of `position` and `normal`, both dvec3; a User's as it was written.
  std::string Expression;
  /// Integrated over ribbons and caps too.
  bool ClosedChain = false;
  /// Total degree of the polynomial g in x.n g(x), n g(x), |n| g(x) or x_i n_z g(x); -1: not such a
  /// polynomial.
  int Degree = -1;
  /// GLSL expression in `size` = |position|: the factor of a sample's relative rounding error, see Bounds.md.
  std::string Magnitude;

  /// The same formulas as structure, to be evaluated in the order of operations of the texts: factors from
  /// left to right, x before y before z. The magnitude is MagnitudeFactor * size^MagnitudePower.
  Kind Form = Kind::User;
  double Factor = 1.0;
  std::array<int, 3> Powers{};
  double MagnitudeFactor = 1.0;
  int MagnitudePower = 0;

  /// The checked and translated expression; null unless Form is User.
  std::shared_ptr<const UserExpression> Source{};
  /// The integral scales as size^(2 + ScalePower); tolerances of a User integrand are relative to area *
  /// size^ScalePower.
  int ScalePower = 0;

  /// Flux of x g(x) / (3 + i + j + k) with g = x^i y^j z^k: the volume integral of g.
  static Integrand VolumeMoment(const std::string& name, int i, int j, int k);
  /// |n| x^i y^j z^k.
  static Integrand AreaMoment(const std::string& name, int i, int j, int k);
  /// A component of the vector area, 0 on a closed surface.
  static Integrand VectorArea(const std::string& name, int component);
  /// Flux of (0, 0, z) g(x) / (k + 1) with g = x^i y^j z^k: the volume integral of g, too. It vanishes on the
  /// plane z = 0, so a section there adds nothing.
  static Integrand HeightMoment(const std::string& name, int i, int j, int k);
  /// Flux of the divergence-free field (0, 0, 1) x^i y^j: through the part of a closed surface below z = 0 it
  /// is minus the moment of the section at z = 0. i + j is at most 2.
  static Integrand SectionMoment(const std::string& name, int i, int j);
  static Integrand User(const std::string& name, const std::string& expression, bool closedChain,
    const UserExpression::Constants& constants = {});

  bool operator==(const Integrand& other) const
  {
    const auto getGlsl = [](const Integrand& integrand)
    { return integrand.Source ? integrand.Source->MakeFunction("", false) : std::string(); };
    return this->Name == other.Name && this->Expression == other.Expression &&
      this->ClosedChain == other.ClosedChain && getGlsl(*this) == getGlsl(other);
  }
};
}

#endif
