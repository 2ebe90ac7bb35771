// What a file states of its products.
#include "vtkSTEPReader.h"

#include "smSTEPProducts.h"

#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

bool vtkSTEPReader::ReadStatedProducts(const char* fileName, vtkTable* table)
{
  sm::Part21File file;
  if (!file.Read(fileName))
  {
    return false;
  }
  vtkNew<vtkStringArray> names;
  vtkNew<vtkStringArray> volumeProblems;
  vtkNew<vtkStringArray> areaProblems;
  vtkNew<vtkStringArray> centroidProblems;
  vtkNew<vtkIdTypeArray> definitions;
  vtkNew<vtkDoubleArray> volumes;
  vtkNew<vtkDoubleArray> areas;
  vtkNew<vtkDoubleArray> centroids;
  centroids->SetNumberOfComponents(3);
  for (const sm::STEPProduct& product : sm::ReadSTEPProducts(file))
  {
    names->InsertNextValue(product.Name);
    volumeProblems->InsertNextValue(product.VolumeProblem);
    areaProblems->InsertNextValue(product.AreaProblem);
    centroidProblems->InsertNextValue(product.CentroidProblem);
    definitions->InsertNextValue(static_cast<vtkIdType>(product.Definition));
    volumes->InsertNextValue(product.Stated.Volume);
    areas->InsertNextValue(product.Stated.Area);
    centroids->InsertNextTuple(product.Stated.Centroid.data());
  }
  const std::pair<const char*, vtkAbstractArray*> columns[] = { { "Product", names },
    { "Definition", definitions }, { "VolumeProblem", volumeProblems }, { "AreaProblem", areaProblems },
    { "CentroidProblem", centroidProblems }, { "Volume", volumes }, { "Area", areas },
    { "Centroid", centroids } };
  for (const auto& [name, column] : columns)
  {
    column->SetName(name);
    table->AddColumn(column);
  }
  return true;
}
