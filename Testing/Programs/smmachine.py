"""A machine of boxes, and checks of mass, centre and inertia of boxes against formulas, for the tests of products."""
from fractions import Fraction

from smcheck import check, check_true
from smproduct import Assembly, Part, get_properties

QUARTER = ((0, -1, 0), (1, 0, 0), (0, 0, 1))
KG = Fraction(1, 10 ** 9)  # kg of mm^3 at kg/m^3


def check_bounded(what, expected, actual, bound):
    """Within the bound, which is not vacuous."""
    check(what, float(expected), actual, bound + 1e-15 * abs(float(expected)), "its bound")
    check_true(what + ": bound", 0 <= bound <= 1e-8 * max(abs(float(expected)), 1.0), str(bound))


def check_matrix(what, expected, actual, bound):
    size = max(abs(float(x)) for row in expected for x in row)
    for i in range(3):
        for j in range(3):
            check(f"{what} {i}{j}", float(expected[i][j]), actual[i][j], bound + 1e-15 * size, "its bound")
    check_true(what + ": bound", 0 < bound <= 1e-8 * size, str(bound))


def check_mass(total, boxes, weights, length=Fraction(1)):
    """Mass, centre and inertia of boxes in mm with densities; `length` is mm of the unit of the results."""
    mass, center, get_inertia = get_properties(boxes, [w * KG for w in weights])
    check_bounded("mass", mass, total["mass"], total["bounds"]["mass"])
    for i in range(3):
        check(f"centre of mass {i}", float(center[i] / length), total["mass_center"][i],
              total["bounds"]["mass_center"] + 1e-15 * float(abs(center[i] / length)), "its bound")
    check_true("bound of the centre", 0 < total["bounds"]["mass_center"] < 1e-7, str(total["bounds"]["mass_center"]))
    inertia = [[x / length ** 2 for x in row] for row in get_inertia(center)]
    check_matrix("mass inertia", inertia, total["mass_inertia"], total["bounds"]["mass_inertia"])
    eigen = total["mass_principal_moments"]
    check("trace of the principal moments", float(sum(inertia[i][i] for i in range(3))), sum(eigen), 1e-12 * sum(eigen))
    for moment, radius in zip(eigen, total["mass_radii_of_gyration"]):
        check("radius of gyration", (moment / total["mass"]) ** 0.5, radius, 1e-14 * radius, "rounding")


def make_machine(bolt_density="7.85", plate_density="2700."):
    """A frame with two stations, each with a plate and three bolts, one of them lying; the plate is in inches."""
    bolt = Part("bolt", [((0, 0, 0), (2, 2, 10))], bolt_density, "g/cm^3")
    plate = Part("plate", [((0, 0, 0), (2, 1, "0.25"))], plate_density, "kg/m^3", "inch")
    station = Assembly("station", [(plate, (0, 0, 0), None), (bolt, (5, 5, "6.35"), None), (bolt, (20, 5, "6.35"), None),
                                   (bolt, (40, 5, "6.35"), QUARTER)])
    rail = Part("rail", [((0, 0, 0), (200, 10, 10))], "1.4", "g/cm^3")
    return Assembly("machine", [(station, (0, 0, 10), None), (station, (100, 0, 10), QUARTER), (rail, (0, 0, 0), None)])
