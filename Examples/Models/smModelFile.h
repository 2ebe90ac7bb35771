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
  /// The name of the product and, with ".step", of the file in its header.
  std::string Name;
  std::string Description;
  /// The program that models it.
  std::string Program;
};

/// The main function of a program that models a part: calls `make`, prints a summary, and writes the part to
/// the file that the only argument names. Returns the exit status: 0, or 1 with a message on the standard
/// error when the shape is not one valid solid or the file cannot be written.
int Run(int argc, char** argv, const ModelFile& file, const std::function<TopoDS_Shape()>& make);
}

#endif
