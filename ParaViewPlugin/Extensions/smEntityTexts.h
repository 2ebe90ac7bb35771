/**
 * @file smEntityTexts.h
 * @brief What a user reads of solids, faces and edges that are selected: names, masses, areas, gaps
 *
 * Rows are those of the tables of vtkSurfaceIntegralBase and its subclasses; a table may be null, and may lack columns.
 */
#ifndef smEntityTexts_h
#define smEntityTexts_h

#include "vtkType.h"

#include <string>
#include <vector>

class vtkTable;

namespace sm
{
/// Faces, their solids, and the solids that are selected themselves; the first few of each, and the mass of several solids together.
std::string DescribeSolidsAndFaces(vtkTable* solids, const std::vector<vtkIdType>& solidRows, vtkTable* faces,
  const std::vector<vtkIdType>& faceRows);
std::string DescribeEdges(vtkTable* solids, vtkTable* edges, const std::vector<vtkIdType>& edgeRows);
}

#endif
