"""A STEP file that can be rewritten: entities as MutantOracle.py reads them, exchanged one by one, and written again. What was not
touched keeps its text."""
import collections
import copy

from MutantIntegrals import Edge
from MutantKinds import RECORD
from MutantOracle import Model, Number, Reference, references
from MutantShapes import Shapes, Unknown

FACES = ("ADVANCED_FACE", "FACE_SURFACE")
BOUNDS = ("FACE_OUTER_BOUND", "FACE_BOUND")
SURFACE_CURVES = ("SURFACE_CURVE", "SEAM_CURVE", "INTERSECTION_CURVE")
Face = collections.namedtuple("Face", "number surface sense bounds")
Use = collections.namedtuple("Use", "face bound loop oriented")


def real(value):
    """A number as Part 21 has it, with all its digits."""
    text = repr(float(value)).upper()
    mantissa, _, exponent = text.partition("E")
    return (mantissa if "." in mantissa else mantissa + ".") + ("E" + exponent if exponent else "")


def written(value):
    """The text of a parameter."""
    if isinstance(value, Reference):
        return f"#{int(value)}"
    if isinstance(value, Number):
        return value.text
    if isinstance(value, float):
        return real(value)
    if isinstance(value, tuple):
        return value[0] + written(value[1])
    if isinstance(value, list):
        return "(" + ",".join(written(v) for v in value) + ")"
    return str(value)


