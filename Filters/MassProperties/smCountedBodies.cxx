#include "smCountedBodies.h"

#include "smBodyIntegrals.h"
#include "smCountedTexts.h"
#include "smFormat.h"
#include "smProducts.h"
#include "smUnitRoundoff.h"
#include "smVector.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>

namespace sm
{
namespace
{
/// Largest distance of control points that coincide, relative to the size of the body, and largest difference
/// of their weights, knots and trim curves.
constexpr double CoincidentPoints = 1e-9;

using BodyNumbers = std::map<std::string, std::size_t>;

bool AreClose(const std::vector<double>& a, const std::vector<double>& b)
{
  return a.size() == b.size() &&
    std::equal(a.begin(), a.end(), b.begin(),
      [](double x, double y) {
        return std::abs(x - y) <= CoincidentPoints * std::max({ 1.0, std::abs(x), std::abs(y) });
      });
}

bool HaveCloseCurves(const Coedge& a, const Coedge& b)
{
  const auto& p = a.Curve.Coefficients;
  const auto& q = b.Curve.Coefficients;
  return a.Reversed == b.Reversed && p.size() == q.size() && AreClose(a.Curve.Breaks, b.Curve.Breaks) &&
    std::equal(p.begin(), p.end(), q.begin(),
      [](const auto& x, const auto& y) {
        return AreClose({ x[0], x[1] }, { y[0], y[1] });
      });
}

bool HaveCloseLoops(const Face& a, const Face& b)
{
  return a.Loops.size() == b.Loops.size() &&
    std::equal(a.Loops.begin(), a.Loops.end(), b.Loops.begin(),
      [](const Loop& x, const Loop& y)
      {
        return x.Coedges.size() == y.Coedges.size() &&
          std::equal(x.Coedges.begin(), x.Coedges.end(), y.Coedges.begin(), HaveCloseCurves);
      });
}

/// A body with its box, both as placed.
class PlacedBody
{
public:
  explicit PlacedBody(const BodyIntegrals& body)
    : Body(&body)
  {
    double bounds[6];
    body.Model->GetLocalBounds(bounds);
    for (int corner = 0; corner < 8; ++corner)
    {
      const Vector3 p =
        this->Place({ bounds[corner & 1], bounds[2 + (corner >> 1 & 1)], bounds[4 + (corner >> 2 & 1)] });
      this->Corners.insert(this->Corners.end(), p.begin(), p.end());
    }
    double largest = 0.0;
    double sum = 0.0;
    for (std::size_t i = 0; i < this->Corners.size(); ++i)
    {
      // Roots of different numbers: regular patterns of bodies have different marks, too. No sum overflows.
      const double weight = std::sqrt(static_cast<double>(i + 2)) / 128.0;
      sum += weight;
      this->Mark += weight * this->Corners[i];
      largest = std::max(largest, std::abs(this->Corners[i]));
    }
    this->Allowed = 32.0 * UnitRoundoff * largest +
      CoincidentPoints *
        GetDistance(Vector3{ bounds[0], bounds[2], bounds[4] }, Vector3{ bounds[1], bounds[3], bounds[5] });
    // Three times: also the roundings of two marks.
    this->MarkWidth = 3.0 * sum * this->Allowed;
  }

  /// A sum of the coordinates: bodies whose marks differ by more than the width do not coincide with this
  /// one.
  double GetMark() const { return this->Mark; }
  double GetMarkWidth() const { return this->MarkWidth; }

  bool Coincides(const PlacedBody& other) const
  {
    vtkTrimmedNURBSModel* a = this->Body->Model;
    vtkTrimmedNURBSModel* b = other.Body->Model;
    for (std::size_t i = 0; i < this->Corners.size(); ++i)
    {
      if (!this->IsNear(this->Corners[i], other.Corners[i]))
      {
        return false;
      }
    }
    if (a == b)
    {
      return true;
    }
    const std::vector<FacePointer>& faces = a->GetFaces();
    const std::vector<FacePointer>& others = b->GetFaces();
    return a->GetBody() == b->GetBody() && faces.size() == others.size() &&
      std::equal(faces.begin(), faces.end(), others.begin(),
        [&](const FacePointer& x, const FacePointer& y) { return this->HasFace(*x, other, *y); });
  }

private:
  /// Coordinates of the model, relative to its origin, to those of the world.
  Vector3 Place(const Vector3& stored) const
  {
    const double* origin = this->Body->Model->GetOrigin();
    const double* m = this->Body->Placement.data();
    const Vector3 p{ origin[0] + stored[0], origin[1] + stored[1], origin[2] + stored[2] };
    return { Dot(m, p.data()) + m[3], Dot(m + 4, p.data()) + m[7], Dot(m + 8, p.data()) + m[11] };
  }
  bool IsNear(double a, double b) const { return std::abs(a - b) <= this->Allowed; }

