/**
 * @file smBREPFormat.h
 * @brief Distinguishes the forms of OpenCASCADE's BREP files by their first and last bytes
 */
#ifndef smBREPFormat_h
#define smBREPFormat_h

#include "smReadersKernelModule.h"

#include <string>
#include <string_view>

namespace sm
{
/// Message for bytes that do not begin like a BREP file.
inline const std::string NotBREP =
  "it is not a BREP file of OpenCASCADE: \"CASCADE Topology\" is missing at its start";

/// Message for the binary form that FreeCAD's exportBinary() writes.
inline const std::string FreeCADProblem = "it is a binary BREP of FreeCAD (exportBinary), which ends "
                                          "otherwise than OpenCASCADE's; export the shape as "
                                          "STEP, or as a BREP of text (exportBrep)";

/// Returns true if the bytes begin like a BREP file.
SMREADERSKERNEL_EXPORT bool LooksLikeBREP(std::string_view bytes);

/// Returns true for the form of text.
SMREADERSKERNEL_EXPORT bool IsTextBREP(std::string_view bytes);

/// Returns true if a text is complete: it ends with the reference to its last shape, "+1 0", behind the
/// asterisk that ends the table of shapes. If no blank or line end follows, the location may be truncated
/// unless it is 0. Behind the reference a file of the test harness has a line with a number, of lines that it
/// draws on faces.
SMREADERSKERNEL_EXPORT bool IsWholeBREP(std::string_view text);

/// Returns true for the binary form that FreeCAD's exportBinary() writes: OpenCASCADE's, but at the end the
/// last shape is referred to by the numbers of shape, location and orientation, of four bytes each, instead
/// of OpenCASCADE's nine bytes in another order.
SMREADERSKERNEL_EXPORT bool IsBREPOfFreeCAD(std::string_view bytes);
}

#endif
