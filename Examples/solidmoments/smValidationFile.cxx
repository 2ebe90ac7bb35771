#include "smValidationFile.h"

#include "smMaterials.h"
#include "smProductResults.h"
#include "smResults.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

namespace sm
{
StatedFile::StatedFile(const std::string& name)
  : HasText(this->File.Read(name))
{
  if (this->HasText)
  {
    this->Products = ReadSTEPProducts(this->File);
  }
}

std::vector<StatedProduct> StatedFile::List() const
{
  std::vector<StatedProduct> list;
  for (const STEPProduct& product : this->Products)
  {
    list.push_back(
      { product.Name, static_cast<long long>(product.Definition), product.VolumeProblem, product.AreaProblem,
        product.CentroidProblem, product.Stated.Volume, product.Stated.Area, product.Stated.Centroid });
  }
  return list;
}

namespace
{
/// Returns a material that the file names for the product and whose density was not computed with; nothing if
/// there is none. The material of an assembly counts only where that of the density has no name to write.
std::optional<std::string> FindOtherMaterial(const STEPProduct& product, const ComputedProduct& computed)
{
  const std::set<std::string>& names = computed.FileMaterials;
  const auto found = std::find_if(names.begin(), names.end(),
    [&](const std::string& name)
    { return name.empty() ? product.HasMaterial : !IsSameMaterial(name, computed.Material); });
  return found == names.end() || !(product.HasMaterial || computed.Material.empty()) ? std::nullopt
                                                                                     : std::optional(*found);
}

/// Products whose density is not written.
class OtherMaterials
{
public:
  void Add(const STEPProduct& product, const std::string& name, const std::string& material)
  {
    if (this->Count++ == 0)
    {
      this->Product = product.Name + " (#" + std::to_string(product.Definition) + ")";
      this->Reason = ": the file names the material " + (name.empty() ? "in another way" : name) +
        ", and the density is that of " + (material.empty() ? "no named material" : material) +
        "; give the material of the file and its density in a line of --materials";
    }
  }
  std::string Describe() const
  {
    const int others = this->Count - 1;
    return this->Count == 0 ? std::string()
                            : "--write-validation: no density is written for " + this->Product +
        (others > 0 ? " and " + std::to_string(others) + " other product" + (others > 1 ? "s" : "") : "") +
        this->Reason;
  }

private:
  int Count = 0;
  std::string Product, Reason;
};
}

ValidationPlan PlanValidation(const std::string& fileName, const ProductTreeNode& tree,
  const ProductResults& results, const std::string& leftOut)
{
  if (!leftOut.empty())
  {
    // The note is a message of its own.
    return { {},
      "bodies are left out, and it would state volumes and centroids of products without them; use "
      "--hidden count",
      {} };
  }
  const StatedFile file(fileName);
  if (!file.IsRead())
  {
    return { {}, fileName + " is not a STEP file that can be written again with validation properties", {} };
  }
  const ProductSums sums(file.List(), tree, results);
  const bool isFileSound = IsFileSound(results);
  std::vector<STEPStatement> statements;
  OtherMaterials others;
  for (const STEPProduct& product : file.GetProducts())
  {
    const ComputedProduct computed = sums.Find(product.Name);
    const STEPValidation& stated = product.Stated;
    if (!computed.Reason.empty() || product.Context == 0)
    {
      continue;
    }
    STEPStatement statement;
    statement.Product = product;
    // A property that the file states already, usable or not, is not written a second time, and none of which
    // this program says that it may be wrong.
    const bool isSound = isFileSound && computed.IsSound;
    const auto isWanted = [isSound](double value, const std::string& problem)
    { return isSound && problem.empty() && !std::isfinite(value); };
    const bool wantsVolume = isWanted(stated.Volume, product.VolumeProblem);
    const bool wantsArea = isWanted(stated.Area, product.AreaProblem);
    statement.Values.Volume = wantsVolume ? computed.Volume : std::nan("");
    statement.Values.Area = wantsArea ? computed.Area : std::nan("");
    if (computed.NoCenter.empty() && isWanted(stated.Centroid[0], product.CentroidProblem))
    {
      statement.Values.Centroid = computed.Center;
    }
    const std::optional<std::string> other = FindOtherMaterial(product, computed);
    const bool hasDensity = !std::isnan(computed.Density) && !product.HasDensity;
    if (hasDensity && other)
    {
      others.Add(product, *other, computed.Material);
    }
    else if (hasDensity)
    {
      statement.Density = computed.Density;
      statement.Material = computed.Material;
    }
    statements.push_back(statement);
  }
  const std::string text = AppendSTEPValidation(file.GetFile(), statements);
  return { text, text.empty() ? fileName + " has no entities" : std::string(), others.Describe() };
}

long long CountValidation(const FileResult& file, const std::string& result)
{
  const std::vector<ValidationEntry> list = file.Validation.value_or(std::vector<ValidationEntry>());
  return std::count_if(
    list.begin(), list.end(), [&result](const ValidationEntry& entry) { return entry.Result == result; });
}
}
