/**
 * @file smEntityTexts.h
 * @brief Texts about selected solids, faces and edges: names, masses, areas, gaps
 *
 * Rows are those of the tables of vtkSurfaceIntegralBase and its subclasses; a table may be null, and may
 * lack columns.
 */
#ifndef smEntityTexts_h
#define smEntityTexts_h

#include "vtkType.h"

#include <string>
#include <vector>

class vtkTable;

namespace sm
{
/// Returns a text about selected faces with their solids, and about selected solids: the first few of each,
/// and the mass of several solids together.
std::string DescribeSolidsAndFaces(vtkTable* solids, const std::vector<vtkIdType>& solidRows, vtkTable* faces,
  const std::vector<vtkIdType>& faceRows);
std::string DescribeEdges(vtkTable* solids, vtkTable* edges, const std::vector<vtkIdType>& edgeRows);
}

#endif
