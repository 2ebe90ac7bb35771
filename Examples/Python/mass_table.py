"""Functions that the scripts of this folder share: arguments, exit status, and the filter's outputs as a table and as CSV."""
import argparse
import csv
import decimal
import io
import math
import os
import shutil
import sys

# Exit statuses, as those of `solidmoments`; when several apply, the first of 1, 2, 3.
ALL_OK, USAGE_OR_OUTPUT, UNREADABLE, FLAGGED = range(4)

# Entries of a symmetric matrix, and their components.
SIX, SIX_COMPONENTS = ("xx", "yy", "zz", "xy", "yz", "xz"), (0, 4, 8, 1, 5, 2)

# A column of the CSV with its name in `solidmoments --csv`, the filter's array, and the component.
COLUMNS = (
    [("volume", "Volume", 0), ("volume_bound", "VolumeBound", 0), ("area", "SurfaceArea", 0), ("area_bound", "SurfaceAreaBound", 0)]
    + [("center_" + axis, "CenterOfMass", i) for i, axis in enumerate("xyz")] + [("center_bound", "CenterOfMassBound", 0)]
    + [("inertia_" + axes, "VolumeInertia", i) for axes, i in zip(SIX, SIX_COMPONENTS)]
    + [("inertia_bound", "VolumeInertiaBound", 0)] + [(f"principal_{i + 1}", "PrincipalMoments", i) for i in range(3)]
    + [(f"axis{i + 1}_{axis}", "PrincipalAxes", 3 * i + k) for i in range(3) for k, axis in enumerate("xyz")]
    + [("mass", "Mass", 0), ("mass_bound", "MassBound", 0), ("closure_spread_volume", "VolumeSpread", 0),
       ("closure_spread_area", "SurfaceAreaSpread", 0), ("closure_spread_center", "CenterOfMassSpread", 0),
       ("closure_spread_inertia", "VolumeInertiaSpread", 0), ("closure_spread_mass", "MassSpread", 0), ("closure_correction", "ClosureCorrection", 0),
       ("gap_squared", "GapSquared", 0), ("max_gap", "MaxGap", 0), ("gap_area", "GapArea", 0), ("open_edges", "OpenEdges", 0),
       ("closure_residual", "ClosureResidual", 0), ("flipped_shells", "FlippedShells", 0), ("density", "Density", 0),
       ("mass_uncertainty", "MassUncertainty", 0), ("mass_uncertainty_density", "MassUncertainty", 1),
       ("mass_uncertainty_gaps", "MassUncertainty", 2), ("mass_uncertainty_overridden", "MassUncertainty", 4),
       ("overridden_mass", "OverriddenMass", 0)]
    + [("mass_center_" + axis, "MassCenter", i) for i, axis in enumerate("xyz")] + [("mass_center_bound", "MassCenterBound", 0)]
    + [("mass_inertia_" + axes, "MassInertia", i) for axes, i in zip(SIX, SIX_COMPONENTS)] + [("mass_inertia_bound", "MassInertiaBound", 0)]
    + [("known_mass", "KnownMass", 0), ("known_mass_bound", "KnownMassBound", 0), ("solids_with_mass", "SolidsWithMass", 0),
       ("solids_with_volume", "SolidsWithVolume", 0)]
    + [(f"radius_of_gyration_{i + 1}", "RadiiOfGyration", i) for i in range(3)] + [("radius_of_gyration_bound", "RadiiOfGyrationBound", 0)]
    + [("inertia_at_origin_" + axes, "VolumeInertiaAtOrigin", i) for axes, i in zip(SIX, SIX_COMPONENTS)]
    + [("inertia_at_origin_bound", "VolumeInertiaAtOriginBound", 0)])
HEAD = ["file", "row", "name", "id", "status", "length_unit"] + [column for column, _, _ in COLUMNS] + ["material"]


def exit_without_package(error):
    """Ends the script because VTK or the package solidmoments does not load."""
    sys.exit(f"{error}\nPYTHONPATH has to name the folder that holds the package solidmoments, and the folder of the VTK that "
             "SolidMoments was built with.")


