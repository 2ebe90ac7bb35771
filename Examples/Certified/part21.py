"""Writes the text of STEP files (ISO 10303-21, AP214) with boundary representations, every number as an exact decimal."""
from fractions import Fraction
from math import gcd, lcm

HEADER = """ISO-10303-21;
HEADER;
FILE_DESCRIPTION(('{description}'),'2;1');
FILE_NAME('{name}.step','2026-01-01T00:00:00',('SolidMoments'),(''),'make_certified_set.py','','');
FILE_SCHEMA(('AUTOMOTIVE_DESIGN {{ 1 0 10303 214 1 1 1 1 }}'));
ENDSEC;
DATA;
"""
IDENTITY = ((1, 0, 0), (0, 1, 0), (0, 0, 1))


def format_number(x):
    """A rational as decimal digits, all of them."""
    x = Fraction(x)
    places = 0
    while (x * 10 ** places).denominator != 1:
        places += 1
        if places > 60:
            raise ValueError(f"{x} is not a decimal")
    digits = str(abs(int(x * 10 ** places)))
    sign = "-" if x < 0 else ""
    if places:
        digits = digits.rjust(places + 1, "0")
        return f"{sign}{digits[:-places]}.{digits[-places:]}"
    short = digits.rstrip("0")
    if len(digits) - len(short) > 5:
        return f"{sign}{short}.E{len(digits) - len(short)}"
    return f"{sign}{digits}."


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def subtract(a, b):
    return tuple(x - y for x, y in zip(a, b))


