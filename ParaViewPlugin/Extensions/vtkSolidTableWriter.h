/**
 * @class   vtkSolidTableWriter
 * @brief   writes a table of solids, faces, edges or parts as CSV, with units in the headings
 *
 * ParaView's writer of CSV files, with headings such as "Volume (mm^3)" where the rows have one length unit.
 * Numbers have 17 digits unless SetPrecision() says otherwise, so that they can be read back with the same
 * bits.
 */
#ifndef vtkSolidTableWriter_h
#define vtkSolidTableWriter_h

#include "smParaViewExtensionsModule.h" // for the export macro
#include "vtkCSVWriter.h"

class SMPARAVIEWEXTENSIONS_EXPORT vtkSolidTableWriter : public vtkCSVWriter
{
public:
  static vtkSolidTableWriter* New();
  vtkTypeMacro(vtkSolidTableWriter, vtkCSVWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkSolidTableWriter();
  ~vtkSolidTableWriter() override;

  int RequestData(
    vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector) override;

private:
  vtkSolidTableWriter(const vtkSolidTableWriter&) = delete;
  void operator=(const vtkSolidTableWriter&) = delete;
};

#endif
