/**
 * @file smMeshDemand.h
 * @brief Reports to a source of solids whether anything downstream needs their display mesh
 *
 * A request key (vtkInformationIntegerRequestKey, set in REQUEST_UPDATE_EXTENT) would also reach pipelines
 * that need the mesh. VTK copies it upstream through every filter that does not know it, so that a Clip
 * between a reader and one of our filters would be left without points; and it stays in the information of
 * the reader's output, which all consumers share, so that a view which never set it would be refused a mesh,
 * also after a run that failed.
 *
 * Instead the need is determined in ComputePipelineMTime(), with which every update begins. An executive
 * calls it for its filter and immediately afterwards for the producers of the filter's inputs. A filter of
 * ours that works without the mesh sets a mark (a key) in the producer's output information, and the producer
 * removes it in its own call, which follows. A call without a mark comes from something that needs the mesh:
 * a reader that has not made one yet then reports a newer modification time, to every executive.
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

/// For Update(port) of a filter with DeclareMeshOutput(), which only an application calls: if the port holds
/// a mesh, the application is to have it from now on, also with nothing connected to the port.
SMFILTERSNURBS_EXPORT void RequestMeshOutput(vtkAlgorithm* filter, int port);

/// For ComputePipelineMTime() of a filter that works with the exact geometry of its inputs: sets marks at
/// their producers, unless the call is for an output with DeclareMeshOutput() and has no mark itself, another
/// such output is connected, or one was requested by RequestMeshOutput().
SMFILTERSNURBS_EXPORT void PassMeshDemand(
  vtkAlgorithm* filter, vtkInformationVector** inputs, vtkInformationVector* outputs, int port);

/// For ComputePipelineMTime() of a source: returns true if the call comes from a filter that works without
/// the mesh. Removes the mark.
SMFILTERSNURBS_EXPORT bool TakeExactMark(vtkInformation* outputInformation);
}

#endif
