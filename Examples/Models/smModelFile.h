/**
 * @file smModelFile.h
 * @brief Checks a modelled solid and writes it as STEP, the same bytes on every run
 */
#ifndef smModelFile_h
#define smModelFile_h

#include <TopoDS_Shape.hxx>

#include <functional>
#include <string>

namespace smmodel
{
struct ModelFile
{
  /// Of the product; also the file's name in its header, with ".step".
  std::string Name;
  std::string Description;
  /// The program that models it.
  std::string Program;
};

/// What such a program does: calls `make`, prints what came out, and writes it to the only argument of the command line. The
/// exit status: 0, or 1 with a sentence on the standard error when there is not one valid solid or the file cannot be written.
int Run(int argc, char** argv, const ModelFile& file, const std::function<TopoDS_Shape()>& make);
}

#endif
