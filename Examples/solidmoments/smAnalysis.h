/**
 * @file smAnalysis.h
 * @brief What every further analysis of a file has: options with their help, results, columns, rows of the
 * table
 *
 * smAnalyses.cxx lists all of them. The developer guide shows how one is added.
 */
#ifndef smAnalysis_h
#define smAnalysis_h

#include "smFields.h"

#include "vtkPartitionedDataSetCollection.h"
#include "vtkSmartPointer.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

class vtkAlgorithm;
class vtkCADReader;
class vtkPolyData;

namespace CLI
{
class App;
}

namespace sm
{
class Columns;
class MessageList;
struct FileResult;
struct JobOptions;

/// The results of an analysis for a file or for one of its solids.
class AnalysisResult
{
public:
  virtual ~AnalysisResult() = default;
  virtual std::unique_ptr<AnalysisResult> Clone() const = 0;
  /// Visits the results as one member.
  virtual void Visit(Fields& fields, const char* key) = 0;
  virtual void AddColumns(Columns&) const {}
  /// Returns rows of the table for people; `unit` is the length unit.
  virtual std::string FormatRows(const std::string&) const { return {}; }
};

/// AnalysisResult with Clone() for the class `Derived`.
template <typename Derived>
class AnalysisResultOf : public AnalysisResult
{
public:
  std::unique_ptr<AnalysisResult> Clone() const override
  {
    return std::make_unique<Derived>(static_cast<const Derived&>(*this));
  }
};

/// What the picture shows as colours of faces; no Bodies: the colours of the file.
struct FaceColors
{
  /// Meshes with the cell array of that name.
  vtkSmartPointer<vtkPartitionedDataSetCollection> Bodies;
  std::string Array;
  /// The quantity and its unit, above the colour bar.
  std::string Title;
};

/// What an analysis runs on and writes to.
struct AnalysisRun
{
  vtkCADReader* Reader;
  const JobOptions& Options;
  /// Runs a filter and reports its progress.
  std::function<void(vtkAlgorithm*)> Update;
  FileResult& File;
  MessageList& Messages;
  /// What the picture shows in addition; null: nothing.
  vtkSmartPointer<vtkPolyData>& Drawing;
  /// The colours of faces in the picture, which the last analysis that has some sets.
  FaceColors& Colors;
  /// Index of the analysis in the list, and of its results.
  std::size_t Index;
  /// Reports why its output was not written; empty: it was.
  std::function<void(const std::string&)> ReportOutput;
};

/// An analysis with the values of its options.
class Analysis
{
public:
  virtual ~Analysis() = default;
  /// Returns the key of its results in JSON, which is the name of its stage, too, unless GetStage() says
  /// otherwise.
  virtual const char* GetKey() const = 0;
  virtual const char* GetStage() const { return this->GetKey(); }
  /// Returns whether the results are those of solids, and of all together, rather than of a file.
  virtual bool IsOfBodies() const { return false; }
  /// Returns whether it may crash a driver, and so comes after all others.
  virtual bool RunsLast() const { return false; }
  /// Declares its options with their help.
  virtual void Declare(CLI::App& app) = 0;
  /// Returns an error message for a combination of options that is wrong; empty otherwise.
  virtual std::string FindProblem(const CLI::App&) const { return {}; }
  /// Returns the option of CMake that this build was made without, and that GetOption() needs; null if it has
  /// all.
  virtual const char* GetMissingModule() const { return nullptr; }
  virtual const char* GetOption() const { return ""; }
  virtual bool IsWanted() const = 0;
  /// Return the names of a file that its options name, to read and to write; empty: none.
  virtual std::string GetInputFile() const { return {}; }
  virtual std::string GetOutputFile() const { return {}; }
  /// Returns results of which nothing is known yet; null if it has none of its own.
  virtual std::unique_ptr<AnalysisResult> MakeResult() const { return nullptr; }
  virtual void Run(const AnalysisRun& run) const = 0;
};

using AnalysisList = std::vector<std::shared_ptr<Analysis>>;

/// Returns all analyses, with the defaults of their options.
AnalysisList MakeAnalyses();

/// Results by the index of their analysis; null for one that was not requested.
class AnalysisResults
{
public:
  AnalysisResults() = default;
  AnalysisResults(const AnalysisResults& other) { *this = other; }
  AnalysisResults(AnalysisResults&&) = default;
  AnalysisResults& operator=(const AnalysisResults& other);
  AnalysisResults& operator=(AnalysisResults&&) = default;

  AnalysisResult* Get(std::size_t index) const
  {
    return index < this->Results.size() ? this->Results[index].get() : nullptr;
  }
  void Set(std::size_t index, std::unique_ptr<AnalysisResult> result);
  /// Returns the result of that class; null if there is none.
  template <typename Derived>
  Derived* Find() const
  {
    for (const std::unique_ptr<AnalysisResult>& result : this->Results)
    {
      if (auto* found = dynamic_cast<Derived*>(result.get()))
      {
        return found;
      }
    }
    return nullptr;
  }

private:
  std::vector<std::unique_ptr<AnalysisResult>> Results;
};
}

#endif
