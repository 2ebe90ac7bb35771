/**
 * @file smOCCTTable.h
 * @brief Names, colours, materials, properties and entity numbers that a STEP file gives its shapes
 */
#ifndef smOCCTTable_h
#define smOCCTTable_h

#include "smOCCTBody.h"
#include "smOCCTDamage.h"

#include <TDF_Label.hxx>
#include <TDocStd_Document.hxx>
#include <XSControl_WorkSession.hxx>

#include <string>

namespace sm
{
/// Fills the table: entity numbers and names of solids, shells, faces and edges; colours; faces for which the
/// file has bounds; and the numbers of missing faces of shells, which are those in `lost` and those without a
/// shape.
void FillTable(const Handle(XSControl_WorkSession) & session, const Handle(TDocStd_Document) & document,
  const LostFaces& lost, ShapeTable& table);

/// Returns "face #12" for a shape that the transfer has just made of entity #12, else "a shape".
std::string GetShapeLabel(const Handle(XSControl_WorkSession) & session, const TopoDS_Shape& shape);

/// Marks the solids and shells that the operators place (ShapeInfo::Misplaced). Returns false if an operator
/// places something else, so that any shape may be affected.
bool MarkMisplaced(const Handle(XSControl_WorkSession) & session,
  const std::vector<Handle(Standard_Transient)>& operators, ShapeTable& table);

std::string GetLabelName(const TDF_Label& label);
std::string GetLabelLayer(const Handle(TDocStd_Document) & document, const TDF_Label& label);
/// Returns the colour of a label, sRGB in [0,1]; negative if there is none.
Vector3 GetLabelColor(const Handle(TDocStd_Document) & document, const TDF_Label& label);
/// Returns the name of the material; empty if there is none.
std::string GetLabelMaterial(const TDF_Label& label);
/// Gets the volume (mm^3) and area (mm^2) that the CAD system wrote; if it wrote none, they are not changed.
void GetLabelProperties(const TDF_Label& label, double& volume, double& area);
}

#endif
