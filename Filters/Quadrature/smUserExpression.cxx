#include "smUserExpression.h"

#include "smFormat.h"

#include <algorithm>
#include <cctype>
#include <cstring>
#include <regex>
#include <set>
#include <sstream>

namespace sm
{
namespace
{
// Line of the first of the user's tokens, beyond all others. (Mesa's messages say nothing of source numbers.)
constexpr int FirstLine = 100001;
// Limits of the message: number of errors, and characters of each.
constexpr int MaxReported = 3;
constexpr std::size_t MaxLine = 1000;
// GLSL's own limit of names is 1024; std::regex's is the stack.
constexpr std::size_t MaxWord = 1000;

/// A name for a quantity of a sample: its definition in GLSL, and the quantities that the definition needs.
struct SampleName
{
  const char* Name;
  const char* Type;
  const char* Definition;
  int Detail;
};

constexpr SampleName SampleNames[] = {
  { "unitNormal", "dvec3", "normal / max(length(normal), 1e-300LF)", UserExpression::PositionAndNormal },
  { "dA", "double", "length(normal)", UserExpression::PositionAndNormal },
  { "u", "double", "smSampleParameters.x", UserExpression::Parameters },
  { "v", "double", "smSampleParameters.y", UserExpression::Parameters },
  { "du", "dvec3", "smSampleDu", UserExpression::FirstDerivatives },
  { "dv", "dvec3", "smSampleDv", UserExpression::FirstDerivatives },
  { "duu", "dvec3", "smSampleDuu", UserExpression::SecondDerivatives },
  { "duv", "dvec3", "smSampleDuv", UserExpression::SecondDerivatives },
  { "dvv", "dvec3", "smSampleDvv", UserExpression::SecondDerivatives },
  { "meanCurvature", "double", "smSampleCurvatures.x", UserExpression::SecondDerivatives },
  { "gaussianCurvature", "double", "smSampleCurvatures.y", UserExpression::SecondDerivatives },
};

constexpr const char* Functions[][2] = { { "sin", "smUserSin" }, { "cos", "smUserCos" },
  { "tan", "smUserTan" }, { "exp", "smExp" }, { "log", "smUserLog" }, { "pow", "smUserPow" },
  { "sqrt", "smUserSqrt" }, { "inversesqrt", "smUserInverseSqrt" }, { "mod", "smUserMod" },
  { "normalize", "smUserNormalize" } };

bool IsNameStart(char c)
{
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

bool IsNamePart(char c)
{
  return IsNameStart(c) || (c >= '0' && c <= '9');
}

bool IsDigit(char c)
{
  return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

/// Returns the UTF-8 character that begins at byte `at`.
std::string GetCharacter(const std::string& text, std::size_t at)
{
  std::size_t end = at + 1;
  while (end < text.size() && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80)
  {
    ++end;
  }
  return text.substr(at, end - at);
}

/// Recognises names of single precision. GLSL converts floats to doubles silently, and has functions for
/// single precision only.
bool IsSinglePrecision(const std::string& name)
{
  static const std::set<std::string> names = { "float", "vec2", "vec3", "vec4", "intBitsToFloat",
    "uintBitsToFloat" };
  return names.count(name) > 0 || name.compare(0, 3, "mat") == 0 || name.compare(0, 6, "unpack") == 0;
}

/// The type of a name that has a value by itself; Unknown for others.
ExpressionType GetQuantityType(const std::string& name)
{
  if (name == "true" || name == "false")
  {
    return { ExpressionType::Bool, 1 };
  }
  const bool isVector = name == "position" || name == "normal";
  for (const SampleName& sample : SampleNames)
  {
    if (name == sample.Name)
    {
      return { ExpressionType::Double, std::strcmp(sample.Type, "dvec3") == 0 ? 3 : 1 };
    }
  }
  return isVector ? ExpressionType{ ExpressionType::Double, 3 } : ExpressionType{};
}

bool IsReserved(const std::string& name)
{
  return name.compare(0, 2, "sm") == 0 || name.compare(0, 2, "SM") == 0 || name.compare(0, 3, "gl_") == 0;
}
}

UserExpression::UserExpression(const std::string& text, const Constants& constants)
  : Text(text)
{
  this->Read(constants);
}

std::string UserExpression::GetPlace(std::size_t at) const
{
  const std::string before = this->Text.substr(0, at);
  const std::size_t lineStart = before.rfind('\n');
  const std::size_t column = at - (lineStart == std::string::npos ? 0 : lineStart + 1) + 1;
  const std::string place = "column " + std::to_string(column);
  return this->Text.find('\n') == std::string::npos
    ? place
    : "line " + std::to_string(std::count(before.begin(), before.end(), '\n') + 1) + ", " + place;
}

bool UserExpression::Fail(std::size_t at, const std::string& what)
{
  this->Error = this->GetPlace(at) + ": " + what;
  return false;
}

void UserExpression::Read(const Constants& constants)
{
  for (std::size_t at = 0; at < this->Text.size();)
  {
    if (std::isspace(static_cast<unsigned char>(this->Text[at])) != 0)
    {
      ++at;
    }
    else if (!this->ReadToken(at, constants))
    {
      return;
    }
  }
  if (!this->Open.empty())
  {
    this->Fail(this->Open.back().At, "the bracket is not closed");
  }
  else if (this->Tokens.empty())
  {
    this->Error = "the expression is empty";
  }
  else if (this->CheckTypes() && !this->HasAreaElement())
  {
    this->Error = "the expression has no area element: multiply it by dA, or a vector by normal";
  }
}

bool UserExpression::CheckTypes()
{
  std::vector<ExpressionToken> tokens;
  for (const Token& token : this->Tokens)
  {
    tokens.push_back(token.Checked);
    if (token.Checked.Text.empty())
    {
      tokens.back().Text = token.Glsl;
    }
  }
  const ExpressionMistake mistake = FindMistake(tokens);
  return mistake.What.empty() ||
    this->Fail(
      mistake.Token < this->Tokens.size() ? this->Tokens[mistake.Token].At : this->Text.size(), mistake.What);
}

bool UserExpression::HasAreaElement() const
{
  const auto has = [this](const char* name)
  { return std::find(this->Names.begin(), this->Names.end(), name) != this->Names.end(); };
  return has("dA") || has("normal") || (has("du") && has("dv"));
}

bool UserExpression::ReadToken(std::size_t& at, const Constants& constants)
{
  const std::size_t begin = at;
  const char first = this->Text[at];
  const char second = at + 1 < this->Text.size() ? this->Text[at + 1] : '\0';
  if (IsNameStart(first))
  {
    at = std::find_if_not(this->Text.begin() + at, this->Text.end(), IsNamePart) - this->Text.begin();
    const std::string name = this->Text.substr(begin, at - begin);
    if (name.size() > MaxWord)
    {
      return this->Fail(begin, "the name is too long");
    }
    if (IsReserved(name))
    {
      return this->Fail(begin, "'" + name + "' is reserved");
    }
    if (IsSinglePrecision(name))
    {
      return this->Fail(
        begin, "'" + name + "' is of single precision, which no bound here covers; there are doubles only");
    }
    this->AddName(name, begin, constants);
    return true;
  }
  if (IsDigit(first) || (first == '.' && IsDigit(second)))
  {
    for (; at < this->Text.size() &&
         (IsNamePart(this->Text[at]) || this->Text[at] == '.' ||
           (std::strchr("+-", this->Text[at]) && std::strchr("eE", this->Text[at - 1])));
         ++at)
    {
    }
    return this->AddNumber(this->Text.substr(begin, at - begin), begin);
  }
  if (std::strchr("()[]", first))
  {
    ++at;
    return this->TrackBracket(first, begin);
  }
  if (first == ',' && (this->Open.empty() || !this->Open.back().IsCall))
  {
    // The sequence operator is refused, too: it would discard the value before it and call functions without
    // a result.
    return this->Fail(
      begin, "',' stands only between the arguments of a function; numbers have a decimal point");
  }
  static const char* const pairs[] = { "<=", ">=", "==", "!=", "&&", "||", "^^" };
  const bool isPair = std::any_of(std::begin(pairs), std::end(pairs),
    [=](const char* pair) { return pair[0] == first && pair[1] == second; });
  if (!isPair &&
    (!std::strchr("+-*/%<>!?:,.", first) || (first == '/' && std::strchr("/*", second)) ||
      (second == '=' && std::strchr("+-*/%", first)) || (second == first && std::strchr("+-", first))))
  {
    return this->Fail(begin,
      "'" + GetCharacter(this->Text, begin) +
        "' cannot stand here: an expression has no statements, assignments or comments");
  }
  at += isPair ? 2 : 1;
  this->Tokens.push_back({ this->Text.substr(begin, at - begin), begin });
  return true;
}

bool UserExpression::TrackBracket(char c, std::size_t at)
{
  // The parenthesis of a function, or of an array's constructor.
  const bool isCall = c == '(' && !this->Tokens.empty() &&
    (IsNameStart(this->Tokens.back().Glsl[0]) || this->Tokens.back().Glsl == "]");
  this->Tokens.push_back({ std::string(1, c), at, isCall });
  if (c == '(' || c == '[')
  {
    this->Open.push_back(this->Tokens.back());
    return true;
  }
  if (this->Open.empty() || this->Open.back().Glsl != (c == ')' ? "(" : "["))
  {
    return this->Fail(at, "the bracket was not opened");
  }
  this->Open.pop_back();
  return true;
}

void UserExpression::AddName(const std::string& name, std::size_t at, const Constants& constants)
{
  std::string glsl = name;
  const bool isComponent = !this->Tokens.empty() && this->Tokens.back().Glsl == ".";
  // A name with a parenthesis behind it is a function, also where a constant has the same name.
  const std::size_t next = this->Text.find_first_not_of(" \t\r\n", at + name.size());
  const bool isCalled = next != std::string::npos && this->Text[next] == '(';
  const auto constant = isCalled ? constants.end() : constants.find(name);
  ExpressionType type;
  if (!isComponent && constant != constants.end())
  {
    glsl = "(" + MakeLiteral(constant->second) + ")";
    type = { ExpressionType::Double, 1 };
  }
  else if (!isComponent)
  {
    for (const auto& [function, ours] : Functions)
    {
      glsl = name == function ? ours : glsl;
    }
    for (const SampleName& sample : SampleNames)
    {
      this->Detail = name == sample.Name ? std::max(this->Detail, sample.Detail) : this->Detail;
    }
    this->Names.push_back(name);
    type = GetQuantityType(name);
  }
  this->Tokens.push_back({ glsl, at, false, { ExpressionToken::Name, name, type } });
}

bool UserExpression::AddNumber(const std::string& number, std::size_t at)
{
  static const std::regex pattern(
    R"((0[xX][0-9a-fA-F]+[uU]?|([0-9]+\.?[0-9]*|\.[0-9]+)([eE][-+]?[0-9]+)?(LF|lf|[fFuU])?))");
  if (number.size() > MaxWord)
  {
    return this->Fail(at, "the number is too long");
  }
  if (!std::regex_match(number, pattern))
  {
    return this->Fail(at, "'" + number + "' is not a number");
  }
  const bool isInteger = number.find_first_of("xX") != std::string::npos || std::strchr("uU", number.back());
  if (!isInteger && std::strchr("fF", number.back()) && number.find_first_of("lL") == std::string::npos)
  {
    return this->Fail(at, "'" + number + "' is of single precision; without the suffix it is a double");
  }
  const bool isHexadecimal = number.find_first_of("xX") != std::string::npos;
  const bool isIndex = !this->Open.empty() && this->Open.back().Glsl == "[";
  const bool isWhole = number.find_first_not_of("0123456789") == std::string::npos;
  std::string glsl = number;
  if (!isHexadecimal && !(isWhole && isIndex) && number.find_first_of("lLfFuU") == std::string::npos)
  {
    glsl += isWhole ? ".0LF" : "LF";
  }
  const bool isUnsigned = std::strchr("uU", number.back()) != nullptr;
  const ExpressionType type{ isUnsigned       ? ExpressionType::Uint
      : isHexadecimal || (isWhole && isIndex) ? ExpressionType::Int
                                              : ExpressionType::Double,
    1 };
  this->Tokens.push_back({ glsl, at, false, { ExpressionToken::Number, number, type } });
  return true;
}

bool UserExpression::MayHaveKinks() const
{
  // Whole numbers have steps, too.
  static const std::set<std::string> rough = { "abs", "sign", "floor", "trunc", "round", "roundEven", "ceil",
    "fract", "smUserMod", "min", "max", "clamp", "step", "smoothstep", "faceforward", "refract", "int",
    "uint", "bool", "ivec2", "ivec3", "ivec4", "uvec2", "uvec3", "uvec4", "bvec2", "bvec3", "bvec4",
    "lessThan", "lessThanEqual", "greaterThan", "greaterThanEqual", "equal", "notEqual", "isnan", "isinf",
    "?", "<", ">", "<=", ">=", "==", "!=" };
  return std::any_of(
    this->Tokens.begin(), this->Tokens.end(), [](const Token& token) { return rough.count(token.Glsl) > 0; });
}

std::size_t UserExpression::FindBracketEnd(std::size_t token) const
{
  int depth = 0;
  for (; token + 1 < this->Tokens.size(); ++token)
  {
    const std::string& glsl = this->Tokens[token].Glsl;
    depth += glsl == "(" || glsl == "[" ? 1 : glsl == ")" || glsl == "]" ? -1 : 0;
    if (depth == 0)
    {
      break;
    }
  }
  return token;
}

/// The last token of a divisor: signs, a name, number or bracket, and indices, arguments and components of
/// it.
std::size_t UserExpression::FindOperandEnd(std::size_t token) const
{
  const auto isOneOf = [this](std::size_t i, const char* characters)
  {
    const std::string glsl = i < this->Tokens.size() ? this->Tokens[i].Glsl : "";
    return glsl.size() == 1 && std::strchr(characters, glsl[0]);
  };
  while (isOneOf(token, "+-!"))
  {
    ++token;
  }
  token = isOneOf(token, "(") ? this->FindBracketEnd(token) : token;
  while (isOneOf(token + 1, "([."))
  {
    token = isOneOf(token + 1, ".") ? token + 2 : this->FindBracketEnd(token + 1);
  }
  return token;
}

std::string UserExpression::MakeFunction(const std::string& name, bool forMessages) const
{
  std::string text = "double " + name + "Value(const dvec3 position, const dvec3 normal)\n{\n";
  for (const SampleName& sample : SampleNames)
  {
    if (std::find(this->Names.begin(), this->Names.end(), sample.Name) != this->Names.end())
    {
      text += std::string("const ") + sample.Type + " " + sample.Name + " = " + sample.Definition + ";\n";
    }
  }
  text += "return (\n";
  text += forMessages ? "#line " + std::to_string(FirstLine) + "\n" : "";
  std::vector<int> divisorsEnd(this->Tokens.size() + 2);
  for (std::size_t i = 0; i < this->Tokens.size(); ++i)
  {
    text += this->Tokens[i].Glsl;
    if (this->Tokens[i].Glsl == "/" || this->Tokens[i].Glsl == "%")
    {
      text += " smDivisor(";
      ++divisorsEnd[std::min(this->FindOperandEnd(i + 1), this->Tokens.size())];
    }
    text += std::string(divisorsEnd[i], ')') + "\n";
  }
  // An integrand with an area element doubles when the normal is doubled. The check is left out for
  // expressions with derivatives of the surface, which do not change with the normal.
  const bool hasDerivatives = std::any_of(std::begin(SampleNames), std::end(SampleNames),
    [this](const SampleName& sample)
    {
      return sample.Detail >= UserExpression::FirstDerivatives && std::string(sample.Type) == "dvec3" &&
        std::find(this->Names.begin(), this->Names.end(), sample.Name) != this->Names.end();
    });
  const std::string check = hasDerivatives
    ? ""
    : "smRequire(abs(" + name + "Value(position, 2.0LF * normal) - 2.0LF * value) <= 1e-6LF * abs(value));\n";
  return text + ");\n}\ndouble " + name +
    "(const dvec3 position, const dvec3 normal)\n{\nsmIsDefined = true;\nconst double value = " + name +
    "Value(position, normal);\n" + check + "return smIsDefined ? value : smNotANumber();\n}\n";
}

std::string UserExpression::Explain(const std::string& log) const
{
  // "0:12(5): error: text" (Mesa), "0(12) : error C1008: text" (NVIDIA), "ERROR: 0:12: text", "ERROR: 0:12:
  // error(#143) text" (others). Lines of other forms, among them warnings and lists of candidates, say
  // nothing of a place.
  static const std::regex pattern(
    R"(^(?:ERROR:\s*)?\d+(?::(\d+)(?:\(\d+\))?|\((\d+)\))\s*:(?!\s*(?:warning|note)))"
    R"(\s*(?:(?:preprocessor |fatal )?error(?: C\d+|\(#\d+\))?:?\s+)?(.*)$)");
  std::istringstream lines(log);
  std::vector<std::string> reported;
  std::set<std::string> places;
  std::string ofWhole;
  std::string line;
  while (std::getline(lines, line) && reported.size() < MaxReported)
  {
    line.resize(std::min(line.size(), MaxLine));
    std::smatch match;
    line.erase(line.find_last_not_of(" \r") + 1);
    if (!std::regex_match(line, match, pattern))
    {
      continue;
    }
    const std::string number = match[1].matched ? match[1] : match[2];
    if (number.size() > 9)
    {
      continue;
    }
    const long token = std::stol(number) - FirstLine;
    std::string what = match[3];
    for (const auto& [function, ours] : Functions)
    {
      what = std::regex_replace(what, std::regex(ours), function);
    }
    if (token < 0)
    {
      ofWhole = ofWhole.empty() ? what.substr(0, what.find(", in function")) : ofWhole;
      continue;
    }
    // A message about text behind the last token is about our own text: the expression ended too early.
    const bool isBeyond = token >= static_cast<long>(this->Tokens.size());
    const std::string place = this->GetPlace(isBeyond ? this->Text.size() : this->Tokens[token].At);
    // Further messages about a place list candidates.
    if (places.insert(place).second)
    {
      reported.push_back(place + ": " + what);
    }
  }
  std::string text = reported.empty() && !ofWhole.empty() ? this->GetPlace(0) + ": " + ofWhole : "";
  for (const std::string& message : reported)
  {
    text += (text.empty() ? "" : "; ") + message;
  }
  return text.empty() ? log : text;
}

bool UserExpression::IsFree(const std::string& name)
{
  const bool isName = !name.empty() && IsNameStart(name[0]) &&
    std::all_of(name.begin(), name.end(), IsNamePart) && !IsReserved(name);
  const bool isSample = std::any_of(std::begin(SampleNames), std::end(SampleNames),
    [&name](const SampleName& sample) { return name == sample.Name; });
  const bool isFunction = std::any_of(std::begin(Functions), std::end(Functions),
    [&name](const auto& function) { return name == function[0]; });
  return isName && !isSample && !isFunction && name != "position" && name != "normal";
}
}
