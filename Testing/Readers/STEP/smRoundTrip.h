/**
 * @file smRoundTrip.h
 * @brief A dataset saved and read again, and how far everything moved
 */
#ifndef smRoundTrip_h
#define smRoundTrip_h

#include "smTestPipeline.h"

#include <vtkBREPWriter.h>
#include <vtkPartitionedDataSetCollection.h>
#include <vtkSTEPWriter.h>
#include <vtkSmartPointer.h>
#include <vtkTrimmedNURBSModel.h>

#include <array>
#include <string>
#include <vector>

namespace smtest
{
/// Totals of the mass filter, all faces of the solids, and the scales that differences are relative to.
struct Properties
{
  std::string Status;
  double Volume = 0.0;
  double Area = 0.0;
  std::array<double, 3> Center{};
  std::array<double, 9> Inertia{};
  /// Error bounds of volume, area, centre (a length) and inertia (largest entry).
  std::array<double, 4> Bounds{};
  double GapSquared = 0.0;
  double MaxGap = 0.0;
  int OpenEdges = 0;
  vtkIdType Solids = 0;

  double GetSize() const;
};

/// `tolerance` is that of the filter, relative.
Properties Weigh(vtkDataObject* data, double tolerance = 1e-13);

/// Differences of volume, area, centre and inertia, relative to volume, area, V^(1/3) and the trace, without
/// what both bounds allow: 0 where they explain it.
std::array<double, 4> GetDifferences(const Properties& a, const Properties& b, bool beyondBounds);

/// All models of the leaves in order.
std::vector<vtkSmartPointer<vtkTrimmedNURBSModel>> GetModels(vtkDataObject* data);

/// Number of faces of all leaves.
long long CountFaces(vtkDataObject* data);

/// Reads a file in one of the reader's units; null when it cannot be read. The filter's messages are not
/// printed.
vtkSmartPointer<vtkPartitionedDataSetCollection> ReadFile(
  const std::string& path, const std::string& unit = "mm", DisplayMesh mesh = DisplayMesh::Coarse);

/// Writes a STEP file; null, and a failed check, when that fails, otherwise what reading it again gives.
/// `messages` gets those of the writer. The mesh is to be that of `data`: the sampled gaps depend a little on
/// the box of a body, and that on its mesh.
vtkSmartPointer<vtkPartitionedDataSetCollection> SaveAndRead(const std::string& path, vtkDataObject* data,
  std::string* messages = nullptr, DisplayMesh mesh = DisplayMesh::Coarse);

/// Checks that the properties of both are the same: relative differences beyond both bounds are at most
/// `limit`. `distance`: how far the part's coordinates are from the origin they are saved in.
void CompareProperties(
  const std::string& name, vtkDataObject* before, vtkDataObject* after, double limit, double distance = 0.0);

/// OpenCASCADE's own view of a BREP file.
struct KernelView
{
  bool Read = false;
  /// Verdict of BRepCheck_Analyzer.
  bool Valid = false;
  int Solids = 0;
  int Faces = 0;
  /// BRepGProp's adaptive quadrature of the faces.
  double Volume = 0.0;
  double Area = 0.0;
  /// Names of the first few complaints.
  std::string Complaints;
};
KernelView ViewBREP(const std::string& path, bool integrate = true);

/// Saves a BREP file: OpenCASCADE reads it, finds nothing wrong, and integrates about the same volume and
/// area.
void CheckKernel(
  const std::string& path, const std::string& name, vtkDataObject* data, double volume, double area);
}

#endif
