"""The results, exceptions and warnings of `mass_properties`."""
import dataclasses
import math

Vector = tuple[float, float, float]
Matrix = tuple[Vector, Vector, Vector]

# Unit of each quantity: power of the length unit L, and its other factors. A bound has the unit of its
# quantity.
_UNITS = {"volume": (3, ""), "area": (2, ""), "center_of_mass": (1, ""), "inertia": (5, ""), "inertia_at_origin": (5, ""),
          "principal_moments": (5, ""), "principal_axes": (0, ""), "radii_of_gyration": (1, ""), "mass": (0, "kg"), "mass_center": (1, ""),
          "mass_inertia": (2, "kg"), "mass_uncertainty": (0, "kg"), "overridden_mass": (0, "kg"), "density": (0, "kg/m^3"), "closure_correction": (3, ""), "gap_squared": (3, ""), "max_gap": (1, ""),
          "gap_area": (2, ""), "closure_residual": (0, "")}


class SolidMomentsError(RuntimeError):
    """There is no result, or a flagged one with strict=True. `status` is that of the program `solidmoments`, `messages` a tuple of texts,
    `properties` the flagged MassProperties or None."""

    def __init__(self, text, status, messages=(), properties=None):
        super().__init__(text)
        self.status, self.messages, self.properties = status, tuple(messages), properties


class FlaggedResultWarning(UserWarning):
    """The result has another status than ok; its text gives the reason."""


@dataclasses.dataclass(frozen=True)
class MassProperties:
    """Mass properties of a file, or of one of its solids (`solids`), in world coordinates.

    Every quantity has its error bound next to it, one number for all its components, in the same unit; `units` has the units. A quantity
    that could not be computed is None. `center_of_mass` and `inertia` are those of unit density: a homogeneous body; tensors have the
    negative products of inertia off the diagonal and are about the centre unless their name says otherwise. `mass_center` and
    `mass_inertia` take the densities of the solids as weight. `volume_spread` and the others say how far closing the gaps of
    the model in another way may change the quantity, which no bound includes; None where edges are open. `mass_uncertainty` has the
    uncertainty of the mass in kg: the sum, and its shares by the tolerance of the densities, by `mass_spread`, by `mass_bound` and by the tolerances of
    masses that `materials` state; `overridden_mass` is the part of the mass that they state. `status` is ok, open, suspect or
    tolerance-not-met; `closure_correction` and what follows it describe defects of the model, which are part of no bound.
    """

    file: str
    name: str
    id: str
    status: str
    length_unit: str
    volume: "float | None"
    volume_bound: "float | None"
    area: "float | None"
    area_bound: "float | None"
    center_of_mass: "Vector | None"
    center_of_mass_bound: "float | None"
    inertia: "Matrix | None"
    inertia_bound: "float | None"
    inertia_at_origin: "Matrix | None"
    inertia_at_origin_bound: "float | None"
    principal_moments: "Vector | None"
    principal_moments_bound: "float | None"
    principal_axes: "Matrix | None"
    principal_axes_bound: "float | None"
    radii_of_gyration: "Vector | None"
    radii_of_gyration_bound: "float | None"
    mass: "float | None"
    mass_bound: "float | None"
    mass_center: "Vector | None"
    mass_center_bound: "float | None"
    mass_inertia: "Matrix | None"
    mass_inertia_bound: "float | None"
    mass_uncertainty: "tuple[float, float, float, float, float] | None"
    overridden_mass: "float | None"
    density: "float | None"
    material: str
    volume_spread: "float | None"
    area_spread: "float | None"
    center_of_mass_spread: "float | None"
    inertia_spread: "float | None"
    principal_moments_spread: "float | None"
    mass_spread: "float | None"
    mass_center_spread: "float | None"
    mass_inertia_spread: "float | None"
    closure_correction: "float | None"
    gap_squared: "float | None"
    max_gap: "float | None"
    gap_area: "float | None"
    closure_residual: "float | None"
    open_edges: "int | None"
    messages: tuple[str, ...] = ()
    solids: tuple["MassProperties", ...] = dataclasses.field(default=(), repr=False)

    @property
    def units(self):
        """The unit of each quantity by its name; "1" for a number without unit."""
        units = {}
        for name, (power, factor) in _UNITS.items():
            length = self.length_unit + (f"^{power}" if power > 1 else "") if power else ""
            units[name] = " ".join(part for part in (factor, length) if part) or "1"
        return units

    def to_dict(self):
        """All numbers and texts of this row without messages and solids, components as center_of_mass_x, inertia_xy, principal_axes_1_x."""
        row = {}
        for field in dataclasses.fields(self):
            if field.name not in ("messages", "solids"):
                row.update(_components(field.name, getattr(self, field.name)))
        return row

    def _repr_html_(self):
        """The table that a notebook shows: quantities with bounds and units, a row per solid, and the messages."""
        import html
        head = ["quantity", "value", "bound", "unit"]
        rows = []
        for name in ("volume", "area", "center_of_mass", "principal_moments", "mass"):
            value, bound = getattr(self, name), getattr(self, name + "_bound")
            if value is not None:
                values = value if isinstance(value, tuple) else (value,)
                rows.append([name.replace("_", " ").replace("center", "centre"), ", ".join(_format(x, bound) for x in values),
                             _format_bound(bound), self.units[name]])
        text = f"<p><b>{html.escape(self.name or self.file)}</b>: {html.escape(self.status)}</p>" + _table(head, rows)
        if len(self.solids) > 1:
            text += _table(["solid", f"volume {self.units['volume']}", "bound", "mass kg", "status"],
                           [[solid.name or solid.id, _format(solid.volume, solid.volume_bound), _format_bound(solid.volume_bound),
                             _format(solid.mass, solid.mass_bound), solid.status] for solid in self.solids])
        return text + "".join(f"<p>{html.escape(message)}</p>" for message in self.messages)


