/**
 * @file smOCCTDamage.h
 * @brief Removes faces with damaged entities from their shells before the transfer
 */
#ifndef smOCCTDamage_h
#define smOCCTDamage_h

#include "smOCCTEntities.h"

#include <StepShape_ConnectedFaceSet.hxx>
#include <XSControl_WorkSession.hxx>

#include <functional>
#include <string>
#include <unordered_map>
#include <vector>

namespace sm
{
/// Number of faces that each entity of the file (a shell) lost.
using LostFaces = std::unordered_map<const Standard_Transient*, int>;

/// Returns the reason why OpenCASCADE cannot process the entity with this number, which places bodies or is a
/// part of them, although its parser has read it; empty if it can. A null function states that it can process
/// all.
using EntityPeril = std::function<std::string(int number, bool isPlacing)>;

/**
 * Removes every face that refers to a damaged entity, directly or not, from its shell, adds a message, and
 * counts it in `lost`. An entity is damaged if it has references that OpenCASCADE's parser reported as
 * unresolved, or if `peril` returns a reason. OpenCASCADE 7.6 does not survive all of them. Annotations for
 * which `matters` returns false are ignored. Returns an empty string, or the reason why the file cannot be
 * transferred at all. Call it between parsing and transfer.
 */
std::string DropDamagedFaces(const Handle(XSControl_WorkSession) & session, const ModelEntities& entities,
  const EntityFilter& matters, const EntityPeril& peril, std::vector<std::string>& messages, LostFaces& lost);

/// Returns true if the list of faces of a shell can be accessed.
bool HasFaceList(Handle(StepShape_ConnectedFaceSet) shell);

/// States if entities of colours or of properties (volumes, materials) have unresolved references, so that
/// OpenCASCADE must not read them.
struct Attributes
{
  bool Colors = false;
  bool Properties = false;
};
Attributes FindDamagedAttributes(const ModelEntities& entities);
}

#endif
