"""The text of table.py: Markdown, CSV, and the summary below each table."""
import csv
import statistics

HEAD = ["model", "faces", "GAUSS2, k = 2: volume", "Eq. 36, fraction", "with boundary", "difference", "centre of mass",
        "prepare, s", "integrate, s", "ADAPTIVE: volume", "bound, fraction", "difference", "prepare, s", "integrate, s",
        "OCCT default: volume", "difference", "s", "reference", "centre of mass", "from"]
CAPTION = ("Volumes in mm^3; estimates, bounds and differences are fractions of the reference. Eq. 36 as the paper reads it counts "
           "sub-patches wholly in the face, `with boundary` also those that a trim curve crosses; its second derivatives are "
           "{deviation}. Planes have chords within {chord:g} of the box's diagonal of their trim curves. The second centre of mass is "
           "the reference's, or ADAPTIVE's where that has none. Seconds are of the faster of {runs} runs, without reading the "
           "file, context and shaders; OCCT's are those of VolumeProperties. A difference from itself is `-`.")


def number(value, form="{:.1e}"):
    return "-" if value is None else form.format(value)


def point(center, form):
    return "-" if center is None else ", ".join(form.format(coordinate) for coordinate in center)


def cell(text):
    """The text with its Markdown column separators escaped."""
    return " ".join(str(text).split()).replace("|", "\\|")


def gauss2_cells(row):
    result = row.gauss2
    if result.reason:
        return [cell(result.reason)] + ["-"] * 6
    return [number(result.volume, "{:.10g}"), number(row.fraction(result.estimate)),
            number(row.fraction(result.estimate_with_boundary)), number(row.difference(result), "{:+.1e}"),
            point(result.center, "{:.7g}"), number(result.prepare, "{:.2g}"), number(result.integrate, "{:.2g}")]


def adaptive_cells(row):
    result = row.adaptive
    if result.reason:
        return [cell(result.reason)] + ["-"] * 4
    volume = number(result.volume, "{:.12g}") + ("" if result.status == "ok" else f" ({result.status})")
    return [volume, number(row.fraction(result.bound)), number(row.difference(result), "{:+.1e}"),
            number(result.prepare, "{:.2g}"), number(result.integrate, "{:.2g}")]


def occt_cells(row):
    result = row.occt
    if result.reason:
        return [cell(result.reason), "-", "-"]
    return [number(result.volume, "{:.10g}"), number(row.difference(result), "{:+.1e}"), number(result.seconds, "{:.2g}")]


def cells(row):
    return ([cell(row.name), number(row.faces(), "{}")] + gauss2_cells(row) + adaptive_cells(row) + occt_cells(row)
            + [number(row.reference, "{:.12g}"), point(row.center(), "{:.10g}"), row.reference_kind or "-"])


def middle_and_worst(values):
    values = [abs(value) for value in values if value is not None]
    return f"{statistics.median(values):.1e}, {max(values):.1e}" if values else "-, -"


def count(answers):
    """The number of True values and the number of known values."""
    known = [answer for answer in answers if answer is not None]
    return f"{sum(known)} of {len(known)}"


def summary(rows):
    """A summary of the table, in sentences."""
    strict = count([row.is_estimate_below_error(row.gauss2.estimate) for row in rows])
    whole = count([row.is_estimate_below_error(row.gauss2.estimate_with_boundary) for row in rows])
    independent = [row for row in rows if row.has_independent_reference()]
    lines = [f"The Eq. 36 estimate is smaller than the true error on {strict} models, with boundary sub-patches counted whole on "
             f"{whole}; the true error is taken less what the reference cannot vouch for, what closing the model's gaps moves, and the "
             "chords of planes (their distance from the curves times the area).",
             f"Difference from the reference, median, worst: GAUSS2 {middle_and_worst([row.difference(row.gauss2) for row in rows])}; "
             f"ADAPTIVE {middle_and_worst([row.difference(row.adaptive) for row in independent])}, "
             "where the reference is not its own; "
             f"OCCT {middle_and_worst([row.difference(row.occt) for row in rows])}.",
             "ADAPTIVE's bound, with the reference's uncertainty, is smaller than its difference on "
             f"{count([row.is_bound_exceeded() for row in independent])} models with a reference not its own."]
    failed = [row for row in rows if row.gauss2.reason or row.adaptive.reason or row.occt.reason]
    if failed:
        lines.append(f"On {len(failed)} of {len(rows)} models some run has no volume; its reason stands in its place.")
    return "\n".join(lines)


