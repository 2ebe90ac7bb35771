/**
 * @file smProductResults.h
 * @brief The results of a product and of its solids, by which products are compared; not installed
 */
#ifndef smProductResults_h
#define smProductResults_h

#include "smFiltersProductsModule.h"
#include "smQuantities.h"

#include <optional>
#include <string>
#include <vector>

class vtkDataObject;
class vtkMassPropertiesBase;

namespace sm
{
struct SolidResults
{
  std::string Id, Name, Status;
  Quantities Values;
};

struct ProductResults
{
  std::string Status;
  std::optional<std::string> LengthUnit;
  double Diagonal = Unknown; ///< of the bounding box
  Quantities Total;
  std::vector<SolidResults> Solids;
};

/// Returns the results of the last run of a filter.
SMFILTERSPRODUCTS_EXPORT ProductResults ReadProductResults(vtkMassPropertiesBase* filter);

/// Returns the diagonal of the bounding box of all bodies of a filter's input; NaN if there are none.
SMFILTERSPRODUCTS_EXPORT double GetDiagonal(vtkDataObject* input);
}

#endif
