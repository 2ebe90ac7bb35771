/**
 * @file smExtras.h
 * @brief What few runs need, in a library that is loaded when the first of it is wanted: pictures, files of
 * triangles and sections
 *
 * They bring three quarters of the libraries that the program would link, and of the time to start it.
 */
#ifndef smExtras_h
#define smExtras_h

#include <array>
#include <string>
#include <utility>
#include <vector>

class vtkCADReader;
class vtkImageData;
class vtkPartitionedDataSetCollection;
class vtkPolyData;

namespace sm
{
class BudgetResult;
struct AnalysisRun;
struct JobOptions;
struct Picture;

/// The functions of the library; headers of their names in Extras/ say what they do.
struct ExtraFunctions
{
  std::string (*WriteBudget)(const BudgetResult&, const JobOptions&, const std::string& fileName);
  std::string (*WriteComparison)(vtkCADReader* before, vtkCADReader* after, const JobOptions&);
  std::string (*WriteImage)(vtkImageData*, const std::string& fileName);
  std::string (*WriteLinkMesh)(const std::vector<vtkPolyData*>& bodies, double metres,
    const std::array<double, 12>& pose, bool isHull, const std::string& fileName);
  std::string (*WriteMesh)(vtkPartitionedDataSetCollection* bodies, const std::string& unit,
    const std::array<double, 3>& origin, const std::string& fileName);
  std::string (*WritePicture)(const Picture&, const std::string& fileName);
  /// Null in a build without the module Filters/Section.
  void (*RunSections)(const std::vector<std::array<double, 6>>& planes, const AnalysisRun&);
};

/// The name of the library's function (smOnDemandLibrary.h), whose content are its ExtraFunctions.
constexpr const char* ExtrasEntryName = "smGetExtras";

/// Returns the functions, or null with the reason, in sentences for users.
const ExtraFunctions* GetExtras(std::string& problem);

/// Calls a function that returns an error message; returns the reason if there is none.
template <typename... Parameters, typename... Values>
std::string CallExtra(std::string (*ExtraFunctions::*function)(Parameters...), Values&&... values)
{
  std::string problem;
  const ExtraFunctions* const functions = GetExtras(problem);
  return functions ? (functions->*function)(std::forward<Values>(values)...) : problem;
}
}

#endif
