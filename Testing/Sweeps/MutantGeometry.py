"""Geometry of a STEP file that is exact and cheap: volumes of polyhedra by their corners, and how far corners lie off the
lines, circles, planes, cylinders and spheres that they should lie on. Part of the oracle of MutantSweep.py."""
import math

from MutantOracle import references


def subtract(a, b):
    return tuple(x - y for x, y in zip(a, b))


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def corners_of_loop(model, loop):
    """Corners in order, or None where the loop is not a closed chain of straight edges."""
    poly = model.get(loop, "POLY_LOOP")
    if poly is not None:
        points = [model.point(r) for r in references(poly)]
        return points if len(points) > 2 and None not in points else None
    ends = []
    for oriented in references(model.get(loop, "EDGE_LOOP") or []):
        edge, forward = straight_edge(model, oriented)
        if edge is None:
            return None
        ends.append(edge if forward else edge[::-1])
    if len(ends) < 3 or any(a[1] != b[0] for a, b in zip(ends, ends[1:] + ends[:1])):
        return None
    points = [model.point(e[0]) for e in ends]
    return points if None not in points else None


def curve_of_edge(model, edge):
    """Spatial curve of an EDGE_CURVE."""
    curve = model.at(model.get(edge, "EDGE_CURVE"), 3)
    for keyword in ("SURFACE_CURVE", "SEAM_CURVE", "INTERSECTION_CURVE"):
        inner = model.get(curve, keyword)
        if inner is not None:
            return model.at(inner, 1)
    return curve


def straight_edge(model, oriented):
    parameters = model.get(oriented, "ORIENTED_EDGE")
    edge = model.at(parameters, 3)
    if model.get(curve_of_edge(model, edge), "LINE") is None:
        return None, None
    ends = tuple(model.get(edge, "EDGE_CURVE")[1:3])
    return (ends if len(ends) == 2 else None), model.at(parameters, 4) == ".T."


def polyhedron_volume(model, solid):
    """Volume of a solid with plane faces and straight edges in the file's unit; None for any other."""
    total = 0.0
    for shell in model.shells(solid):
        part, faces = 0.0, list(references(model.get(shell, "CLOSED_SHELL") or []))
        for face in faces:
            parameters = model.get(face, "ADVANCED_FACE") or model.get(face, "FACE_SURFACE")
            if model.get(model.at(parameters, 2), "PLANE") is None:
                return None
            for bound in references(model.at(parameters, 1)):
                inner = model.get(bound, "FACE_OUTER_BOUND") or model.get(bound, "FACE_BOUND")
                points = corners_of_loop(model, model.at(inner, 1))
                if points is None:
                    return None
                origin = points[0]
                part += (1 if model.at(inner, 2) == ".T." else -1) * sum(
                    dot(origin, cross(a, b)) for a, b in zip(points[1:], points[2:])) / 6
        total = abs(part) if not total else total - abs(part)
    return total


def distance(model, shape, point):
    """Distance of a point from a line, circle, plane, cylinder or sphere; None for other shapes."""
    line = model.get(shape, "LINE")
    if line is not None:
        origin = model.point(model.at(line, 1))
        along = model.unit_vector(model.at(model.get(model.at(line, 2), "VECTOR"), 1))
        return math.dist(cross(subtract(point, origin), along), (0, 0, 0)) if origin and along else None
    for keyword in ("CIRCLE", "PLANE", "CYLINDRICAL_SURFACE", "SPHERICAL_SURFACE"):
        parameters = model.get(shape, keyword)
        if parameters is None:
            continue
        placement = model.get(model.at(parameters, 1), "AXIS2_PLACEMENT_3D")
        origin, axis = model.point(model.at(placement, 1)), model.unit_vector(model.at(placement, 2))
        radius = model.at(parameters, 2)
        if origin is None or axis is None or not (keyword == "PLANE" or isinstance(radius, float)):
            return None
        away = subtract(point, origin)
        height, size = dot(away, axis), math.dist(point, origin)
        if keyword == "PLANE":
            return abs(height)
        if keyword == "SPHERICAL_SURFACE":
            return abs(size - radius)
        radial = math.dist(cross(away, axis), (0, 0, 0)) - radius
        return abs(radial) if keyword == "CYLINDRICAL_SURFACE" else math.hypot(radial, height)
    return None


def worst_corner(model, solids):
    """(distance, where) of the corner that lies farthest off what it should lie on."""
    worst = (0.0, "")
    for solid in solids:
        for face in model.faces(solid):
            parameters = model.get(face, "ADVANCED_FACE") or model.get(face, "FACE_SURFACE")
            surface = model.at(parameters, 2)
            for bound in references(model.at(parameters, 1) or []):
                inner = model.get(bound, "FACE_OUTER_BOUND") or model.get(bound, "FACE_BOUND")
                for oriented in references(model.get(model.at(inner, 1), "EDGE_LOOP") or []):
                    edge = model.at(model.get(oriented, "ORIENTED_EDGE"), 3)
                    for end in (model.get(edge, "EDGE_CURVE") or [])[1:3]:
                        point = model.point(end)
                        for shape in (surface, curve_of_edge(model, edge)) if point else ():
                            off = distance(model, shape, point)
                            if off is not None and not off <= worst[0]:
                                worst = (off, f"#{end} off #{shape} by {off:.3g}")
    return worst
