#include "Detail/smProductMasses.h"

#include "Detail/smTotalMass.h"
#include "smCountedTexts.h"
#include "smFormat.h"
#include "smLengthUnits.h"
#include "smUnitRoundoff.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

namespace sm
{
namespace
{
/// Largest relative difference of a mass and of the sum of its parts that do not contradict each other.
constexpr double EqualMasses = 1e-9;
/// Bound of the relative rounding of a factor, without that of its sums.
constexpr double ShareRounding = 16.0 * UnitRoundoff;

/// Distributes the masses of one input.
class ProductMasses
{
public:
  ProductMasses(
    const std::vector<BodyIntegrals>& bodies, const std::vector<MassRow>& rows, MassAnalysisOptions& options)
    : Bodies(bodies)
    , Rows(rows)
    , Options(options)
  {
    for (std::size_t b = 0; b < bodies.size(); ++b)
    {
      this->Indices[bodies[b].Id] = b;
    }
  }

  std::vector<std::string> Run()
  {
    for (const ProductTreeNode& product : this->Options.Products.Children)
    {
      this->Visit(product);
    }
    std::vector<std::string> messages;
    const auto add = [&messages](const std::string& text, const CountedTexts& list)
    {
      if (list.GetTotal() > 0)
      {
        messages.push_back(text + list.List());
      }
    };
    add("the materials state masses of products, which their solids share in proportion to volume times "
        "density: ",
      this->Used);
    add("the stated masses of these products are shared in proportion to volume, since not all solids that "
        "share them have a density; give densities if theirs differ: ",
      this->ByVolume);
    add("no tolerance is stated for the masses of these products, so they count as exact: ", this->Exact);
    add("the stated masses of these products contradict those that are stated for what is in them, so that "
        "none of their solids has a mass; correct or remove one of the lines: ",
      this->Contradictory);
    add("the stated masses of these products are not distributed, since a length unit is not known: ",
      this->UnknownUnit);
    add("the materials state a mass for products without a volume, which have no inertia and do not count: ",
      this->WithoutVolume);
    add(
      "the materials state a mass for products of which all solids are left out, so that it does not count: ",
      this->LeftOut);
    add("solids of these products are left out, and the others have all of the stated mass: ",
      this->Incomplete);
    for (const MaterialRule& rule : this->Options.Materials)
    {
      if (rule.IsOfProduct && this->UsedRules.count(&rule) == 0)
      {
        messages.push_back("no product gets its mass from the pattern " + rule.Pattern);
      }
    }
    return messages;
  }

private:
  /// The solids of a product, at any level below it.
  struct Content
  {
    std::vector<std::size_t> Solids;
    /// Those whose mass is not stated.
    std::vector<std::size_t> Free;
    /// Sum of the stated masses, how far it may be off, and the number of statements.
    double Mass = 0.0;
    double InDoubt = 0.0;
    std::size_t Statements = 0;
    /// False if solids are left out.
    bool IsComplete = true;
    bool IsContradictory = false;

    void Add(const Content& below)
    {
      this->Solids.insert(this->Solids.end(), below.Solids.begin(), below.Solids.end());
      this->Free.insert(this->Free.end(), below.Free.begin(), below.Free.end());
      this->State(this->Mass + below.Mass, this->InDoubt + below.InDoubt);
      this->Statements += below.Statements;
      this->IsComplete = this->IsComplete && below.IsComplete;
      this->IsContradictory = this->IsContradictory || below.IsContradictory;
    }
    void State(double mass, double inDoubt)
    {
      this->Mass = mass;
      this->InDoubt = inDoubt;
    }
  };

  void AddBody(const ProductTreeNode::Body& body, Content& content) const
  {
    const auto found = this->Indices.find(body.Id);
    content.IsComplete = content.IsComplete && found != this->Indices.end();
    if (found == this->Indices.end() || !(this->Rows[found->second].Properties.Volume > 0.0))
    {
      return;
    }
    const std::size_t b = found->second;
    const Material material = ChooseMaterial(this->Bodies[b], this->Options);
    content.Solids.push_back(b);
    if (material.Mass > 0.0)
    {
      content.State(content.Mass + material.Mass, content.InDoubt + material.Tolerance * material.Mass);
      ++content.Statements;
    }
    else
    {
      content.Free.push_back(b);
    }
  }

  /// Distributes the masses of a product and of those in it, these first.
  Content Visit(const ProductTreeNode& product)
  {
    const MaterialRule* rule = FindProductRule(this->Options.Materials, product.Name);
    // A line counts for the outermost product that it fits.
    const bool counts = rule && this->Open.insert(rule).second;
    Content content;
    for (const ProductTreeNode::Body& body : product.Bodies)
    {
      this->AddBody(body, content);
    }
    for (const ProductTreeNode& child : product.Children)
    {
      content.Add(this->Visit(child));
    }
    if (counts)
    {
      this->Open.erase(rule);
      this->UsedRules.insert(rule);
      this->Distribute(product.Name, *rule, content);
    }
    return content;
  }