def markdown(sections, deviation, chord, runs):
    lines = ["# Table 1", "", CAPTION.format(deviation=deviation, chord=chord, runs="two" if runs == 2 else runs), ""]
    for title, rows in sections:
        lines += [f"## {title}", "", "| " + " | ".join(HEAD) + " |", "|" + "---|" * len(HEAD)]
        lines += ["| " + " | ".join(cells(row)) + " |" for row in rows]
        lines += ["", summary(rows), ""]
    return "\n".join(lines)


def center_difference(row, result):
    """The distance of the centre from that of the reference or of ADAPTIVE, relative to the cube root of the volume."""
    if result.center is None or row.center() is None or not row.reference:
        return None
    distance = max(abs(a - b) for a, b in zip(result.center, row.center()))
    return distance / abs(row.reference) ** (1 / 3)


def coordinates(center):
    return list(center or [None] * 3)


def write_csv(sections, file):
    writer = csv.writer(file)
    writer.writerow(["table", "model", "faces", "reference", "reference_kind", "reference_uncertainty", "center_x", "center_y",
                     "center_z", "center_kind", "closure_correction", "gauss2_chord_tolerance", "gauss2_chords_doubt",
                     "gauss2_volume", "gauss2_sub_patches", "gauss2_estimate_fraction", "gauss2_estimate_with_boundary_fraction",
                     "gauss2_difference", "gauss2_center_x", "gauss2_center_y", "gauss2_center_z",
                     "gauss2_center_difference", "gauss2_prepare_seconds", "gauss2_integrate_seconds", "estimate_below_error",
                     "estimate_with_boundary_below_error", "adaptive_volume", "adaptive_status", "adaptive_bound_fraction",
                     "adaptive_difference", "adaptive_prepare_seconds", "adaptive_integrate_seconds", "occt_volume",
                     "occt_difference", "occt_center_x", "occt_center_y", "occt_center_z", "occt_center_difference", "occt_seconds",
                     "gauss2_reason", "adaptive_reason", "occt_reason"])
    for title, rows in sections:
        for row in rows:
            gauss2, adaptive, occt = row.gauss2, row.adaptive, row.occt
            writer.writerow([
                title, row.name, row.faces(), row.reference, row.reference_kind, row.uncertainty,
                *coordinates(row.center()), row.center_kind(), row.fraction(adaptive.closure_correction), row.chord,
                row.chords_doubt(), gauss2.volume, gauss2.sub_patches, row.fraction(gauss2.estimate),
                row.fraction(gauss2.estimate_with_boundary), row.difference(gauss2), *coordinates(gauss2.center),
                center_difference(row, gauss2), gauss2.prepare, gauss2.integrate,
                row.is_estimate_below_error(gauss2.estimate), row.is_estimate_below_error(gauss2.estimate_with_boundary),
                adaptive.volume, adaptive.status, row.fraction(adaptive.bound), row.difference(adaptive),
                adaptive.prepare, adaptive.integrate, occt.volume, row.difference(occt), *coordinates(occt.center), center_difference(row, occt), occt.seconds, gauss2.reason, adaptive.reason,
                occt.reason])


def progress(row):
    reasons = [result.reason for result in (row.gauss2, row.adaptive, row.occt) if result.reason]
    return (f"{row.name:24} GAUSS2 {number(row.difference(row.gauss2), '{:+.1e}')} "
            f"ADAPTIVE {number(row.difference(row.adaptive), '{:+.1e}')} OCCT {number(row.difference(row.occt), '{:+.1e}')}"
            + ("  " + "; ".join(reasons) if reasons else ""))
