"""The content that a STEP file declares, read by MutantSweep.py from its text alone: nothing here is shared with the program.

The reading is generous: an entity begins with its id, after a semicolon or at the start of a line, and ends where the next
one begins, so that a damaged one takes no other with it. A file that the reader takes for less must be said to be damaged."""
import collections
import hashlib
import math

from MutantKinds import RECORD, TOKEN

SI_PREFIXES = {"$": 1, ".MILLI.": 1e-3, ".CENTI.": 1e-2, ".DECI.": 1e-1, ".KILO.": 1e3, ".MICRO.": 1e-6, ".NANO.": 1e-9,
               ".MEGA.": 1e6, ".HECTO.": 1e2, ".DECA.": 1e1, ".GIGA.": 1e9, ".PICO.": 1e-12}
SOLIDS = ("MANIFOLD_SOLID_BREP", "BREP_WITH_VOIDS", "FACETED_BREP")
DEPTH = 60


class Reference(int):
    """The id that a parameter refers to."""


class Number(float):
    """A number with the text that it has in the file."""

    def __new__(cls, text):
        number = super().__new__(cls, text)
        number.text = text
        return number


def parse(text, start):
    """Nested lists of parameters from start: (keyword, parameters) for what has a keyword."""
    root, pending = [], None
    stack = [root]
    for match in TOKEN.finditer(text, start):
        word = match.group(0)
        if word == "(":
            inner = []
            stack[-1].append(inner if pending is None else (pending, inner))
            stack.append(inner)
            pending = None
            continue
        if pending is not None:
            stack[-1].append(pending)
            pending = None
        if word == ")":
            if len(stack) > 1:
                stack.pop()
        elif word == ";":
            break
        elif word[0] == "#":
            stack[-1].append(Reference(word[1:]))
        elif word[0].isalpha() or word[0] == "_":
            pending = word.upper()
        elif word[0] in "+-0123456789":
            stack[-1].append(Number(word))
        elif word not in "=,":
            stack[-1].append(word)
    return root


def references(value):
    """All ids in a value, in order."""
    if isinstance(value, Reference):
        yield value
    elif isinstance(value, (list, tuple)):
        for member in value:
            yield from references(member)
    elif isinstance(value, dict):
        for member in value.values():
            yield from references(member)


