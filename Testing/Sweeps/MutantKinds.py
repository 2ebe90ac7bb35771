"""Kinds of damage for MutantSweep.py: each takes (random, source) and returns the changed text, or None where a file has
nothing of its kind. All of them change text, as damage does: none knows more of STEP than its tokens."""
import re

TOKEN = re.compile(r"'(?:[^'\n]|''|\n(?!\s*#\d+\s*=))*'|#\d+|[+-]?\d+\.?\d*(?:[Ee][+-]?\d+)?|\.[A-Z0-9_]+\.|[A-Za-z_]\w*|[(),;=$*]")
RECORD = re.compile(r"(?:^|(?<=;))\s*#(\d+)\s*=", re.MULTILINE)
GEOMETRY = re.compile(r"CARTESIAN_POINT|DIRECTION|VECTOR|_SURFACE|PLANE|CIRCLE|ELLIPSE|LINE|SPLINE|PLACEMENT|HYPERBOLA|PARABOLA")
TOPOLOGY = re.compile(r"VERTEX|EDGE|LOOP|BOUND|FACE|SHELL|BREP(?!_SHAPE)")
STRUCTURE = re.compile(r"PRODUCT|REPRESENTATION|MAPPED_ITEM|ITEM_DEFINED|ASSEMBLY|NEXT_ASS|BREP|SHELL|CONTEXT")
ROUND = re.compile(r"CIRCLE|ELLIPSE|CYLINDRICAL|SPHERICAL|TOROIDAL|CONICAL")
UNIT = re.compile(r"UNIT|MEASURE|CONTEXT")
PREFIXES = ("MILLI", "CENTI", "MICRO", "KILO", "DECI", "NANO", "MEGA")


class Record:
    """One entity: where it stands, its tokens (start, end, text, keyword that it belongs to, depth of parentheses)."""

    def __init__(self, text, number, start, end):
        self.number, self.start, self.end = number, start, end
        self.text = text[start:end]
        self.body = self.text.index("=") + 1
        self.keyword = (re.search(r"[A-Z_][A-Z_0-9]*", self.text[self.body:]) or re.search(r"^", "")).group(0)
        self.cached = None

    def tokens(self):
        if self.cached is None:
            self.cached, keyword, depth = [], "", 0
            for match in TOKEN.finditer(self.text, self.body):
                word = match.group(0)
                depth -= word == ")"
                if word[0].isalpha():
                    keyword = word
                self.cached.append((self.start + match.start(), self.start + match.end(), word, keyword, depth))
                depth += word == "("
        return self.cached

    def numbers(self):
        return [t for t in self.tokens() if re.match(r"[+-]?\d", t[2])]

    def references(self):
        return [t for t in self.tokens() if t[2][0] == "#"]

    def lists(self, least=1):
        """Innermost lists as lists of members (start, end, text), each of one token."""
        found, members = [], None
        for token in self.tokens():
            if token[2] == "(":
                members = []
            elif token[2] == ")":
                if members is not None and len(members) >= least:
                    found.append(members)
                members = None
            elif members is not None and token[2] != ",":
                members.append(token)
        return found


class Source:
    """A STEP file's text and its entities."""

    def __init__(self, name, text):
        self.name, self.text = name, text
        starts = list(RECORD.finditer(text))
        self.records = []
        for i, match in enumerate(starts):
            limit = starts[i + 1].start() if i + 1 < len(starts) else text.find("ENDSEC", match.end())
            limit = limit if limit > 0 else len(text)
            start, end = match.start(1) - 1, text.rfind(";", match.end(), limit) + 1
            self.records.append(Record(text, int(match.group(1)), start, end if end > start else limit))
        self.types = {}
        for record in self.records:
            self.types.setdefault(record.keyword, []).append(record)

    def some(self, random, pattern, test=lambda record: True):
        """A record whose text before its first parameters matches: first a type, then one of it, so that rare ones come up."""
        types = sorted(t for t in self.types if not pattern or pattern.search(self.types[t][0].text if not t else t))
        for _ in range(20):
            if types:
                record = random.choice(self.types[random.choice(types)])
                if test(record):
                    return record
        return None

    def replaced(self, token, text):
        return self.text[:token[0]] + text + self.text[token[1]:]


def byte_changed(random, source):
    at = random.randrange(len(source.text))
    return source.text[:at] + chr(random.randrange(32, 127)) + source.text[at + 1:]


def byte_deleted(random, source):
    at = random.randrange(len(source.text))
    return source.text[:at] + source.text[at + 1:]


def byte_inserted(random, source):
    at = random.randrange(len(source.text))
    return source.text[:at] + random.choice("0123456789#$*(),;'.=-EABTF ") + source.text[at:]


def _number(random, source, pattern=GEOMETRY):
    record = source.some(random, pattern, lambda r: r.numbers())
    return record and random.choice(record.numbers())


