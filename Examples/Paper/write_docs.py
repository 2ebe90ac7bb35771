#!/usr/bin/env python3
"""Writes what regenerate.sh made into the page, or compares: write_docs.py OUTDIR, write_docs.py --check FIGURES

Pictures go to images/; in README.md the numbers of Figures 7b and 8 between <!-- Figure7b --> and <!-- /Figure7b --> and so on, the
table between <!-- Table --> and <!-- /Table -->, and, where OUTDIR's table has a section "Real files", its end between
<!-- RealFiles --> and <!-- /RealFiles --> and the whole of it in real_files.md. Sentences around these marks are written by hand: read them
again.

--check compares the numbers of the figures in a folder that paper_figures wrote with those on the page. Exit status 1 where they differ.
"""
import csv
import difflib
import math
import pathlib
import re
import shutil
import sys
import textwrap

HERE = pathlib.Path(__file__).resolve().parent
SCHEMES = ("MIDPOINT", "GAUSS2", "GAUSS3")
# From this k on only the error of the trim texture is left.
LARGE_FACTOR = 32


def read_runs(path):
    """{scheme: its rows by k} of a figure's CSV, numbers as numbers."""
    runs = {}
    with open(path, encoding="utf-8", newline="") as file:
        for row in csv.DictReader(file):
            runs.setdefault(row.pop("scheme"), []).append({key: float(value) for key, value in row.items()})
    return runs


def fit_order(rows):
    """The order of convergence in 1/k: minus the slope of the error's logarithm against that of k, by least squares."""
    x = [math.log(row["k"]) for row in rows]
    y = [math.log(row["relative_error"]) for row in rows]
    n = len(rows)
    return (sum(x) * sum(y) - n * sum(a * b for a, b in zip(x, y))) / (n * sum(a * a for a in x) - sum(x) ** 2)


def name_factors(rows):
    return ", ".join(f"{row['k']:.0f}" for row in rows) or "none"


def describe_estimates(rows):
    """A sentence with the k at which GAUSS2's error is above the paper's estimate."""
    below = {key: [row for row in rows if row[key] < row["relative_error"]] for key in ("estimate", "estimate_with_boundary")}
    whole, every = below["estimate"], below["estimate_with_boundary"]
    return (f"Eq. 36 as the paper reads it (whole sub-patches) is below the error of GAUSS2 at {len(whole)} of {len(rows)} values of k "
            f"({name_factors(whole)}); counted over all sub-patches, those on a trim boundary as well, at {len(every)} of {len(rows)} "
            f"({name_factors(every)}).")


def table_of(runs):
    lines = ["| k | sub-patches | " + " | ".join(SCHEMES) + " | Eq. 36, whole | Eq. 36, all |",
             "|---|---|" + "---|" * (len(SCHEMES) + 2)]
    for i, row in enumerate(runs["GAUSS2"]):
        errors = " | ".join(f"{runs[scheme][i]['normalised_volume'] - 1.0:+.1e}" for scheme in SCHEMES)
        lines.append(f"| {row['k']:.0f} | {row['sub_patches']:,.0f} | {errors} | {row['estimate']:.1e} "
                     f"| {row['estimate_with_boundary']:.1e} |")
    return "\n".join(lines)


def describe_figure7b(runs):
    rows = runs["GAUSS2"]
    large = [row for row in rows if row["k"] >= LARGE_FACTOR]
    first = {scheme: runs[scheme][0]["normalised_volume"] - 1.0 for scheme in SCHEMES}
    sentences = ["Volume / exact volume - 1 at k = 1, " + f"{rows[0]['sub_patches']:.0f} sub-patches: "
                 + ", ".join(f"{scheme} {error:+.1e}" for scheme, error in first.items()) + ".",
                 f"Order of the error of GAUSS2 in 1/k, by a fit: {fit_order(rows):.1f} over all k, {fit_order(large):.1f} from "
                 f"k = {LARGE_FACTOR} on.", describe_estimates(rows)]
    return table_of(runs) + "\n\n" + bullets("\n".join(sentences))


def describe_figure8(runs):
    rows = runs["GAUSS2"]
    above = [row["estimate"] / row["relative_error"] for row in rows if row["estimate"] >= row["relative_error"]]
    sentences = [describe_estimates(rows),
                 f"Where the estimate over whole sub-patches is above the error of GAUSS2, it is {min(above):.1f} to "
                 f"{max(above):.0f} times the error."]
    return table_of(runs) + "\n\n" + bullets("\n".join(sentences))


def describe_figures(folder):
    """{mark: text}: the texts about the figures in a folder, which the page has between marks."""
    return {"Figure7b": describe_figure7b(read_runs(folder / "fig7b.csv")),
            "Figure8": describe_figure8(read_runs(folder / "fig8.csv"))}


def split_sections(text):
    """Caption, then {title: (table, sentences)} of table.md."""
    head, *parts = re.split(r"^## ", text, flags=re.MULTILINE)
    sections = {}
    for part in parts:
        title, table, sentences = (piece.strip() for piece in (part.split("\n\n", 2)))
        sections[title] = (table, sentences)
    return head.split("\n\n", 1)[1].strip(), sections


def bullets(sentences):
    return "\n".join(textwrap.fill(line, 120, initial_indent="- ", subsequent_indent="  ", break_on_hyphens=False)
                     for line in sentences.splitlines())


def replace_between(text, mark, content):
    pattern = re.compile(rf"(<!-- {mark} -->\n).*?(<!-- /{mark} -->)", re.DOTALL)
    if not pattern.search(text):
        raise ValueError(f"README.md has no <!-- {mark} --> ... <!-- /{mark} -->")
    return pattern.sub(lambda found: found.group(1) + content + "\n" + found.group(2), text)


def write(made):
    caption, sections = split_sections((made / "table.md").read_text(encoding="utf-8"))
    page = (HERE / "README.md").read_text(encoding="utf-8")
    for mark, text in describe_figures(made / "figures").items():
        page = replace_between(page, mark, text)
    table, sentences = sections["The parts"]
    page = replace_between(page, "Table", table + "\n\n" + bullets(sentences))
    real = sections.get("Real files")
    if real:
        page = replace_between(page, "RealFiles", bullets(real[1]))
        (HERE / "real_files.md").write_text(
            "# Table 1 for real files\n\nBy `regenerate.sh --folder`; what the columns mean is in [README.md](README.md).\n\n"
            + textwrap.fill(caption, 120) + "\n\n" + real[0] + "\n\n" + real[1] + "\n", encoding="utf-8")
    (HERE / "README.md").write_text(page, encoding="utf-8")
    for picture in sorted((made / "figures").glob("*.png")):
        shutil.copyfile(picture, HERE / "images" / picture.name)
    return 0


def check(figures):
    page = (HERE / "README.md").read_text(encoding="utf-8")
    made = page
    for mark, text in describe_figures(figures).items():
        made = replace_between(made, mark, text)
    sys.stdout.writelines(difflib.unified_diff(page.splitlines(True), made.splitlines(True), "on the page", "in the figures"))
    return 0 if page == made else 1


def main():
    arguments = sys.argv[1:]
    action = write
    if arguments[:1] == ["--check"]:
        action = check
        del arguments[0]
    if len(arguments) != 1:
        print("usage: write_docs.py OUTDIR, write_docs.py --check FIGURES", file=sys.stderr)
        return 1
    try:
        return action(pathlib.Path(arguments[0]))
    except (OSError, ValueError, KeyError) as error:
        print(f"write_docs.py: {error}", file=sys.stderr)
        return 1


if __name__ == "__main__":
    sys.exit(main())
