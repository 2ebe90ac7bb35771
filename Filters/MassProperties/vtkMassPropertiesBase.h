/**
 * @class   vtkMassPropertiesBase
 * @brief   base of the filters that compute volume, area, centre of mass and inertia
 *
 * Abstract; see vtkMassPropertiesGPU, which integrates to a tolerance with bounds, and
 * vtkSchemeMassPropertiesGPU, which integrates by the schemes of the paper, without bounds. Coordinates are
 * world coordinates; L is the model's length unit; density is in kg/m^3.
 *
 * Outputs, in addition to those of vtkSurfaceIntegralBase:
 * | port | type | contents |
 * |---|---|---|
 * | 0 | polydata | sphere at the centre of mass, and principal axes; field data as below |
 * | 1 | table | a row per solid instance with the quantities below and their bounds |
 * | 2 | table | 1x1, column Text: a summary to show in a view; its field data has Status |
 * | 3 | table | a row per face and instance: area and part of the volume (flux about the part's origin) |
 * | 5 | partitioned dataset collection | meshes of the bodies; cell arrays (float): Volume, Mass, FaceShare |
 * | | | (part of the volume due to the face), FaceArea, FaceGap and FaceBound |
 * | 7 | table | the parts list: a row per product, depth first, equal ones in one place together, with their
 * | | | | count, worst status, volume, area, mass (columns: smMassPropertyNames.h); empty if units differ |
 *
 * The active cell scalars of the glyph are its colour, green, or red for a flagged result; vtkPolyDataMapper
 * shows them directly. If there is no glyph, port 0 has one point without a cell, in the middle of the
 * solids' box.
 *
 * Field data (smMassPropertyNames.h); each quantity has a `<name>Bound`, one number in the quantity's unit:
 * | name | comp. | unit | meaning |
 * |---|---|---|---|
 * | Volume | 1 | L^3 | |
 * | SurfaceArea | 1 | L^2 | area of the faces |
 * | CenterOfMass | 3 | L | |
 * | FirstMoments | 3 | L^4 | about the world origin |
 * | SecondMoments | 6 | L^5 | XX YY ZZ XY YZ XZ about the centre |
 * | VolumeInertia | 9 | L^5 | about the centre; off-diagonals are negative products |
 * | VolumeInertiaAtOrigin | 9 | L^5 | about the world origin |
 * | PrincipalMoments | 3 | L^5 | ascending |
 * | PrincipalAxes | 9 | 1 | rows; PrincipalAxesDegenerate is 1 when moments coincide |
 * | RadiiOfGyration | 3 | L | about the principal axes |
 * | Mass, MassInertia | 1, 9 | kg, kg L^2 | only with a density; MassInertia is about the MassCenter |
 * | MassCenter, MassRadiiOfGyration | 3 | L | with the densities as weight, as the next two |
 * | MassPrincipalMoments, MassPrincipalAxes | 3, 9 | kg L^2, 1 | as PrincipalMoments and PrincipalAxes |
 * | Density, Material | 1 | kg/m^3 | Material (string) in the table of port 1 only |
 * | VolumeSpread, SurfaceAreaSpread | 1 | L^3, L^2 | largest change by closing gaps in another way, which |
 * | | | | no bound includes (smClosingSpread.h); NaN for open solids |
 * | CenterOfMassSpread, MassCenterSpread | 1 | L | the same of the centres |
 * | VolumeInertiaSpread, PrincipalMomentsSpread | 1 | L^5 | the same of an entry, and of a moment |
 * | MassSpread, MassInertiaSpread, MassPrincipalMomentsSpread | 1 | kg, kg L^2 | the same, with a density |
 * | MassUncertainty | 5 | kg | doubt of the mass: sum; by DensityTolerance; MassSpread; numerical; by the |
 * | | | | tolerances of masses that materials state |
 * | OverriddenMass | 1 | kg | the part of Mass that materials state |
 * | KnownMass, SolidsWithMass, SolidsWithVolume | 1 | kg | mass and number of solids with a density |
 * | CenterOfMassInFrame, VolumeInertiaInFrame | 3, 9 | L, L^5 | in the frame of reference, if there is one |
 * | MassCenterInFrame, MassInertiaInFrame | 3, 9 | L, kg L^2 | the same with the densities as weight |
 * | CentralInertiaInFrame, MassCentralInertiaInFrame | 9, 9 | L^5, kg L^2 | about the centres, frame's axes |
 * | ClosureCorrection, GapSquared, MaxGap, GapArea, ClosureResidual, OpenEdges | 1 | | defects; no bounds |
 * | FlippedShells | 1 | | number of shells whose normals pointed inwards; reversed |
 * | BoundsMeasured | 4 | | the estimated parts of the bounds of volume, area, centre |
 * | | | | and inertia: measured constants and residuals (Bounds.md) |
 * | LengthUnit, Status, Backend, Renderer, BackendReason, BoundsEstimated | 1 | | |
 * | Evaluations, Dispatches, Faces, Ranks | 1 | | |
 * A quantity that does not exist is NaN (the volume of a surface, anything that was not computed). The total
 * of solids of which only some have a density has no Mass but a KnownMass. CenterOfMass and VolumeInertia are
 * those of a homogeneous body; where densities differ, MassCenter is where the body balances.
 */
