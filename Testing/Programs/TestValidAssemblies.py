"""TestValidAssemblies.py MODE --program SOLIDMOMENTS --output FOLDER: every way in which a STEP file places parts is followed.

Small bodies with known volumes are written in these forms; each is `ok` with its volume and without a message that sounds like a loss, or
flagged where the file is wrong. MODE is the name of a function without check_; CMake makes a test of each.
"""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Support"))
from smcheck import check_true  # noqa: E402
from smstepbody import EMPTY, Body  # noqa: E402
from smvalidforms import run_modes  # noqa: E402


def add_mapped(body, shape, at):
    source = body.add(f"REPRESENTATION_MAP({body.identity},{shape})")
    return body.add(f"MAPPED_ITEM('',{source},{at})")


def check_mapped(runner):
    """Parts whose shapes are mapped into that of an assembly are not products next to it."""
    for count in (1, 2, 3):
        body = Body()
        part = body.shape([body.solid(body.box((0, 0, 0), (1, 2, 3)))])
        body.product("part", part)
        places = [body.axes((10.0 * k, 0, 0)) for k in range(count)]
        body.product("asm", body.shape([body.identity] + [add_mapped(body, part, place) for place in places]))
        runner.check_value(f"mapped {count} times", body.get_text(), 6.0 * count)
    body = Body()
    parts = [body.shape([body.solid(body.box((5.0 * k, 0, 0), (1, 2, 3 + k)))]) for k in range(2)]
    for k, part in enumerate(parts):
        body.product(f"part{k}", part)
    body.product("asm", body.shape([body.identity] + [add_mapped(body, part, body.identity) for part in parts]))
    runner.check_value("two parts", body.get_text(), 6.0 + 8.0)

    body = Body()
    part = body.shape([body.solid(body.box((0, 0, 0), (1, 2, 3)))])
    body.product("part", part)
    middle = body.shape([body.identity, add_mapped(body, part, body.identity), add_mapped(body, part, body.axes((9, 0, 0)))])
    body.product("middle", middle)
    body.product("asm", body.shape([body.identity, add_mapped(body, middle, body.identity), add_mapped(body, middle, body.axes((0, 9, 0)))]))
    runner.check_value("mapped through a product", body.get_text(), 24.0)

    body = Body()
    part = body.shape([body.solid(body.box((0, 0, 0), (1, 2, 3)))])
    definition = body.product("part", part)
    units = body.add("(MASS_UNIT()NAMED_UNIT(*)SI_UNIT(.KILO.,.GRAM.))"), body.add("(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT($,.METRE.))")
    elements = f"{body.add(f'DERIVED_UNIT_ELEMENT({units[0]},1.)')},{body.add(f'DERIVED_UNIT_ELEMENT({units[1]},-3.)')}"
    item = body.add(f"MEASURE_REPRESENTATION_ITEM('density measure',POSITIVE_RATIO_MEASURE(1000.),{body.add(f'DERIVED_UNIT(({elements}))')})")
    described = body.add(f"PROPERTY_DEFINITION('material property','density',{definition})")
    body.add(f"PROPERTY_DEFINITION_REPRESENTATION({described},{body.add(f'REPRESENTATION({EMPTY},({item}),{body.context})')})")
    body.product("asm", body.shape([body.identity] + [add_mapped(body, part, body.axes((9.0 * k, 0, 0))) for k in range(2)]))
    runner.check_value("with a density", body.get_text(), 12.0, 12e-6)

    body = Body()
    part = body.shape([body.solid(body.box((0, 0, 0), (1, 2, 3)))])
    body.product("part", part)
    body.product("other", body.shape([body.solid(body.box((20, 0, 0), (1, 1, 1)))]))
    body.product("asm", body.shape([body.identity, add_mapped(body, part, body.identity)]))
    runner.check_value("a product next to them", body.get_text(), 7.0)


