/**
 * @file smOCCTDamage.h
 * @brief Faces with damaged entities, taken out of their shells before the transfer
 */
#ifndef smOCCTDamage_h
#define smOCCTDamage_h

#include <StepData_StepModel.hxx>
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

/// True if geometry or structure of a body depends on the entity with this number in the file.
using EntityFilter = std::function<bool(int)>;

/// Why OpenCASCADE cannot follow the entity with this number, which places bodies or is a part of them, though its parser has read it;
/// empty when it can.
using EntityPeril = std::function<std::string(int number, bool isPlacing)>;

/**
 * OpenCASCADE 7.6 follows references that its own parser reported as unresolved, and crashes; so it does at a `peril`. This takes every
 * face that leads to such an entity out of its shell, says which and counts them in `lost`. Annotations that do not `matter` are
 * passed over. Returns an empty string, or why the file cannot be transferred at all. Call between parsing and transfer.
 */
std::string DropDamagedFaces(const Handle(XSControl_WorkSession) & session,
  const Handle(StepData_StepModel) & model, const EntityFilter& matters, const EntityPeril& peril,
  std::vector<std::string>& messages, LostFaces& lost);

/// True if the shell has faces to ask for. An oriented shell asks the one that it turns, which a damaged file need not have: OpenCASCADE
/// crashes then.
bool HasFaceList(Handle(StepShape_ConnectedFaceSet) shell);

/// Colours or properties (volumes, materials) whose entities have dangling references: not to be asked for.
struct Attributes
{
  bool Colors = false;
  bool Properties = false;
};
Attributes FindDamagedAttributes(const Handle(StepData_StepModel) & model);
}

#endif
