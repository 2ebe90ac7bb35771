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
/// Entity numbers and names of solids, shells, faces and edges; colours of shapes and their parts; which faces the
/// file bounds by edges, and how many faces of a shell are missing: `lost` and those without a shape.
void FillTable(const Handle(XSControl_WorkSession) & session, const Handle(TDocStd_Document) & document,
  const LostFaces& lost, ShapeTable& table);

/// "face #12" for a shape that the transfer has just made of an entity of this number, else "a shape".
std::string GetShapeLabel(const Handle(XSControl_WorkSession) & session, const TopoDS_Shape& shape);

/// Marks the solids and shells that the operators place (ShapeInfo::Misplaced); false when one of them places
/// something else, and any shape may be meant.
bool MarkMisplaced(const Handle(XSControl_WorkSession) & session,
  const std::vector<Handle(Standard_Transient)>& operators, ShapeTable& table);

std::string GetLabelName(const TDF_Label& label);
std::string GetLabelLayer(const Handle(TDocStd_Document) & document, const TDF_Label& label);
/// sRGB in [0,1]; negative when there is none.
Vector3 GetLabelColor(const Handle(TDocStd_Document) & document, const TDF_Label& label);
/// Name of the material, empty for none.
std::string GetLabelMaterial(const TDF_Label& label);
/// Volume (mm^3) and area (mm^2) the originating system wrote; left alone when it wrote none.
void GetLabelProperties(const TDF_Label& label, double& volume, double& area);
}

#endif