def add_occurrence(body, parent, child, at=None, shapes=None):
    """An occurrence, placed by a relationship of the shapes of child and parent if `at` is given."""
    occurrence = body.add(f"NEXT_ASSEMBLY_USAGE_OCCURRENCE('o','o','',{parent},{child},$)")
    if at:
        property_ = body.add(f"PRODUCT_DEFINITION_SHAPE('','',{occurrence})")
        body.add(f"CONTEXT_DEPENDENT_SHAPE_REPRESENTATION({add_relationship(body, *shapes, at)},{property_})")


def add_relationship(body, child, parent, at):
    """`at` and the identity are frames of the parent and of the child."""
    motion = body.add(f"ITEM_DEFINED_TRANSFORMATION('','',{body.identity},{at})")
    return body.add(f"(REPRESENTATION_RELATIONSHIP('','',{child},{parent})REPRESENTATION_RELATIONSHIP_WITH_TRANSFORMATION({motion})"
                    "SHAPE_REPRESENTATION_RELATIONSHIP())")


def check_placed(runner):
    """Every arc of the product structure is followed: mapped items that place occurrences, and relationships without an occurrence."""
    def add_box(body, x=0.0):
        return body.shape([body.identity, body.solid(body.box((x, 0, 0), (1, 2, 3)))])

    # A part of a sub-assembly that a mapped item places, and the same part elsewhere.
    body = Body()
    part, middle = add_box(body), body.shape([body.identity])
    whole = body.shape([body.identity, add_mapped(body, middle, body.axes((20, 0, 0)))])
    products = [body.product(name, shape) for name, shape in (("part", part), ("middle", middle), ("asm", whole))]
    add_occurrence(body, products[1], products[0], body.axes((5, 0, 0)), (part, middle))
    add_occurrence(body, products[2], products[0], body.axes((0, 9, 0)), (part, whole))
    add_occurrence(body, products[2], products[1])
    runner.check_value("a part of a mapped sub-assembly", body.get_text(), 12.0, center=(13.0, 5.5, 1.5))

    # A relationship without an occurrence, alone and with a mapped item of the same part.
    for count in (1, 2):
        body = Body()
        part = add_box(body)
        whole = body.shape([body.axes((0, 0, 0))] + [add_mapped(body, part, body.axes((20, 0, 0)))] * (count - 1))
        body.product("asm", whole)
        add_relationship(body, part, whole, body.axes((0, 9, 0)))
        runner.check_value(f"placed by a relationship, {count}", body.get_text(), 6.0 * count,
                           center=(0.5, 10.0, 1.5) if count == 1 else (10.5, 5.5, 1.5))

    # Both shapes of a part are mapped, or one of them is.
    for count in (1, 2):
        body = Body()
        shapes = [add_box(body, 5.0 * k) for k in range(2)]
        part = body.product("part", shapes[0])
        body.define(part, shapes[1])
        items = [add_mapped(body, shape, body.axes((20.0 * (k + 1), 0, 0))) for k, shape in enumerate(shapes[:count])]
        whole = body.product("asm", body.shape([body.identity] + items))
        add_occurrence(body, whole, part)
        runner.check_value(f"two shapes of a part, {count} mapped", body.get_text(), 12.0, center=(23.0 if count == 1 else 33.0, 1.0, 1.5))

    # A shape of two products is placed in both.
    body = Body()
    part, middle = add_box(body), body.shape([body.identity])
    whole = body.shape([body.identity, add_mapped(body, middle, body.axes((20, 0, 0)))])
    products = [body.product(name, shape) for name, shape in (("part", part), ("middle", middle), ("one", whole), ("two", whole))]
    add_occurrence(body, products[1], products[0], body.axes((5, 0, 0)), (part, middle))
    add_occurrence(body, products[2], products[1])
    runner.check_flagged("an occurrence in one of two products of a shape", body.get_text())


