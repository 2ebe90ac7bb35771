/**
 * @class vtkProducts
 * @brief Products as JSON texts, for scripts: parts list, materials, comparison, validation properties,
 * robots
 *
 * The filters are vtkMassPropertiesBase's, with their inputs connected and after their last run. The keys and
 * units are those of the program `solidmoments` (Documentation/Reference.md); L is the length unit of the
 * filter's input. A value that is not known is null. Texts are UTF-8 if the names in the file are.
 */
#ifndef vtkProducts_h
#define vtkProducts_h

#include "smFiltersProductsModule.h"

#include "vtkObject.h"

#include <string>

class vtkMassPropertiesBase;
class vtkTable;

class SMFILTERSPRODUCTS_EXPORT vtkProducts : public vtkObject
{
public:
  static vtkProducts* New();
  vtkTypeMacro(vtkProducts, vtkObject);

  /** Returns the common materials, a list of objects with the keys `name` and
   * `density` (kg/m^3). */
  static std::string GetMaterials();

  /**
   * Adds the line of a table of materials to those of a filter, as the option --materials of the program:
   * `density` in kg/m^3 or a mass with a unit, `mass` in kg or with a unit, both perhaps followed by "per
   * product", `tolerance` relative or a mass with a unit; each may be empty. Returns why the texts make no
   * line, with a remedy, and adds none then; empty if it was added.
   */
  static std::string AddMaterial(vtkMassPropertiesBase* filter, const std::string& pattern,
    const std::string& material, const std::string& density, const std::string& tolerance,
    const std::string& mass);

  /** Returns the parts list, as the key `parts` of the program. */
  static std::string GetPartsList(vtkMassPropertiesBase* filter);

  /**
   * Compares two products by the geometry of their solids, as the key `comparison` of the program. `limit` is
   * the largest relative difference, in addition to the bounds, that counts as equal; it is not clamped.
   * Measures the shapes of all models on the CPU. Empty if the length units differ.
   */
  static std::string Compare(vtkMassPropertiesBase* before, vtkMassPropertiesBase* after, double limit);

  /**
   * Compares the validation properties that a file states with the results, as the key `validation` of the
   * program. `stated` has a row for each product of the file (vtkSTEPReader::ReadStatedProducts()). Volume
   * and area may differ by `limit` of the stated value, the centroid by `limit` of the cube root of the
   * volume, and all by their bounds.
   */
  static std::string CompareValidation(vtkMassPropertiesBase* filter, vtkTable* stated, double limit);

  /**
   * Returns the products as a robot, without meshes: an object with the keys `text`, the file in the format
   * "urdf", "sdf" or "mjcf", `messages`, and `problem`, empty if there is a text. `joints` has lines
   * "parent,child,type,axis x,y,z,origin x,y,z" as the option --joints of the program; `fused` has patterns
   * of names of products, one a line, of which each is one link with all below it. kg, m and kg m^2.
   */
  static std::string MakeRobot(vtkMassPropertiesBase* filter, const std::string& name,
    const std::string& format, const std::string& joints, const std::string& fused);

protected:
  vtkProducts() = default;
  ~vtkProducts() override = default;

private:
  vtkProducts(const vtkProducts&) = delete;
  void operator=(const vtkProducts&) = delete;
};

#endif
