/**
 * @file smBackendChoice.h
 * @brief The device that computes
 */
#ifndef smBackendChoice_h
#define smBackendChoice_h

namespace sm
{
/// The device that computes; the values are those of BackendType of the VTK classes.
enum class BackendChoice
{
  /// OpenGL if the context is that of a GPU and the CPU is estimated or measured to be slower; else the CPU.
  Automatic,
  /// OpenGL, also of a software renderer; the CPU, with the reason, without a context or double precision.
  OpenGL,
  CPU
};
}

#endif
