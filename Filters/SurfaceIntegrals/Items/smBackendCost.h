/**
 * @file smBackendCost.h
 * @brief Estimates what a run takes on the CPU backend and on a GPU, from the sizes of its faces alone
 *
 * Nothing is cut, planned or measured for it, and no OpenGL context is made: the estimate is a function of
 * the input and of the constants below, so that a choice by it is the same for an edit and a full run of the
 * edited part. An edit that adds many pieces may change it.
 *
 * A face has about one item of integration (panel, ribbon) for each piece of its trim curves and edges, each
 * coedge and each cell between knots, and an item takes about as many evaluations as a patch has
 * coefficients, twice as many where it is rational and curved in both directions. Of 95 real files at a
 * tolerance of 1e-9 the estimate is within a factor of 2 for 73, of 3 for 86, of 4 for 88; it is 13 times too
 * high for a cube of 24 evaluations, and 19 times too low for `occt_linkrods`, where normals nearly vanish.
 * Between tolerances of 1e-3 and 1e-12 the evaluations differ by a factor of 2 to 7, so that the tolerance is
 * not considered. Expressions, which are refined by comparison, are not estimated.
 */
#ifndef smBackendCost_h
#define smBackendCost_h

#include "smFace.h"
#include "smFiltersSurfaceIntegralsModule.h"

#include <cstddef>
#include <string>

namespace sm
{
/// Approximate number of panels and ribbons of a face, from its trim curves and the cells between its knots.
double CountItems(const Face& face);

/// What a run evaluates, and what a GPU has to be sent for it.
struct RunSize
{
  double Evaluations = 0.0;
  double Bytes = 0.0;

  void Add(const RunSize& other)
  {
    this->Evaluations += other.Evaluations;
    this->Bytes += other.Bytes;
  }
};
SMFILTERSSURFACEINTEGRALS_EXPORT RunSize EstimateSize(const Face& face);

/**
 * Rates of the machine, measured: those of the CPU (Documentation/Performance.md), and those of a GPU by
 * Testing/gpu.py on an NVIDIA H200 (driver 580.159.04, EGL), a card for computing. Cards for graphics, whose
 * doubles have 1/64 of the rate of floats, were not at hand; by the work around the shaders their rate is
 * assumed to be the same.
 */
struct BackendRates
{
  /// Evaluations a second of one thread with 1, 2, 4 and 8 lanes, for the integrands of mass properties.
  /// Measured: every fourth of the real files, one thread of a processor with AVX-512.
  double CPUEvaluationsPerSecond[4] = { 5.3e6, 8.6e6, 16e6, 20e6 };
  /// Seconds of a run that do not depend on its size: its threads and batches. Measured: a cube.
  double CPURunSeconds = 1e-3;

  /// Seconds until there is a context: the driver's libraries and the device. Measured: 0.06 to 0.09 s.
  double ContextSeconds = 0.07;
  /// Seconds of the programs that the driver has kept from an earlier run, their first dispatches, and the
  /// comparison with the CPU. Measured; compiling them takes 0.6 to 3 s.
  double ProgramSeconds = 0.04;
  /// Seconds of a run's lists, dispatches and its read-back. Measured: parts of up to 100 faces.
  double GPURunSeconds = 3e-3;
  /// Bytes a second of the upload with its new buffers. Measured: a plate of 906 faces, 10 MB in 26 ms.
  double UploadBytesPerSecond = 4e8;
  /// Evaluations a second of all that is around them. Measured: 6.2 million evaluations of `occt_linkrods` in
  /// 31 to 35 ms.
  double GPUEvaluationsPerSecond = 2e8;
};

/// The processor's share: threads, and the lanes of each (1, 2, 4 or 8).
struct ProcessorSize
{
  int Threads = 1;
  int Lanes = 1;
};

struct BackendCost
{
  RunSize Size;
  /// Estimated seconds of the integration by either backend; those of the GPU begin without a context.
  double CPUSeconds = 0.0;
  double OpenGLSeconds = 0.0;

  bool PrefersOpenGL() const { return this->OpenGLSeconds < this->CPUSeconds; }
};

/// Estimates a run with so many integrands. All seconds increase with the size and the number of integrands.
SMFILTERSSURFACEINTEGRALS_EXPORT BackendCost EstimateBackends(
  const RunSize& size, std::size_t integrands, const ProcessorSize& processor, const BackendRates& rates);

/// "0.25 s".
std::string FormatEstimate(double seconds);
}

#endif
