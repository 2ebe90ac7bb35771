"""Table 1 of the paper, for the parts of make_paper_parts and for any folder of STEP files.

    table.py --program solidmoments --occt occt_mass_properties [--markdown FILE] [--csv FILE] [--only ID ...]
             [TITLE=]FOLDER...

For every .step, .stp or .step.gz of a folder: GAUSS2 with two sub-patches a knot interval each way, its paper's error
estimate, ADAPTIVE with its bound, and OpenCASCADE's BRepGProp in its default way, volume and centre of mass, each volume
against a reference:
- `formula`: the volume that parts.json next to the files gives;
- `file`: the volume and its uncertainty that reference.jsonl next to the files gives;
- `ADAPTIVE 1e-12`: else, ADAPTIVE at that tolerance, with its bound.
Times are the JSON's own seconds: of solidmoments preparing, and integrating, of the faster of two runs; of OpenCASCADE
VolumeProperties; reading the file, making the context and compiling shaders are in neither. A run that fails leaves its
reason in the row.

The table goes to stdout unless --markdown or --csv names a file. Exit status 0; 1 for wrong usage or a folder without files.
"""
import argparse
import dataclasses
import gzip
import json
import os
import shutil
import subprocess
import sys
import tempfile

import table_text

ENDINGS = (".step", ".stp", ".step.gz", ".stp.gz")
ADAPTIVE_TOLERANCE = "1e-9"
REFERENCE_TOLERANCE = "1e-12"
SUB_PATCHES = "2"
# Runs of each method of solidmoments, of which the fastest counts.
RUNS = 2
# Above this, the relative squared gaps of a reference limit its accuracy (Testing/Sweeps/SweepJudge.py).
LARGE_GAP_SQUARED = 1e-10


class Failure(Exception):
    """A run has no result, for the reason in the message."""


@dataclasses.dataclass
class Model:
    name: str
    path: str
    # Its entry of parts.json, and its line of reference.jsonl.
    exact: dict = None
    reference: dict = None


@dataclasses.dataclass
class Result:
    """The result of one method, or the reason why it has none."""
    volume: float = None
    center: list = None
    area: float = None
    # The diagonal of the box.
    diagonal: float = None
    # The time to integrate with OpenCASCADE; the time to prepare and integrate with the other methods.
    seconds: float = None
    prepare: float = None
    integrate: float = None
    status: str = None
    reason: str = None
    # In the unit of the volume.
    bound: float = None
    estimate: float = None
    estimate_with_boundary: float = None
    closure_correction: float = None
    sub_patches: int = None
    faces: int = None


@dataclasses.dataclass
class Row:
    name: str
    gauss2: Result
    adaptive: Result
    occt: Result
    reference: float = None
    reference_kind: str = None
    # The relative uncertainty of the reference.
    uncertainty: float = None
    # The volume of the reference; None: it has none, and that of ADAPTIVE takes its place.
    reference_center: list = None
    reference_center_kind: str = None
    # The chord tolerance of the GAUSS2 run, relative to the diagonal.
    chord: float = None

    def has_independent_reference(self):
        return self.reference_kind in ("formula", "file")

    def faces(self):
        return self.adaptive.faces if self.adaptive.faces is not None else self.gauss2.faces

    def difference(self, result):
        """The signed relative error; None without a value or a reference, and for ADAPTIVE when it is the reference."""
        if result.volume is None or not self.reference or (result is self.adaptive and not self.has_independent_reference()):
            return None
        return (result.volume - self.reference) / abs(self.reference)

    def fraction(self, value):
        """A volume's error as a fraction of the reference."""
        return None if value is None or not self.reference else value / abs(self.reference)

    def center(self):
        return self.reference_center or self.adaptive.center

    def center_kind(self):
        if self.reference_center:
            return self.reference_center_kind
        return "ADAPTIVE " + ADAPTIVE_TOLERANCE if self.adaptive.center else None

    def chords_doubt(self):
        """The approximate effect of the chords of planes on the volume of GAUSS2: their distance from the curves times the area."""
        if None in (self.chord, self.gauss2.diagonal, self.gauss2.area):
            return None
        return self.fraction(self.chord * self.gauss2.diagonal * self.gauss2.area)

    def doubt(self):
        """The part of GAUSS2's difference that is not its error on curved faces: the uncertainty of the reference, the volume change by
        closing the model's gaps, and the chords of planes."""
        return ((self.uncertainty or 0.0) + abs(self.fraction(self.adaptive.closure_correction) or 0.0)
                + abs(self.chords_doubt() or 0.0))

    def is_estimate_below_error(self, estimate):
        """True when the error is certainly larger than the estimate; None where one of them is missing."""
        error, claimed = self.difference(self.gauss2), self.fraction(estimate)
        return None if error is None or claimed is None else abs(error) - self.doubt() > claimed

    def is_bound_exceeded(self):
        error, bound = self.difference(self.adaptive), self.fraction(self.adaptive.bound)
        return None if error is None or bound is None else abs(error) > bound + (self.uncertainty or 0.0)


