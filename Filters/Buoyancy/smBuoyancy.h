/**
 * @file smBuoyancy.h
 * @brief Volume, first moments and centroid of the part of a solid below a plane, and moments of its section,
 * with bounds
 *
 * Let h be the height above the plane of the waterline, and up the plane's unit normal. In coordinates (x, y,
 * z) with z = h the fields up h, up h x, up h y and up h z/2 have the divergences 1, x, y and z and vanish on
 * the plane. Their fluxes through the submerged part of the closed chain are therefore the displaced volume
 * and its first moments; the waterplane contributes nothing. These are fluxes of z n_z times 1, x, y and z/2
 * (Integrand::HeightMoment): the placement of a body rotates its positions and normals into these
 * coordinates, so that no plane needs a shader of its own. The submerged part of a face is again a list of
 * panels, ribbons and caps (smSubmergedFace.h).
 *
 * The section with the plane closes that part: its area is the flux of -up through the submerged part, and
 * its moments are those of -up times x, y, xx, yy and xy (Integrand::SectionMoment), provided that the chain
 * is closed: openings of the surface below the plane would count as section. These do not vanish on the
 * plane: smSubmergedFace.h has their bound.
 */
#ifndef smBuoyancy_h
#define smBuoyancy_h

#include "Detail/smSectionMoments.h"
#include "Detail/smSubmergedFace.h"
#include "Detail/smWaterlineFrame.h"
#include "smBodyIntegrals.h"
#include "smFaceCache.h"
#include "smFacePanelsCache.h"
#include "smFiltersBuoyancyModule.h"
#include "smProgressCallback.h"
#include "smSurfaceIntegrator.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace sm
{
/// Displaced volume and its first moments about Origin, along the world's axes, with their bounds. Origin is
/// a point near the body.
struct SMFILTERSBUOYANCY_EXPORT DisplacedMoments
{
  std::array<double, 3> Origin{};
  double Volume = 0.0;
  double VolumeBound = 0.0;
  std::array<double, 3> First{};
  std::array<double, 3> FirstBound{};

  /// Adds the moments of another body, shifted to this Origin.
  void Add(const DisplacedMoments& other);
  /// Returns the centroid and its bound. Both are NaN if the volume may be 0, that is, if it does not exceed
  /// its bound.
  std::array<double, 3> GetCenter(double& bound) const;
};

/// Results of one body.
struct BodyBuoyancy
{
  /// Volume and first moments in x, y and z about the world's origin, for each face of the model.
  std::vector<FaceIntegrals> Faces;
  DisplacedMoments Total;
  /// Moments of the section; zero if they are not wanted, and zero with bounds 0 if the plane certainly
  /// misses the body.
  SectionMoments Section;
};

/// Integrates volume and first moments of the submerged parts of bodies. It keeps cut faces for later runs;
/// it is not thread safe.
class SMFILTERSBUOYANCY_EXPORT BuoyancyIntegrator
{
public:
  explicit BuoyancyIntegrator(bool withSection = false)
    : WithSection(withSection)
  {
  }

  /**
   * Computes one entry of `results` per body. `integrator` evaluates the panels; it must have a runner and
   * the integrands of MakeIntegrands(). `relativeTolerance` is relative to the body's volume, and for the
   * first moments to volume times radius; the moments of the section are relative to the body's area and
   * powers of its radius. `progress` (may be empty) is called while faces are cut, in the first half, and
   * while they are integrated; it returns false to stop. Returns false if nothing was computed;
   * WasAbortedInCut(), GetCutError() or the integrator's GetError() gives the reason.
   */
  bool Integrate(SurfaceIntegrator& integrator, const std::vector<BodyIntegrals>& bodies,
    const Waterline& waterline, double relativeTolerance, const ProgressCallback& progress,
    std::vector<BodyBuoyancy>& results);

  /// Returns the integrands for volume and first moments in coordinates whose z is the height above the
  /// waterline, and behind them those of the section.
  std::vector<Integrand> MakeIntegrands() const;

  /// Returns the seconds that the last Integrate() needed to cut all faces.
  double GetCutSeconds() const { return this->CutSeconds; }

  /// Returns why the last Integrate() could not cut the faces; empty if it could, or was stopped.
  const std::string& GetCutError() const { return this->CutError; }

  /// Returns true if `progress` stopped the last Integrate() while it cut faces: the integrator did not run
  /// then.
  bool WasAbortedInCut() const { return this->WasCutAborted; }

  /// Releases all cut faces that are kept for later runs.
  void ReleaseMemory();

private:
  /// Faces of a body and their parts below the waterline.
  struct CutBody
  {
    WaterlineFrame View;
    std::vector<CutFacePointer> Faces;
    std::vector<SubmergedFace> Below;
    /// True if all of the body is below the waterline.
    bool IsWhole = true;
    /// True if the plane may touch the body.
    bool IsCrossed = false;
    /// Bounds of the errors of volume and section caused by cutting, and the reason if the face could not be
    /// cut (else empty), for each face.
    std::vector<double> VolumeErrors;
    std::vector<double> AreaErrors;
    std::vector<std::string> Errors;
  };
  /// Indices of the body and the face that a task belongs to.
  struct Place
  {
    std::size_t Body;
    std::size_t Face;
  };
  /// Key of the submerged part of a face in the cache: everything it depends on except the face itself.
  struct CutKey
  {
    HeightPlane Plane;
    CutLimits Limits;

    bool operator==(const CutKey& other) const
    {
      return this->Plane.Up == other.Plane.Up && this->Plane.Offset == other.Plane.Offset &&
        this->Limits == other.Limits;
    }
  };

  /// Tolerances of one face.
  struct Tolerance
  {
    double Volume;
    double Area;
  };

  std::size_t GetNumberOfQuantities() const { return this->WithSection ? 10 : 4; }
  void AddTasks(CutBody& cut, std::size_t body, const Tolerance& tolerance, std::vector<FaceTask>& tasks,
    std::vector<Place>& places) const;
  void SumBody(const CutBody& cut, BodyBuoyancy& result) const;
  CutLimits MakeLimits(const CutFace& face, const WaterlineFrame& frame, const Tolerance& tolerance) const;
  ///@{
  /// Cut all bodies, one body, or faces at the waterline. Return false if a face's id is not unique or
  /// `progress` stopped them; faces cut until then are kept for later runs.
  bool CutBodies(const std::vector<BodyIntegrals>& bodies, const Waterline& waterline,
    double relativeTolerance, const ProgressCallback& progress, std::vector<CutBody>& cuts,
    std::vector<FaceTask>& tasks, std::vector<Place>& places);
  bool CutAtWaterline(const BodyIntegrals& body, const Waterline& waterline, const Tolerance& tolerance,
    const ProgressCallback& progress, CutBody& cut);
  bool CutFaces(const std::vector<CutFacePointer>& faces, const HeightPlane& plane,
    const std::vector<CutLimits>& limits, const ProgressCallback& progress,
    std::vector<SubmergedFace>& below);
  ///@}

  bool WithSection;
  FacePanelsCache Cuts;
  double CutSeconds = 0.0;
  std::string CutError;
  bool WasCutAborted = false;
  /// Entries are kept for two runs, because a section is computed from either side.
  FaceCache<CutKey, SubmergedFace> Below{ CacheBudget::GetProcessBudget(), 2 };
};
}

#endif
