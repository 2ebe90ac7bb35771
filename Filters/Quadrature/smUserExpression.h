/**
 * @file smUserExpression.h
 * @brief An integrand as the user wrote it: checked, translated to the shaders' GLSL; compilers' messages are
 * given with its columns
 */
#ifndef smUserExpression_h
#define smUserExpression_h

#include "smExpressionTypes.h"
#include "smFiltersQuadratureModule.h"
#include <map>
#include <string>
#include <vector>

namespace sm
{
/**
 * GLSL, with four differences: sin, cos, tan, exp, log and pow are of doubles (smElementary.glsl); numbers
 * are doubles, so that 1/3 is a third, unless they have a suffix or stand within [ ]; names of constants are
 * replaced by their values; and where a division or a function is not defined, the expression is NaN
 * (smUserFunctions.glsl). Other names are listed in vtkSurfaceIntegralGPU.h.
 */
class SMFILTERSQUADRATURE_EXPORT UserExpression
{
public:
  using Constants = std::map<std::string, double>;

  /// Quantities that a sample must provide.
  enum DetailType
  {
    PositionAndNormal = 0,
    Parameters = 1,
    FirstDerivatives = 2,
    SecondDerivatives = 3
  };

  UserExpression(const std::string& text, const Constants& constants);

  /// The reason why the text is refused, with the place; empty when it was accepted. Names, arities and types
  /// are checked here, so that the place does not depend on a driver's compiler.
  const std::string& GetError() const { return this->Error; }
  int GetDetail() const { return this->Detail; }
  /// Returns true if it uses functions with kinks or steps: abs, min, ?: and so on. Gauss rules converge
  /// slowly there.
  bool MayHaveKinks() const;

  /// A GLSL function `double NAME(dvec3 position, dvec3 normal)`, and one that it calls, with each of the
  /// user's tokens on a line of its own. They need chunk smUserFunctions. `forMessages` gives these lines
  /// numbers by which Explain() knows them.
  std::string MakeFunction(const std::string& name, bool forMessages) const;

  /// The errors of a compiler's log about such a function: "column 8: …; column 30: …", or with lines where
  /// the text has several. Messages about other lines concern the whole expression, and are returned only
  /// when there is no other.
  std::string Explain(const std::string& log) const;

  /// Returns true when a constant may have this name: an identifier without a meaning so far.
  static bool IsFree(const std::string& name);

private:
  struct Token
  {
    std::string Glsl;
    std::size_t At;
    /// A bracket around arguments.
    bool IsCall = false;
    /// As FindMistake() sees it; the text of names is the user's.
    ExpressionToken Checked = {};
  };
  void Read(const Constants& constants);
  bool ReadToken(std::size_t& at, const Constants& constants);
  void AddName(const std::string& name, std::size_t at, const Constants& constants);
  bool AddNumber(const std::string& number, std::size_t at);
  bool TrackBracket(char c, std::size_t at);
  bool Fail(std::size_t at, const std::string& what);
  std::string GetPlace(std::size_t at) const;
  bool CheckTypes();
  /// False for an expression that would be integrated over the parameter domain, which has no meaning for the
  /// solid.
  bool HasAreaElement() const;
  std::size_t FindBracketEnd(std::size_t token) const;
  std::size_t FindOperandEnd(std::size_t token) const;

  std::string Text;
  std::vector<Token> Tokens;
  /// Opening brackets without their closing ones, while the text is read.
  std::vector<Token> Open;
  std::vector<std::string> Names;
  int Detail = PositionAndNormal;
  std::string Error;
};
}

#endif