# Names of the columns are in the code that reads the filter; None as a value keeps all columns of a table.
_SHAPES = {"center_of_mass": "xyz", "mass_center": "xyz", "principal_moments": "123", "radii_of_gyration": "123"}
_MATRICES = ("inertia", "inertia_at_origin", "mass_inertia", "principal_axes")


def _components(name, value):
    if name in _SHAPES:
        return {f"{name}_{axis}": value[i] if value else None for i, axis in enumerate(_SHAPES[name])}
    if name == "principal_axes":
        return {f"{name}_{i + 1}_{axis}": value[i][k] if value else None for i in range(3) for k, axis in enumerate("xyz")}
    if name in _MATRICES:
        pairs = ((0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (0, 2))
        return {f"{name}_{'xyz'[i]}{'xyz'[k]}": value[i][k] if value else None for i, k in pairs}
    return {name: value}


def _format(value, bound):
    """The number with the digits that its bound leaves: rounded by at most a twentieth of it."""
    if value is None:
        return "-"
    if bound is None:
        return f"{value:.15g}"
    if abs(value) <= 0.05 * bound:
        return "0"
    if bound == 0:
        return repr(value)
    digits = math.ceil(math.floor(math.log10(abs(value))) + 1 - math.log10(0.1 * bound))
    return f"{value:.{min(max(digits, 1), 17)}g}"


def _format_bound(bound):
    """The bound of the number that _format() prints, which includes its rounding, with two digits, rounded up."""
    import decimal
    if bound is None:
        return "-"
    return f"{decimal.Context(prec=2, rounding=decimal.ROUND_CEILING).create_decimal_from_float(1.05 * bound):.1e}"


def _table(head, rows):
    import html

    def line(cells, tag):
        return "<tr>" + "".join(f"<{tag}>{html.escape(cell)}</{tag}>" for cell in cells) + "</tr>"
    return "<table>" + line(head, "th") + "".join(line(row, "td") for row in rows) + "</table>"
