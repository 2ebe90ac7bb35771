/**
 * @file smVisitMeshes.h
 * @brief Visits the meshes in data that a representation draws
 */
#ifndef smVisitMeshes_h
#define smVisitMeshes_h

#include <functional>
#include <string>

class vtkCompositeDataDisplayAttributes;
class vtkDataObject;
class vtkPolyData;

namespace sm
{
/// Calls `visit` with every mesh that is not hidden and the name of the nearest block around it that has one.
/// `attributes` has the hidden blocks, whose descendants are hidden, too; null: none is hidden.
void VisitMeshes(vtkDataObject* data, vtkCompositeDataDisplayAttributes* attributes,
  const std::function<void(vtkPolyData* mesh, const std::string& name)>& visit);
}

#endif
