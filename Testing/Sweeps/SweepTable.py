"""The tables of SweepModels.py: a row on the console, Markdown, CSV, and the summary that Documentation/Numerics.md shows."""
import csv
import statistics

import SweepJudge

NAMES = {"volume": "volume", "area": "area", "center": "centre", "inertia": "inertia"}


DOCUMENT_MARKS = ("<!-- SweepModels -->\n", "<!-- /SweepModels -->\n")


def number(value, form="{:.1e}"):
    return "-" if value is None else form.format(value)


def ratio(error, limit):
    return None if error is None or limit is None else error / limit


def used(run, name):
    """Returns the error of a quantity over the error that is allowed, None where one of them is not known; above 1 the run fails."""
    return ratio(run.errors.get(name), run.allowed.get(name))


CONSOLE = "{:22}{:>6} {:>19} {:>19}" + " {:>8} {:>8}" * 4 + " {:>8} {:>8}" + " {:>8}" * 2 + "  {:18}{:>6}"


def console_header():
    head = ["file", "faces", "volume", "reference"]
    for name in ("dV", "dA", "dc", "dI"):
        head += [name, "bound"]
    return CONSOLE.format(*head, "closure_residual", "at 1e-12", "OCCT dV", "claimed", "status", "s")


def console_row(entry):
    first, second = entry.runs[0], entry.runs[-1]
    reference = entry.reference
    cells = [reference["id"][:21], number(first.document["faces"] if first.document else None, "{}"),
             number(first.total("volume"), "{:.12g}"), number(reference.get("volume"), "{:.12g}")]
    for name in SweepJudge.QUANTITIES:
        cells += [number(first.errors.get(name)), number(first.bounds.get(name))]
    solids = entry.has_solids()
    status = first.status() if first.status() == second.status() else first.status() + "/" + second.status()
    return CONSOLE.format(
        *cells, number(first.total("closure_residual")), number(second.bounds.get("volume")),
        number(SweepJudge.occt_error(reference) if solids else None),
        number(reference[SweepJudge.OCCT]["claimed"] if solids else None), status,
        number(first.seconds + second.seconds, "{:.1f}"))


def write_csv(swept, file):
    writer = csv.writer(file)
    head = ["file", "tolerance", "faces", "status"]
    for name in NAMES:
        head += [f"{name}_error", f"{name}_bound", f"{name}_allowed"]
    writer.writerow(head + ["volume", "volume_bound_absolute", "volume_reference", "area", "area_reference", "uncertainty",
                            "gap_squared", "closure_spread", "closure_residual", "closure_correction", "volume_written_by_cad", "occt_volume", "occt_error",
                            "occt_error_of_faces", "occt_claimed", "evaluations", "seconds"])
    for entry in swept:
        reference, solids = entry.reference, entry.has_solids()
        for run in entry.runs:
            document = run.document or {}
            row = [reference["id"], f"{run.tolerance:g}", document.get("faces"), run.status()]
            for name in NAMES:
                row += [run.errors.get(name), run.bounds.get(name), run.allowed.get(name)]
            row += [run.total("volume"), (run.total("bounds") or {}).get("volume"), reference.get("volume"), run.total("area"),
                    reference.get("area"), reference.get("uncertainty"), reference.get("gap_squared"),
                    (run.total("closure_spread") or {}).get("volume"), run.total("closure_residual"),
                    run.total("closure_correction"), reference.get("volume_written_by_cad")]
            row += [reference[SweepJudge.OCCT]["volume"], SweepJudge.occt_error(reference),
                    SweepJudge.occt_error(reference, "volume_faces_only"),
                    reference[SweepJudge.OCCT]["claimed"]] if solids else [None] * 4
            writer.writerow(row + [document.get("evaluations"), f"{run.seconds:.2f}"])


