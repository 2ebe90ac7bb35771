/**
 * @file smOCCTExport.h
 * @brief Parts and instances written as STEP or BREP by OpenCASCADE
 */
#ifndef smOCCTExport_h
#define smOCCTExport_h

#include "smExportTree.h"
#include "smProgressCallback.h"
#include "smReadersSTEPModule.h"

#include <iosfwd>
#include <string>
#include <vector>

namespace sm
{
struct ExportOptions
{
  /// Unit of the file's lengths, and how many of them one length of the models is.
  std::string UnitName = "mm";
  double Unit = 1.0;
  /// Entries of the header: the file's name, and the program with its version.
  std::string FileName;
  std::string System;
};

struct ExportResult
{
  /// Why nothing was written; empty when all went well. The stream's state says whether it took all.
  std::string Problem;
  std::vector<std::string> Warnings;
  /// Faces in the file: those of every part once.
  int Faces = 0;
  bool Aborted = false;
};

/**
 * AP214 (AUTOMOTIVE_DESIGN): products, assemblies, colours, layers, materials; faces with their trim curves, every number with
 * 17 digits. Bodies, faces and edges keep their names, and their entity numbers where no other body took them first.
 * `progress` gets a fraction in [0,1] and answers false to stop. Holds a KernelSession. Throws std::bad_alloc, and nothing else.
 */
ExportResult WriteSTEP(const ExportTree& tree, const ExportOptions& options, std::ostream& stream,
  const ProgressCallback& progress);

/// OpenCASCADE's own text format, one compound of all instances; it has neither units, names nor colours.
SMREADERSSTEP_EXPORT ExportResult WriteBREP(const ExportTree& tree, const ExportOptions& options,
  std::ostream& stream, const ProgressCallback& progress);
}

#endif
