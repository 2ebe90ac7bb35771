#include "smSTEPSchema.h"

#include <algorithm>
#include <vector>

namespace sm
{
namespace
{
using namespace STEPRole;

// ISO 10303-42 (geometry and topology), 43 (representations), 41 (products, units), 44 (assemblies).
const STEPEntityType Types[] = {
  // Solids
  { "MANIFOLD_SOLID_BREP", Solid, ".H", "H" },
  { "BREP_WITH_VOIDS", Solid, ".H(H)", "(H)" },
  { "FACETED_BREP", Solid, ".H", "" },
  { "BREP_2D", WireModel, nullptr, nullptr },
  // Solids without faces: constructive geometry, primitives, swept solids and volumes of ISO 10303-42
  { "CSG_SOLID", OtherSolid, nullptr, nullptr },
  { "BOOLEAN_RESULT", OtherSolid, nullptr, nullptr },
  { "BOOLEAN_CLIPPING_RESULT", OtherSolid, nullptr, nullptr },
  { "SOLID_REPLICA", OtherSolid, nullptr, nullptr },
  { "BLOCK", OtherSolid, nullptr, nullptr },
  { "RIGHT_ANGULAR_WEDGE", OtherSolid, nullptr, nullptr },
  { "SPHERE", OtherSolid, nullptr, nullptr },
  { "TORUS", OtherSolid, nullptr, nullptr },
  { "ELLIPSOID", OtherSolid, nullptr, nullptr },
  { "CYCLIDE_SEGMENT_SOLID", OtherSolid, nullptr, nullptr },
  { "RIGHT_CIRCULAR_CONE", OtherSolid, nullptr, nullptr },
  { "RIGHT_CIRCULAR_CYLINDER", OtherSolid, nullptr, nullptr },
  { "ECCENTRIC_CONE", OtherSolid, nullptr, nullptr },
  { "FACETED_PRIMITIVE", OtherSolid, nullptr, nullptr },
  { "TETRAHEDRON", OtherSolid, nullptr, nullptr },
  { "RECTANGULAR_PYRAMID", OtherSolid, nullptr, nullptr },
  { "CONVEX_HEXAHEDRON", OtherSolid, nullptr, nullptr },
  { "HALF_SPACE_SOLID", OtherSolid, nullptr, nullptr },
  { "BOXED_HALF_SPACE", OtherSolid, nullptr, nullptr },
  { "SWEPT_AREA_SOLID", OtherSolid, nullptr, nullptr },
  { "EXTRUDED_AREA_SOLID", OtherSolid, nullptr, nullptr },
  { "REVOLVED_AREA_SOLID", OtherSolid, nullptr, nullptr },
  { "SURFACE_CURVE_SWEPT_AREA_SOLID", OtherSolid, nullptr, nullptr },
  { "SWEPT_FACE_SOLID", OtherSolid, nullptr, nullptr },
  { "EXTRUDED_FACE_SOLID", OtherSolid, nullptr, nullptr },
  { "REVOLVED_FACE_SOLID", OtherSolid, nullptr, nullptr },
  { "SURFACE_CURVE_SWEPT_FACE_SOLID", OtherSolid, nullptr, nullptr },
  { "EXTRUDED_FACE_SOLID_WITH_DRAFT_ANGLE", OtherSolid, nullptr, nullptr },
  { "EXTRUDED_FACE_SOLID_WITH_MULTIPLE_DRAFT_ANGLES", OtherSolid, nullptr, nullptr },
  { "EXTRUDED_FACE_SOLID_WITH_TRIM_CONDITIONS", OtherSolid, nullptr, nullptr },
  { "REVOLVED_FACE_SOLID_WITH_TRIM_CONDITIONS", OtherSolid, nullptr, nullptr },
  { "SWEPT_DISK_SOLID", OtherSolid, nullptr, nullptr },
  { "VOLUME", OtherSolid, nullptr, nullptr },
  { "BLOCK_VOLUME", OtherSolid, nullptr, nullptr },
  { "WEDGE_VOLUME", OtherSolid, nullptr, nullptr },
  { "PYRAMID_VOLUME", OtherSolid, nullptr, nullptr },
  { "TETRAHEDRON_VOLUME", OtherSolid, nullptr, nullptr },
  { "HEXAHEDRON_VOLUME", OtherSolid, nullptr, nullptr },
  { "SPHERICAL_VOLUME", OtherSolid, nullptr, nullptr },
  { "CYLINDRICAL_VOLUME", OtherSolid, nullptr, nullptr },
  { "ECCENTRIC_CONICAL_VOLUME", OtherSolid, nullptr, nullptr },
  { "TOROIDAL_VOLUME", OtherSolid, nullptr, nullptr },
  { "ELLIPSOID_VOLUME", OtherSolid, nullptr, nullptr },
  { "B_SPLINE_VOLUME", OtherSolid, nullptr, nullptr },
  { "B_SPLINE_VOLUME_WITH_KNOTS", OtherSolid, nullptr, nullptr },
  { "BEZIER_VOLUME", OtherSolid, nullptr, nullptr },
  { "UNIFORM_VOLUME", OtherSolid, nullptr, nullptr },
  { "QUASI_UNIFORM_VOLUME", OtherSolid, nullptr, nullptr },
  { "RATIONAL_B_SPLINE_VOLUME", OtherSolid, nullptr, nullptr },
  { "TRIMMED_VOLUME", OtherSolid, nullptr, nullptr },
  // Construction history of ISO 10303-111
  { "SCULPTURED_SOLID", OtherSolid, nullptr, nullptr },
  { "MODIFIED_SOLID", OtherSolid, nullptr, nullptr },
  { "MODIFIED_SOLID_WITH_PLACED_CONFIGURATION", OtherSolid, nullptr, nullptr },
  { "THICKENED_FACE_SOLID", OtherSolid, nullptr, nullptr },
  { "SHELLED_SOLID", OtherSolid, nullptr, nullptr },
  { "COMPLEX_SHELLED_SOLID", OtherSolid, nullptr, nullptr },
  { "DOUBLE_OFFSET_SHELLED_SOLID", OtherSolid, nullptr, nullptr },
  { "EDGE_BLENDED_SOLID", OtherSolid, nullptr, nullptr },
  { "TRACK_BLENDED_SOLID", OtherSolid, nullptr, nullptr },
  { "TRACK_BLENDED_SOLID_WITH_END_CONDITIONS", OtherSolid, nullptr, nullptr },
  { "SOLID_WITH_CONSTANT_RADIUS_EDGE_BLEND", OtherSolid, nullptr, nullptr },
  { "SOLID_WITH_VARIABLE_RADIUS_EDGE_BLEND", OtherSolid, nullptr, nullptr },
  { "SOLID_WITH_CHAMFERED_EDGES", OtherSolid, nullptr, nullptr },
  { "SOLID_WITH_ANGLE_BASED_CHAMFER", OtherSolid, nullptr, nullptr },
  { "SOLID_WITH_SINGLE_OFFSET_CHAMFER", OtherSolid, nullptr, nullptr },
  { "SOLID_WITH_DOUBLE_OFFSET_CHAMFER", OtherSolid, nullptr, nullptr },
  { "SOLID_WITH_DEPRESSION", OtherSolid, nullptr, nullptr },
  { "SOLID_WITH_THROUGH_DEPRESSION", OtherSolid, nullptr, nullptr },
  { "SOLID_WITH_HOLE", OtherSolid, nullptr, nullptr },
  { "SOLID_WITH_STEPPED_ROUND_HOLE", OtherSolid, nullptr, nullptr },
  { "SOLID_WITH_STEPPED_ROUND_HOLE_AND_CONICAL_TRANSITIONS", OtherSolid, nullptr, nullptr },
  { "SOLID_WITH_FLAT_BOTTOM_ROUND_HOLE", OtherSolid, nullptr, nullptr },
  { "SOLID_WITH_CONICAL_BOTTOM_ROUND_HOLE", OtherSolid, nullptr, nullptr },
  { "SOLID_WITH_SPHERICAL_BOTTOM_ROUND_HOLE", OtherSolid, nullptr, nullptr },
  { "SOLID_WITH_POCKET", OtherSolid, nullptr, nullptr },
  { "SOLID_WITH_GENERAL_POCKET", OtherSolid, nullptr, nullptr },
  { "SOLID_WITH_RECTANGULAR_POCKET", OtherSolid, nullptr, nullptr },
  { "SOLID_WITH_CIRCULAR_POCKET", OtherSolid, nullptr, nullptr },
  { "SOLID_WITH_SLOT", OtherSolid, nullptr, nullptr },
  { "SOLID_WITH_STRAIGHT_SLOT", OtherSolid, nullptr, nullptr },
  { "SOLID_WITH_CURVED_SLOT", OtherSolid, nullptr, nullptr },
  { "SOLID_WITH_TEE_SECTION_SLOT", OtherSolid, nullptr, nullptr },
  { "SOLID_WITH_TRAPEZOIDAL_SECTION_SLOT", OtherSolid, nullptr, nullptr },
  { "SOLID_WITH_GROOVE", OtherSolid, nullptr, nullptr },
  { "SOLID_WITH_PROTRUSION", OtherSolid, nullptr, nullptr },
  { "SOLID_WITH_GENERAL_PROTRUSION", OtherSolid, nullptr, nullptr },
  { "SOLID_WITH_CIRCULAR_PROTRUSION", OtherSolid, nullptr, nullptr },
  { "SOLID_WITH_RECTANGULAR_PROTRUSION", OtherSolid, nullptr, nullptr },
  { "SOLID_WITH_SHAPE_ELEMENT_PATTERN", OtherSolid, nullptr, nullptr },
  { "SOLID_WITH_CIRCULAR_PATTERN", OtherSolid, nullptr, nullptr },
  { "SOLID_WITH_RECTANGULAR_PATTERN", OtherSolid, nullptr, nullptr },
  { "SOLID_WITH_INCOMPLETE_CIRCULAR_PATTERN", OtherSolid, nullptr, nullptr },
  { "SOLID_WITH_INCOMPLETE_RECTANGULAR_PATTERN", OtherSolid, nullptr, nullptr },
  // Triangles
  { "TESSELLATED_SOLID", Tessellated, nullptr, nullptr },
  { "TESSELLATED_SHELL", Tessellated, nullptr, nullptr },
  { "TESSELLATED_GEOMETRIC_SET", Tessellated, nullptr, nullptr },
  { "TRIANGULATED_FACE", Tessellated, nullptr, nullptr },
  { "COMPLEX_TRIANGULATED_FACE", Tessellated, nullptr, nullptr },
  { "CUBIC_BEZIER_TRIANGULATED_FACE", Tessellated, nullptr, nullptr },
  { "TRIANGULATED_SURFACE_SET", Tessellated, nullptr, nullptr },
  { "COMPLEX_TRIANGULATED_SURFACE_SET", Tessellated, nullptr, nullptr },
  // Models of surfaces and wires
  { "SHELL_BASED_SURFACE_MODEL", SurfaceModel, ".(H)", "(H)" },
  { "FACE_BASED_SURFACE_MODEL", SurfaceModel, ".(H)", "(H)" },
  { "SHELL_BASED_WIREFRAME_MODEL", WireModel, nullptr, nullptr },
  { "EDGE_BASED_WIREFRAME_MODEL", WireModel, nullptr, nullptr },
  { "GEOMETRIC_SET", GeometricSet, nullptr, nullptr },
  { "GEOMETRIC_CURVE_SET", GeometricSet, nullptr, nullptr },
  // Topology
  { "CLOSED_SHELL", Shell, ".(F)", "" },
  { "OPEN_SHELL", Shell, ".(F)", "" },
  { "SURFACED_OPEN_SHELL", Shell, ".(F)", "" },
  { "CONNECTED_FACE_SET", Shell, ".(F)", "(F)" },
  { "CONNECTED_FACE_SUB_SET", Shell, ".(F)H", "H" },
  { "ORIENTED_CLOSED_SHELL", Shell, "..Hb", "Hb" },
  { "ORIENTED_OPEN_SHELL", Shell, "..Hb", "Hb" },
  { "ADVANCED_FACE", Face, ".(B)Sb", "" },
  { "FACE_SURFACE", Face, ".(B)Sb", "Sb" },
  { "ORIENTED_FACE", Face, "..Fb", "Fb" },
  { "SUBFACE", Face, ".(B)F", "F" },
  { "FACE", Face, ".(B)", "(B)" },
  { "FACE_BOUND", Bound, ".Lb", "Lb" },
  { "FACE_OUTER_BOUND", Bound, ".Lb", "" },
  { "EDGE_LOOP", Loop, ".(O)", "" },
  { "PATH", Loop, ".(O)", "(O)" },
  { "VERTEX_LOOP", Loop, ".V", "V" },
  { "POLY_LOOP", Loop, ".(P)", "(P)" },
  { "ORIENTED_EDGE", OrientedEdge, "...Eb", "Eb" },
  { "EDGE_CURVE", Edge, ".VVCb", "Cb" },
  { "SUBEDGE", Edge, ".VVE", "E" },
  { "EDGE", Edge, ".VV", "VV" },
  { "VERTEX_POINT", Vertex, ".P", "P" },
  { "VERTEX", Vertex, ".", "" },
  // Points and placements
  { "CARTESIAN_POINT", Point, ".c", "c" },
  { "POINT_ON_CURVE", Point, ".Cn", "Cn" },
  { "POINT_ON_SURFACE", Point, ".Snn", "Snn" },
  { "DEGENERATE_PCURVE", Point | Pcurve, ".SR", "SR" },
  { "EVALUATED_DEGENERATE_PCURVE", Point | Pcurve, ".SRP", "P" },
  { "DIRECTION", Direction, ".c", "c" },
  { "VECTOR", Vector, ".Dz", "Dz" },
  { "AXIS1_PLACEMENT", Placement, ".P?D", "?D" },
  { "AXIS2_PLACEMENT_2D", Placement, ".P?D", "?D" },
  { "AXIS2_PLACEMENT_3D", Placement, ".P?D?D", "?D?D" },
  { "PLACEMENT", Placement, ".P", "P" },
  // Curves
  { "LINE", Curve, ".PT", "PT" },
  { "CIRCLE", Curve, ".Ap", "p" },
  { "ELLIPSE", Curve, ".App", "pp" },
  { "HYPERBOLA", Curve, ".App", "pp" },
  { "PARABOLA", Curve, ".An", "n" },
  { "CONIC", Curve, ".A", "A" },
  { "POLYLINE", Curve, ".(P)", "(P)" },
  { "TRIMMED_CURVE", Curve, ".C(.)(.)b.", "C(.)(.)b." },
  { "COMPOSITE_CURVE", Curve, ".(G).", "(G)." },
  { "COMPOSITE_CURVE_ON_SURFACE", Curve, ".(G).", "" },
  { "BOUNDARY_CURVE", Curve, ".(G).", "" },
  { "OUTER_BOUNDARY_CURVE", Curve, ".(G).", "" },
  { "COMPOSITE_CURVE_SEGMENT", CurveSegment, ".bC", ".bC" },
  { "REPARAMETRISED_COMPOSITE_CURVE_SEGMENT", CurveSegment, ".bCn", "n" },
  { "B_SPLINE_CURVE", Curve | SplineCurve, ".i(P)...", "i(P)..." },
  { "B_SPLINE_CURVE_WITH_KNOTS", Curve | SplineCurve, ".i(P)...(i)(n).", "(i)(n)." },
  { "RATIONAL_B_SPLINE_CURVE", Curve, nullptr, "(p)" },
  { "BEZIER_CURVE", Curve | SplineCurve, ".i(P)...", "" },
  { "UNIFORM_CURVE", Curve | SplineCurve, ".i(P)...", "" },
  { "QUASI_UNIFORM_CURVE", Curve | SplineCurve, ".i(P)...", "" },
  { "OFFSET_CURVE_3D", Curve, ".Cn.D", "Cn.D" },
  { "OFFSET_CURVE_2D", Curve, ".Cn.", "Cn." },
  { "CURVE_REPLICA", Curve, ".CZ", "CZ" },
  { "SURFACE_CURVE", Curve, ".C(Q).", "C(Q)." },
  { "SEAM_CURVE", Curve, ".C(Q).", "" },
  { "INTERSECTION_CURVE", Curve, ".C(Q).", "" },
  { "BOUNDED_SURFACE_CURVE", Curve, ".C(Q).", "" },
  { "PCURVE", Curve | Pcurve, ".SR", "SR" },
  { "BOUNDED_PCURVE", Curve | Pcurve, ".SR", "" },
  { "BOUNDED_CURVE", Curve, nullptr, "" },
  { "CURVE", Curve, nullptr, "" },
  { "CLOTHOID", Curve, nullptr, nullptr },
  { "CIRCULAR_INVOLUTE", Curve, nullptr, nullptr },
  { "DEFINITIONAL_REPRESENTATION", Representation | DefinitionalRepresentation, ".(C).", nullptr },
  // Surfaces
  { "PLANE", Surface, ".A", "" },
  { "CYLINDRICAL_SURFACE", Surface, ".Ap", "p" },
  { "CONICAL_SURFACE", Surface, ".Azn", "zn" },
  { "SPHERICAL_SURFACE", Surface, ".Ap", "p" },
  // Some CAD systems write a self-intersecting (lemon) torus with a negative major radius, against the
  // standard.
  { "TOROIDAL_SURFACE", Surface, ".Anp", "np" },
  { "DEGENERATE_TOROIDAL_SURFACE", Surface, ".Anpb", "b" },
  { "ELEMENTARY_SURFACE", Surface, ".A", "A" },
  { "SURFACE_OF_LINEAR_EXTRUSION", Surface, ".CT", "T" },
  { "SURFACE_OF_REVOLUTION", Surface, ".CA", "A" },
  { "SWEPT_SURFACE", Surface, ".C", "C" },
  { "B_SPLINE_SURFACE", Surface | SplineSurface, ".ii((P))....", "ii((P))...." },
  { "B_SPLINE_SURFACE_WITH_KNOTS", Surface | SplineSurface, ".ii((P))....(i)(i)(n)(n).", "(i)(i)(n)(n)." },
  { "RATIONAL_B_SPLINE_SURFACE", Surface, nullptr, "((p))" },
  { "BEZIER_SURFACE", Surface | SplineSurface, ".ii((P))....", "" },
  { "UNIFORM_SURFACE", Surface | SplineSurface, ".ii((P))....", "" },
  { "QUASI_UNIFORM_SURFACE", Surface | SplineSurface, ".ii((P))....", "" },
  { "OFFSET_SURFACE", Surface, ".Sn.", "Sn." },
  { "RECTANGULAR_TRIMMED_SURFACE", Surface, ".Snnnnbb", "Snnnnbb" },
  { "CURVE_BOUNDED_SURFACE", Surface, ".S(C)b", "S(C)b" },
  { "RECTANGULAR_COMPOSITE_SURFACE", Surface, nullptr, nullptr },
  { "SURFACE_REPLICA", Surface, ".SZ", "SZ" },
  { "BOUNDED_SURFACE", Surface, nullptr, "" },
  { "SURFACE", Surface, nullptr, "" },
  // Representations and products; the structure is checked where it is walked.
  { "REPRESENTATION", Representation, nullptr, nullptr },
  { "SHAPE_REPRESENTATION", Representation, nullptr, nullptr },
  { "SHAPE_REPRESENTATION_WITH_PARAMETERS", Representation, nullptr, nullptr },
  { "ADVANCED_BREP_SHAPE_REPRESENTATION", Representation, nullptr, nullptr },
  { "FACETED_BREP_SHAPE_REPRESENTATION", Representation, nullptr, nullptr },
  { "MANIFOLD_SURFACE_SHAPE_REPRESENTATION", Representation, nullptr, nullptr },
  { "NON_MANIFOLD_SURFACE_SHAPE_REPRESENTATION", Representation, nullptr, nullptr },
  { "EDGE_BASED_WIREFRAME_SHAPE_REPRESENTATION", Representation, nullptr, nullptr },
  { "SHELL_BASED_WIREFRAME_SHAPE_REPRESENTATION", Representation, nullptr, nullptr },
  { "GEOMETRICALLY_BOUNDED_SURFACE_SHAPE_REPRESENTATION", Representation, nullptr, nullptr },
  { "GEOMETRICALLY_BOUNDED_WIREFRAME_SHAPE_REPRESENTATION", Representation, nullptr, nullptr },
  { "GEOMETRICALLY_BOUNDED_2D_WIREFRAME_REPRESENTATION", Representation, nullptr, nullptr },
  { "CSG_SHAPE_REPRESENTATION", Representation, nullptr, nullptr },
  { "COMPOUND_SHAPE_REPRESENTATION", Representation, nullptr, nullptr },
  { "TESSELLATED_SHAPE_REPRESENTATION", Representation, nullptr, nullptr },
  { "TOPOLOGICALLY_BOUNDED_SURFACE_SHAPE_REPRESENTATION", Representation, nullptr, nullptr },
  { "ELEMENTARY_BREP_SHAPE_REPRESENTATION", Representation, nullptr, nullptr },
  { "MANIFOLD_SUBSURFACE_SHAPE_REPRESENTATION", Representation, nullptr, nullptr },
  { "CURVE_SWEPT_SOLID_SHAPE_REPRESENTATION", Representation, nullptr, nullptr },
  { "PROCEDURAL_SHAPE_REPRESENTATION", Representation, nullptr, nullptr },
  { "PROCEDURAL_SHAPE_REPRESENTATION_SEQUENCE", Representation, nullptr, nullptr },
  { "CONSTRUCTIVE_GEOMETRY_REPRESENTATION", Representation, nullptr, nullptr },
  { "DRAUGHTING_MODEL", Representation, nullptr, nullptr },
  { "MECHANICAL_DESIGN_GEOMETRIC_PRESENTATION_REPRESENTATION", Representation, nullptr, nullptr },
  { "MECHANICAL_DESIGN_PRESENTATION_REPRESENTATION_WITH_DRAUGHTING", Representation, nullptr, nullptr },
  { "MECHANICAL_DESIGN_SHADED_PRESENTATION_REPRESENTATION", Representation, nullptr, nullptr },
  { "PRESENTATION_REPRESENTATION", Representation, nullptr, nullptr },
  { "PRESENTATION_VIEW", Representation, nullptr, nullptr },
  { "SYMBOL_REPRESENTATION", Representation, nullptr, nullptr },
  { "SHAPE_DIMENSION_REPRESENTATION", Representation, nullptr, nullptr },
  { "MAPPED_ITEM", MappedItem, nullptr, nullptr },
  { "REPRESENTATION_MAP", RepresentationMap, nullptr, nullptr },
  { "REPRESENTATION_RELATIONSHIP", Relationship, nullptr, nullptr },
  { "SHAPE_REPRESENTATION_RELATIONSHIP", Relationship | ShapeRelationship, nullptr, nullptr },
  { "REPRESENTATION_RELATIONSHIP_WITH_TRANSFORMATION", Relationship, nullptr, nullptr },
  { "ITEM_DEFINED_TRANSFORMATION", Transformation, "..AA", "..AA" },
  { "FUNCTIONALLY_DEFINED_TRANSFORMATION", Transformation, nullptr, nullptr },
  { "CARTESIAN_TRANSFORMATION_OPERATOR", Transformation, nullptr, nullptr },
  { "CARTESIAN_TRANSFORMATION_OPERATOR_2D", Transformation, nullptr, nullptr },
  { "CARTESIAN_TRANSFORMATION_OPERATOR_3D", Transformation, nullptr, nullptr },
  { "REPRESENTATION_CONTEXT", Context, nullptr, nullptr },
  { "GEOMETRIC_REPRESENTATION_CONTEXT", Context, nullptr, nullptr },
  { "PARAMETRIC_REPRESENTATION_CONTEXT", Context, nullptr, nullptr },
  { "GLOBAL_UNIT_ASSIGNED_CONTEXT", Context, nullptr, nullptr },
  { "GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT", Context, nullptr, nullptr },
  { "PRODUCT_DEFINITION", ProductDefinition, nullptr, nullptr },
  { "PRODUCT_DEFINITION_WITH_ASSOCIATED_DOCUMENTS", ProductDefinition, nullptr, nullptr },
  { "NEXT_ASSEMBLY_USAGE_OCCURRENCE", Occurrence, nullptr, nullptr },
  { "ASSEMBLY_COMPONENT_USAGE", OtherUsage, nullptr, nullptr },
  { "MAKE_FROM_USAGE_OPTION", OtherUsage, nullptr, nullptr },
  { "PRODUCT_DEFINITION_RELATIONSHIP", OtherUsage, nullptr, nullptr },
  { "PRODUCT_DEFINITION_USAGE", OtherUsage, nullptr, nullptr },
  { "PROMISSORY_USAGE_OCCURRENCE", OtherUsage, nullptr, nullptr },
  { "QUANTIFIED_ASSEMBLY_COMPONENT_USAGE", OtherUsage, nullptr, nullptr },
  { "SPECIFIED_HIGHER_USAGE_OCCURRENCE", OtherUsage, nullptr, nullptr },
  { "DOCUMENT_FILE", Document, nullptr, nullptr },
  { "DOCUMENT_PRODUCT_EQUIVALENCE", DocumentEquivalence, nullptr, nullptr },
  { "APPLIED_DOCUMENT_REFERENCE", DocumentReference, nullptr, nullptr },
  { "CC_DESIGN_SPECIFICATION_REFERENCE", DocumentReference, nullptr, nullptr },
  { "APPLIED_EXTERNAL_IDENTIFICATION_ASSIGNMENT", FileIdentification, nullptr, nullptr },
  { "PROPERTY_DEFINITION", ProductShape, nullptr, nullptr },
  { "PRODUCT_DEFINITION_SHAPE", ProductShape, nullptr, nullptr },
  { "SHAPE_DEFINITION_REPRESENTATION", ShapeDefinition, nullptr, nullptr },
  { "CONTEXT_DEPENDENT_SHAPE_REPRESENTATION", OccurrenceShape, nullptr, nullptr },
  // Units
  { "NAMED_UNIT", Unit, nullptr, nullptr },
  { "SI_UNIT", Unit, nullptr, nullptr },
  { "CONVERSION_BASED_UNIT", Unit, nullptr, nullptr },
  { "CONTEXT_DEPENDENT_UNIT", Unit, nullptr, nullptr },
  { "LENGTH_UNIT", Unit, nullptr, nullptr },
  { "PLANE_ANGLE_UNIT", Unit, nullptr, nullptr },
  { "SOLID_ANGLE_UNIT", Unit, nullptr, nullptr },
  { "MEASURE_WITH_UNIT", Measure, nullptr, nullptr },
  { "LENGTH_MEASURE_WITH_UNIT", Measure, nullptr, nullptr },
  { "PLANE_ANGLE_MEASURE_WITH_UNIT", Measure, nullptr, nullptr },
  { "MASS_MEASURE_WITH_UNIT", Measure, nullptr, nullptr },
  { "UNCERTAINTY_MEASURE_WITH_UNIT", Measure, nullptr, nullptr },
};
}

const STEPEntityType* FindSTEPEntityType(std::string_view name)
{
  static const std::vector<const STEPEntityType*> sorted = []
  {
    std::vector<const STEPEntityType*> types;
    for (const STEPEntityType& type : Types)
    {
      types.push_back(&type);
    }
    std::sort(types.begin(), types.end(),
      [](const STEPEntityType* a, const STEPEntityType* b) { return std::string_view(a->Name) < b->Name; });
    return types;
  }();
  const auto found = std::lower_bound(sorted.begin(), sorted.end(), name,
    [](const STEPEntityType* type, std::string_view value) { return type->Name < value; });
  return found != sorted.end() && name == (*found)->Name ? *found : nullptr;
}

std::uint64_t GetRoleOfLetter(char letter)
{
  switch (letter)
  {
    case 'A':
      return Placement;
    case 'B':
      return Bound;
    case 'C':
      return Curve;
    case 'D':
      return Direction;
    case 'E':
      // The second edition allows edges that are oriented edges of others.
      return Edge | OrientedEdge;
    case 'F':
      return Face;
    case 'G':
      return CurveSegment;
    case 'H':
      return Shell;
    case 'L':
      return Loop;
    case 'O':
      return OrientedEdge;
    case 'P':
      return Point;
    case 'Q':
      return Pcurve | Surface;
    case 'R':
      return Representation;
    case 'S':
      return Surface;
    case 'T':
      return Vector;
    case 'V':
      return Vertex;
    case 'Z':
      return Transformation;
    default:
      return 0;
  }
}
}
