#include "smValidationFile.h"

#include "smProductResults.h"
#include "smResults.h"
#include "smSafeFile.h"

#include <algorithm>
#include <cmath>

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

std::string WriteValidation(const std::string& fileName, const ProductTreeNode& tree,
  const ProductResults& results, const std::string& leftOut, const std::string& target)
{
  if (!leftOut.empty())
  {
    // The note is a message of its own.
    return "bodies are left out, and it would state volumes and centroids of products without them; use "
           "--hidden count";
  }
  const StatedFile file(fileName);
  if (!file.IsRead())
  {
    return fileName + " is not a STEP file that can be written again with validation properties";
  }
  const ProductSums sums(file.List(), tree, results);
  const bool isFileSound = IsFileSound(results);
  std::vector<STEPStatement> statements;
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
    if (!std::isnan(computed.Density) && !product.HasDensity)
    {
      statement.Density = computed.Density;
      statement.Material = computed.Material;
    }
    statements.push_back(statement);
  }
  const std::string text = AppendSTEPValidation(file.GetFile(), statements);
  return text.empty() ? fileName + " has no entities" : SaveFile(target, text);
}

long long CountValidation(const FileResult& file, const std::string& result)
{
  const std::vector<ValidationEntry> list = file.Validation.value_or(std::vector<ValidationEntry>());
  return std::count_if(
    list.begin(), list.end(), [&result](const ValidationEntry& entry) { return entry.Result == result; });
}
}
