#include "Detail/smShaderCheck.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <set>
#include <vector>

namespace sm
{
namespace
{
struct ShaderToken
{
  std::string Text;
  int Line = 0;
};
using ShaderTokens = std::vector<ShaderToken>;

bool IsWordCharacter(char c)
{
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

bool IsName(const std::string& text)
{
  return !text.empty() && IsWordCharacter(text[0]) && std::isdigit(static_cast<unsigned char>(text[0])) == 0;
}

/// Cuts a text into words and signs, without comments. Lines of directives become tokens of `directives`, one
/// list each.
class ShaderScanner
{
public:
  explicit ShaderScanner(const std::string& source)
    : Source(source)
  {
    while (this->At < this->Source.size())
    {
      this->Step();
    }
  }

  ShaderTokens Tokens;
  std::vector<ShaderTokens> Directives;

private:
  char Get(std::size_t ahead = 0) const
  {
    return this->At + ahead < this->Source.size() ? this->Source[this->At + ahead] : '\0';
  }
  void Step()
  {
    const char c = this->Get();
    if (c == '\n')
    {
      ++this->Line;
      ++this->At;
      this->InDirective = false;
    }
    else if (c == '\\' && this->Get(1) == '\n')
    {
      ++this->Line;
      this->At += 2;
    }
    else if (c == '/' && this->Get(1) == '/')
    {
      this->At = std::min(this->Source.find('\n', this->At), this->Source.size());
    }
    else if (c == '/' && this->Get(1) == '*')
    {
      const std::size_t end = std::min(this->Source.find("*/", this->At + 2), this->Source.size());
      for (; this->At < end; ++this->At)
      {
        this->Line += this->Source[this->At] == '\n' ? 1 : 0;
      }
      this->At += 2;
    }
    else if (std::isspace(static_cast<unsigned char>(c)) != 0)
    {
      ++this->At;
    }
    else if (c == '#' && !this->InDirective)
    {
      this->InDirective = true;
      this->Directives.emplace_back();
      ++this->At;
    }
    else
    {
      this->AddToken();
    }
  }
  void AddToken()
  {
    std::size_t length = 1;
    if (IsWordCharacter(this->Get()))
    {
      while (IsWordCharacter(this->Get(length)))
      {
        ++length;
      }
    }
    else if (this->Get(1) == '=' ||
      (this->Get() == this->Get(1) && (this->Get() == '+' || this->Get() == '-')))
    {
      length = 2;
    }
    (this->InDirective ? this->Directives.back() : this->Tokens)
      .push_back({ this->Source.substr(this->At, length), this->Line });
    this->At += length;
  }

  const std::string& Source;
  std::size_t At = 0;
  int Line = 1;
  bool InDirective = false;
};

class ShaderCheck
{
public:
  explicit ShaderCheck(const std::string& source)
  {
    ShaderScanner scanner(source);
    for (const ShaderTokens& directive : scanner.Directives)
    {
      this->ReadDirective(directive);
    }
    this->Search(scanner.Tokens);
  }

  std::string Complaint;

private:
  bool IsDoubleType(const std::string& type) const { return this->DoubleTypes.count(type) > 0; }
  bool IsVectorType(const std::string& type) const { return this->VectorTypes.count(type) > 0; }

  static const std::string& Get(const ShaderTokens& tokens, std::size_t at)
  {
    static const std::string none;
    return at < tokens.size() ? tokens[at].Text : none;
  }
  /// Returns the index behind the bracket that closes the one at `at`.
  static std::size_t FindEnd(const ShaderTokens& tokens, std::size_t at)
  {
    int depth = 0;
    for (; at < tokens.size(); ++at)
    {
      const std::string& text = tokens[at].Text;
      depth += text == "(" || text == "[" || text == "{" ? 1
        : text == ")" || text == "]" || text == "}"      ? -1
                                                         : 0;
      if (depth == 0)
      {
        return at + 1;
      }
    }
    return at;
  }
  void Complain(const ShaderToken& token, const std::string& what)
  {
    if (this->Complaint.empty())
    {
      this->Complaint = "line " + std::to_string(token.Line) + ": " + token.Text + " " + what;
    }
  }

  /// Learns the types that macros stand for, and searches the text of macros.
  void ReadDirective(const ShaderTokens& directive)
  {
    if (Get(directive, 0) != "define" || directive.size() < 3)
    {
      return;
    }
    const std::string& name = directive[1].Text;
    if (directive.size() == 3)
    {
      for (std::set<std::string>* types : { &this->DoubleTypes, &this->VectorTypes, &this->MatrixTypes })
      {
        if (types->count(directive[2].Text) > 0)
        {
          types->insert(name);
        }
      }
      return;
    }
    this->Search(ShaderTokens(directive.begin() + 2, directive.end()));
  }

  void Search(const ShaderTokens& tokens)
  {
    this->Scopes.assign(1, {});
    for (std::size_t at = 0; at < tokens.size() && this->Complaint.empty(); at = this->Read(tokens, at))
    {
    }
  }

  /// Reads what begins at a token and returns where to go on.
  std::size_t Read(const ShaderTokens& tokens, std::size_t at)
  {
    const std::string& text = tokens[at].Text;
    if (text == "buffer" || text == "shared" || text == "uniform")
    {
      return this->SkipInterface(tokens, at);
    }
    if (text == "struct")
    {
      return this->ReadStructure(tokens, at);
    }
    if (text == "{")
    {
      this->Scopes.push_back(std::move(this->Pending));
      this->Pending.clear();
    }
    else if (text == "}" && this->Scopes.size() > 1)
    {
      this->Scopes.pop_back();
    }
    else if (text == ";" && this->Scopes.size() == 1)
    {
      this->Pending.clear();
    }
    else if (this->IsDoubleType(text) && Get(tokens, at - 1) != ".")
    {
      this->ReadDeclaration(tokens, at);
    }
    else if (this->MatrixTypes.count(text) > 0 && Get(tokens, at + 1) != "(")
    {
      this->Complain(
        tokens[at], "is a matrix of doubles: some drivers keep its columns as floats; use vectors");
    }
    else if (Get(tokens, at + 1) == "[")
    {
      this->ReadIndex(tokens, at);
    }
    return at + 1;
  }

  /// Blocks and variables of buffers, uniforms and shared memory end with a semicolon.
  static std::size_t SkipInterface(const ShaderTokens& tokens, std::size_t at)
  {
    while (at < tokens.size() && tokens[at].Text != ";")
    {
      at = tokens[at].Text == "{" ? FindEnd(tokens, at) : at + 1;
    }
    return at + 1;
  }

  std::size_t ReadStructure(const ShaderTokens& tokens, std::size_t at)
  {
    const std::string& name = Get(tokens, at + 1);
    const std::size_t begin = at + 2;
    if (Get(tokens, begin) != "{")
    {
      return at + 1;
    }
    const std::size_t end = FindEnd(tokens, begin);
    bool hasDoubles = false;
    for (std::size_t i = begin; i < end; ++i)
    {
      if (this->IsDoubleType(tokens[i].Text))
      {
        this->ReadDeclaration(tokens, i);
        hasDoubles = true;
        if (this->IsVectorType(tokens[i].Text))
        {
          this->Members.insert(Get(tokens, i + 1));
        }
      }
    }
    if (hasDoubles)
    {
      this->DoubleTypes.insert(name);
    }
    return end;
  }

  /// Refuses arrays among the variables that a type declares, and remembers vectors.
  void ReadDeclaration(const ShaderTokens& tokens, std::size_t at)
  {
    static const std::string what = "is an array of doubles of one invocation: some drivers keep it as "
                                    "floats; use SM_DOUBLES or SM_VECTORS "
                                    "of chunk smPortable, or shared memory";
    const bool isVector = this->IsVectorType(tokens[at].Text);
    if (Get(tokens, at + 1) == "[")
    {
      this->Complain(
        tokens[IsName(Get(tokens, FindEnd(tokens, at + 1))) ? FindEnd(tokens, at + 1) : at], what);
      return;
    }
    if (!IsName(Get(tokens, at + 1)) || Get(tokens, at + 2) == "(")
    {
      return;
    }
    for (std::size_t i = at + 1; IsName(Get(tokens, i)); ++i)
    {
      if (Get(tokens, i + 1) == "[")
      {
        this->Complain(tokens[i], what);
        return;
      }
      if (isVector)
      {
        // Outside of functions it is a parameter if its declaration ends with a comma or a bracket.
        const std::string& next = Get(tokens, i + 1);
        const bool isParameter = this->Scopes.size() == 1 && (next == "," || next == ")");
        (isParameter ? this->Pending : this->Scopes.back()).insert(tokens[i].Text);
      }
      // To the next variable of the same declaration.
      for (++i; i < tokens.size() && tokens[i].Text != "," && tokens[i].Text != ";" && tokens[i].Text != ")";)
      {
        const std::string& text = tokens[i].Text;
        i = text == "(" || text == "[" || text == "{" ? FindEnd(tokens, i) : i + 1;
      }
      if (Get(tokens, i) != "," || (IsName(Get(tokens, i + 1)) && IsName(Get(tokens, i + 2))))
      {
        return;
      }
    }
  }

  /// Refuses an assignment to an indexed component of a vector.
  void ReadIndex(const ShaderTokens& tokens, std::size_t at)
  {
    const std::string& name = tokens[at].Text;
    bool isVector = Get(tokens, at - 1) == "." ? this->Members.count(name) > 0 : false;
    for (const std::set<std::string>& scope : this->Scopes)
    {
      isVector = isVector || (Get(tokens, at - 1) != "." && scope.count(name) > 0);
    }
    const std::size_t end = FindEnd(tokens, at + 1);
    const bool isNumber =
      end == at + 4 && std::isdigit(static_cast<unsigned char>(Get(tokens, at + 2)[0])) != 0;
    static const std::set<std::string> assignments = { "=", "+=", "-=", "*=", "/=", "++", "--" };
    if (isVector && !isNumber && assignments.count(Get(tokens, end)) > 0)
    {
      this->Complain(tokens[at],
        "is a vector of doubles with a component assigned by an index: some drivers do not link that; assign "
        "the "
        "whole vector");
    }
  }

  std::set<std::string> VectorTypes{ "dvec2", "dvec3", "dvec4" };
  std::set<std::string> DoubleTypes{ "double", "dvec2", "dvec3", "dvec4" };
  std::set<std::string> MatrixTypes{ "dmat2", "dmat3", "dmat4", "dmat2x2", "dmat2x3", "dmat2x4", "dmat3x2",
    "dmat3x3", "dmat3x4", "dmat4x2", "dmat4x3", "dmat4x4" };
  /// Members of structures that are vectors.
  std::set<std::string> Members;
  /// Names of vectors: global ones, then those of each open brace; and those of the parameters of a function
  /// that begins.
  std::vector<std::set<std::string>> Scopes;
  std::set<std::string> Pending;
};
}

std::string FindUnsafeConstruct(const std::string& source)
{
  return ShaderCheck(source).Complaint;
}
}
