#include "smIntegrand.h"

#include "smFormat.h"

namespace sm
{
namespace
{
std::string Monomial(int i, int j, int k)
{
  std::string text;
  const char* const names[3] = { " * position.x", " * position.y", " * position.z" };
  const int powers[3] = { i, j, k };
  for (int d = 0; d < 3; ++d)
  {
    for (int n = 0; n < powers[d]; ++n)
    {
      text += names[d];
    }
  }
  return text;
}

std::string SizePower(int power)
{
  std::string text;
  for (int n = 0; n < power; ++n)
  {
    text += " * size";
  }
  return text;
}
}

Integrand Integrand::VolumeMoment(const std::string& name, int i, int j, int k)
{
  const int degree = i + j + k;
  const double factor = 1.0 / (3 + degree);
  const std::string text = MakeLiteral(factor);
  return { name, text + " * dot(position, normal)" + Monomial(i, j, k), true, degree,
    text + SizePower(degree + 1), Kind::VolumeMoment, factor, { i, j, k }, factor, degree + 1 };
}

Integrand Integrand::AreaMoment(const std::string& name, int i, int j, int k)
{
  const int degree = i + j + k;
  return { name, "length(normal)" + Monomial(i, j, k), false, degree, MakeLiteral(1.0) + SizePower(degree),
    Kind::AreaMoment, 1.0, { i, j, k }, 1.0, degree };
}

Integrand Integrand::VectorArea(const std::string& name, int component)
{
  const char* const names[3] = { "normal.x", "normal.y", "normal.z" };
  Integrand result{ name, names[component], true, 0, MakeLiteral(1.0), Kind::VectorArea };
  result.Powers[component] = 1;
  return result;
}

Integrand Integrand::HeightMoment(const std::string& name, int i, int j, int k)
{
  const int degree = i + j + k;
  const double factor = 1.0 / (k + 1);
  const std::string text = MakeLiteral(factor);
  return { name, text + " * normal.z" + Monomial(i, j, k + 1), true, degree, text + SizePower(degree + 1),
    Kind::HeightMoment, factor, { i, j, k + 1 }, factor, degree + 1 };
}

Integrand Integrand::SectionMoment(const std::string& name, int i, int j)
{
  const int power = i + j;
  if (power == 0)
  {
    return VectorArea(name, 2);
  }
  // The bounds of x n_z and y n_z are those of the height z times n_z.
  return { name, "normal.z" + Monomial(i, j, 0), true, power - 1, MakeLiteral(1.0) + SizePower(power),
    Kind::HeightMoment, 1.0, { i, j, 0 }, 1.0, power };
}

Integrand Integrand::User(const std::string& name, const std::string& expression, bool closedChain,
  const UserExpression::Constants& constants)
{
  // The magnitude is the integrand itself (see smIntegrationPrograms), so only equal integrands share one.
  Integrand result{ name, expression, closedChain, -1,
    expression + (closedChain ? " on the chain" : " on faces") };
  result.Source = std::make_shared<const UserExpression>(expression, constants);
  return result;
}
}
