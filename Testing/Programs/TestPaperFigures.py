"""TestPaperFigures.py FOLDER BASELINE6.png BASELINE1.png: what paper_figures and draw_figures.py wrote into FOLDER.

The curves' shape is the paper's: Fig. 7a converges by the order of the rule, Fig. 7b by the trim texture whatever the rule, ADAPTIVE is
at rounding; the paper's estimates fall as 1 / k^2. Fig. 6 and Fig. 1, with a dot in every model, look as in the baselines.
"""
import csv
import math
import os
import sys

sys.path[:0] = [os.path.join(os.path.dirname(os.path.abspath(__file__)), *path)
                for path in (("..", "Support"), ("..", "..", "Examples", "Paper"))]
from smcheck import check, check_equal, check_true, finish  # noqa: E402
from smpicture import check_picture, read_picture, share_of_other_pixels  # noqa: E402
from write_docs import fit_order, read_runs  # noqa: E402

FOLDER, BASELINE6, BASELINE1 = sys.argv[1:]
# Matplotlib's letters depend on the version of FreeType; without the trim curves the share is 6e-3.
CHART_LIMIT = 3e-3


def check_range(what, low, value, high, reason=""):
    check_true(what, low <= value <= high, f"{value:.3g} in {low:g} ... {high:g} {reason}")