class Model:
    """The entities of a file as {keyword: parameters}, and what they declare."""

    def __init__(self, text):
        self.entities, self.repeated = {}, set()
        starts = list(RECORD.finditer(text))
        for i, match in enumerate(starts):
            number = int(match.group(1))
            end = starts[i + 1].start() if i + 1 < len(starts) else len(text)
            root = parse(text[match.end():end], 0)
            parts = root[0] if root and isinstance(root[0], list) else root[:1]
            entity = {p[0]: p[1] for p in parts if isinstance(p, tuple)}
            if number in self.entities and self.entities[number] != entity:
                self.repeated.add(number)
            self.entities.setdefault(number, entity)
        self.broken = []
        self.hashes, self.relations = {}, None

    def all(self, *keywords):
        return [(Reference(i), e[k]) for i, e in self.entities.items() for k in keywords if k in e]

    def get(self, number, keyword):
        """Parameters of an entity of this type; None where it is something else."""
        return self.entities.get(number, {}).get(keyword) if isinstance(number, Reference) else None

    def has(self, number, part):
        return isinstance(number, Reference) and any(part in k for k in self.entities.get(number, {}))

    def at(self, parameters, i):
        return parameters[i] if parameters is not None and i < len(parameters) else None

    # Structure

    def solids(self):
        return [i for i, _ in self.all(*SOLIDS)]

    def shells(self, solid):
        entity = self.entities[solid]
        shells = []
        for part in ("MANIFOLD_SOLID_BREP", "BREP_WITH_VOIDS", "FACETED_BREP"):
            for reference in references(entity.get(part, [])):
                inner = self.get(reference, "ORIENTED_CLOSED_SHELL")
                shells.append(next(references(inner), None) if inner is not None else reference)
        return shells

    def faces(self, solid):
        found = []
        for shell in self.shells(solid):
            parameters = self.get(shell, "CLOSED_SHELL")
            if parameters is None:
                self.broken.append(f"#{solid} has no shell in #{shell}")
            found += list(references(parameters or []))
        for face in found:
            if not self.has(face, "FACE"):
                self.broken.append(f"#{face} of #{solid} is not a face")
        return set(found)

    def representation(self, number):
        """(items, context) of a representation, or None."""
        for keyword, parameters in self.entities.get(number, {}).items() if isinstance(number, Reference) else ():
            if keyword.endswith("REPRESENTATION") and len(parameters) >= 3 and isinstance(parameters[1], list):
                return parameters[1], parameters[2]
        return None

    def related(self):
        """Representations that stand for the same shape: {id: ids}."""
        if self.relations is None:
            self.relations = collections.defaultdict(set)
            for number, entity in self.entities.items():
                if "REPRESENTATION_RELATIONSHIP_WITH_TRANSFORMATION" in entity:
                    continue
                for keyword in ("SHAPE_REPRESENTATION_RELATIONSHIP", "REPRESENTATION_RELATIONSHIP"):
                    ends = entity.get(keyword, [])[2:4]
                    if len(ends) == 2:
                        if any(self.representation(e) is None for e in ends):
                            self.broken.append(f"#{number} relates no two representations")
                        else:
                            self.relations[ends[0]].add(ends[1])
                            self.relations[ends[1]].add(ends[0])
        return self.relations

    def held(self, start, depth=0):
        """Solids of a representation and those related to it: {(solid, context): number}."""
        found, seen, todo = collections.Counter(), set(), [start]
        while todo:
            number = todo.pop()
            shape = self.representation(number)
            if number in seen or shape is None:
                continue
            seen.add(number)
            todo += self.related()[number]
            for item in references(shape[0]):
                if any(k in self.entities.get(item, {}) for k in SOLIDS):
                    found[item, shape[1]] += 1
                mapped = self.get(item, "MAPPED_ITEM")
                if mapped is not None and depth < DEPTH:
                    source = self.at(self.get(self.at(mapped, 1), "REPRESENTATION_MAP"), 1)
                    if self.representation(source) is None:
                        self.broken.append(f"#{item} maps no representation")
                    found += self.held(source, depth + 1)
        return found

    def instances(self):
        """{(solid, context): number} in all products."""
        children, owners, own = collections.defaultdict(list), set(), collections.defaultdict(collections.Counter)
        for number, parameters in self.all("NEXT_ASSEMBLY_USAGE_OCCURRENCE"):
            parent, child = self.at(parameters, 3), self.at(parameters, 4)
            if not all(self.has(p, "PRODUCT_DEFINITION") and not self.has(p, "SHAPE") for p in (parent, child)):
                self.broken.append(f"#{number} relates no two products")
                continue
            children[parent].append(child)
            owners.add(child)
        stated = set()
        for number, parameters in self.all("SHAPE_DEFINITION_REPRESENTATION"):
            # What is stated twice holds once.
            if tuple(map(str, parameters[:2])) in stated:
                continue
            stated.add(tuple(map(str, parameters[:2])))
            definition = self.get(self.at(parameters, 0), "PRODUCT_DEFINITION_SHAPE")
            product = self.at(definition, 2)
            if definition is None or not self.has(product, "") or self.representation(self.at(parameters, 1)) is None:
                self.broken.append(f"#{number} gives no product a shape")
            elif self.has(product, "PRODUCT_DEFINITION"):
                own[product] += self.held(parameters[1])
        total = collections.Counter()
        for root in set(own) | set(children):
            if root not in owners:
                self.add(total, root, children, own, 0)
        return total

    def add(self, total, product, children, own, depth):
        if depth > DEPTH:
            self.broken.append(f"product #{product} contains itself")
            return
        total.update(own[product])
        for child in children[product]:
            self.add(total, child, children, own, depth + 1)

    # Units

    def units(self, context):
        """(metres of the length unit, radians of the angle unit) of a context; None where there is none or it is damaged."""
        assigned = self.get(context, "GLOBAL_UNIT_ASSIGNED_CONTEXT")
        lengths, angles = [], []
        for reference in references(assigned or []):
            entity = self.entities.get(reference, {})
            if "LENGTH_UNIT" in entity:
                lengths.append(self.factor(reference, ".METRE.", 0))
            if "PLANE_ANGLE_UNIT" in entity:
                angles.append(self.factor(reference, ".RADIAN.", 0))
        # A damaged one next to a sound one may be anything, such as what was the unit of solid angles.
        sound = [{v for v in values if v} for values in (lengths, angles)]
        return tuple(next(iter(values)) if len(values) == 1 else None for values in sound)

    def factor(self, reference, base, depth):
        entity = self.entities.get(reference, {})
        if "SI_UNIT" in entity:
            return SI_PREFIXES.get(self.at(entity["SI_UNIT"], 0)) if self.at(entity["SI_UNIT"], 1) == base else None
        measured = self.at(entity.get("CONVERSION_BASED_UNIT"), 1)
        if measured is None or depth > 5:
            return None
        for parameters in self.entities.get(measured, {}).values():
            plain = [p[1][0] if isinstance(p, tuple) and p[1] else p for p in parameters]
            numbers = [p for p in plain if isinstance(p, float)]
            inner = next(references(parameters), None)
            scale = self.factor(inner, base, depth + 1) if inner is not None else None
            if numbers and scale and numbers[0] > 0:
                return numbers[0] * scale
        return None

    # Geometry

    def fingerprint(self, number, depth=0):
        """A fingerprint of an entity and all below it, without names and ids: equal ones describe the same geometry."""
        if number not in self.hashes:
            self.hashes[number] = "cycle"
            entity = self.entities.get(number)
            text = "missing" if entity is None else self.canonical(sorted(entity.items()), depth)
            self.hashes[number] = hashlib.sha1(text.encode("utf8", "replace")).hexdigest()
        return self.hashes[number]

    def canonical(self, value, depth):
        if isinstance(value, Reference):
            return self.fingerprint(value, depth + 1) if depth < 400 else "deep"
        if isinstance(value, (list, tuple)):
            return "(" + ",".join(self.canonical(v, depth) for v in value) + ")"
        return "''" if isinstance(value, str) and value[:1] == "'" else repr(value)

    def point(self, number):
        for keyword in ("VERTEX_POINT", "CARTESIAN_POINT", "DIRECTION"):
            parameters = self.get(number, keyword)
            if parameters is None:
                continue
            if keyword == "VERTEX_POINT":
                return self.point(self.at(parameters, 1))
            values = self.at(parameters, 1)
            if isinstance(values, list) and len(values) == 3 and all(isinstance(v, float) for v in values):
                return tuple(values)
        return None

    def unit_vector(self, number):
        values = self.point(number)
        size = math.sqrt(sum(v * v for v in values)) if values and all(abs(v) < 1e100 for v in values) else 0
        return tuple(v / size for v in values) if size > 0 else None