  /// Leaves all solids of a product without a mass.
  void Refuse(Content& content)
  {
    for (const std::size_t b : content.Solids)
    {
      this->Options.Shares[this->Bodies[b].Id] = ProductShare();
    }
    content.IsContradictory = true;
  }

  void Distribute(const std::string& name, const MaterialRule& rule, Content& content)
  {
    const double mass = rule.Material.Mass;
    if (content.Solids.empty())
    {
      (content.IsComplete ? this->WithoutVolume : this->LeftOut).Add(name);
      return;
    }
    const double rest = mass - content.Mass;
    const bool isPossible =
      content.Free.empty() ? std::abs(rest) <= EqualMasses * mass : rest > EqualMasses * mass;
    if (content.IsContradictory || !isPossible)
    {
      this->Contradictory.Add(name);
      this->Refuse(content);
      return;
    }
    const double tolerance = std::max(rule.Material.Tolerance, 0.0);
    Material shared{ rule.Material.Name, 0.0, (tolerance * mass + content.InDoubt) / rest, rest };
    const double error = static_cast<double>(content.Statements + 1) * ShareRounding * mass / rest;
    if (!content.Free.empty() && !this->SetShares(content.Free, shared, error, name))
    {
      this->UnknownUnit.Add(name);
      this->Refuse(content);
      return;
    }
    content.Free.clear();
    content.State(mass, tolerance * mass);
    this->Used.Add(name + " " + FormatDigits(mass, 10) + " kg for " +
      FormatCount(content.Solids.size(), "solid", "solids"));
    if (tolerance == 0.0)
    {
      this->Exact.Add(name);
    }
    if (!content.IsComplete)
    {
      this->Incomplete.Add(name);
    }
  }

  /// Returns kg of a volume 1 of a body at a density; NaN for an unknown unit.
  double GetKilograms(std::size_t body, double density) const
  {
    const double metres = GetMetres(this->Bodies[body].Model->GetLengthUnit());
    return metres > 0.0 ? density * metres * metres * metres : std::numeric_limits<double>::quiet_NaN();
  }

  /// Distributes `shared.Mass`, which has a relative error of `error`. Returns false if a unit is not known.
  bool SetShares(
    const std::vector<std::size_t>& solids, const Material& shared, double error, const std::string& name)
  {
    std::vector<Material> own;
    for (const std::size_t b : solids)
    {
      own.push_back(ChooseMaterial(this->Bodies[b], this->Options));
    }
    const bool haveDensities =
      std::all_of(own.begin(), own.end(), [](const Material& m) { return m.Density > 0.0; });
    double sum = 0.0;
    double bound = 0.0;
    double spread = 0.0;
    std::vector<double> weights;
    for (std::size_t i = 0; i < solids.size(); ++i)
    {
      own[i].Density = haveDensities ? own[i].Density : 1.0;
      const MassRow& row = this->Rows[solids[i]];
      const double factor = this->GetKilograms(solids[i], own[i].Density);
      weights.push_back(factor * row.Properties.Volume);
      sum += weights.back();
      bound += factor * row.Properties.VolumeBound;
      spread += factor * row.Spread.Volume;
    }
    bound += static_cast<double>(solids.size()) * UnitRoundoff * sum;
    for (std::size_t i = 0; i < solids.size(); ++i)
    {
      ProductShare& share = this->Options.Shares[this->Bodies[solids[i]].Id];
      share.Material = shared;
      share.Material.Name = shared.Name.empty() ? own[i].Name : shared.Name;
      share.Error = error;
      // The mass of a solid alone does not depend on its volume.
      if (solids.size() > 1)
      {
        share.Material.Mass = 0.0;
        share.Material.Density = own[i].Density * (shared.Mass / sum);
        share.Share = weights[i] / sum;
        share.Error += GetReciprocalChange(sum, bound) + ShareRounding;
        share.Spread = std::isnan(spread) ? spread : GetReciprocalChange(sum, spread);
      }
    }
    if (!haveDensities && solids.size() > 1)
    {
      this->ByVolume.Add(name);
    }
    return solids.size() == 1 || sum > 0.0;
  }

  const std::vector<BodyIntegrals>& Bodies;
  const std::vector<MassRow>& Rows;
  MassAnalysisOptions& Options;
  std::map<std::string, std::size_t> Indices;
  std::set<const MaterialRule*> Open, UsedRules;
  CountedTexts Used, Exact, ByVolume, Contradictory, WithoutVolume, LeftOut, Incomplete, UnknownUnit;
};
}

std::vector<std::string> ShareProductMasses(
  const std::vector<BodyIntegrals>& bodies, const std::vector<MassRow>& rows, MassAnalysisOptions& options)
{
  return ProductMasses(bodies, rows, options).Run();
}
}
