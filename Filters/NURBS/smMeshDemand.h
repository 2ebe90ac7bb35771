/**
 * @file smMeshDemand.h
 * @brief Whether anything downstream of a source of solids needs their display mesh
 *
 * A request key (vtkInformationIntegerRequestKey, set in REQUEST_UPDATE_EXTENT) says too much. VTK copies it upstream through every filter that
 * does not know it, so that a Clip between a reader and one of our filters would be left without points; and it stays in the information of the
 * reader's output, which all consumers share, so that a view which never set it would be refused a mesh, also after a run that failed. So filters
 * declare once, in the information of their ports, what they do without, and the reader looks downstream before every update, while the
 * modification time of the pipeline is computed: a reader that has a mesh to add is newer then, for every executive.
 */
#ifndef smMeshDemand_h
#define smMeshDemand_h

#include "smFiltersNURBSModule.h"

class vtkAlgorithm;
class vtkInformation;

namespace sm
{
/// For FillInputPortInformation(): the filter works with the exact geometry of this input. Its outputs hold no display mesh, but for those
/// that are declared by DeclareMeshOutput().
SMFILTERSNURBS_EXPORT void DeclareExactInput(vtkInformation* inputPortInformation);

/// For FillOutputPortInformation(): the output holds the display mesh of an exact input, where that has one.
SMFILTERSNURBS_EXPORT void DeclareMeshOutput(vtkInformation* outputPortInformation);

/// For Update(port) of a filter with DeclareMeshOutput(), which only an application calls: if the port holds a mesh, the application is to have
/// it from now on, also with nothing connected to the port.
SMFILTERSNURBS_EXPORT void RequestMeshOutput(vtkAlgorithm* filter, int port);

/// True if a filter or view that is connected to this output needs the display mesh, or nothing is connected to it but what passes data on.
SMFILTERSNURBS_EXPORT bool IsMeshNeeded(vtkInformation* outputInformation);
}

#endif