def markdown(swept, summary):
    """The summary and a row per file with solids."""
    lines = ["# Real files", "", summary, "", "## File by file", "",
             "Errors and bounds are relative, as above; error / allowed is at the default tolerance and at 1e-12. "
             "OCCT: BRepGProp, Eps = 1e-9.", "",
             "| file | volume | reference | error | bound | error / allowed | bound at 1e-12 | error / allowed "
             "| area: error | bound | centre: error | bound | inertia: error | bound | closure residual | OCCT's error | it claims |",
             "|---" * 17 + "|"]
    for entry in swept:
        if not entry.has_solids():
            continue
        first, second, reference = entry.runs[0], entry.runs[-1], entry.reference
        cells = [reference["id"], number(first.total("volume"), "{:.12g}"), f"{reference['volume']:.12g}",
                 number(first.errors.get("volume")), number(first.bounds.get("volume")),
                 number(used(first, "volume"), "{:.0e}"), number(second.bounds.get("volume")),
                 number(used(second, "volume"), "{:.0e}")]
        for name in ("area", "center", "inertia"):
            cells += [number(first.errors.get(name)), number(first.bounds.get(name))]
        cells += [number(first.total("closure_residual")), number(SweepJudge.occt_error(reference)),
                  number(reference[SweepJudge.OCCT]["claimed"])]
        lines.append("| " + " | ".join(cells) + " |")
    return "\n".join(lines) + "\n"


def add_types(types, kernel):
    """Adds the surface types of a file to those of all."""
    for name, tally in (kernel or {"types": {}})["types"].items():
        total = types.setdefault(name, {"faces": 0, "surface": 0.0, "trim": 0.0})
        total["faces"] += tally["faces"]
        for key in ("surface", "trim"):
            total[key] = max(total[key], tally[key])


def types(tallies):
    """Worst distances from OpenCASCADE's points, relative, by type of surface."""
    lines = ["{:32} {:>7} {:>9} {:>9}".format("surface type", "faces", "surface", "trim")]
    for name, tally in sorted(tallies.items()):
        lines.append(f"{name:32} {tally['faces']:7} {tally['surface']:9.1e} {tally['trim']:9.1e}")
    return "\n".join(lines)


def middle_and_worst(values):
    values = [value for value in values if value is not None]
    return f"{statistics.median(values):.0e}, {max(values):.0e}" if values else "-"


def summary(swept):
    """Markdown: what Documentation/Numerics.md shows."""
    solids = [entry for entry in swept if entry.has_solids()]
    count = len(solids)
    # Where the reference vouches for twelve digits the error is the program's.
    vouched = [entry for entry in solids if entry.reference["uncertainty"] <= 1e-12]
    unreadable = sum(1 for entry in swept if not entry.reference["readable"])
    lines = [f"{len(swept)} files: {count} with solids, {len(swept) - count - unreadable} of surfaces alone, {unreadable} "
             f"unreadable; each read once and integrated at two tolerances.", "",
             "| | tolerance | error: median, worst | bound: median, worst | error <= bound + uncertainty + gaps "
             "| bound <= tolerance |", "|---|---|---|---|---|---|"]
    for name, title in NAMES.items():
        for index, tolerance in enumerate(SweepJudge.TOLERANCES):
            runs = [entry.runs[index] for entry in solids]
            right = sum(1 for run in runs if run.is_right(name))
            tight = sum(1 for run in runs if run.is_tight(name))
            errors = [entry.runs[index].errors.get(name) for entry in vouched]
            lines.append(f"| {title} | {tolerance:.0e} | {middle_and_worst(errors)} "
                         f"| {middle_and_worst([run.bounds.get(name) for run in runs])} "
                         f"| {right} of {count} | {tight} of {count} |")
    lines += ["", "Errors are those on the files whose reference vouches for twelve digits "
              f"({len(vouched)} of {count}). The references were made of shapes that OpenCASCADE had repaired: where the file itself is "
              "read otherwise, its gaps are what differs."]
    lines += ["", describe_without_gaps(solids)]
    for index, tolerance in enumerate(SweepJudge.TOLERANCES):
        residuals = [entry.runs[index].total("closure_residual") for entry in solids]
        closed = sum(1 for entry in solids if entry.runs[index].is_closed())
        lines.append(f"Closure residual at {tolerance:.0e}: <= {SweepJudge.CLOSURE_LIMIT:.0e} on {closed} of {count}; median, worst "
                     f"{middle_and_worst(residuals)}.")
    lines += ["", describe_spreads(solids)]
    lines += occt_lines(solids)
    return "\n".join(line.rstrip() for line in lines)