class Document(Model):
    """The entities of a file, in the order of the text, with those that were made or changed."""

    def __init__(self, text):
        super().__init__(text)
        starts = list(RECORD.finditer(text))
        if not starts or self.repeated or text.count("ENDSEC;") != 2:
            raise Unknown("a file with records twice, or with several sections")
        self.head, end = text[:starts[0].start(1) - 1], text.rindex("ENDSEC;")
        self.tail, self.own = text[end:], {}
        self.residual = 0.0
        for match, after in zip(starts, [m.start(1) - 1 for m in starts[1:]] + [end]):
            number = int(match.group(1))
            self.own[number] = text[match.end():text.rindex(";", match.end(), after) + 1].strip()
        self.order = list(self.own)
        self.last = max(self.order)
        self.usage = None
        self.roots = {number for number in self.order if not self.users(number)}
        angles = {self.units(context)[1] for _, context in self.instances()}
        self.radians = angles.pop() if len(angles) == 1 else None

    def copy(self):
        """One that may be changed while this one stays as it is."""
        other = copy.copy(self)
        other.entities = {n: {k: list(p) for k, p in parts.items()} for n, parts in self.entities.items()}
        other.own, other.order, other.usage = dict(self.own), list(self.order), None
        other.hashes, other.relations, other.broken = {}, None, []
        return other

    # Changes

    def make(self, keyword, *parameters):
        """A new entity; parameters may be one dictionary of the parts of a complex one."""
        self.last += 1
        self.order.append(self.last)
        self.entities[self.last] = keyword if isinstance(keyword, dict) else {keyword: list(parameters)}
        self.usage = None
        return Reference(self.last)

    def set(self, number, keyword, *parameters):
        """Replaces what an entity is."""
        self.entities[number] = {keyword: list(parameters)}
        self.touch(number)

    def put(self, number, keyword, index, value):
        """Replaces a parameter."""
        self.entities[number][keyword][index] = value
        self.touch(number)

    def touch(self, number):
        self.own.pop(number, None)
        self.usage, self.hashes = None, {}

    def drop(self, number):
        if number in self.entities:
            del self.entities[number]
            self.order.remove(number)
            self.touch(number)

    def redirect(self, old, new, users=None):
        """Lets users of an entity, or all of them, refer to another one."""
        for user in list(users if users is not None else self.users(old)):
            parts = self.entities[user]
            self.entities[user] = {k: self.exchanged(v, old, new) for k, v in parts.items()}
            self.touch(user)

    def exchanged(self, value, old, new):
        if isinstance(value, Reference):
            return new if value == old else value
        if isinstance(value, list):
            return [self.exchanged(v, old, new) for v in value]
        return (value[0], self.exchanged(value[1], old, new)) if isinstance(value, tuple) else value

    def body(self, number):
        """The text of an entity after its id."""
        if number in self.own:
            return self.own[number]
        parts = self.entities[number]
        texts = [keyword + written(parameters) for keyword, parameters in parts.items()]
        return (texts[0] if len(texts) == 1 else "(" + "".join(texts) + ")") + ";"

    def clean(self):
        """Takes away what nothing refers to any more."""
        left = list(self.order)
        while left:
            unused = [n for n in left if n in self.entities and n not in self.roots and not self.users(n)]
            left = [r for n in unused for r in references(self.entities[n])]
            for number in unused:
                self.entities.pop(number, None)
                self.own.pop(number, None)
            self.usage = None
        self.order = [n for n in self.order if n in self.entities]

    def text(self):
        self.clean()
        return self.head + "".join(f"#{number}={self.body(number)}\n" for number in self.order) + self.tail

    # Looking things up

    def users(self, number):
        if self.usage is None:
            self.usage = collections.defaultdict(set)
            for user, parts in self.entities.items():
                for inner in references(parts):
                    self.usage[inner].add(user)
        return self.usage[number]

    def kind(self, number):
        """The one keyword of a simple entity."""
        parts = self.entities.get(number, {}) if isinstance(number, int) else {}
        return next(iter(parts)) if len(parts) == 1 else ""

    def shapes(self):
        return Shapes(self, self.radians or 1.0)

    def angle(self, radians):
        """An angle in the file's unit."""
        if self.radians is None:
            raise Unknown("no angle unit")
        return radians / self.radians

    def faces_of(self, *surfaces):
        """All faces of solids, or those on surfaces of these types."""
        found = []
        for solid in self.solids():
            for number in sorted(self.faces(solid)):
                keyword = self.kind(number)
                if keyword not in FACES:
                    continue
                _, bounds, surface, sense = self.entities[number][keyword]
                if not surfaces or any(s in self.entities.get(surface, {}) for s in surfaces):
                    found.append(Face(Reference(number), surface, sense, list(bounds)))
        return found

    def bound(self, number):
        """(loop, orientation) of a bound."""
        parameters = self.entities[number][self.kind(number)]
        return parameters[1], parameters[2]

    def loop(self, number):
        """The oriented edges of a loop; none of a vertex."""
        return list(self.at(self.get(number, "EDGE_LOOP"), 1) or [])

    def use(self, oriented):
        """(edge, orientation)"""
        parameters = self.entities[oriented]["ORIENTED_EDGE"]
        return parameters[3], parameters[4]

    def edges(self):
        """Edges of the solids' faces with their uses: {edge: [Use]}."""
        found = {}
        for face in self.faces_of():
            for bound in face.bounds:
                loop = self.bound(bound)[0]
                for oriented in self.loop(loop):
                    found.setdefault(self.use(oriented)[0], []).append(Use(face, bound, loop, oriented))
        return found

    def curve_of(self, edge):
        """(entity that refers to an edge's curve in space, its keyword, place of the reference, curve)"""
        holder, keyword, place = edge, "EDGE_CURVE", 3
        curve = self.entities[edge]["EDGE_CURVE"][3]
        while self.kind(curve) in SURFACE_CURVES:
            holder, keyword, place = curve, self.kind(curve), 1
            curve = self.entities[holder][keyword][1]
        return holder, keyword, place, curve

    def geometry(self, edge):
        """The edge's curve with its parameters, by the formulas of MutantShapes.py."""
        return Edge(self.shapes(), edge)

    # New geometry

    def make_point(self, point):
        return self.make("CARTESIAN_POINT", "''", [float(p) for p in point])

    def make_direction(self, vector):
        return self.make("DIRECTION", "''", [float(v) for v in vector])

    def make_vector(self, vector, size=1.0):
        return self.make("VECTOR", "''", self.make_direction(vector), float(size))

    def make_placement(self, origin, z, x):
        return self.make("AXIS2_PLACEMENT_3D", "''", self.make_point(origin), self.make_direction(z), self.make_direction(x))

    def make_spline(self, degree, points, weights, multiplicities, knots, closed=".F."):
        """A B-spline curve of points in space; rational where there are weights."""
        poles = [self.make_point(p) for p in points]
        head = [degree, poles, ".UNSPECIFIED.", closed, ".F."]
        tail = [list(multiplicities), [float(k) for k in knots], ".UNSPECIFIED."]
        if weights is None:
            return self.make("B_SPLINE_CURVE_WITH_KNOTS", "''", *head, *tail)
        return self.make({"BOUNDED_CURVE": [], "B_SPLINE_CURVE": head, "B_SPLINE_CURVE_WITH_KNOTS": tail, "CURVE": [],
                         "GEOMETRIC_REPRESENTATION_ITEM": [], "RATIONAL_B_SPLINE_CURVE": [[float(w) for w in weights]],
                         "REPRESENTATION_ITEM": ["''"]})

    def drop_trims(self, edge, surface=None):
        """Takes the parameter curves of an edge away, all or those on a surface."""
        holder = self.entities[edge]["EDGE_CURVE"][3]
        keyword = self.kind(holder)
        if keyword not in SURFACE_CURVES:
            return False
        _, curve, trims, _ = self.entities[holder][keyword]
        basis = [self.at(self.get(t, "PCURVE"), 1) for t in trims]
        left = [t for t, b in zip(trims, basis) if surface is not None and b != surface]
        if len(left) == len(trims):
            return False
        if left and any(self.kind(t) == "PCURVE" for t in left):
            self.set(holder, "SURFACE_CURVE", "''", curve, left, ".CURVE_3D.")
        else:
            self.put(edge, "EDGE_CURVE", 3, curve)
        self.residual += 1
        return True

    def drop_trims_of(self, face):
        """Takes the parameter curves on a face's surface away; whether there were any."""
        edges = {self.use(o)[0] for b in face.bounds for o in self.loop(self.bound(b)[0])}
        return any([self.drop_trims(e, face.surface) for e in edges])
