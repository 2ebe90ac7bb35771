#!/usr/bin/env python3
"""Draws the figures whose numbers paper_figures, or `Benchmark accuracy --output`, wrote: draw_figures.py FOLDER

Every CSV file in FOLDER that belongs to a figure becomes a PNG and an SVG file of the same name, fig7a.csv also fig7a_error.png, and so
on. Needs Matplotlib and no display. Exit status 1 where there is nothing to draw, or a file could not be read or written.
"""
import csv
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
from matplotlib import pyplot, ticker  # noqa: E402

# The palette of Okabe and Ito, which colour-blind readers can distinguish; in grey, lightness and markers
# differ.
GREY, LIGHT_GREY, ORANGE, BLUE = "#969696", "#cdcdcd", "#e69f00", "#0072b2"
GREEN, VERMILLION, SKY_BLUE = "#009e73", "#d55e00", "#56b4e9"
# The order of drawing and the sizes make each one of several equal values visible.
STYLES = {"MIDPOINT": {"color": ORANGE, "marker": "o", "markersize": 10},
          "GAUSS2": {"color": BLUE, "marker": "s", "markersize": 7},
          "GAUSS3": {"color": GREEN, "marker": "D", "markersize": 4}}
# Errors of 0 are drawn as half an ulp of 1, because the axis is logarithmic.
ROUNDING = 2.0**-53
K_TITLE = "sub-patch factor k (every knot interval is divided into k x k)"
SETTINGS = {"font.size": 12, "axes.labelsize": 14, "legend.frameon": False, "legend.columnspacing": 1.5, "legend.borderaxespad": 0.2, "lines.linewidth": 1.8,
            "grid.color": "#e4e4e4", "svg.hashsalt": "solidmoments", "figure.constrained_layout.use": True}


def read_rows(path):
    """Numbers as floats, other cells as text."""
    def convert(cell):
        try:
            return float(cell)
        except ValueError:
            return cell
    with open(path, encoding="utf-8", newline="") as file:
        return [{key: convert(value) for key, value in row.items()} for row in csv.DictReader(file)]


def column(rows, name):
    return [row[name] for row in rows]


def start(width, height, x_title, y_title):
    """A new figure of so many pixels, and its axes."""
    figure, axes = pyplot.subplots(figsize=(width / 100.0, height / 100.0))
    axes.set_xlabel(x_title)
    axes.set_ylabel(y_title)
    axes.set_axisbelow(True)
    return figure, axes


def finish(figure, axes, path, legend_columns, gap=0.01):
    """The legend above the plot, and the files."""
    axes.legend(loc="lower left", bbox_to_anchor=(0.0, 1.0 + gap), ncol=legend_columns)
    figure.savefig(path.with_suffix(".png"), metadata={"Software": None})
    figure.savefig(path.with_suffix(".svg"), metadata={"Date": None})
    pyplot.close(figure)


def set_limits_and_borders(axes, u, v):
    """Ticks and grid lines at the borders of sub-patches."""
    for axis, borders in ((axes.xaxis, u), (axes.yaxis, v)):
        axis.set_ticks(borders)
        axis.set_major_formatter("{x:.3g}")
    axes.set_xlim(u[0], u[-1])
    axes.set_ylim(v[0], v[-1])
    axes.grid(color="#a5a5a5")


def draw_sub_patch(path):
    """The Gauss points of a sub-patch, areas as their weights; positions below and left, intervals above and right."""
    rows = read_rows(path)
    positions = [0.0, *sorted(set(column(rows, "u"))), 1.0]
    figure, axes = start(620, 620, "u as a fraction of the sub-patch", "v as a fraction of the sub-patch")
    set_limits_and_borders(axes, positions, positions)
    weights = sorted({round(weight, 12) for weight in column(rows, "weight")}, reverse=True)
    for weight, color in zip(weights, (VERMILLION, BLUE, GREEN)):
        label = f"weight {weight * 81:.0f}/81" if len(weights) > 1 else f"{len(rows)} Gauss points, each of weight {weight:.3g}"
        chosen = [row for row in rows if abs(row["weight"] - weight) < 1e-9]
        axes.plot(column(chosen, "u"), column(chosen, "v"), "o", color=color, markersize=20 * weight**0.5 if len(weights) > 1 else 12,
                  label=label)
    for low, high in zip(positions, positions[1:]):
        middle, text = 0.5 * (low + high), f"{high - low:.3g}"
        axes.annotate(text, (middle, 1.0), (0, 6), textcoords="offset points", ha="center")
        axes.annotate(text, (1.0, middle), (6, 0), textcoords="offset points", va="center")
    finish(figure, axes, path, 3, gap=0.05)


def draw_patch(path):
    """The points of a patch with 4 x 5 knot intervals."""
    rows = read_rows(path)
    figure, axes = start(580, 710, "u", "v")
    set_limits_and_borders(axes, [i / 4 for i in range(5)], [i / 5 for i in range(6)])
    axes.plot(column(rows, "u"), column(rows, "v"), "o", color=VERMILLION, label="2 x 2 Gauss points of every sub-patch")
    finish(figure, axes, path, 1)