#ifndef vtkMassPropertiesBase_h
#define vtkMassPropertiesBase_h

#include "smFiltersMassPropertiesModule.h"
#include "vtkSurfaceIntegralBase.h"

#include <memory> // for the results
#include <vector> // for the materials

namespace sm
{
struct MassAnalysis;
struct MassAnalysisOptions;
struct MaterialRule;
struct PartsListEntry;
struct ReferenceFrame;
class MassGlyphs;
class SelfCrossingCheck;
}

class SMFILTERSMASSPROPERTIES_EXPORT vtkMassPropertiesBase : public vtkSurfaceIntegralBase
{
public:
  vtkTypeMacro(vtkMassPropertiesBase, vtkSurfaceIntegralBase);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Density of all solids in kg/m^3. 0 (default): the density that the file of each part states, if any; no
   * mass without a density. Another value that is not from 1e-200 to 1e200 is reported as an error and
   * changes nothing. */
  void SetDensity(double density);
  vtkGetMacro(Density, double);

  /** Largest relative deviation of the densities, 0 to 1 (0.01 is one per cent), except of materials that
   * state their own. It is the first share of MassUncertainty. A value outside that range is reported as an
   * error and changes nothing. Default: 0. */
  void SetDensityTolerance(double tolerance);
  vtkGetMacro(DensityTolerance, double);
  ///@}

  ///@{
  /**
   * Materials of solids by their names. They take precedence over Density, and Density over the density that
   * the file states. In a pattern,
   * `*` stands for any characters and `?` for one; letters of ASCII match in either case. The first pattern,
   * in the order of the calls, that is equal to the name of a solid, else the first that matches it, gives
   * the solid its material and density in kg/m^3. The density as text may be empty: then the material is one
   * of the common ones (smMaterials.h). A density that is not from 1e-200 to 1e200, and a material that is
   * not known, is reported as an error and changes nothing; a pattern that gives no solid its material gets a
   * message. `tolerance` is relative, negative for that of DensityTolerance. Default: none.
   */
  void AddMaterial(const char* pattern, const char* material, double density, double tolerance = -1.0);
  void AddMaterial(const char* pattern, const char* material, const char* density);
  /** Overrides the mass of each of these solids: `mass` in kg, from 1e-200 to 1e200, takes the place of
   * volume times density. First moments and inertia are those of the volume, scaled to it; Density is the
   * mean density. `tolerance` is that of the mass, relative; negative: DensityTolerance does not apply, the
   * mass counts as exact. The order of the calls counts as for AddMaterial(), which takes a mass with a unit
   * in place of a density, too ("250 g"; kg, g, mg, t, lb, oz), and the material "left out" for AddLeftOut().
   */
  void AddMass(const char* pattern, const char* material, double mass, double tolerance = -1.0);
  /** As AddMass(), for all solids of every product of that name together, part or assembly: each occurrence
   * has that mass. Solids of it with a stated mass of their own, and products in it, keep theirs; the others
   * share the rest in proportion to volume times density, or to volume where one has no density. Statements
   * that contradict each other leave all solids of the product without a mass, and a message names it. A rule
   * counts for the outermost product that it fits. AddMaterial() takes "250 g per product", too. */
  void AddProductMass(const char* pattern, const char* material, double mass, double tolerance = -1.0);
  /** Leaves these solids out of all results; a message names them. */
  void AddLeftOut(const char* pattern);
  /** Counts one of equal products of that name, parts or assemblies, which have the same bodies and equal
   * products below, and leaves their other occurrences out; with `inPlace` one of solids of that name that
   * have the same faces in the same place. A message has the number and the names of what is left out. These
   * solids have the material that other calls or the file give. AddMaterial() takes the materials "counted
   * once" and "counted once in place", too. */
  void AddCountedOnce(const char* pattern, bool inPlace);
  void ClearMaterials();
  int GetNumberOfMaterials() const;
  ///@}

