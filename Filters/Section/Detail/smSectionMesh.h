/**
 * @file smSectionMesh.h
 * @brief The display mesh of a body below a plane, closed by its section
 */
#ifndef smSectionMesh_h
#define smSectionMesh_h

#include "vtkSmartPointer.h"

class vtkPlane;
class vtkPolyData;

namespace sm
{
/// Returns the part of a mesh on the side that the plane's normal points away from, and its section with the
/// plane as polygons, with the cell arrays Solid (`solid`), Cap, FaceIndex of the mesh (-1 on the section and
/// where the mesh has none), and Color: that of the mesh (or grey), and on the section one of its own. The
/// mesh stays as it is. `hasCap` is set to false if its cut does not bound polygons, as for an open mesh;
/// there is no section then.
vtkSmartPointer<vtkPolyData> MakeSectionMesh(vtkPolyData* mesh, vtkPlane* plane, int solid, bool& hasCap);
}

#endif
