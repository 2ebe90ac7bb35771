/**
 * @file smLiteral.h
 * @brief Doubles as text that GLSL reads back to the bit
 */
#ifndef smLiteral_h
#define smLiteral_h

#include <iomanip>
#include <locale>
#include <sstream>
#include <string>

namespace sm
{
/// "-1.50000000000000000e+00LF", with a point in every locale: applications (Qt's, all of them) set the user's, and
/// std::snprintf then writes a comma, which is an operator of GLSL's.
inline std::string MakeLiteral(double value)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << std::scientific << std::setprecision(17) << value << "LF";
  return text.str();
}
}

#endif