class Parser(argparse.ArgumentParser):
    """Arguments of both scripts; wrong usage ends with USAGE_OR_OUTPUT."""

    def __init__(self, description):
        super().__init__(description=description.strip(), formatter_class=argparse.RawDescriptionHelpFormatter)
        self.add_argument("files", nargs="+", metavar="FILE.step")
        self.add_argument("--density", type=float, default=0.0, metavar="D",
                          help="density of all solids in kg/m^3 (default: that of the file; without one there is no mass)")
        self.add_argument("--unit", default="mm", choices=["mm", "cm", "m", "um", "inch", "ft", "file"],
                          help="length unit; file: the one that the file is written in (default: mm)")
        self.add_argument("--csv", metavar="FILE", help="write the table with all digits; - for the standard output")
        self.add_argument("--png", metavar="FILE",
                          help="draw the part; with several files each picture has the STEP file's name added: out-bracket.png")

    def error(self, message):
        self.print_usage(sys.stderr)
        self.exit(USAGE_OR_OUTPUT, f"{self.prog}: {message}\n")

    def parse(self):
        """The arguments, with `pictures`, a path or None for every file."""
        arguments = self.parse_args()
        if arguments.density != 0.0 and not 1e-200 <= arguments.density <= 1e200:
            self.error("the density must be from 1e-200 to 1e200 kg/m^3, or 0")
        arguments.pictures = [arguments.png] * len(arguments.files)
        if arguments.png and len(arguments.files) > 1:
            base, extension = os.path.splitext(arguments.png)
            stems = [os.path.splitext(os.path.basename(file))[0] for file in arguments.files]
            arguments.pictures = [f"{base}-{stem}{extension}" for stem in stems]
            if len(set(stems)) < len(stems):
                self.error("files of the same name would have one picture: draw them one by one")
        return arguments


def complain(message):
    """Prints a message on the standard error and returns USAGE_OR_OUTPUT."""
    print(f"{os.path.basename(sys.argv[0])}: {message}", file=sys.stderr, flush=True)
    return USAGE_OR_OUTPUT


def worse(one, other):
    """The exit status of two results."""
    return min((one, other), key=lambda status: status or math.inf)


def get_number(data, row, name, component=0):
    """A number; None when it is missing or not finite. `data`: the field data of port 0, or the table of port 1."""
    array = data.GetAbstractArray(name)
    value = array.GetComponent(row, component) if array else math.nan
    if not math.isfinite(value):
        return None
    return value if array.GetDataTypeAsString() == "double" else int(value)


def get_text(data, row, name):
    array = data.GetAbstractArray(name)
    return array.GetValue(row) if array else ""


def read_rows(file, totals, solids):
    """A dictionary for all solids together (port 0) and one for every solid (the table of port 1), keyed as in COLUMNS."""
    rows = []
    for kind, data, count in (("total", totals.GetFieldData(), 1), ("solid", solids.GetRowData(), solids.GetNumberOfRows())):
        for i in range(count):
            row = {"file": file, "row": kind, "name": get_text(data, i, "Name"), "id": get_text(data, i, "Id"),
                   "status": get_text(data, i, "Status"), "length_unit": get_text(data, i, "LengthUnit"),
                   "material": get_text(data, i, "Material")}
            row.update((column, get_number(data, i, name, component)) for column, name, component in COLUMNS)
            rows.append(row)
    return rows


def format_value(value, bound, digits=10):
    """The number with the digits that its bound leaves: rounded by at most a twentieth of it."""
    if value is None:
        return "-"
    if bound is None:
        return f"{value:.{digits}g}"
    if abs(value) <= 0.05 * bound:
        return "0"
    if bound == 0:
        return repr(value)
    digits = math.ceil(math.floor(math.log10(abs(value))) + 1 - math.log10(0.1 * bound))
    return f"{value:.{min(max(digits, 1), 17)}g}"


def format_bound(bound):
    """The bound of the number that format_value() prints, which includes its rounding, with two digits, rounded up."""
    if bound is None:
        return "-"
    return f"{decimal.Context(prec=2, rounding=decimal.ROUND_CEILING).create_decimal_from_float(1.05 * bound):.1e}"