def read_table(name):
    with open(os.path.join(FOLDER, name), encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def check_files():
    names = ["fig3", "fig4", "fig5", "fig6", "fig7a", "fig7a_error", "fig7b", "fig7b_error", "fig8", "fig8_error"]
    for name in (name + ending for name in names for ending in (".png", ".svg")):
        path = os.path.join(FOLDER, name)
        check_true(name, os.path.exists(path) and os.path.getsize(path) > 5000)


def check_adaptive(runs):
    row = runs["ADAPTIVE"][0]
    check_range("ADAPTIVE", 0.0, row["relative_error"], row["bound"], "its bound")
    check_range("ADAPTIVE's bound", 0.0, row["bound"], 1e-12, "tolerance")


def check_quarter_cylinder():
    runs = read_runs(os.path.join(FOLDER, "fig7a.csv"))
    errors = {(scheme, row["k"]): row["relative_error"] for scheme, rows in runs.items() for row in rows}
    check_range("GAUSS3, 2 sub-patches", 0.0, errors["GAUSS3", 2], 1e-6)
    check_range("GAUSS2, 8 sub-patches", 0.0, errors["GAUSS2", 8], 1e-6)
    check_range("GAUSS2, 2 sub-patches", 1e-6, errors["GAUSS2", 2], 1.0)
    check_range("MIDPOINT, 64 sub-patches", 1e-6, errors["MIDPOINT", 64], 1.0)
    # An n-point rule on sub-patches of width h converges as h^(2n); GAUSS3 is at rounding before k = 64.
    check("order of MIDPOINT", 2.0, fit_order(runs["MIDPOINT"]), 0.1, "h^2")
    check("order of GAUSS2", 4.0, fit_order(runs["GAUSS2"]), 0.2, "h^4")
    check("order of GAUSS3", 6.0, math.log2(errors["GAUSS3", 4] / errors["GAUSS3", 8]), 0.2, "h^6")
    # The estimate is that of a linear approximation, whatever the rule.
    estimates = {row["k"]: row["estimate"] for row in runs["GAUSS2"]}
    check("order of the estimate", 2.0, math.log2(estimates[32] / estimates[64]), 0.15, "1 / k^2")
    check_adaptive(runs)


def make_envelope(rows):
    """The largest error at this k or any larger one: an error that is small by chance at one k does not count."""
    return [{"k": row["k"], "relative_error": max(other["relative_error"] for other in rows[i:])} for i, row in enumerate(rows)]


def check_slanted_block():
    runs = read_runs(os.path.join(FOLDER, "fig7b.csv"))
    # Texels that a smooth curve crosses are in or out: first order if all err to one side, order 3/2 if as by
    # chance.
    for scheme in ("MIDPOINT", "GAUSS2", "GAUSS3"):
        check_range(f"order of {scheme}", 0.8, fit_order(make_envelope(runs[scheme])), 1.9, "the texture's")
    # The rule hardly matters where the trim is what errs.
    gauss2, gauss3 = ([row["normalised_volume"] for row in runs[scheme] if row["k"] == 32][0] for scheme in ("GAUSS2", "GAUSS3"))
    check("GAUSS2 and GAUSS3, k = 32", gauss2, gauss3, 1e-3 * abs(gauss2 - 1.0))
    check_adaptive(runs)


def check_free_form():
    runs = read_runs(os.path.join(FOLDER, "fig8.csv"))
    # As 1 / k^2 in the end; before that K, which is bounded by control points, comes down as well.
    rows = [{"k": row["k"], "relative_error": row["estimate_with_boundary"]} for row in runs["GAUSS2"]]
    check_range("order of the estimate", 1.9, fit_order(rows), 4.0)
    row = [row for row in runs["GAUSS2"] if row["k"] == 8][0]
    check_range("the estimate counts fewer sub-patches", 0.0, row["estimate"], row["estimate_with_boundary"])
    errors = {row["k"]: row["relative_error"] for row in runs["GAUSS3"]}
    check_range("GAUSS3, k = 32", 0.0, errors[32], 0.1 * errors[1], "converges")
    check_range("ADAPTIVE's bound", 1e-16, runs["ADAPTIVE"][0]["bound"], 1e-10, "of V")


def check_texture():
    """Checks every texel centre of Fig. 6 against the formulas of the trim curves that MakeTrimmedPatch() has."""
    rows, wrong = read_table("fig6.csv"), 0
    for row in rows:
        u, v = float(row["u"]), float(row["v"])
        wave = 2.6 - 0.3 * math.cos(1.25 * math.pi * (4.0 - u)) - v
        hole = math.hypot((u - 1.6) / 0.8, (v - 1.15) / 0.62) - 1.0
        # The curves were fitted to these formulas, to less than this.
        if min(abs(wave), abs(hole)) >= 1e-6:
            wrong += (wave > 0.0 and hole > 0.0) != (row["in_face"] == "1")
    check_equal("texels of Fig. 6", 32 * 24, len(rows))
    check_equal("texels on the wrong side", 0, wrong)
    check_range("texels in the face", 400, sum(row["in_face"] == "1" for row in rows), 700, "two thirds or so")


def check_models():
    rows = read_table("fig1.csv")
    check_equal("models of Fig. 1", 6, len(rows))
    picture = read_picture(os.path.join(FOLDER, "fig1.png"))
    height, width = picture.shape[0] // 2, picture.shape[1] // 3
    is_green = (picture[:, :, 1] > picture[:, :, 0] + 60) & (picture[:, :, 1] > picture[:, :, 2] + 60)
    for i, row in enumerate(rows):
        volume = float(row["volume"])
        check_range(row["model"] + ", bound", 1e-16 * volume, float(row["volume_bound"]), 1e-9 * volume, "tolerance")
        bottom, left = height * (1 - i // 3), width * (i % 3)
        # A sphere's radius of 0.025 of the diagonal is 6 to 8 pixels.
        check_range(row["model"] + ", green pixels", 60, is_green[bottom:bottom + height, left:left + width].sum(), 250, "a dot")
    check_picture("Fig. 1", read_picture(BASELINE1), picture)


check_files()
check_quarter_cylinder()
check_slanted_block()
check_free_form()
check_texture()
check_range("Fig. 6, pixels unlike the baseline's", 0.0,
            share_of_other_pixels(read_picture(os.path.join(FOLDER, "fig6.png")), read_picture(BASELINE6)), CHART_LIMIT, "share of all")
check_models()
finish()