def run_json(command, seconds):
    """The JSON on a command's stdout; raises Failure."""
    try:
        done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, universal_newlines=True,
                              timeout=seconds, check=False)
    except subprocess.TimeoutExpired as expired:
        raise Failure(f"not done in {seconds:g} s") from expired
    except OSError as error:
        raise Failure(f"{command[0]} does not start: {error.strerror}") from error
    try:
        return json.loads(done.stdout)
    except ValueError as error:
        said = done.stderr.strip().splitlines()
        raise Failure(said[0] if said else f"exit status {done.returncode}, no JSON") from error


def choose_message(messages):
    """The message that reports why there is no volume, if there is one."""
    for word in ("no volume", "surface"):
        for message in messages:
            if word in message:
                return message
    return messages[0] if messages else "no volume"


def measure_best(options, path, arguments):
    """The fastest of several equal runs of solidmoments, or the first that fails."""
    best = None
    for _ in range(RUNS):
        result = measure(options, path, arguments)
        if result.reason:
            return result
        if best is None or result.prepare + result.integrate < best.prepare + best.integrate:
            best = result
    return best


def measure(options, path, arguments):
    """One run of solidmoments."""
    try:
        document = run_json([options.program, "--quiet", "--json", "-"] + arguments + [path], options.timeout)
        entry = document["files"][0]
        total, seconds = entry["total"], entry["seconds"]
        if total.get("volume") is None:
            return Result(status=entry["status"], faces=entry.get("faces"),
                          reason=f"{entry['status']}: {choose_message(entry.get('messages') or [])}".replace(
                              path, os.path.basename(path)))
        return Result(volume=total["volume"], center=total.get("center_of_mass"), area=total.get("area"),
                      diagonal=entry.get("diagonal"), status=entry["status"], prepare=seconds["prepare"],
                      integrate=seconds["integrate"], bound=total["bounds"]["volume"], faces=entry.get("faces"),
                      estimate=total.get("paper_error_estimate"),
                      estimate_with_boundary=total.get("paper_error_estimate_with_boundary"),
                      closure_correction=total.get("closure_correction"), sub_patches=total.get("sub_patches"))
    except Failure as failure:
        return Result(reason=str(failure))
    except (KeyError, IndexError, TypeError) as error:
        return Result(reason=f"its JSON is not as expected: {error!r}")


def ask_occt(options, path):
    try:
        answer = run_json([options.occt, path], options.timeout)
        return Result(volume=answer["volume"], center=answer["center_of_mass"], seconds=answer["seconds"])
    except Failure as failure:
        return Result(reason=str(failure))
    except (KeyError, TypeError) as error:
        return Result(reason=f"its JSON is not as expected: {error!r}")


def set_reference(options, row, model):
    for kind, known in (("file", model.reference), ("formula", model.exact)):
        if known and known.get("center_of_mass"):
            row.reference_center, row.reference_center_kind = known["center_of_mass"], kind
    if model.exact and model.exact.get("volume") is not None:
        row.reference, row.reference_kind, row.uncertainty = model.exact["volume"], "formula", 0.0
    elif model.reference is not None and model.reference.get("volume"):
        gap = model.reference.get("gap_squared", 0.0)
        row.reference, row.reference_kind = model.reference["volume"], "file"
        row.uncertainty = model.reference.get("uncertainty", 0.0) + (gap if gap > LARGE_GAP_SQUARED else 0.0)
    elif row.adaptive.volume is not None:
        tight = measure(options, model.path, ["--tolerance", REFERENCE_TOLERANCE])
        if tight.volume and tight.bound is not None:
            row.reference, row.reference_kind = tight.volume, "ADAPTIVE " + REFERENCE_TOLERANCE
            row.uncertainty = tight.bound / abs(tight.volume)


