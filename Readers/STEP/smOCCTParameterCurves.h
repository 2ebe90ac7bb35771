/**
 * @file smOCCTParameterCurves.h
 * @brief Parameter curves of a file that contradict the curves of their edges
 */
#ifndef smOCCTParameterCurves_h
#define smOCCTParameterCurves_h

#include "smOCCTDamage.h"

#include <StepData_StepModel.hxx>

#include <string>
#include <vector>

namespace sm
{
/**
 * Reports parameter curves (PCURVE) that lie elsewhere on their surface than the three-dimensional curve of
 * the same edge, by more than 1e-3 of the size of what the file's edges enclose. The three-dimensional curve
 * is what the reader takes. It is a defect where the file prefers the parameter curve (master_representation)
 * and the distance exceeds 1e-2 of the size, else a message. `unit` and `angle` are the file's units of
 * lengths in mm and of angles in radians; parameter curves may have radians all the same, as some systems
 * write them.
 *
 * Examined are curves on planes, cylinders, cones, spheres, tori and splines, at some points of each edge for
 * which `matters` returns true. Call it when faces with damaged entities have been removed from their shells.
 */
void CheckParameterCurves(const ModelEntities& entities, double unit, double angle,
  const EntityFilter& matters, std::vector<std::string>& messages, std::vector<std::string>& defects);
}

#endif