def describe_without_gaps(solids):
    """How many volumes at the default tolerance are within bound and uncertainty alone, and the one that is farthest beyond."""
    beyond = {}
    for entry in solids:
        error, bound = (values.get("volume") for values in (entry.runs[0].errors, entry.runs[0].bounds))
        if error is None or bound is None or not error <= bound + entry.reference["uncertainty"]:
            beyond[entry.reference["id"]] = float("inf") if error is None else error
    text = (f"Without the squared gap: at {SweepJudge.TOLERANCES[0]:.0e} the volume is within bound and uncertainty on "
            f"{len(solids) - len(beyond)} of {len(solids)}")
    return text + (f"; of the others {max(beyond, key=beyond.get)} differs most, by {max(beyond.values()):.0e}." if beyond else ".")


def describe_spreads(solids):
    """The closing spread of the volumes, relative to them, and how many volumes are within bound, uncertainty and spread."""
    spreads, within = [], 0
    for entry in solids:
        run, volume = entry.runs[0], entry.runs[0].total("volume")
        spread = (run.total("closure_spread") or {}).get("volume")
        if spread is not None and volume:
            spreads.append(spread / abs(volume))
            error, bound = run.errors.get("volume"), run.bounds.get("volume")
            within += None not in (error, bound) and error <= bound + entry.reference["uncertainty"] + spreads[-1]
    if not spreads:
        return "No volume has a closing spread."
    return (f"Closing spread of the volume, on {len(spreads)} of {len(solids)}: median, worst {middle_and_worst(spreads)}. Within bound, uncertainty "
            f"and spread of the reference's volume: {within} of {len(spreads)}.")


def replace_summary(document, text):
    before, _, rest = document.partition(DOCUMENT_MARKS[0])
    _, _, after = rest.partition(DOCUMENT_MARKS[1])
    if not after:
        raise ValueError("the document has no place for the summary: " + DOCUMENT_MARKS[0].strip())
    return before + DOCUMENT_MARKS[0] + text + "\n" + DOCUMENT_MARKS[1] + after


def occt_lines(solids):
    claims = [(SweepJudge.occt_error(entry.reference), SweepJudge.occt_error(entry.reference, "volume_faces_only"),
               entry.reference[SweepJudge.OCCT]["claimed"]) for entry in solids]
    exceeded = [ratio(min(error, faces), max(claim, 1e-16)) for error, faces, claim in claims
                if min(error, faces) > claim + 1e-12]
    lines = ["", f"OCCT's BRepGProp with Eps = 1e-9: error of the volume, median, worst "
             f"{middle_and_worst([error for error, _, _ in claims])}; against the faces alone, gaps left open, which is what "
             f"it integrates, {middle_and_worst([faces for _, faces, _ in claims])}. The error it claims is exceeded by more "
             f"than 1e-12 on {len(exceeded)} of {len(solids)}, even if held against the nearer of the two."]
    lines += ["", "| volume that the CAD system wrote | distance | OCCT's | times closer |", "|---|---|---|---|"]
    for entry in solids:
        closer = SweepJudge.closer_than_occt(entry.reference, entry.runs[0])
        if closer is not None:
            reference = entry.reference
            written = reference["volume_written_by_cad"]
            mine = abs(entry.runs[0].total("volume") - written) / written
            theirs = abs(reference[SweepJudge.OCCT]["volume"] - written) / written
            lines.append(f"| {reference['id']} | {mine:.1e} | {theirs:.1e} | {closer:.3g} |")
    return lines