def _number_kind(make, pattern=GEOMETRY):
    def kind(random, source):
        token = _number(random, source, pattern)
        return token and source.replaced(token, make(random, token[2]))
    return kind


def _other_digit(random, text):
    places = [i for i, c in enumerate(re.split("[Ee]", text)[0]) if c.isdigit()]
    at = random.choice(places)
    return text[:at] + random.choice([d for d in "0123456789" if d != text[at]]) + text[at + 1:]


digit = _number_kind(_other_digit)
number_small = _number_kind(lambda random, text: random.choice(["1.E-300", "1.E-9", "0.", "-1.E-12", "4.9E-324"]))
number_huge = _number_kind(lambda random, text: random.choice(["1.E300", "-1.E20", "1.E9", "1.E400", "99999999999999999999"]))
number_nan = _number_kind(lambda random, text: random.choice(["NaN", "nan", "-NAN", "1.E"]))
number_inf = _number_kind(lambda random, text: random.choice(["INF", "-inf", "1.E999", "Infinity"]))
number_text = _number_kind(lambda random, text: random.choice(["'text'", "$", "*", ".T.", "X", "", "1.2.3", "--1"]))
radius_zero = _number_kind(lambda random, text: "0.", ROUND)
radius_negative = _number_kind(lambda random, text: text[1:] if text[0] == "-" else "-" + text, ROUND)


def direction(random, source):
    record = source.some(random, re.compile("^DIRECTION$"), lambda r: r.numbers())
    if not record:
        return None
    members = record.numbers()
    values = random.choice([[0.0] * 3, [random.uniform(-1, 1) for _ in range(3)], [-float(m[2]) for m in members],
                            [float(m[2]) for m in members[1:] + members[:1]]])
    return source.text[:members[0][0]] + ",".join(f"{v:.9g}" + ("" if "." in f"{v:.9g}" else ".")
                                                  for v in values[:len(members)]) + source.text[members[-1][1]:]


def _spline_lists(source, random, test):
    found = []
    for record in source.records:
        if "B_SPLINE" in record.text:
            found += [m for m in record.lists() if test(m)]
    return random.choice(found) if found else None


def _reals(members, keyword):
    return keyword in members[0][3] and all("." in m[2] and m[2][0] not in ".'" for m in members)


def _knots(change):
    def kind(random, source):
        members = _spline_lists(source, random, lambda m: len(m) > 1 and _reals(m, "WITH_KNOTS"))
        if not members:
            return None
        texts = change(random, [m[2] for m in members])
        return source.text[:members[0][0]] + ",".join(texts) + source.text[members[-1][1]:]
    return kind


def _repeat(random, texts):
    at = random.randrange(len(texts) - 1)
    return random.choice([texts[:at + 1] + [texts[at]] + texts[at + 2:], texts[:at] + [texts[at]] + texts[at:]])


knots_reversed = _knots(lambda random, texts: texts[::-1])
knots_repeated = _knots(_repeat)
knots_shuffled = _knots(lambda random, texts: random.sample(texts, len(texts)))


def weight(random, source):
    members = _spline_lists(source, random, lambda m: _reals(m, "RATIONAL"))
    return members and source.replaced(random.choice(members), random.choice(["0.", "-1.", "1.E12", "1.E-12", "2.5"]))


def multiplicity(random, source):
    members = _spline_lists(source, random, lambda m: "WITH_KNOTS" in m[0][3] and all(t[2].isdigit() for t in m))
    return members and source.replaced(random.choice(members), str(random.choice([0, 1, 2, 3, 4, 5, 7, 30])))


def degree(random, source):
    records = [r for r in source.records if "B_SPLINE" in r.text]
    tokens = []
    for record in records:
        depths = [t[4] for t in record.tokens() if t[2].isdigit()]
        tokens += [t for t in record.tokens() if t[2].isdigit() and t[4] == min(depths)]
    return source.replaced(random.choice(tokens), str(random.choice([0, 1, 2, 3, 4, 9, 26, 100]))) if tokens else None


def _reference(choose, pattern=None):
    def kind(random, source):
        record = source.some(random, pattern, lambda r: r.references())
        if not record:
            return None
        token = random.choice(record.references())
        number = choose(random, source, record, int(token[2][1:]))
        return source.replaced(token, f"#{number}") if number is not None and f"#{number}" != token[2] else None
    return kind


def _same_type(random, source, record, number):
    target = next((r for r in source.records if r.number == number), None)
    return target and random.choice(source.types[target.keyword]).number


reference_same_type = _reference(_same_type)
reference_any_type = _reference(lambda random, source, record, number: random.choice(source.records).number)
reference_self = _reference(lambda random, source, record, number: record.number)
reference_dangling = _reference(lambda random, source, record, number: 10 ** 7 + random.randrange(1000))
structure_same_type = _reference(_same_type, STRUCTURE)
structure_any_type = _reference(lambda random, source, record, number: random.choice(source.records).number, STRUCTURE)


