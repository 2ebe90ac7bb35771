/**
 * @class   vtkSMMaterialTableProperty
 * @brief   the cells of the table of materials in the panel of Mass Properties
 *
 * vtkSMMaterialTableDomain fills the cells from input, rules and results, so that they are not an independent
 * setting: in states and traces in Python they always have the default, and only the rules (the property
 * Materials) are recorded.
 */
#ifndef vtkSMMaterialTableProperty_h
#define vtkSMMaterialTableProperty_h

#include "smParaViewExtensionsModule.h" // for the export macro
#include "vtkSMStringVectorProperty.h"

class SMPARAVIEWEXTENSIONS_EXPORT vtkSMMaterialTableProperty : public vtkSMStringVectorProperty
{
public:
  static vtkSMMaterialTableProperty* New();
  vtkTypeMacro(vtkSMMaterialTableProperty, vtkSMStringVectorProperty);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  bool IsValueDefault() override { return true; }
  vtkMTimeType GetMTime() override { return 0; }

protected:
  vtkSMMaterialTableProperty();
  ~vtkSMMaterialTableProperty() override;

private:
  vtkSMMaterialTableProperty(const vtkSMMaterialTableProperty&) = delete;
  void operator=(const vtkSMMaterialTableProperty&) = delete;
};

#endif