  ///@{
  /**
   * Frame of reference for CenterOfMassInFrame, VolumeInertiaInFrame and those with MassCenter and
   * MassInertia: a point in world coordinates and length unit, the direction of its z axis, and a direction
   * whose part perpendicular to that is its x axis (of any length). Parallel directions, and what is not
   * finite, are reported as an error and change nothing. Default: no frame.
   */
  void SetReferenceFrame(const double origin[3], const double zAxis[3], const double xAxis[3]);
  void ClearReferenceFrame();
  bool HasReferenceFrame() const;
  ///@}

  ///@{
  /** If off, a solid some of whose faces were exchanged since this filter found that its boundary does not
   * cross itself is not checked again: for the updates during a drag, which have to be fast. If on (default),
   * every edit is checked. */
  vtkSetMacro(CheckEditedSolids, bool);
  vtkGetMacro(CheckEditedSolids, bool);
  vtkBooleanMacro(CheckEditedSolids, bool);
  ///@}

  ///@{
  /** Radius of the sphere on port 0 as a fraction of the diagonal of the bounding box. Range [0, 1], clamped.
   * Default 0.02; 0: no sphere. */
  vtkSetClampMacro(GlyphScale, double, 0.0, 1.0);
  vtkGetMacro(GlyphScale, double);
  ///@}

  ///@{
  /** If on, draws the principal axes at the centre of mass, to 0.3 of the diagonal of the bounding box on
   * either side. They are not drawn if they are degenerate. Default on. */
  vtkSetMacro(ShowPrincipalAxes, bool);
  vtkGetMacro(ShowPrincipalAxes, bool);
  vtkBooleanMacro(ShowPrincipalAxes, bool);
  ///@}

  ///@{
  /** If on, draws a glyph for every solid instance in addition to that of the total. Default off. */
  vtkSetMacro(GlyphPerSolid, bool);
  vtkGetMacro(GlyphPerSolid, bool);
  vtkBooleanMacro(GlyphPerSolid, bool);
  ///@}

  ///@{
  /** Totals of the last run; NaN if not computed. The table above has their units. */
  double GetVolume() const;
  double GetVolumeBound() const;
  double GetSurfaceArea() const;
  double GetSurfaceAreaBound() const;
  void GetCenterOfMass(double center[3]) const;
  double GetCenterOfMassBound() const;
  void GetVolumeInertia(double inertia[9]) const;
  double GetVolumeInertiaBound() const;
  void GetPrincipalMoments(double moments[3]) const;
  void GetPrincipalAxes(double axes[9]) const;
  double GetMass() const;
  double GetMassBound() const;
  ///@}

#ifndef __VTK_WRAP__
  /** The parts list of the last run, as on port 7 (smPartsList.h). */
  const std::vector<sm::PartsListEntry>& GetPartsList() const;
#endif

protected:
  vtkMassPropertiesBase();
  ~vtkMassPropertiesBase() override;

#ifndef __VTK_WRAP__
  void ResetResults() override;
  void ReleaseKept() override;
  void AnalyzeBodies(std::vector<sm::BodyIntegrals>& bodies) override;
  void WriteOutputs(const std::vector<sm::BodyIntegrals>& bodies, const Outputs& outputs) const override;
  std::vector<sm::MeshArray> GetMeshArrays(const std::vector<sm::BodyIntegrals>& bodies) const override;

  /** Returns the tolerances, and whether results have bounds. The caller sets the density. */
  virtual sm::MassAnalysisOptions MakeAnalysisOptions() const = 0;
  /** Writes additional outputs of a subclass, and appends lines to the summary. The default writes nothing.
   */
  virtual void WriteMoreOutputs(
    const std::vector<sm::BodyIntegrals>& bodies, const Outputs& outputs, std::string& summary) const;

  /** Adds a material and calls Modified(). */
  void AppendMaterial(const sm::MaterialRule& rule);

  /** Returns the mass properties of the last run. */
  const sm::MassAnalysis& GetAnalysis() const;
#endif

  double Density = 0.0;
  double DensityTolerance = 0.0;
  double GlyphScale = 0.02;
  bool ShowPrincipalAxes = true;
  bool GlyphPerSolid = false;
  bool CheckEditedSolids = true;

private:
  vtkMassPropertiesBase(const vtkMassPropertiesBase&) = delete;
  void operator=(const vtkMassPropertiesBase&) = delete;

#ifndef __VTK_WRAP__
  std::unique_ptr<sm::MassAnalysis> Analysis;
  std::unique_ptr<sm::SelfCrossingCheck> CrossingCheck;
  std::unique_ptr<sm::MassGlyphs> Glyphs;
  std::vector<sm::MaterialRule> Materials;
  std::unique_ptr<sm::ReferenceFrame> Frame;
#endif
};

#endif
