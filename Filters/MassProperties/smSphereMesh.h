/**
 * @file smSphereMesh.h
 * @brief Triangles of a sphere, for drawings; not installed
 */
#ifndef smSphereMesh_h
#define smSphereMesh_h

#include "smFiltersMassPropertiesModule.h"

#include "vtkSmartPointer.h"

class vtkPolyData;

namespace sm
{
/**
 * Returns the mesh that vtkSphereSource makes of the same numbers, in double precision: both poles, then
 * meridian after meridian from pole to pole, with normals. VTK's module of sources brings six other libraries
 * to every program.
 */
SMFILTERSMASSPROPERTIES_EXPORT vtkSmartPointer<vtkPolyData> MakeSphereMesh(
  const double center[3], double radius, int meridians, int parallels);
}

#endif
