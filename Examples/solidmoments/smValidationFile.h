/**
 * @file smValidationFile.h
 * @brief Reads the validation properties of a STEP file, and writes them
 */
#ifndef smValidationFile_h
#define smValidationFile_h

#include "smSTEPProducts.h"
#include "smValidation.h"

#include <string>
#include <vector>

namespace sm
{
struct FileResult;

/// The text of a STEP file, with its products.
class StatedFile
{
public:
  explicit StatedFile(const std::string& name);
  /// Returns false if the file has no text of STEP; it has no products then.
  bool IsRead() const { return this->HasText; }
  const Part21File& GetFile() const { return this->File; }
  const std::vector<STEPProduct>& GetProducts() const { return this->Products; }
  std::vector<StatedProduct> List() const;

private:
  Part21File File;
  bool HasText;
  std::vector<STEPProduct> Products;
};

/// What --write-validation writes.
struct ValidationPlan
{
  std::string Text;
  /// The reason why nothing can be written; empty if it can.
  std::string Problem;
  /// Names products whose density is not written; empty if there are none.
  std::string Message;
};

/// Returns the text of the file with the validation properties and densities of the products that were
/// computed. Existing statements are kept, and a density is not written next to the name of another material.
/// `leftOut` is FindLeftOutNote() of the reader: nothing is written unless it is empty.
ValidationPlan PlanValidation(const std::string& fileName, const ProductTreeNode& tree,
  const ProductResults& results, const std::string& leftOut);

/// Returns the number of entries with that result.
long long CountValidation(const FileResult& file, const std::string& result);
}

#endif