def _entity(pattern, doubled):
    def kind(random, source):
        record = source.some(random, pattern)
        if not record:
            return None
        more = record.text + "\n"
        if doubled and random.random() < 0.5:
            more = more.replace(f"#{record.number}", f"#{max(r.number for r in source.records) + 1}", 1)
        return source.text[:record.start] + (more + record.text if doubled else "") + source.text[record.end:]
    return kind


entity_deleted, entity_doubled = _entity(None, False), _entity(None, True)
topology_deleted, topology_doubled = _entity(TOPOLOGY, False), _entity(TOPOLOGY, True)


def _member(doubled):
    def kind(random, source):
        record = source.some(random, None, lambda r: r.lists(1 + (not doubled)))
        if not record:
            return None
        members = random.choice(record.lists(1 + (not doubled)))
        texts = [m[2] for m in members]
        at = random.randrange(len(texts))
        texts = texts[:at] + ([texts[at]] * 2 if doubled else []) + texts[at + 1:]
        return source.text[:members[0][0]] + ",".join(texts) + source.text[members[-1][1]:]
    return kind


member_deleted, member_doubled = _member(False), _member(True)


def lines_swapped(random, source):
    lines = source.text.split("\n")
    a, b = (random.randrange(len(lines)) for _ in range(2))
    lines[a], lines[b] = lines[b], lines[a]
    return "\n".join(lines)


def _swap(source, spans):
    (a, b), (c, d) = sorted(spans)
    text = source.text
    return text[:a] + text[c:d] + text[b:c] + text[a:b] + text[d:] if b <= c else None


def entities_swapped(random, source):
    """Two entities of one type exchange what they say."""
    record = source.some(random, None, lambda r: len(source.types[r.keyword]) > 1)
    other = record and random.choice(source.types[record.keyword])
    return record and _swap(source, [(r.start + r.body, r.end) for r in (record, other)])


def ids_swapped(random, source):
    """Two entities of any type exchange their ids."""
    pair = random.sample(source.records, 2)
    return _swap(source, [(r.start, r.start + 1 + len(str(r.number))) for r in pair])


def flag_flipped(random, source):
    record = source.some(random, None, lambda r: any(t[2] in (".T.", ".F.") for t in r.tokens()))
    if not record:
        return None
    token = random.choice([t for t in record.tokens() if t[2] in (".T.", ".F.")])
    return source.replaced(token, ".F." if token[2] == ".T." else ".T.")


def truncated(random, source):
    return source.text[:random.randrange(len(source.text))]


def type_exchanged(random, source):
    record = source.some(random, None, lambda r: r.keyword)
    words = [t for t in record.tokens() if t[2][0].isalpha() and t[2] == t[3]]
    others = sorted(t for t in source.types if t and t != record.keyword)
    return source.replaced(random.choice(words), random.choice(others)) if words and others else None


def unit(random, source):
    records = [r for r in source.records if UNIT.search(r.text) and "UNIT" in r.text and "PRODUCT" not in r.text]
    record = random.choice(records) if records else None
    if not record:
        return None
    tokens = [t for t in record.tokens() if t[2] not in "(),;="]
    token = random.choice(tokens)
    word = token[2]
    if word[0] == "." or word == "$":
        return source.replaced(token, random.choice([f".{random.choice(PREFIXES)}.", "$", ".METRE.", ".RADIAN.", ".GRAM."]))
    if re.match(r"[+-]?\d", word):
        return source.replaced(token, random.choice(["0.", "-25.4", "1.E9", "25.4", "1.E-3", _other_digit(random, word)]))
    if word[0] == "#":
        return source.replaced(token, f"#{random.choice(records).number}")
    if word[0] == "'":
        return source.replaced(token, random.choice(["'INCH'", "'FOOT'", "'METRE'", "'DEGREE'", "''"]))
    return source.replaced(token, random.choice(["LENGTH_UNIT", "PLANE_ANGLE_UNIT", "SOLID_ANGLE_UNIT", "SI_UNIT", "X"]))


SINGLE = {f.__name__: f for f in (byte_changed, byte_deleted, byte_inserted, direction, weight, multiplicity, degree,
                                  lines_swapped, entities_swapped, ids_swapped, flag_flipped, truncated, type_exchanged, unit)}
for _name in ("digit number_small number_huge number_nan number_inf number_text radius_zero radius_negative knots_reversed "
              "knots_repeated knots_shuffled reference_same_type reference_any_type reference_self reference_dangling "
              "structure_same_type structure_any_type entity_deleted entity_doubled topology_deleted topology_doubled "
              "member_deleted member_doubled").split():
    SINGLE[_name] = globals()[_name]


def several(random, source):
    """Two to five kinds of damage, one after another."""
    text = source.text
    for _ in range(random.randrange(2, 6)):
        current = Source(source.name, text)
        if len(current.records) < 2:
            break
        text = SINGLE[random.choice(sorted(SINGLE))](random, current) or text
    return text if text != source.text else None


KINDS = dict(SINGLE, several=several)