def make_row(options, model):
    gauss2 = measure_best(options, model.path, ["--scheme", "gauss2", "--subpatches", SUB_PATCHES,
                                                "--deviation", options.deviation, "--chord", f"{options.chord:g}"])
    adaptive = measure_best(options, model.path, ["--tolerance", ADAPTIVE_TOLERANCE])
    row = Row(model.name, gauss2, adaptive, ask_occt(options, model.path), chord=options.chord)
    set_reference(options, row, model)
    return row


def read_exact(folder):
    """The entries of parts.json by id, in its order; volume and centre are null or missing where no formula gives them."""
    path = os.path.join(folder, "parts.json")
    if not os.path.exists(path):
        return {}
    with open(path, encoding="utf-8") as file:
        return {part["id"]: part for part in json.load(file)["parts"]}


def read_references(folder):
    path = os.path.join(folder, "reference.jsonl")
    if not os.path.exists(path):
        return {}
    with open(path, encoding="utf-8") as file:
        lines = [json.loads(line) for line in file if line.strip()]
    return {line["id"]: line for line in lines}


def find_models(folder, unpacked):
    """The folder's models, unpacked: first those of the lists next to them, in that order, then the others by name."""
    exact, references = read_exact(folder), read_references(folder)
    order = list(exact) + list(references)
    models = []
    for file_name in sorted(os.listdir(folder)):
        ending = next((ending for ending in ENDINGS if file_name.lower().endswith(ending)), None)
        if ending is None:
            continue
        name, path = file_name[:-len(ending)], os.path.join(folder, file_name)
        if ending.endswith(".gz"):
            packed, path = path, os.path.join(unpacked, file_name[:-len(".gz")])
            with gzip.open(packed) as source, open(path, "wb") as target:
                shutil.copyfileobj(source, target)
        models.append(Model(name, path, exact.get(name), references.get(name)))
    return sorted(models, key=lambda model: order.index(model.name) if model.name in order else len(order))


def make_section(options, argument):
    """A folder's title and rows."""
    title, separator, folder = argument.partition("=")
    if not separator:
        title, folder = os.path.basename(os.path.normpath(argument)), argument
    rows = []
    with tempfile.TemporaryDirectory() as unpacked:
        for model in find_models(folder, unpacked):
            if options.only and model.name not in options.only:
                continue
            rows.append(make_row(options, model))
            print(table_text.progress(rows[-1]), file=sys.stderr, flush=True)
    return title, rows


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", required=True, help="path of solidmoments")
    parser.add_argument("--occt", required=True, help="path of occt_mass_properties")
    parser.add_argument("--markdown", help="write the table there")
    parser.add_argument("--csv", help="write a row per file there, with every number in full")
    parser.add_argument("--deviation", choices=("bounded", "sampled"), default="bounded",
                        help="how Eq. 36 finds the second derivatives: by control points (default) or by samples")
    parser.add_argument("--chord", type=float, default=1e-8,
                        help="GAUSS2's chord tolerance of planes, relative to the box's diagonal, default 1e-8")
    parser.add_argument("--only", action="append", help="this model only; may be given several times")
    parser.add_argument("--timeout", type=float, default=900.0, help="seconds that a run may take, default 900")
    parser.add_argument("folders", nargs="+", metavar="[TITLE=]FOLDER")
    return parser.parse_args()


def main():
    options = parse_arguments()
    try:
        sections = [make_section(options, folder) for folder in options.folders]
    except (OSError, ValueError, KeyError) as error:
        print(f"table.py: {error}", file=sys.stderr)
        return 1
    empty = [title for title, rows in sections if not rows]
    if empty:
        print(f"table.py: no STEP file in {', '.join(empty)}", file=sys.stderr)
        return 1
    text = table_text.markdown(sections, options.deviation, options.chord, RUNS)
    if options.markdown:
        with open(options.markdown, "w", encoding="utf-8") as file:
            file.write(text)
    if options.csv:
        with open(options.csv, "w", encoding="utf-8", newline="") as file:
            table_text.write_csv(sections, file)
    if not options.markdown and not options.csv:
        print(text, end="")
    return 0


if __name__ == "__main__":
    sys.exit(main())