def draw_texture(path):
    """The trim texture of a patch of 4 x 3 knot intervals, divided by k = 2, with Gauss points and trim curves."""
    rows = read_rows(path)
    figure, axes = start(900, 750, "u", "v")
    set_limits_and_borders(axes, [i / 2 for i in range(9)], [i / 2 for i in range(7)])
    for value, color, label in ((1, SKY_BLUE, "trim texture 1: in the face"), (0, LIGHT_GREY, "trim texture 0: trimmed away")):
        chosen = [row for row in rows if row["in_face"] == value]
        axes.plot(column(chosen, "u"), column(chosen, "v"), "s", color=color, markersize=5, label=label)
    points = read_rows(path.with_name("fig6_points.csv"))
    axes.plot(column(points, "u"), column(points, "v"), "o", color=VERMILLION, label="2 x 2 Gauss points of a sub-patch")
    curves = read_rows(path.with_name("fig6_curves.csv"))
    for loop in sorted(set(column(curves, "loop"))):
        line = [row for row in curves if row["loop"] == loop]
        axes.plot(column(line, "u"), column(line, "v"), "k", label="trim curves" if loop == 0 else None)
    finish(figure, axes, path, 2)


def start_graph(x_title, y_title, factors):
    figure, axes = start(800, 600, x_title, y_title)
    axes.set_xscale("log", base=2)
    axes.set_xticks([2**i for i in range(10) if 2**i <= factors[-1]])
    axes.xaxis.set_major_formatter("{x:.0f}")
    axes.grid()
    return figure, axes


def draw_volumes(path, runs, x_title, y_title):
    factors = column(runs["GAUSS2"], "k")
    figure, axes = start_graph(x_title, y_title, factors)
    # This line is wider, because the others are drawn on top of it.
    axes.plot([factors[0], factors[-1]], [runs["ADAPTIVE"][0]["normalised_volume"]] * 2, "k", linewidth=3.2, label="ADAPTIVE")
    for scheme, style in STYLES.items():
        axes.plot(factors, column(runs[scheme], "normalised_volume"), label=scheme, **style)
    finish(figure, axes, path, 4)


def draw_errors(path, runs, x_title):
    """Errors of the schemes, ADAPTIVE's error or bound, and the paper's estimates; of the three schemes these are nearly equal."""
    rows, name = runs["GAUSS2"], path.stem
    factors = column(rows, "k")
    figure, axes = start_graph(x_title, "relative error of the volume", factors)
    axes.set_yscale("log")
    axes.yaxis.set_major_locator(ticker.LogLocator(base=100.0, numticks=20))
    for scheme, style in STYLES.items():
        axes.plot(factors, [max(error, ROUNDING) for error in column(runs[scheme], "relative_error")], label=scheme, **style)
    if name == "fig8":
        axes.plot([factors[0], factors[-1]], [runs["ADAPTIVE"][0]["bound"]] * 2, "k:", label="bound of ADAPTIVE")
    else:
        error = max(runs["ADAPTIVE"][0]["relative_error"], ROUNDING)
        axes.plot([factors[0], factors[-1]], [error] * 2, "k", label="ADAPTIVE")
    if name == "fig7a":  # without trimmed faces both estimates are equal
        axes.plot(factors, column(rows, "estimate_with_boundary"), color=VERMILLION, label="paper's estimate")
    else:
        # An estimate is 0, and has no logarithm, if no sub-patch lies entirely in its face.
        axes.plot(factors, [row["estimate"] or float("nan") for row in rows], ":", color=VERMILLION, label="Eq. 36, whole")
        axes.plot(factors, column(rows, "estimate_with_boundary"), color=VERMILLION, label="Eq. 36, all")
    if name == "fig7b":
        first = runs["GAUSS3"][0]["relative_error"]
        axes.plot(factors, [first / k for k in factors], ":", color=GREY, label="1 / k")
    finish(figure, axes, path.with_name(name + "_error"), 4 if name == "fig7b" else 3)


def draw_graphs(path):
    """Volume, and its error, against the number of sub-patches."""
    runs = {}
    for row in read_rows(path):
        runs.setdefault(row["scheme"], []).append(row)
    x_title = "sub-patches along the arc" if path.stem == "fig7a" else K_TITLE
    draw_volumes(path, runs, x_title, "volume / volume by ADAPTIVE" if path.stem == "fig8" else "volume / exact volume")
    draw_errors(path, runs, x_title)


def draw_accuracy(path):
    """Median and largest errors against the seconds of all files."""
    figure, axes = start(800, 600, "Seconds of the processor, all files", "Relative error of the volume")
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.grid()
    rows = sorted(read_rows(path), key=lambda row: row["seconds"])
    for program, label, color, marker in (("SolidMoments", "SolidMoments", BLUE, "o"), ("BRepGProp", "BRepGProp", ORANGE, "s"),
                                          ("BRepMesh", "triangles of BRepMesh", GREEN, "D")):
        chosen = [row for row in rows if row["method"].startswith(program)]
        for error, line, size, text in (("median_error", "-", 7, f"{label}, median"), ("largest_error", ":", 4, f"{label}, largest")):
            axes.plot(column(chosen, "seconds"), [max(value, 1e-16) for value in column(chosen, error)], line, color=color, marker=marker,
                      markersize=size, label=text)
    finish(figure, axes, path, 2)


DRAWINGS = {"fig3": draw_sub_patch, "fig4": draw_patch, "fig5": draw_sub_patch, "fig6": draw_texture, "fig7a": draw_graphs,
            "fig7b": draw_graphs, "fig8": draw_graphs, "accuracy_over_time": draw_accuracy}


def main():
    if len(sys.argv) != 2 or sys.argv[1].startswith("-"):
        print("usage: draw_figures.py FOLDER", file=sys.stderr)
        return 1
    paths = [path for path in (pathlib.Path(sys.argv[1]) / f"{name}.csv" for name in DRAWINGS) if path.is_file()]
    if not paths:
        print(f"draw_figures.py: {sys.argv[1]} has no CSV file of a figure", file=sys.stderr)
        return 1
    try:
        with pyplot.rc_context(SETTINGS):
            for path in paths:
                DRAWINGS[path.stem](path)
    except (OSError, KeyError, ValueError) as error:
        print(f"draw_figures.py: {path}: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
