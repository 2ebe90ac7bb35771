"""TestCases.py --program SOLIDMOMENTS --cases FOLDER [--print] [FILE...]: small files with known answers, each by its rule.

FOLDER/expect.tsv has a row for each file: its name, a rule, a value or words, and the number of an issue. The rules:

value V             status ok, volume V within 1e-9
quiet V             as value, and no message
value-or-flagged V  as value, or as flagged
flagged             open or suspect with exit status 3, or unreadable with exit status 2, and a message that names an entity
words W             flagged, and one message has the words W
ok                  status ok
validate N          N quantities that the file states are compared and pass

OPEN has the rows that the program does not meet. It must be exact: a row that fails and is not in it fails the test, and so does a row in
it that the program meets. With names of files only these rows run; with --print nothing fails.
"""
import argparse
import csv
import os
import re
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Support"))
from smcheck import check_equal, check_true, finish  # noqa: E402
from smprogram import compute  # noqa: E402

# The rows that the program does not meet.
OPEN = {
    # Issue 27
    "10_validation_of_assembly.step",
}
TOLERANCE = 1e-9
EXITS = {"ok": 0, "unreadable": 2}


def is_value(entry, expected):
    volume = entry["total"]["volume"]
    return entry["status"] == "ok" and volume is not None and abs(volume - expected) <= TOLERANCE * abs(expected)


def is_flagged(entry):
    return entry["status"] in ("open", "suspect", "unreadable") and any(re.search(r"#\d", text) for text in entry["messages"])


def is_met(rule, argument, code, entry):
    """Whether a result meets a rule. The exit status always has to be that of the status."""
    if code != EXITS.get(entry["status"], 3):
        return False
    if rule == "value":
        return is_value(entry, float(argument))
    if rule == "quiet":
        return is_value(entry, float(argument)) and not entry["messages"]
    if rule == "value-or-flagged":
        return is_value(entry, float(argument)) or is_flagged(entry)
    if rule == "flagged":
        return is_flagged(entry)
    if rule == "words":
        return entry["status"] in ("open", "suspect", "unreadable", "empty") and any(argument in text for text in entry["messages"])
    if rule == "ok":
        return entry["status"] == "ok"
    if rule == "validate":
        return [item["result"] for item in entry["validation"]] == int(argument) * ["pass"]
    raise ValueError(f"unknown rule {rule}")


def check_rules():
    """The rules on invented results: each refuses what it has to refuse."""
    def entry(status, volume=None, messages=()):
        return {"status": status, "total": {"volume": volume}, "messages": list(messages), "validation": [{"result": "pass"}, {"result": "fail"}]}

    good, off, flagged = entry("ok", 2.0), entry("ok", 2.0 + 4e-9), entry("suspect", 2.0, ["Face #3: words"])
    for rule, argument, code, result, expected in (
            ("value", "2", 0, good, True), ("value", "2", 3, good, False), ("value", "2", 0, off, False), ("value", "2", 3, flagged, False),
            ("value", "2", 0, entry("ok"), False), ("quiet", "2", 0, good, True), ("quiet", "2", 0, entry("ok", 2.0, ["a"]), False),
            ("value-or-flagged", "2", 0, good, True), ("value-or-flagged", "3", 3, flagged, True), ("value-or-flagged", "3", 0, good, False),
            ("flagged", "", 3, flagged, True), ("flagged", "", 0, flagged, False), ("flagged", "", 0, good, False),
            ("flagged", "", 3, entry("suspect", 2.0, ["no entity"]), False), ("words", "words", 3, flagged, True),
            ("words", "others", 3, flagged, False), ("words", "words", 0, entry("ok", 2.0, ["words"]), False), ("ok", "", 0, off, True),
            ("ok", "", 3, flagged, False), ("validate", "1", 0, good, False)):
        check_equal(f"rule {rule} {argument}, {result['status']}, exit status {code}", expected, is_met(rule, argument, code, result))


def read_rows(folder):
    """The rows of expect.tsv: file, rule, argument, issue."""
    with open(os.path.join(folder, "expect.tsv"), encoding="utf-8", newline="") as file:
        rows = [row for row in csv.reader(file, delimiter="\t", quoting=csv.QUOTE_NONE) if row and not row[0].startswith("#")]
    return [(row[0], row[1], row[2] if len(row) > 2 else "", row[3] if len(row) > 3 else "") for row in rows]


def main():
    parser = argparse.ArgumentParser()
    for option in ("--program", "--cases"):
        parser.add_argument(option, required=True)
    parser.add_argument("--print", action="store_true", help="print the results and check nothing")
    parser.add_argument("names", nargs="*", metavar="FILE")
    options = parser.parse_args()
    rows = read_rows(options.cases)
    names = [name for name, _, _, _ in rows]
    missing = [name for name in names if not os.path.isfile(os.path.join(options.cases, name))]
    if not options.print:
        check_rules()
        check_equal("files of expect.tsv that are not there", [], missing)
        check_equal("rows of OPEN that expect.tsv does not have", [], sorted(OPEN - set(names)))
    met = {}
    for name, rule, argument, issue in rows:
        if options.names and name not in options.names:
            continue
        code, entry = compute(options.program, os.path.join(options.cases, name), *(["--validate"] if rule == "validate" else []))
        met[name] = is_met(rule, argument, code, entry)
        volume = entry["total"]["volume"]
        text = (f"issue {issue:3} {'met ' if met[name] else 'OPEN'} {name}: {rule} {argument} -> {code} {entry['status']} "
                f"{'none' if volume is None else format(volume, '.13g')}")
        if options.print:
            print(text, *("    " + message for message in entry["messages"][:3]), sep="\n")
        elif name in OPEN:
            check_true("still open" if not met[name] else "no longer open: take it out of OPEN", not met[name], text)
        else:
            check_true("met", met[name], "\n    ".join([text, *entry["messages"]]) if not met[name] else text)
    print(f"{sum(met.values())} of {len(met)} rows are met")
    if not options.print:
        finish()


main()