def shorten(direction):
    """Returns the same direction with the smallest whole numbers, which are exact decimals in every frame."""
    common = lcm(*(Fraction(x).denominator for x in direction))
    whole = [int(x * common) for x in direction]
    divisor = gcd(*whole)
    return tuple(Fraction(x // divisor) for x in whole)


class Frame:
    """The placement of a solid, x -> size * turn x + shift, where `turn` is a rational rotation."""

    def __init__(self, size=1, turn=IDENTITY, shift=(0, 0, 0)):
        self.size, self.turn, self.shift = Fraction(size), turn, shift
        rows = [tuple(Fraction(x) for x in row) for row in turn]
        if any(dot(rows[i], rows[j]) != (i == j) for i in range(3) for j in range(3)) or dot(cross(*rows[:2]), rows[2]) != 1:
            raise ValueError("no rotation")

    def rotate(self, d):
        return tuple(dot(row, d) for row in self.turn)

    def place(self, p):
        return tuple(self.size * x + s for x, s in zip(self.rotate(p), self.shift))


class Part21:
    """Collects entities, each written once. Points, directions and lengths are given in the frame and written after its transform."""

    def __init__(self, frame=None):
        self.frame = frame or Frame()
        self.lines = []
        self.known = {}
        self.solids = []

    def add(self, text):
        if text not in self.known:
            self.lines.append(text)
            self.known[text] = f"#{len(self.lines)}"
        return self.known[text]

    def length(self, x):
        return format_number(self.frame.size * x)

    def point(self, p):
        return self.add("CARTESIAN_POINT('',(" + ",".join(format_number(x) for x in self.frame.place(p)) + "))")

    def direction(self, d):
        return self.add("DIRECTION('',(" + ",".join(format_number(x) for x in self.frame.rotate(d)) + "))")

    def axes(self, origin, z, x):
        if dot(z, x) != 0:
            raise ValueError("the axes are not at right angles")
        return self.add(f"AXIS2_PLACEMENT_3D('',{self.point(origin)},{self.direction(z)},{self.direction(x)})")

    def vertex(self, p):
        return self.add(f"VERTEX_POINT('',{self.point(p)})")

    def line(self, p, q):
        return self.add(f"LINE('',{self.point(p)},{self.vector(subtract(q, p))})")

    def vector(self, d):
        """A direction; its magnitude is a scale of the parameter only."""
        return self.add(f"VECTOR('',{self.direction(d)},1.)")

    def circle(self, center, z, x, radius):
        return self.add(f"CIRCLE('',{self.axes(center, z, x)},{self.length(radius)})")

    def ellipse(self, center, z, x, a, b):
        return self.add(f"ELLIPSE('',{self.axes(center, z, x)},{self.length(a)},{self.length(b)})")

    def bspline_curve(self, points, knots=None, weights=None):
        names = ",".join(self.point(p) for p in points)
        degree, multiplicities, values = self._describe_knots(knots, len(points))
        if weights is None:
            return self.add(f"B_SPLINE_CURVE_WITH_KNOTS('',{degree},({names}),.UNSPECIFIED.,.F.,.F.,{multiplicities},{values},"
                            ".UNSPECIFIED.)")
        weights = ",".join(format_number(w) for w in weights)
        return self.add(f"(BOUNDED_CURVE()B_SPLINE_CURVE({degree},({names}),.UNSPECIFIED.,.F.,.F.)"
                        f"B_SPLINE_CURVE_WITH_KNOTS({multiplicities},{values},.UNSPECIFIED.)CURVE()"
                        f"GEOMETRIC_REPRESENTATION_ITEM()RATIONAL_B_SPLINE_CURVE(({weights}))REPRESENTATION_ITEM(''))")

    def _describe_knots(self, knots, count):
        knots = knots or [0] * count + [1] * count
        values = sorted(set(knots))
        multiplicities = ",".join(str(knots.count(k)) for k in values)
        return len(knots) - count - 1, f"({multiplicities})", "(" + ",".join(format_number(k) for k in values) + ")"

    def plane(self, origin, z, x):
        return self.add(f"PLANE('',{self.axes(origin, z, x)})")

    def cylinder(self, origin, z, x, radius):
        return self.add(f"CYLINDRICAL_SURFACE('',{self.axes(origin, z, x)},{self.length(radius)})")

    def cone(self, origin, z, x, radius, angle):
        return self.add(f"CONICAL_SURFACE('',{self.axes(origin, z, x)},{self.length(radius)},{format_number(angle)})")

    def sphere(self, origin, z, x, radius):
        return self.add(f"SPHERICAL_SURFACE('',{self.axes(origin, z, x)},{self.length(radius)})")

    def torus(self, origin, z, x, major, minor):
        return self.add(f"TOROIDAL_SURFACE('',{self.axes(origin, z, x)},{self.length(major)},{self.length(minor)})")

    def extrusion(self, curve, d):
        return self.add(f"SURFACE_OF_LINEAR_EXTRUSION('',{curve},{self.vector(d)})")

    def revolution(self, curve, origin, z):
        axis = self.add(f"AXIS1_PLACEMENT('',{self.point(origin)},{self.direction(z)})")
        return self.add(f"SURFACE_OF_REVOLUTION('',{curve},{axis})")

    def bspline_surface(self, rows, knots=(None, None), weights=None):
        """Writes a B-spline surface with control points rows[i][j], where i is the index in u and j that in v."""
        names = ",".join("(" + ",".join(self.point(p) for p in row) + ")" for row in rows)
        p, mu, u = self._describe_knots(knots[0], len(rows))
        q, mv, v = self._describe_knots(knots[1], len(rows[0]))
        form = ".UNSPECIFIED.,.F.,.F.,.F."
        if weights is None:
            return self.add(f"B_SPLINE_SURFACE_WITH_KNOTS('',{p},{q},({names}),{form},{mu},{mv},{u},{v},.UNSPECIFIED.)")
        weights = ",".join("(" + ",".join(format_number(w) for w in row) + ")" for row in weights)
        return self.add(f"(BOUNDED_SURFACE()B_SPLINE_SURFACE({p},{q},({names}),{form})"
                        f"B_SPLINE_SURFACE_WITH_KNOTS({mu},{mv},{u},{v},.UNSPECIFIED.)GEOMETRIC_REPRESENTATION_ITEM()"
                        f"RATIONAL_B_SPLINE_SURFACE(({weights}))REPRESENTATION_ITEM('')SURFACE())")

    def edge(self, p, q, curve=None):
        """Writes an edge from p to q along a curve, by default a line."""
        return self.add(f"EDGE_CURVE('',{self.vertex(p)},{self.vertex(q)},{curve or self.line(p, q)},.T.)")

    def face(self, surface, loops, forward=True):
        """Loops are lists of (edge, with the edge's direction), counter-clockwise as seen from outside the solid."""
        bounds = []
        for k, loop in enumerate(loops):
            edges = ",".join(self.add(f"ORIENTED_EDGE('',*,*,{edge},{'.T.' if same else '.F.'})") for edge, same in loop)
            loop = self.add(f"EDGE_LOOP('',({edges}))")
            bounds.append(self.add(f"{'FACE_BOUND' if k else 'FACE_OUTER_BOUND'}('',{loop},.T.)"))
        return self.add(f"ADVANCED_FACE('',({','.join(bounds)}),{surface},{'.T.' if forward else '.F.'})")

    def solid(self, faces, voids=()):
        """A void is a list of faces whose loops and senses are those of a solid that fills it."""
        shell = self.add(f"CLOSED_SHELL('',({','.join(faces)}))")
        if not voids:
            self.solids.append(self.add(f"MANIFOLD_SOLID_BREP('',{shell})"))
            return
        shells = [self.add(f"CLOSED_SHELL('',({','.join(void)}))") for void in voids]
        turned = ",".join(self.add(f"ORIENTED_CLOSED_SHELL('',*,{void},.F.)") for void in shells)
        self.solids.append(self.add(f"BREP_WITH_VOIDS('',{shell},({turned}))"))

    def write(self, name, description, unit, instances=None):
        """The text of the file. `instances`: frames at which an assembly has the product; otherwise the product is the file."""
        context = self._add_context(unit)
        origin = self._add_origin()
        shape = self.add(f"ADVANCED_BREP_SHAPE_REPRESENTATION('',({','.join([origin] + self.solids)}),{context})")
        application = self.add("APPLICATION_CONTEXT('automotive design')")
        self.add(f"APPLICATION_PROTOCOL_DEFINITION('international standard','automotive_design',2000,{application})")
        part = self._add_product(name, application, shape)
        if instances:
            self._add_instances(name, application, context, (part, shape, origin), instances)
        body = "".join(f"#{k}={line};\n" for k, line in enumerate(self.lines, 1))
        return HEADER.format(name=name, description=description) + body + "ENDSEC;\nEND-ISO-10303-21;\n"

    def _add_origin(self):
        frame, self.frame = self.frame, Frame()
        origin = self.axes((0, 0, 0), (0, 0, 1), (1, 0, 0))
        self.frame = frame
        return origin

    def _add_context(self, unit):
        prefixes = {"mm": ".MILLI.", "m": "$", "inch": ".MILLI."}
        length = f"(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT({prefixes[unit]},.METRE.))"
        if unit == "inch":
            factor = self.add(f"LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(25.4),{self.add(length)})")
            exponents = self.add("DIMENSIONAL_EXPONENTS(1.,0.,0.,0.,0.,0.,0.)")
            length = f"(CONVERSION_BASED_UNIT('INCH',{factor})LENGTH_UNIT()NAMED_UNIT({exponents}))"
        length = self.add(length)
        angle = self.add("(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.))")
        solid = self.add("(NAMED_UNIT(*)SI_UNIT($,.STERADIAN.)SOLID_ANGLE_UNIT())")
        accuracy = self.add(f"UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE(1.E-7),{length},'distance_accuracy_value','')")
        return self.add(f"(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT(({accuracy}))"
                        f"GLOBAL_UNIT_ASSIGNED_CONTEXT(({length},{angle},{solid}))REPRESENTATION_CONTEXT('',''))")

    def _add_product(self, name, application, shape, identifier=None):
        context = self.add(f"PRODUCT_CONTEXT('',{application},'mechanical')")
        product = self.add(f"PRODUCT('{identifier or name}','{name}','',({context}))")
        formation = self.add(f"PRODUCT_DEFINITION_FORMATION('','',{product})")
        design = self.add(f"PRODUCT_DEFINITION_CONTEXT('part definition',{application},'design')")
        definition = self.add(f"PRODUCT_DEFINITION('design','',{formation},{design})")
        described = self.add(f"PRODUCT_DEFINITION_SHAPE('','',{definition})")
        self.add(f"SHAPE_DEFINITION_REPRESENTATION({described},{shape})")
        return definition

    def _add_instances(self, name, application, context, part, frames):
        definition, shape, origin = part
        places = []
        for frame in frames:
            self.frame = Frame(1, frame.turn, frame.shift)
            places.append(self.axes((0, 0, 0), (0, 0, 1), (1, 0, 0)))
        whole = self.add(f"SHAPE_REPRESENTATION('',({','.join([origin] + places)}),{context})")
        assembly = self._add_product(name + "_assembly", application, whole)
        for k, place in enumerate(places, 1):
            use = self.add(f"NEXT_ASSEMBLY_USAGE_OCCURRENCE('{k}','{name}_{k}','',{assembly},{definition},$)")
            described = self.add(f"PRODUCT_DEFINITION_SHAPE('placement','',{use})")
            moved = self.add(f"ITEM_DEFINED_TRANSFORMATION('','',{origin},{place})")
            relation = self.add(f"(REPRESENTATION_RELATIONSHIP('','',{shape},{whole})"
                                f"REPRESENTATION_RELATIONSHIP_WITH_TRANSFORMATION({moved})SHAPE_REPRESENTATION_RELATIONSHIP())")
            self.add(f"CONTEXT_DEPENDENT_SHAPE_REPRESENTATION({relation},{described})")
