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

/// Writes the text of the file with the validation properties and densities of the products that were
/// computed. Existing statements are kept. `leftOut` is FindLeftOutNote() of the reader: nothing is written
/// unless it is empty. Returns an error message; empty if the file was written.
std::string WriteValidation(const std::string& fileName, const ProductTreeNode& tree,
  const ProductResults& results, const std::string& leftOut, const std::string& target);

/// Returns the number of entries with that result.
long long CountValidation(const FileResult& file, const std::string& result);
}

#endif
