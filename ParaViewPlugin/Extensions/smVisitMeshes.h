/**
 * @file smVisitMeshes.h
 * @brief Visits the meshes in data that a representation draws
 */
#ifndef smVisitMeshes_h
#define smVisitMeshes_h

#include <functional>
#include <string>

class vtkDataObject;
class vtkPolyData;

namespace sm
{
/// Calls `visit` with every mesh and the name of the nearest block around it that has one.
void VisitMeshes(
  vtkDataObject* data, const std::function<void(vtkPolyData* mesh, const std::string& name)>& visit);
}

#endif
