"""The conditions of SweepModels.py on one real file.

Errors and bounds are relative: volume and area to themselves, the centre to the cube root of the volume, inertia to its
trace. The reference's `uncertainty` is that of the integrator which made it, found by moving the origin of the volume. It
is held to be the same, at those scales, for area, centre and inertia, which come from the same samples. Reference and
program close the gaps between faces in the same way, but the reader brings trim curves into step with their edges and the
reference does not: ribbons then differ, by less than the squared gap, which is allowed for where it is above 1e-10.
The references were made of shapes that OpenCASCADE had repaired, the program reads sound ones as the file has them: trim curves differ
within the gaps, and the area by the area of both gaps at most. Where more differs, SweepExceptions.json says why the file is right.
"""
import math

DEFAULT_TOLERANCE = 1e-9
TOLERANCES = (DEFAULT_TOLERANCE, 1e-12)
CLOSURE_LIMIT = 1e-12
# Name here -> key in JSON, of the program and of the reference.
QUANTITIES = {"volume": "volume", "area": "area", "center": "center_of_mass", "inertia": "inertia"}
# References of surfaces state no uncertainty.
SURFACE_LIMIT = 1e-9
# The display mesh is off by no more.
MESH_VOLUME_LIMIT = 0.03
# Relative squared gaps above this are allowed for.
LARGE_GAP_SQUARED = 1e-10
OCCT = "occt_eps_1e-09"


class Run:
    """One run: what came out, the figures of every quantity, and the conditions missed with what was found instead."""

    def __init__(self, tolerance, code, document, stderr, seconds):
        self.tolerance = tolerance
        self.code = code
        self.document = document
        self.stderr = stderr
        self.seconds = seconds
        self.missed = {}
        self.errors = {}
        self.bounds = {}
        self.allowed = {}
        # The tolerance of the centre refers to half the diagonal where that is more than the cube root of the
        # volume.
        self.center_scale = 1.0

    def total(self, key):
        return self.document["total"].get(key) if self.document else None

    def status(self):
        return self.document["status"] if self.document else "crash"

    def is_closed(self):
        residual = self.total("closure_residual")
        return residual is not None and residual <= CLOSURE_LIMIT

    def is_tight(self, name):
        bound = self.bounds.get(name)
        return bound is not None and bound <= self.tolerance * (self.center_scale if name == "center" else 1.0)

    def is_right(self, name):
        error, allowed = self.errors.get(name), self.allowed.get(name)
        return error is not None and allowed is not None and error <= allowed


class Swept:
    """A file, its reference values, and its runs in the order of TOLERANCES."""

    def __init__(self, reference, runs):
        self.reference = reference
        self.runs = runs

    def has_solids(self):
        return "volume" in self.reference


def difference(actual, expected):
    """Largest difference of two numbers or nested lists; None when a value is missing."""
    if isinstance(expected, list):
        if actual is None or len(actual) != len(expected):
            return None
        parts = [difference(a, e) for a, e in zip(actual, expected)]
        return None if None in parts else max(parts)
    return None if actual is None else abs(actual - expected)


def scales(reference):
    volume = abs(reference["volume"])
    return {"volume": volume, "area": reference["area"], "center": volume ** (1 / 3),
            "inertia": sum(reference["inertia"][i][i] for i in range(3))}


def closer_than_occt(reference, run):
    """How many times closer than OCCT's the volume is to that which the CAD system wrote into the file."""
    written, volume = reference.get("volume_written_by_cad"), run.total("volume")
    if written is None or volume is None:
        return None
    return abs(reference[OCCT]["volume"] - written) / max(abs(volume - written), 1e-300)


def occt_error(reference, exact="volume"):
    """OCCT's error, relative as its claim. It integrates the faces alone: of these `volume_faces_only` is exact."""
    return abs(reference[OCCT]["volume"] - reference[exact]) / abs(reference["volume"])


def judge_unreadable(run):
    if run.code != 2 or run.status() != "unreadable" or not run.document["messages"]:
        run.missed["status"] = f"exit status {run.code}, status {run.status()}, messages {run.document['messages']}"


def judge_surfaces(reference, run):
    if run.status() != "open" or run.code != 3:
        run.missed["status"] = f"exit status {run.code}, status {run.status()}: a surface is open"
    if run.total("volume") is not None:
        run.missed["volume"] = f"{run.total('volume')}, but surfaces have none"
    error = difference(run.total("area"), reference["area"])
    bound = run.document["total"]["bounds"]["area"]
    if error is None or bound is None:
        run.missed["area"] = "none"
        return
    run.errors["area"] = error / reference["area"]
    run.bounds["area"] = bound / reference["area"]
    run.allowed["area"] = run.bounds["area"] + SURFACE_LIMIT + get_gap_area(reference, run)
    if not run.is_right("area"):
        run.missed["area"] = f"{run.errors['area']:.2e} off, {run.allowed['area']:.2e} allowed"


