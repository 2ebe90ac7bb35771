"""STEP files of products made of boxes: nested, in several units, with densities; and their exact properties by hand.

A Part is a box, or several, in a unit of its own, with a density as the file states it, or none. An Assembly has uses of parts and of
other assemblies, each with a place. expand() lists the boxes of all instances in mm with their density, and get_properties() what follows
from them: volumes, first moments and inertia of boxes are formulas.
"""
import os
import sys
from fractions import Fraction

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Examples", "Certified"))
from part21 import HEADER, IDENTITY, Frame, Part21  # noqa: E402
from polyhedra import make_box, write_polyhedron  # noqa: E402

MILLIMETRES = {"mm": Fraction(1), "inch": Fraction("25.4"), "m": Fraction(1000)}
# kg/m^3 of a unit of density, and how the file writes it: mass unit with exponent, length unit with exponent.
DENSITY_UNITS = {
    "kg/m^3": (Fraction(1), "(MASS_UNIT()NAMED_UNIT(*)SI_UNIT(.KILO.,.GRAM.))", "(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT($,.METRE.))"),
    "g/cm^3": (Fraction(1000), "(MASS_UNIT()NAMED_UNIT(*)SI_UNIT($,.GRAM.))", "(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.CENTI.,.METRE.))"),
}


class Part:
    def __init__(self, name, boxes, density=None, density_unit="kg/m^3", unit="mm", validation=None, polyhedra=(), material=None):
        """boxes: (corner, size) in the unit; density: a decimal as text; validation: (volume, area, centroid) in the unit, as texts;
        polyhedra: more solids, points in the unit and faces as make_prism() has them, which expand() does not know; material: its name."""
        self.polyhedra, self.material = polyhedra, material
        self.name, self.boxes, self.unit = name, boxes, unit
        self.density, self.density_unit, self.validation = density, density_unit, validation

    def get_density(self):
        return None if self.density is None else Fraction(self.density) * DENSITY_UNITS[self.density_unit][0]


class Assembly:
    def __init__(self, name, uses, unit="mm", validation=None, material=None):
        """uses: (node, shift in the unit, rotation or None); validation and material: as of a part."""
        self.name, self.uses, self.unit, self.validation, self.material = name, uses, unit, validation, material


class Writer(Part21):
    def __init__(self):
        super().__init__()
        self.application = self.add("APPLICATION_CONTEXT('automotive design')")
        self.add(f"APPLICATION_PROTOCOL_DEFINITION('international standard','automotive_design',2000,{self.application})")
        self.done = {}

    def add_node(self, node):
        """Product definition, shape, origin and context of a part or an assembly, each written once."""
        if id(node) not in self.done:
            self.done[id(node)] = self._add_part(node) if isinstance(node, Part) else self._add_assembly(node)
        return self.done[id(node)]

    def _add_part(self, part):
        context = self._add_context(part.unit)
        origin = self._add_origin()
        self.solids = []
        # Geometry is shared within a part only.
        kept, self.known = self.known, {}
        for corner, size in part.boxes:
            points, faces = make_box(*[Fraction(x) for x in size], tuple(Fraction(x) for x in corner))
            self.solid(write_polyhedron(self, points, faces))
        for points, faces in part.polyhedra:
            self.solid(write_polyhedron(self, points, faces))
        self.known = kept
        items = ",".join([origin] + self.solids)
        shape = self.add(f"ADVANCED_BREP_SHAPE_REPRESENTATION('{part.name}',({items}),{context})")
        definition = self._add_product(part.name, self.application, shape)
        if part.density is not None:
            self._add_density(part, definition, context)
        self._add_statements(part, definition, context)
        return definition, shape, origin, context

    def _add_product(self, name, application, shape, identifier=None):
        """A product of its own, also next to one with the same name."""
        return super()._add_product(name, application, shape, identifier or len(self.done) + 1)

    def _add_density(self, part, definition, context):
        _, mass, length = DENSITY_UNITS[part.density_unit]
        elements = self.add(f"DERIVED_UNIT_ELEMENT({self.add(mass)},1.)"), self.add(f"DERIVED_UNIT_ELEMENT({self.add(length)},-3.)")
        unit = self.add(f"DERIVED_UNIT(({','.join(elements)}))")
        item = self.add(f"MEASURE_REPRESENTATION_ITEM('density measure',POSITIVE_RATIO_MEASURE({part.density}),{unit})")
        self._add_property("'material property','density'", definition, f"REPRESENTATION('{part.name}',({item}),{context})")

    def _add_property(self, names, definition, representation):
        described = self.add(f"PROPERTY_DEFINITION({names},{definition})")
        self.add(f"PROPERTY_DEFINITION_REPRESENTATION({described},{self.add(representation)})")

    def _add_statements(self, node, definition, context):
        if node.validation:
            self._add_validation(node, definition, context)
        if node.material is not None:
            item = self.add(f"DESCRIPTIVE_REPRESENTATION_ITEM('{node.material}','')")
            self._add_property("'material property','material name'", definition, f"REPRESENTATION('material name',({item}),{context})")

    def _add_validation(self, part, definition, context):
        volume, area, centroid = part.validation
        length = next(line for line in self.lines if "LENGTH_UNIT()" in line and ("CONVERSION" in line) == (part.unit == "inch") and
                      (part.unit == "inch" or (".MILLI." in line) == (part.unit == "mm")) and ".CENTI." not in line)
        shape = next(f"#{k}" for k, line in enumerate(self.lines, 1) if line == f"PRODUCT_DEFINITION_SHAPE('','',{definition})")
        for kind, value, exponent in (("volume", volume, 3), ("surface area", area, 2)):
            if value is not None:
                unit = self.add(f"DERIVED_UNIT(({self.add(f'DERIVED_UNIT_ELEMENT({self.known[length]},{exponent}.)')}))")
                word = "VOLUME" if exponent == 3 else "AREA"
                item = self.add(f"MEASURE_REPRESENTATION_ITEM('{kind} measure',{word}_MEASURE({value}),{unit})")
                self._add_property("'geometric validation property',''", shape, f"REPRESENTATION('{kind}',({item}),{context})")
        if centroid is not None:
            point = self.add(f"CARTESIAN_POINT('centre point',({','.join(centroid)}))")
            self._add_property("'geometric validation property',''", shape, f"REPRESENTATION('centroid',({point}),{context})")

    def _add_assembly(self, assembly):
        context = self._add_context(assembly.unit)
        origin = self._add_origin()
        children = [self.add_node(node) for node, _, _ in assembly.uses]
        places = []
        for _, shift, turn in assembly.uses:
            self.frame = Frame(1, turn or IDENTITY, tuple(Fraction(x) for x in shift))
            places.append(self.axes((0, 0, 0), (0, 0, 1), (1, 0, 0)))
        self.frame = Frame()
        whole = self.add(f"SHAPE_REPRESENTATION('{assembly.name}',({','.join([origin] + places)}),{context})")
        definition = self._add_product(assembly.name, self.application, whole)
        for k, (place, child, (node, _, _)) in enumerate(zip(places, children, assembly.uses), 1):
            use = self.add(f"NEXT_ASSEMBLY_USAGE_OCCURRENCE('{assembly.name}-{k}','{node.name}-{k}','',{definition},{child[0]},$)")
            described = self.add(f"PRODUCT_DEFINITION_SHAPE('placement','',{use})")
            moved = self.add(f"ITEM_DEFINED_TRANSFORMATION('{k}','',{child[2]},{place})")
            relation = self.add(f"(REPRESENTATION_RELATIONSHIP('','',{child[1]},{whole})"
                                f"REPRESENTATION_RELATIONSHIP_WITH_TRANSFORMATION({moved})SHAPE_REPRESENTATION_RELATIONSHIP())")
            self.add(f"CONTEXT_DEPENDENT_SHAPE_REPRESENTATION({relation},{described})")
        self._add_statements(assembly, definition, context)
        return definition, whole, origin, context