  bool HasFace(const Face& a, const PlacedBody& other, const Face& b) const
  {
    const NURBSSurface& s = a.Surface;
    const NURBSSurface& t = b.Surface;
    if (a.Reversed != b.Reversed || s.Degree[0] != t.Degree[0] || s.Degree[1] != t.Degree[1] ||
      s.ControlPoints.size() != t.ControlPoints.size() || !AreClose(s.Knots[0], t.Knots[0]) ||
      !AreClose(s.Knots[1], t.Knots[1]) || !HaveCloseLoops(a, b))
    {
      return false;
    }
    for (std::size_t i = 0; i < s.ControlPoints.size(); ++i)
    {
      const std::array<double, 4>& h = s.ControlPoints[i];
      const std::array<double, 4>& g = t.ControlPoints[i];
      const Vector3 p = this->Place({ h[0] / h[3], h[1] / h[3], h[2] / h[3] });
      const Vector3 q = other.Place({ g[0] / g[3], g[1] / g[3], g[2] / g[3] });
      if (!AreClose({ h[3] }, { g[3] }) || !this->IsNear(p[0], q[0]) || !this->IsNear(p[1], q[1]) ||
        !this->IsNear(p[2], q[2]))
      {
        return false;
      }
    }
    return true;
  }

  const BodyIntegrals* Body;
  std::vector<double> Corners;
  double Allowed = 0.0;
  double Mark = 0.0;
  double MarkWidth = 0.0;
};

/// Finds what a run leaves out.
class BodySieve
{
public:
  BodySieve(const std::vector<MaterialRule>& rules, std::vector<BodyIntegrals>& bodies)
    : Rules(rules)
    , Bodies(bodies)
  {
  }

  std::vector<std::string> Run(vtkDataObject* input, bool noteUnused)
  {
    const std::string named = LeaveOut(
      [this](const std::string& name)
      {
        const MaterialRule* rule = FindRule(this->Rules, name);
        return rule && rule->IsLeftOut && this->Used.insert(rule).first != this->Used.end();
      },
      this->Bodies);
    this->Note(named);
    this->CountProductsOnce(input);
    this->CountPlacesOnce();
    for (const MaterialRule& rule : this->Rules)
    {
      if (noteUnused && this->Used.count(&rule) == 0)
      {
        this->Note(rule.IsLeftOut ? "no solid is left out by the pattern " + rule.Pattern
            : rule.Counting == Counting::Once
            ? "no product occurs several times that the pattern " + rule.Pattern + " counts once"
            : rule.Counting == Counting::OnceInPlace
            ? "no solids coincide that the pattern " + rule.Pattern + " counts once in place"
            : std::string());
      }
    }
    return this->Messages;
  }

private:
  void Note(const std::string& message)
  {
    if (!message.empty())
    {
      this->Messages.push_back(message);
    }
  }

  /// Removes the bodies for whose indices `isRemoved` is true.
  void Remove(const std::vector<bool>& isRemoved)
  {
    std::vector<BodyIntegrals> kept;
    for (std::size_t i = 0; i < this->Bodies.size(); ++i)
    {
      if (!isRemoved[i])
      {
        kept.push_back(std::move(this->Bodies[i]));
      }
    }
    this->Bodies = std::move(kept);
  }

  void CountProductsOnce(vtkDataObject* input)
  {
    if (std::none_of(this->Rules.begin(), this->Rules.end(),
          [](const MaterialRule& rule) { return rule.Counting == Counting::Once; }))
    {
      return;
    }
    for (std::size_t i = 0; i < this->Bodies.size(); ++i)
    {
      this->Numbers[this->Bodies[i].Id] = i;
    }
    this->IsRepeated.assign(this->Bodies.size(), false);
    const ProductTreeNode tree = MakeProductTree(input);
    for (const ProductTreeNode& product : tree.Children)
    {
      this->Visit(product);
    }
    const auto removed = std::count(this->IsRepeated.begin(), this->IsRepeated.end(), true);
    if (removed > 0)
    {
      this->Note("the materials count products once, and leave out " +
        FormatCount(static_cast<std::size_t>(removed), "body", "bodies") +
        " of their other occurrences: " + this->Repeated.List());
    }
    this->Remove(this->IsRepeated);
  }