def judge_quantity(reference, run, name, key, scale):
    error, bound = difference(run.total(key), reference[key]), run.document["total"]["bounds"][key]
    if error is None or bound is None or not math.isfinite(bound) or not bound > 0:
        run.missed[name] = f"no value or no bound: {run.total(key)}, {bound}"
        return
    run.errors[name] = error / scale
    run.bounds[name] = bound / scale
    if name == "center":
        run.center_scale = max(1.0, 0.5 * run.document["diagonal"] / scale)
    gap = get_gap_area(reference, run) if name == "area" else get_gap_squared(reference)
    run.allowed[name] = run.bounds[name] + reference["uncertainty"] + gap
    if not run.is_right(name):
        run.missed[name] = (f"{run.errors[name]:.2e} off, {run.allowed[name]:.2e} allowed "
                            f"(bound {run.bounds[name]:.2e}, uncertainty {reference['uncertainty']:.1e})")
    if run.tolerance == DEFAULT_TOLERANCE and not run.is_tight(name):
        run.missed["bound"] = f"{name} {run.bounds[name]:.2e}"


def get_gap_area(reference, run):
    return (reference.get("gap_area", 0.0) + (run.total("gap_area") or 0.0)) / reference["area"]


def get_gap_squared(reference):
    gap = reference.get("gap_squared", 0.0)
    return gap if gap > LARGE_GAP_SQUARED else 0.0


def judge_solids(reference, run):
    """Every solid of the file against its own volume."""
    solids, expected = run.document["solids"], reference.get("solid_volumes")
    if expected is None:
        return
    if len(solids) != len(expected):
        run.missed["solids"] = f"{len(solids)} solids, {len(expected)} expected"
        return
    for solid, volume in zip(solids, expected):
        bound = solid["bounds"]["volume"]
        error = difference(solid["volume"], volume)
        allowed = (bound or 0.0) + (reference["uncertainty"] + get_gap_squared(reference)) * abs(volume)
        if error is None or bound is None or not error <= allowed:
            run.missed["solids"] = f"{solid['name']}: {solid['volume']} +/- {bound}, {volume} expected"


def judge_status(reference, run):
    status = run.status()
    if (run.code, status) not in ((0, "ok"), (3, "open"), (3, "tolerance-not-met"), (3, "suspect")):
        run.missed["status"] = f"exit status {run.code}, status {status}"
    if (status == "open") != (reference["open_edges"] > 0):
        run.missed["open"] = (f"status {status}, {run.total('open_edges')} open edges, the reference has "
                              f"{reference['open_edges']}")
    loose = [f"{name} {run.bounds[name]:.2e}" for name in QUANTITIES if not run.is_tight(name) and name in run.bounds]
    if status == "ok" and loose:
        run.missed["honest"] = f"status ok, but bounds above the tolerance: {', '.join(loose)}"


def judge(reference, run):
    """Fills the figures of a run and the conditions that it misses."""
    if run.document is None:
        run.missed["crash"] = f"exit status {run.code}, no JSON: {run.stderr[-300:]}"
        return
    if not reference["readable"]:
        judge_unreadable(run)
        return
    if "volume" not in reference:
        judge_surfaces(reference, run)
        return
    for name, scale in scales(reference).items():
        judge_quantity(reference, run, name, QUANTITIES[name], scale)
    judge_solids(reference, run)
    judge_status(reference, run)


def judge_kernel(reference, kernel, mesh):
    """Conditions that the reader misses: what it converted against OpenCASCADE's shapes, and the display mesh."""
    if not reference["readable"]:
        return {} if kernel is None else {"kernel": "an unreadable file has shapes"}
    if kernel is None:
        return {"kernel": "no shapes were read"}
    solids = reference["solids"] > 0
    expected = {"solids": reference["solids"], "faces": reference["faces"], "missing_faces": 0,
                "defects": reference.get("open_loops", 0), "above_limits": 0}
    if solids:
        expected["open_edges"] = reference.get("open_edges", 0)
    missed = {key: f"{kernel[key]} instead of {value}; {' | '.join(kernel['messages'][:4])}"
              for key, value in expected.items() if kernel[key] != value}
    # The reference samples the gap between coedge and edge far more densely; what we see is never more.
    if solids and not kernel["max_gap"] <= 1.05 * reference["max_gap"] + 1e-8:
        missed["max_gap"] = f"{kernel['max_gap']} mm between coedges and edges, the reference has {reference['max_gap']}"
    if mesh["bad_normals"]:
        missed["normals"] = f"{mesh['bad_normals']} of the display mesh are not unit vectors"
    if solids and not abs(mesh["volume"] / reference["volume"] - 1) <= MESH_VOLUME_LIMIT:
        missed["mesh_volume"] = f"{mesh['volume']}"
    return missed