def write_product(path, root, *more):
    """`more` are products next to the first one, without an assembly of them all."""
    writer = Writer()
    for node in (root, *more):
        writer.add_node(node)
    body = "".join(f"#{k}={line};\n" for k, line in enumerate(writer.lines, 1))
    with open(path, "w", encoding="ascii") as file:
        file.write(HEADER.format(name=root.name, description="product of boxes") + body + "ENDSEC;\nEND-ISO-10303-21;\n")
    return path


def expand(node, frame=None):
    """(name, density or None, corners low and high as placed) of every box, in mm; rotations are by right angles."""
    turn, shift = frame or (IDENTITY, (Fraction(0),) * 3)
    scale = MILLIMETRES[node.unit]
    place = lambda p: tuple(sum(r * x for r, x in zip(row, p)) + s for row, s in zip(turn, shift))  # noqa: E731
    if isinstance(node, Part):
        boxes = []
        for corner, size in node.boxes:
            low = place([scale * Fraction(x) for x in corner])
            high = place([scale * (Fraction(x) + Fraction(d)) for x, d in zip(corner, size)])
            boxes.append((node.name, node.get_density(), tuple(map(min, low, high)), tuple(map(max, low, high))))
        return boxes
    result = []
    for child, moved, rotation in node.uses:
        rotation = rotation or IDENTITY
        product = tuple(tuple(sum(turn[i][k] * rotation[k][j] for k in range(3)) for j in range(3)) for i in range(3))
        result += expand(child, (product, place([scale * Fraction(x) for x in moved])))
    return result


def get_properties(boxes, weights=None):
    """Volume (or mass, with weights), centre, and inertia about a point as a function, of boxes (name, density, low, high)."""
    weights = weights or [Fraction(1)] * len(boxes)
    masses = [w * (h[0] - l[0]) * (h[1] - l[1]) * (h[2] - l[2]) for w, (_, _, l, h) in zip(weights, boxes)]
    middles = [tuple((a + b) / 2 for a, b in zip(low, high)) for _, _, low, high in boxes]
    total = sum(masses)
    center = tuple(sum(m * c[i] for m, c in zip(masses, middles)) / total for i in range(3))

    def get_inertia(about):
        second = [[Fraction(0)] * 3 for _ in range(3)]
        for m, c, (_, _, low, high) in zip(masses, middles, boxes):
            for i in range(3):
                for j in range(3):
                    second[i][j] += m * (c[i] - about[i]) * (c[j] - about[j]) + (m * (high[i] - low[i]) ** 2 / 12 if i == j else 0)
        trace = sum(second[i][i] for i in range(3))
        return [[(trace if i == j else 0) - second[i][j] for j in range(3)] for i in range(3)]
    return total, center, get_inertia
