/**
 * @file smOCCTContradictions.h
 * @brief Statements of a file that OpenCASCADE overrules, as sentences
 */
#ifndef smOCCTContradictions_h
#define smOCCTContradictions_h

#include "smOCCTEntities.h"
#include "smOCCTLoop.h"
#include "smOCCTSurface.h"

#include <StepGeom_Surface.hxx>
#include <StepShape_FaceSurface.hxx>
#include <StepShape_Vertex.hxx>
#include <gp_Pnt.hxx>

#include <string>
#include <vector>

namespace sm
{
/// A message about the first of several entities, and the number of the others.
class FirstOfSeveral
{
public:
  template <class Describe>
  void Add(const Describe& describe)
  {
    this->Others += this->First.empty() ? 0 : 1;
    this->First = this->First.empty() ? describe() : this->First;
  }
  void Report(std::vector<std::string>& messages) const
  {
    if (!this->First.empty())
    {
      messages.push_back(
        this->First + (this->Others > 0 ? " So it is with " + std::to_string(this->Others) + " more." : ""));
    }
  }

private:
  std::string First;
  int Others = 0;
};

/// Returns the surface of a face without rectangular trims; null if it has none.
Handle(StepGeom_Surface) GetBasisOfFace(const Handle(StepShape_FaceSurface) & face);

/// Returns true if no edge bounds the face: it is the whole surface.
bool IsWithoutEdges(const Handle(StepShape_FaceSurface) & face);

/// Reads the point of a vertex, in the unit of the file. Returns false if it is not a point in space.
bool GetPoint(const Handle(StepShape_Vertex) & vertex, gp_Pnt& position);

/// Reports faces that are a whole torus whose minor radius exceeds the major one. It crosses itself, and
/// OpenCASCADE takes all of it, whatever DEGENERATE_TOROIDAL_SURFACE selects.
void CheckSpindleTori(const ModelEntities& entities, std::vector<std::string>& defects);

/// Reports cones whose VERTEX_LOOP is not their apex: it is the only other statement of the cone's size on
/// this side. `unit` and `angle` are the file's units in mm and radians.
void CheckApexes(const ModelEntities& entities, double unit, double angle, const EntityFilter& matters,
  std::vector<std::string>& defects);

/// Reports edges on circles and ellipses between two different points that are closer to each other than
/// OpenCASCADE's tolerance, which takes the whole curve. `unit` is the file's length unit in mm. It takes the
/// whole curve, too, where the arc is that short relative to its radius, however far the points are apart,
/// which is a defect.
void CheckShortArcs(const ModelEntities& entities, double unit, std::vector<std::string>& messages,
  std::vector<std::string>& defects);

/// Reports the first edge for which `matters` returns true on a composite curve, of which OpenCASCADE makes
/// nothing, and the number of others.
void CheckCompositeEdges(
  const ModelEntities& entities, const EntityFilter& matters, std::vector<std::string>& messages);

/// Returns a sentence if loops that cover `box` in the parameters lead beyond the rectangular trimmed surface
/// that the face is on, of which the basis surface is taken; else an empty text.
std::string DescribeOverstep(const DraftFace& face, const NativeBox& box);
}

#endif
