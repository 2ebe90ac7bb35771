/**
 * @file smKernelMessages.h
 * @brief The messages between this library and solidmoments-kernel, the program that links OpenCASCADE
 *
 * Both are of one machine and one version: numbers are in their memory representation (smBytes.h). A message
 * is its kind, the number of bytes that follow, and these bytes (smHelperProcess.h). The program first sends
 * `Version`; it takes any number of requests, one after another, and ends when its standard input does.
 *
 * | request | holds | replies before `Result` | `Result` holds |
 * |---|---|---|---|
 * | RepairBody | RepairLimits, BodyShape | | failure, ShapeGroup |
 * | RepairFaces | RepairLimits, BodyShape, numbers of its faces | | failure, BodyShape, repaired faces |
 * | ReadBREP | the bytes of the file | Fraction | BREPContent |
 * | WriteSTEP, WriteBREP | ExportOptions, ExportTree | Fraction, Content | ExportResult |
 *
 * Shapes are those of smShapeBytes.h, trees those of smExportBytes.h. Objects that a reply refers to and that
 * the request has are sent as their numbers. Limits: geometry is nested at most MaxShapeDepth times, and
 * counts are at most what the bytes of a message can hold. A message that is not valid is refused.
 */
#ifndef smKernelMessages_h
#define smKernelMessages_h

namespace sm
{
namespace kernel
{
/// The program's file name.
constexpr const char* ProgramName = "solidmoments-kernel";

constexpr char RepairBody = 'B';
constexpr char RepairFaces = 'F';
constexpr char ReadBREP = 'R';
constexpr char WriteSTEP = 'S';
constexpr char WriteBREP = 'W';

/// A text.
constexpr char Version = 'v';
/// A double, the fraction of the work that is done.
constexpr char Fraction = 'f';
/// The next bytes of the file.
constexpr char Content = 'c';
constexpr char Result = 'r';
/// There was not enough memory; no `Result` follows.
constexpr char OutOfMemory = 'm';
}
}

#endif