  /// Returns the number of a product, which equal products have, and no others; 0 if it has no bodies.
  std::size_t Identify(const ProductTreeNode& product)
  {
    std::string text = std::to_string(product.Name.size()) + ":" + product.Name + "[";
    bool isEmpty = true;
    for (const ProductTreeNode::Body& body : product.Bodies)
    {
      if (this->Numbers.count(body.Id) > 0)
      {
        text += std::to_string(this->Models.emplace(body.Model, this->Models.size()).first->second) + ",";
        isEmpty = false;
      }
    }
    std::vector<std::size_t> below;
    for (const ProductTreeNode& child : product.Children)
    {
      const std::size_t number = this->Identify(child);
      if (number > 0)
      {
        below.push_back(number);
        isEmpty = false;
      }
    }
    std::sort(below.begin(), below.end());
    text += "]";
    for (const std::size_t number : below)
    {
      text += std::to_string(number) + ",";
    }
    const std::size_t number =
      isEmpty ? 0 : this->Products.emplace(text, this->Products.size() + 1).first->second;
    this->Identities[&product] = number;
    return number;
  }

  void Visit(const ProductTreeNode& product)
  {
    if (this->Identities.count(&product) == 0)
    {
      this->Identify(product);
    }
    const std::size_t number = this->Identities.at(&product);
    const MaterialRule* rule = FindCountingRule(this->Rules, Counting::Once, product.Name);
    if (rule && number > 0 && !this->Seen.insert(number).second)
    {
      this->Used.insert(rule);
      this->Repeated.Add(product.Name.empty() ? "without a name" : product.Name);
      this->MarkRepeated(product);
      return;
    }
    for (const ProductTreeNode& child : product.Children)
    {
      this->Visit(child);
    }
  }

  void MarkRepeated(const ProductTreeNode& product)
  {
    for (const ProductTreeNode::Body& body : product.Bodies)
    {
      const auto found = this->Numbers.find(body.Id);
      if (found != this->Numbers.end())
      {
        this->IsRepeated[found->second] = true;
      }
    }
    for (const ProductTreeNode& child : product.Children)
    {
      this->MarkRepeated(child);
    }
  }

  void CountPlacesOnce()
  {
    std::vector<std::pair<std::size_t, const MaterialRule*>> candidates;
    for (std::size_t i = 0; i < this->Bodies.size(); ++i)
    {
      const MaterialRule* rule = FindCountingRule(this->Rules, Counting::OnceInPlace, this->Bodies[i].Name);
      if (rule)
      {
        candidates.emplace_back(i, rule);
      }
    }
    std::multimap<double, PlacedBody> first;
    std::vector<bool> isRemoved(this->Bodies.size(), false);
    CountedTexts names;
    for (const auto& [index, rule] : candidates)
    {
      PlacedBody body(this->Bodies[index]);
      const double mark = body.GetMark();
      if (!std::isfinite(mark))
      {
        continue;
      }
      if (std::any_of(first.lower_bound(mark - body.GetMarkWidth()),
            first.upper_bound(mark + body.GetMarkWidth()),
            [&body](const auto& other) { return body.Coincides(other.second); }))
      {
        isRemoved[index] = true;
        this->Used.insert(rule);
        names.Add(this->Bodies[index].GetLabel());
      }
      else
      {
        first.emplace(mark, std::move(body));
      }
    }
    if (names.GetTotal() > 0)
    {
      this->Note("the materials count solids once that coincide, and leave out " +
        FormatCount(names.GetTotal(), "body", "bodies") + ": " + names.List());
    }
    this->Remove(isRemoved);
  }

  const std::vector<MaterialRule>& Rules;
  std::vector<BodyIntegrals>& Bodies;
  std::vector<std::string> Messages;
  std::set<const MaterialRule*> Used;
  BodyNumbers Numbers;
  std::map<const void*, std::size_t> Models;
  std::map<std::string, std::size_t> Products;
  std::map<const ProductTreeNode*, std::size_t> Identities;
  std::set<std::size_t> Seen;
  std::vector<bool> IsRepeated;
  CountedTexts Repeated;
};
}

bool LeavesOutBodies(const std::vector<MaterialRule>& rules)
{
  return std::any_of(rules.begin(), rules.end(),
    [](const MaterialRule& rule) { return rule.IsLeftOut || rule.Counting != Counting::Every; });
}

std::vector<std::string> LeaveOutBodies(const std::vector<MaterialRule>& rules, vtkDataObject* input,
  bool noteUnused, std::vector<BodyIntegrals>& bodies)
{
  return BodySieve(rules, bodies).Run(input, noteUnused);
}
}