def format_table(rows):
    """Lines of text: a head with units, a line for every solid, and one for the total when there are several solids."""
    unit = rows[0]["length_unit"]
    lines = [("solid", f"volume {unit}^3", "+-", f"area {unit}^2", "+-", "mass kg", f"centre of mass {unit}", "+-", "status")]
    total, solids = rows[0], rows[1:]
    for row in solids + ([dict(total, name="total")] if len(solids) != 1 else []):
        center = [format_value(row["center_" + axis], row["center_bound"]) for axis in "xyz"]
        lines.append((row["name"] or row["id"], format_value(row["volume"], row["volume_bound"]), format_bound(row["volume_bound"]),
                      format_value(row["area"], row["area_bound"]), format_bound(row["area_bound"]),
                      format_value(row["mass"], None), "  ".join(center), format_bound(row["center_bound"]), row["status"]))
    widths = [max(len(line[column]) for line in lines) for column in range(len(lines[0]))]
    names = (0, len(widths) - 1)  # flush left, numbers flush right
    return ["  ".join(cell.ljust(width) if column in names else cell.rjust(width)
                      for column, (cell, width) in enumerate(zip(line, widths))).rstrip() for line in lines]


def print_report(file, totals, solids, messages, arguments, rows):
    """Prints the table of one file and adds its rows to `rows`. Returns the exit status."""
    status = get_text(totals.GetFieldData(), 0, "Status")
    if not solids.GetNumberOfRows():
        complain(f"{file} is unreadable" + (": " + messages[-1] if messages else ""))
        return UNREADABLE
    found = read_rows(file, totals, solids)
    rows += found
    backend, renderer, reason = (get_text(totals.GetFieldData(), 0, name) for name in ("Backend", "Renderer", "BackendReason"))
    lines = [f"{file}   {status}   by {backend} on {renderer}" + (f" ({reason})" if reason else "")]
    lines += ["  " + line for line in format_table(found)] + ["  note: " + message for message in messages]
    # The standard output has either the CSV or the table.
    print(*lines, sep="\n", file=sys.stderr if arguments.csv == "-" else sys.stdout, flush=True)
    return ALL_OK if status == "ok" else FLAGGED


def add_picture(status, path, draw):
    """Calls draw(path), which returns an error message or an empty string, when there is a path and something to draw. Returns the
    exit status of table and picture."""
    problem = draw(path) if path and status != UNREADABLE else ""
    return complain(f"no picture {path}: {problem}") if problem else status


def save_file(path, data):
    """Replaces a regular file by one of these bytes; if that fails, the old file is unchanged. Raises OSError."""
    target = os.path.realpath(path)
    if os.path.exists(target) and not os.path.isfile(target):
        with open(target, "wb") as file:  # a device or a pipe
            file.write(data)
        return
    temporary = f"{target}.saving{os.getpid()}"
    try:
        with open(temporary, "xb") as file:
            file.write(data)
        if os.path.exists(target):
            shutil.copymode(target, temporary)
        os.replace(temporary, target)
    except OSError:
        if os.path.exists(temporary):
            os.remove(temporary)
        raise


def write_csv(path, rows, head=None):
    """Writes the columns HEAD, or those of `head`. Numbers have all digits and read back to the same bits. Raises OSError."""

    def write(file):
        writer = csv.DictWriter(file, head or HEAD, restval="", lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)  # a float is written by repr()

    if path == "-":
        write(sys.stdout)
        sys.stdout.flush()
        return
    text = io.StringIO(newline="")
    write(text)
    save_file(path, text.getvalue().encode())


def run(arguments, compute):
    """Calls compute(file, picture, arguments, rows) for every file and writes the CSV. Returns the exit status."""
    rows = []
    status = ALL_OK
    for file, picture in zip(arguments.files, arguments.pictures):
        status = worse(status, compute(file, picture, arguments, rows))
        if arguments.csv and arguments.csv != "-":
            try:
                write_csv(arguments.csv, rows)  # now: a crash in the next file does not cost these rows
            except OSError as error:
                return complain(f"{arguments.csv} cannot be written: {error.strerror}")
    if arguments.csv == "-":
        try:
            write_csv("-", rows)
        except OSError as error:
            status = complain(f"the standard output cannot be written: {error.strerror}")
    return status