def check_unclear(runner):
    """What places the shape of a product without an occurrence leaves open what is counted: such files are flagged."""
    def add_box(body, x=0.0):
        return body.shape([body.identity, body.solid(body.box((x, 0, 0), (1, 2, 3)))])

    for kind in ("mapped item", "relationship"):
        # A part; a sub-assembly whose part is in an occurrence, alone and with that part elsewhere.
        for count in (0, 1, 2):
            body = Body()
            part = add_box(body)
            middle = body.shape([body.identity]) if count else part
            at = body.axes((20, 0, 0))
            whole = body.shape([body.identity, add_mapped(body, middle, at) if kind == "mapped item" else at])
            products = [body.product(name, shape) for name, shape in (("part", part), *((("middle", middle),) if count else ()), ("asm", whole))]
            if kind == "relationship":
                add_relationship(body, middle, whole, at)
            for parent, shape in ((products[1], middle), (products[-1], whole))[:count]:
                add_occurrence(body, parent, products[0], body.axes((5, 0, 0)), (part, shape))
            if count == 0 and kind == "mapped item":
                runner.check_value("a mapped part", body.get_text(), 6.0, center=(20.5, 1.0, 1.5))
            else:
                runner.check_flagged(f"{kind}, {count} occurrences of the part", body.get_text())

    # A second relationship of the shapes of an occurrence, at another place.
    for count in (1, 2):
        body = Body()
        part, whole = add_box(body), body.shape([body.identity])
        products = [body.product(name, shape) for name, shape in (("part", part), ("asm", whole))]
        add_occurrence(body, products[1], products[0], body.axes((5, 0, 0)), (part, whole))
        if count == 1:
            runner.check_value("one placement", body.get_text(), 6.0, center=(5.5, 1.0, 1.5))
        else:
            add_relationship(body, part, whole, body.axes((0, 9, 0)))
            runner.check_flagged("two placements", body.get_text())


