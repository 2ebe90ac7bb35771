/**
 * @file smBuoyancy.h
 * @brief Volume and first moments of what lies below a plane, and their centre, with bounds
 *
 * With h the height above the waterline's plane and up its unit normal, up h and up x_i h - ... have divergences 1 and x_i and
 * vanish on the plane: their flux through the submerged part of the closed chain is the displaced volume and its first
 * moments, and nothing is to be added for the waterplane. In coordinates with z = h these are fluxes of z n_z times 1, x, y
 * and z/2 (Integrand::HeightMoment): placements turn positions and normals there, so that another plane needs no other
 * shader. What is submerged of a face is a list of panels, ribbons and caps again (smSubmergedFace.h).
 */
#ifndef smBuoyancy_h
#define smBuoyancy_h

#include "smBodyIntegrals.h"
#include "smFaceCache.h"
#include "smFacePanelsCache.h"
#include "smFiltersBuoyancyModule.h"
#include "smProgressCallback.h"
#include "smSubmergedFace.h"
#include "smSurfaceIntegrator.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace sm
{
/// A point of the plane, in world coordinates, and the direction out of the water, of any length but 0.
struct Waterline
{
  std::array<double, 3> Point{};
  std::array<double, 3> Up{};
};

/// Moments about a point near the body, along the world's axes, and their bounds.
struct SMFILTERSBUOYANCY_EXPORT DisplacedMoments
{
  std::array<double, 3> Origin{};
  double Volume = 0.0;
  double VolumeBound = 0.0;
  std::array<double, 3> First{};
  std::array<double, 3> FirstBound{};

  /// Adds those of another body.
  void Add(const DisplacedMoments& other);
  /// NaN, with a bound that is NaN, where the volume is not surely there: its bound is no less than it.
  std::array<double, 3> GetCenter(double& bound) const;
};

/// The results of one body.
struct BodyBuoyancy
{
  /// By face of the model: volume, and moments in x, y and z about the world's origin.
  std::vector<FaceIntegrals> Faces;
  DisplacedMoments Total;
};

class SMFILTERSBUOYANCY_EXPORT BuoyancyIntegrator
{
public:
  /**
   * `results` gets one entry per body. `integrator` evaluates; it has a runner, and the integrands of MakeIntegrands(). The tolerance is
   * relative to the body's volume, and for the first moments to volume times radius. False when nothing was computed: the integrator's
   * GetError() says why.
   */
  bool Integrate(SurfaceIntegrator& integrator, const std::vector<BodyIntegrals>& bodies,
    const Waterline& waterline, double relativeTolerance, const ProgressCallback& progress,
    std::vector<BodyBuoyancy>& results);

  /// Volume and first moments in coordinates whose z is the height above the waterline.
  static std::vector<Integrand> MakeIntegrands();

  /// Seconds of the last Integrate() until all faces were cut.
  double GetCutSeconds() const { return this->CutSeconds; }

  /// Forgets what is kept for later runs.
  void ReleaseMemory();

private:
  /// A body as the waterline sees it.
  struct Frame
  {
    /// In the model's coordinates.
    HeightPlane Plane;
    /// To coordinates with z = height, near the body; and the directions of x, y and z in the world.
    std::array<double, 12> Placement{};
    std::array<std::array<double, 3>, 3> Axes{};
    std::array<double, 3> Origin{};
    /// The middle of the body's box, in the model's coordinates and the world's.
    std::array<double, 3> LocalMiddle{};
    std::array<double, 3> Middle{};
    /// How far rounding may move the plane; no point is further from the frame's origin than Reach.
    double PlaneBound = 0.0;
    double Reach = 0.0;
  };
  /// A body's faces, cut at the waterline.
  struct CutBody
  {
    Frame View;
    std::vector<CutFacePointer> Faces;
    std::vector<SubmergedFace> Below;
    /// All of the body is below the waterline.
    bool IsWhole = true;
    /// Bounds of what cutting may move of the volume of each face; and why a face could not be cut.
    std::vector<double> VolumeErrors;
    std::vector<std::string> Errors;
  };
  /// The face that a task belongs to.
  struct Place
  {
    std::size_t Body;
    std::size_t Face;
  };
  /// What the part of a face below the waterline depends on, beside the face.
  struct CutKey
  {
    HeightPlane Plane;
    double Tolerance;

    bool operator==(const CutKey& other) const
    {
      return this->Plane.Up == other.Plane.Up && this->Plane.Offset == other.Plane.Offset &&
        this->Tolerance == other.Tolerance;
    }
  };

  static Frame MakeFrame(const BodyIntegrals& body, const Waterline& waterline);
  static void MoveToMiddle(Frame& frame);
  static void AddTasks(CutBody& cut, std::size_t body, double tolerance, std::vector<FaceTask>& tasks,
    std::vector<Place>& places);
  static void SumBody(const CutBody& cut, BodyBuoyancy& result);
  bool CutAtWaterline(const BodyIntegrals& body, const Waterline& waterline, double tolerance, CutBody& cut);
  void CutFaces(const std::vector<CutFacePointer>& faces, const HeightPlane& plane, double tolerance,
    std::vector<SubmergedFace>& below);

  FacePanelsCache Cuts;
  double CutSeconds = 0.0;
  FaceCache<CutKey, SubmergedFace> Below{ CacheBudget::GetProcessBudget(), 1 };
};
}

#endif
