/**
 * @file smMeshDemand.h
 * @brief Whether anything downstream of a source of solids needs their display mesh
 *
 * A request key (vtkInformationIntegerRequestKey, set in REQUEST_UPDATE_EXTENT) says too much. VTK copies it upstream through every filter that
 * does not know it, so that a Clip between a reader and one of our filters would be left without points; and it stays in the information of the
 * reader's output, which all consumers share, so that a view which never set it would be refused a mesh, also after a run that failed.
 *
 * So the demand is told while the modification time of the pipeline is computed, which begins every update. An executive asks its filter and
 * right then the producers of its inputs: a filter of ours that does without the mesh leaves a mark at its producer, which takes it away with
 * this very question. A question without a mark comes from something that needs the mesh, and a reader that has none yet is newer then, for every
 * executive.
 */
#ifndef smMeshDemand_h
#define smMeshDemand_h

#include "smFiltersNURBSModule.h"

class vtkAlgorithm;
class vtkInformation;
class vtkInformationVector;

namespace sm
{
/// For FillOutputPortInformation(): the output holds the display mesh of the input, where that has one.
SMFILTERSNURBS_EXPORT void DeclareMeshOutput(vtkInformation* outputPortInformation);

/// For Update(port) of a filter with DeclareMeshOutput(), which only an application calls: if the port holds a mesh, the application is to have
/// it from now on, also with nothing connected to the port.
SMFILTERSNURBS_EXPORT void RequestMeshOutput(vtkAlgorithm* filter, int port);

/// For ComputePipelineMTime() of a filter that works with the exact geometry of its inputs: leaves marks at their producers unless the question
/// comes from something that needs the mesh in a DeclareMeshOutput(), another such output is connected, or one was requested.
SMFILTERSNURBS_EXPORT void PassMeshDemand(
  vtkAlgorithm* filter, vtkInformationVector** inputs, vtkInformationVector* outputs, int port);

/// For ComputePipelineMTime() of a source: true if the question comes from a filter that does without the mesh. Takes the mark away.
SMFILTERSNURBS_EXPORT bool TakeExactMark(vtkInformation* outputInformation);
}

#endif