def check_repeated(runner):
    """A solid that is in one place twice, without an occurrence for each, is flagged; two occurrences in one place are what the file states."""
    def add_box(body):
        return body.solid(body.box((0, 0, 0), (1, 2, 3)))

    def add_part(body):
        part = body.shape([body.identity, add_box(body)])
        return part, body.product("part", part)

    def map_once(body):
        part, definition = add_part(body)
        body.define(definition, body.shape([body.identity, add_mapped(body, part, body.identity)]))

    def share_solid(body):
        solid = add_box(body)
        for name in ("one", "two"):
            body.product(name, body.shape([body.identity, solid]))

    def repeat_part(body):
        solid = add_box(body)
        part, whole = body.shape([body.identity, solid]), body.shape([body.identity, solid])
        definition = body.product("part", part)
        add_occurrence(body, body.product("asm", whole), definition, body.identity, (part, whole))

    def join_products(body):
        shapes = [body.shape([body.identity, body.solid(body.box((9 * k, 0, 0), (1, 2, 3)))]) for k in range(2)]
        products = [body.product(f"part{k}", shape) for k, shape in enumerate(shapes)]
        body.add(f"SHAPE_REPRESENTATION_RELATIONSHIP('','',{shapes[0]},{shapes[1]})")
        whole = body.shape([body.identity])
        assembly = body.product("asm", whole)
        for k, product in enumerate(products):
            add_occurrence(body, assembly, product, body.axes((0, 9 * k, 0)), (shapes[k], whole))

    def occur_twice(body):
        part, definition = add_part(body)
        whole = body.shape([body.identity])
        assembly = body.product("asm", whole)
        for _ in range(2):
            add_occurrence(body, assembly, definition, body.axes((5, 0, 0)), (part, whole))

    def map_next_to_part(body, x, shift):
        """A part, and its solid in the same place by a mapped item of the assembly with another frame. Returns the item."""
        solid = add_box(body)
        part, inner = body.shape([body.identity, solid]), body.shape([body.identity, solid])
        source = body.add(f"REPRESENTATION_MAP({body.axes((-shift, 0, 0))},{inner})")
        item = body.add(f"MAPPED_ITEM('',{source},{body.axes((round(x - shift, 9), 0, 0))})")
        whole = body.shape([body.identity, item])
        definition = body.product("part", part)
        add_occurrence(body, body.product("asm", whole), definition, body.axes((x, 0, 0)), (part, whole))
        return item

    # Motions that differ by a rounding are one place, also where they lie halfway between two nanometres.
    for x in (5.3, 25.4 / 128.0, 25.4 * 3.0 / 128.0, 25.4 * 129.0 / 128.0, 5123456789.0123, 4e13 / 3.0):
        for shift in (0.1, 0.7, 12.7, 1000.3):
            body = Body()
            map_next_to_part(body, x, shift)
            code, entry = runner.run("in two frames", body.get_text())
            check_true(f"at {x} in a frame at {shift}", code != 0 and entry["status"] == "suspect" and any("is in one place twice" in m for m in entry["messages"]),
                       f"{code} {entry['status']}, volume {entry['total']['volume']}, {entry['messages']}")
    # Places far away are not one place, nor are rotated ones.
    for name, places in (("far", [(1e13, 0, 0), (2e13, 0, 0), (0, 0, 0), (0, 3e13, 0)]), ("close", [(0.19843751 + 2e-5 * k, 0, 0) for k in range(3)])):
        body = Body()
        part = body.shape([body.identity, add_box(body)])
        body.product("asm", body.shape([body.identity] + [add_mapped(body, part, body.axes(place)) for place in places]))
        entry = runner.run(name, body.get_text())[1]
        check_true(f"{name} places differ", abs(entry["total"]["volume"] - 6.0 * len(places)) < 1e-6 and not any("one place" in m for m in entry["messages"]),
                   f"{entry['status']}, volume {entry['total']['volume']}, {entry['messages']}")
    body = Body()
    part = body.shape([body.identity, add_box(body)])
    rotated = [body.axes((7, 0, 0), (0, 0, 1), direction) for direction in ((1, 0, 0), (0, 1, 0), (-1, 0, 0), (0, -1, 0))]
    body.product("asm", body.shape([body.identity] + [add_mapped(body, part, place) for place in rotated]))
    runner.check_value("rotated places differ", body.get_text(), 24.0)

    # What the file hides and a run leaves out is not counted twice.
    body = Body()
    item = map_next_to_part(body, 5.3, 0.7)
    body.add(f"INVISIBILITY(({body.add(f'PRESENTATION_LAYER_ASSIGNMENT({EMPTY},{EMPTY},({item}))')}))")
    runner.check_flagged("a hidden copy counts", body.get_text())
    for mode in ("skip", "only"):
        runner.check_value(f"hidden copy, {mode}", body.get_text(), 6.0, allowed="left out", center=(5.8, 1.0, 1.5), arguments=("--hidden", mode))

    for work in (map_once, share_solid, repeat_part, join_products):
        body = Body()
        work(body)
        runner.check_flagged(work.__name__, body.get_text())
    body = Body()
    occur_twice(body)
    runner.check_value("two occurrences in one place", body.get_text(), 12.0, allowed="they overlap, and both are counted")
    body = Body()
    part, definition = add_part(body)
    shapes = [body.shape([body.identity]) for _ in range(2)]
    middle, whole = (body.product(name, shape) for name, shape in zip(("middle", "asm"), shapes))
    add_occurrence(body, middle, definition, body.axes((-0.7, 0, 0)), (part, shapes[0]))
    add_occurrence(body, whole, middle, body.axes((0.8984375, 0, 0)), (shapes[0], shapes[1]))
    add_occurrence(body, whole, definition, body.axes((0.1984375, 0, 0)), (part, shapes[1]))
    runner.check_value("two occurrences in two frames", body.get_text(), 12.0, allowed="they overlap, and both are counted")


run_modes()
