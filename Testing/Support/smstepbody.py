"""Small STEP files (AP214) written entity by entity, in forms that no modelling kernel writes."""
import math

HEADER = ("ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\nFILE_NAME('','',(''),(''),'','','');\n"
          "FILE_SCHEMA(('AUTOMOTIVE_DESIGN { 1 0 10303 214 1 1 1 1 }'));\nENDSEC;\n")
EMPTY = "''"


class Body:
    """Collects entities of a file in mm; what is given in the frame of the body is written rotated and moved to `origin`."""

    def __init__(self, turn=0.0, origin=(0.0, 0.0, 0.0), degrees=False):
        self.lines = []
        c, s = math.cos(turn), math.sin(turn)
        self.rows = ((c, -s, 0.0), (s * c, c * c, -s), (s * s, c * s, c))
        self.origin = origin
        application = self.add("APPLICATION_CONTEXT('')")
        unit = self.add("(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.))")
        angle = self.add("(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.))")
        if degrees:
            measure = self.add(f"PLANE_ANGLE_MEASURE_WITH_UNIT(PLANE_ANGLE_MEASURE({format_real(math.pi / 180.0)}),{angle})")
            exponents = self.add("DIMENSIONAL_EXPONENTS(0.,0.,0.,0.,0.,0.,0.)")
            angle = self.add(f"(CONVERSION_BASED_UNIT('DEGREE',{measure})NAMED_UNIT({exponents})PLANE_ANGLE_UNIT())")
        accuracy = self.add(f"UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE(1.E-07),{unit},'distance_accuracy_value','')")
        self.context = self.add(f"(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT(({accuracy}))"
                                f"GLOBAL_UNIT_ASSIGNED_CONTEXT(({unit},{angle}))REPRESENTATION_CONTEXT('',''))")
        self.product_context = self.add(f"PRODUCT_CONTEXT('',{application},'mechanical')")
        self.design = self.add(f"PRODUCT_DEFINITION_CONTEXT('part definition',{application},'design')")
        self.identity = self.add(f"AXIS2_PLACEMENT_3D('',{self.add(triple('CARTESIAN_POINT', (0.0, 0.0, 0.0)))},"
                                 f"{self.add(triple('DIRECTION', (0.0, 0.0, 1.0)))},{self.add(triple('DIRECTION', (1.0, 0.0, 0.0)))})")

    def add(self, text):
        self.lines.append(text)
        return f"#{len(self.lines)}"

    def rotate(self, d):
        return tuple(sum(r * x for r, x in zip(row, d)) for row in self.rows)

    def point(self, p):
        return self.add(triple("CARTESIAN_POINT", [a + o for a, o in zip(self.rotate(p), self.origin)]))

    def direction(self, d):
        return self.add(triple("DIRECTION", self.rotate(d)))

    def axes(self, p, z=(0.0, 0.0, 1.0), x=(1.0, 0.0, 0.0)):
        return self.add(f"AXIS2_PLACEMENT_3D('',{self.point(p)},{self.direction(z)},{self.direction(x)})")

    def vertex(self, p):
        return self.add(f"VERTEX_POINT('',{self.point(p)})")

    def loop(self, uses):
        """Uses of edges, (edge, forward)."""
        edges = ",".join(self.add(f"ORIENTED_EDGE('',*,*,{edge},.{'T' if forward else 'F'}.)") for edge, forward in uses)
        return self.add(f"EDGE_LOOP('',({edges}))")

    def face(self, loops, surface, sense=True):
        bounds = ",".join(self.add(f"FACE_BOUND('',{loop},.T.)") for loop in loops)
        return self.add(f"ADVANCED_FACE('',({bounds}),{surface},.{'T' if sense else 'F'}.)")

    def line_edge(self, start, end, p, q):
        length = math.dist(p, q)
        d = [(b - a) / length for a, b in zip(p, q)]
        line = self.add(f"LINE('',{self.point(p)},{self.add(f'VECTOR({EMPTY},{self.direction(d)},1.)')})")
        return self.add(f"EDGE_CURVE('',{start},{end},{line},.T.)")

    def product(self, name, shape):
        """A product definition with this representation."""
        product = self.add(f"PRODUCT('{name}','{name}','',({self.product_context}))")
        formation = self.add(f"PRODUCT_DEFINITION_FORMATION('','',{product})")
        definition = self.add(f"PRODUCT_DEFINITION('design','',{formation},{self.design})")
        self.define(definition, shape)
        return definition

    def define(self, definition, shape):
        self.add(f"SHAPE_DEFINITION_REPRESENTATION({self.add(f'PRODUCT_DEFINITION_SHAPE({EMPTY},{EMPTY},{definition})')},{shape})")

    def shape(self, items, kind="ADVANCED_BREP_SHAPE_REPRESENTATION"):
        return self.add(f"{kind}('',({','.join(items)}),{self.context})")

    def solid(self, faces, name=""):
        shell = self.add(f"CLOSED_SHELL('',({','.join(faces)}))")
        return self.add(f"MANIFOLD_SOLID_BREP('{name}',{shell})")

    def box(self, corner, size):
        """The faces of a box."""
        points = [tuple(c + s * ((k >> d) & 1) for d, (c, s) in enumerate(zip(corner, size))) for k in range(8)]
        vertices = [self.vertex(p) for p in points]
        edges = {}
        for a in range(8):
            for d in range(3):
                b = a | 1 << d
                if b != a:
                    edges[a, b] = self.line_edge(vertices[a], vertices[b], points[a], points[b])
        faces = []
        for d in range(3):
            u, v = 1 << (d + 1) % 3, 1 << (d + 2) % 3
            for side in (0, 1):
                first = side << d
                ring = [first, first + u, first + u + v, first + v]
                ring = ring if side else ring[::-1]
                normal = tuple(float((2 * side - 1) * (k == d)) for k in range(3))
                uses = [((min(a, b), max(a, b)), a < b) for a, b in zip(ring, ring[1:] + ring[:1])]
                along = tuple(float(k == (d + 1) % 3) for k in range(3))
                plane = self.add(f"PLANE('',{self.axes(points[first], normal, along)})")
                faces.append(self.face([self.loop([(edges[e], forward) for e, forward in uses])], plane))
        return faces

    def get_text(self, sections=None):
        body = [f"#{k}={line};\n" for k, line in enumerate(self.lines, 1)]
        data = sections(body) if sections else "DATA;\n" + "".join(body) + "ENDSEC;\n"
        return HEADER + data + "END-ISO-10303-21;\n"


def triple(kind, values):
    return f"{kind}('',({','.join(format_real(x) for x in values)}))"


def format_real(x):
    text = repr(float(x)).upper()
    return text if "." in text else text.replace("E", ".E") if "E" in text else text + "."
