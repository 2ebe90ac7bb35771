/**
 * @file smStepFile.h
 * @brief Writing STEP with OCCT
 */
#ifndef smStepFile_h
#define smStepFile_h

#include <TopoDS_Shape.hxx>

#include <string>

namespace smtest
{
struct StepOptions
{
  bool WithPcurves = true;
  /// 17 digits a number, which hold a double exactly; else OCCT's own format of 12 to 13 digits.
  bool AllDigits = true;
  /// "MM", "INCH", "M" …: the file's length unit. Shapes are in mm.
  const char* Unit = "MM";
};

/// Turns off OCCT's messages on stdout.
void QuietOcct();

/// Writes one shape; throws std::runtime_error when OCCT refuses.
void WriteStep(const TopoDS_Shape& shape, const std::string& path, const StepOptions& options = {});
}

#endif
