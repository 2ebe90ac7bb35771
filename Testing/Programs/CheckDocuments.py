"""Checks the documents of the tree against the tree: CheckDocuments.py [--root FOLDER] [--program solidmoments] [--write]

Without a program:
- no document has a mark @@ that was to be replaced;
- README, CHANGELOG, developer guide and Performance.md have at most the lines of LINES;
- every relative link of a Markdown file leads to a file and, behind a '#', to a heading of it, and every path of the tree that is
  named in code (`Testing/run.sh`) exists (Documentation/notes may name what is gone);
- every code block in C++ or Python follows a line <!-- Snippet: EXAMPLE [MARK] -->, and is the region of that example between two comment
  lines "// [MARK]" or "# [MARK]", which CTest builds or runs; the indentation of the region is taken off;
- in the table of accuracy every cell whose error exceeds its bound has a mark, and a line below the table names its solid.
With a program:
- the block behind <!-- Sample: FILE.step --> is what the program prints for that file, except for what differs from machine to machine:
  OpenGL's driver, times, numbers of evaluations, and the last digits;
- the pages of the user guide name every option of --help, every key of the JSON and every column of the CSV.

--write puts snippets and sample into the documents instead of comparing them. Exit status 1 where something is wrong.
"""
import argparse
import csv
import io
import json
import os
import re
import subprocess
import sys

# Maximum lines of documents.
LINES = {"README.md": 130, "Documentation/DeveloperGuide.md": 260, "Documentation/Performance.md": 120, "CHANGELOG.md": 60}
GUIDE = ("UserGuide", "CommandLine", "Outputs", "Reference", "Products", "Analyses", "ParaView", "Python")
SNIPPET = re.compile(r"(?P<head><!-- Snippet: (?P<example>\S+) \[(?P<mark>[^]]+)\] -->\n```(?:cpp|python)\n)(?P<code>.*?)(?=^```$)",
                     re.DOTALL | re.MULTILINE)
SAMPLE = re.compile(r"(?P<head><!-- Sample: (?P<file>\S+) -->\n```\n)(?P<text>.*?)(?=^```$)", re.DOTALL | re.MULTILINE)
LINK = re.compile(r"\[[^]]*\]\(([^)\s]+)\)")
PATH = re.compile(r"(?<![\w./-])(?:Documentation|Examples|Filters|ParaViewPlugin|Readers|Rendering|Testing|cmake)/[\w./-]*\w")
# Paths below the build folder that the documents may name.
BUILT = ("Testing/output", "Testing/solids")
NUMBER = re.compile(r"-?\d+(\.\d+)?(e[-+]?\d+)?")
# Bounds and gaps are printed with two digits and are sums over all samples; of other numbers the last digit
# may be rounded otherwise.
BOUND_FACTOR = 1.5
LAST_DIGITS = 2.0
# The options of the schemes are in --help alone.
PAPER_OPTIONS = ("--subpatches", "--trim-texture", "--trim-textures", "--chord", "--deviation")
# Options that give the JSON all its keys; a program that was built without a module lacks its option.
COMPLETE = (("--stability", "-z"), ("--waterline", "10"), ("--section", "0,0,5,0,0,1"), ("--density", "1000"), ("--moments", "0"), ("--about", "origin"), ("--bom",), ("--box",), ("--validate",))


class Checker:
    def __init__(self, root, write):
        self.root = root
        self.write = write
        self.checks = 0
        self.failures = []

    def check(self, passed, what):
        self.checks += 1
        if not passed:
            self.failures.append(what)

    def find_documents(self):
        """Markdown of the tree, without folders of builds and hidden ones."""
        for folder, folders, files in os.walk(self.root):
            folders[:] = sorted(name for name in folders
                                if not name.startswith((".", "build", "install")))
            for name in sorted(files):
                if name.endswith(".md"):
                    yield os.path.relpath(os.path.join(folder, name), self.root)

    def read(self, path):
        with open(os.path.join(self.root, path), encoding="utf-8") as file:
            return file.read()

    def put(self, path, text):
        with open(os.path.join(self.root, path), "w", encoding="utf-8") as file:
            file.write(text)


def list_anchors(text):
    """Returns the anchors that GitHub makes of the headings of a Markdown text."""
    headings = re.findall(r"^#+ +(.*)$", re.sub(r"^```.*?^```", "", text, flags=re.DOTALL | re.MULTILINE), re.MULTILINE)
    plain = (re.sub(r"[`*]|\[|\]\([^)]*\)", "", heading) for heading in headings)
    return [re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in plain]


def check_links(checker, path, text):
    prose = re.sub(r"^```.*?^```", "", text, flags=re.DOTALL | re.MULTILINE)
    for link in LINK.findall(prose):
        if re.match(r"[a-z]+:", link):
            continue
        target, _, anchor = link.partition("#")
        place = os.path.normpath(os.path.join(os.path.dirname(path), target)) if target else path
        exists = os.path.exists(os.path.join(checker.root, place))
        checker.check(exists, f"{path}: the link {link} leads nowhere")
        if exists and anchor and place.endswith(".md"):
            checker.check(anchor in list_anchors(checker.read(place)), f"{path}: {place} has no heading #{anchor}")


def check_paths(checker, path, text):
    code = re.findall(r"^```sh$.*?^```$", text, re.DOTALL | re.MULTILINE) + re.findall(r"`[^`\n]+`", text)
    for name in sorted({name for span in code for name in PATH.findall(span)}):
        checker.check(name in BUILT or os.path.exists(os.path.join(checker.root, name)), f"{path}: there is no {name}")


def get_region(checker, example, mark):
    """The marked lines of an example without their indentation; None where it has no such region."""
    comment = "#" if example.endswith(".py") else "//"
    line = rf"^( *){comment} \[{re.escape(mark)}\]\n"
    found = re.search(line + rf"(.*?)^ *{comment} \[{re.escape(mark)}\]\n", checker.read(example), re.DOTALL | re.MULTILINE)
    return re.sub(rf"^{found.group(1)}", "", found.group(2), flags=re.MULTILINE) if found else None


def check_snippets(checker, path, text):
    blocks = len(re.findall(r"^```(?:cpp|python)$", text, re.MULTILINE))
    found = list(SNIPPET.finditer(text))
    checker.check(blocks == len(found), f"{path}: {blocks} blocks of code, {len(found)} of them behind <!-- Snippet: ... -->")
    for snippet in found:
        name = f"{snippet['example']} [{snippet['mark']}]"
        exists = os.path.exists(os.path.join(checker.root, snippet["example"]))
        region = get_region(checker, snippet["example"], snippet["mark"]) if exists else None
        checker.check(region is not None, f"{path}: there is no {name}")
        if region is None:
            continue
        if checker.write:
            text = text.replace(snippet["head"] + snippet["code"], snippet["head"] + region)
        else:
            checker.check(snippet["code"] == region, f"{path}: the code is not that of {name}; --write takes it over")
    if checker.write:
        checker.put(path, text)


def check_accuracy(checker, path):
    table = re.search(r"^<!-- AccuracyTable -->\n(.*?)^\\\* Beyond the bound(.*?)^<!-- /AccuracyTable -->$", checker.read(path),
                      re.DOTALL | re.MULTILINE)
    checker.check(table is not None, f"{path} has no table of accuracy with a line on marks")
    rows, notes = table.groups() if table else ("", "")
    cells = 0
    for row in rows.splitlines():
        solid = row.split("|")[1].strip() if row.startswith("|") else ""
        for error, bound, rest in re.findall(r"\| (\S+) / ([^\s\\]+)([^|]*)", row):
            cells += 1
            checker.check(float(error) <= float(bound) or "*" in rest, f"{path}: {solid}: {error} is beyond {bound}, without a mark")
            checker.check("*" not in rest or f"{solid} (" in notes, f"{path}: the line on marks does not name {solid}")
    checker.check(cells >= 4, f"{path}: the table of accuracy has {cells} cells")


def check_files(checker):
    for path, allowed in LINES.items():
        lines = checker.read(path).count("\n")
        checker.check(lines <= allowed, f"{path} has {lines} lines, {allowed} are allowed")
    for path in checker.find_documents():
        check_links(checker, path, checker.read(path))
        checker.check("@@" not in checker.read(path), f"{path} has a mark @@ that was to be replaced")
        # The notes name what was there on their day.
        if not path.startswith("Documentation/notes/"):
            check_paths(checker, path, checker.read(path))
        check_snippets(checker, path, checker.read(path))
    check_accuracy(checker, "Documentation/Numerics.md")


def run(checker, *arguments):
    result = subprocess.run([checker.program, *arguments], stdout=subprocess.PIPE, stderr=subprocess.PIPE, universal_newlines=True,
                            cwd=checker.root, timeout=200, check=False)
    checker.check(result.returncode == 0, f"{' '.join(arguments)}: exit status {result.returncode} {result.stderr}")
    return result.stdout


def is_near(expected, actual, is_bound):
    if not NUMBER.fullmatch(expected) or not NUMBER.fullmatch(actual):
        return expected == actual
    a, b = float(expected), float(actual)
    if is_bound:
        return a <= b * BOUND_FACTOR and b <= a * BOUND_FACTOR
    mantissa, _, exponent = expected.partition("e")
    decimals = len(mantissa.partition(".")[2])
    # Counts have no decimals and are exact.
    return a == b or (decimals > 0 and abs(a - b) <= LAST_DIGITS * 10.0 ** (int(exponent or 0) - decimals))


def is_same_line(expected, actual):
    if expected.startswith(("  evaluations ", "  seconds ")):
        # The words alone.
        return NUMBER.sub("", expected) == NUMBER.sub("", actual)
    if ", backend " in expected:
        return expected.split(", backend ")[0] == actual.split(", backend ")[0]
    old, new = re.split(r"[\s;,]+", expected), re.split(r"[\s;,]+", actual)
    return len(old) == len(new) and all(is_near(a, b, i > 0 and old[i - 1] in ("+/-", "by"))
                                        for i, (a, b) in enumerate(zip(old, new)))


def check_sample(checker, path):
    text = checker.read(path)
    for sample in SAMPLE.finditer(text):
        printed = run(checker, sample["file"])
        if checker.write:
            text = text.replace(sample["head"] + sample["text"], sample["head"] + printed)
            checker.put(path, text)
            continue
        old, new = sample["text"].splitlines(), printed.splitlines()
        checker.check(len(old) == len(new), f"{path}: the sample has {len(old)} lines, the program prints {len(new)}")
        for a, b in zip(old, new):
            checker.check(is_same_line(a, b), f"{path}: the sample has\n  {a}\nand the program prints\n  {b}")


def list_keys(value):
    """Keys of JSON, but not names of integrals, which are the user's."""
    if isinstance(value, list):
        return set().union(*(list_keys(item) for item in value)) if value else set()
    if not isinstance(value, dict):
        return set()
    keys = set(value)
    for key, item in value.items():
        keys |= set().union(*(list_keys(entry) for entry in item.values())) if key == "integrals" and item else list_keys(item)
    return keys


def check_guide(checker, sample):
    guide = "\n".join(checker.read(f"Documentation/{page}.md") for page in GUIDE)
    code = " ".join(re.findall(r"`([^`\n]+)`", guide)) + " " + " ".join(re.findall(r"^```.*?^```", guide, re.DOTALL | re.MULTILINE))
    words = set(re.findall(r"[\w-]+", code))
    options = sorted(set(re.findall(r"--[a-z-]+", run(checker, "--help"))))
    for option in options:
        checker.check(option in words or option.lstrip("-") in words or option in PAPER_OPTIONS,
                      f"the user guide does not name the option {option}")
    wanted = [word for pair in COMPLETE if pair[0] in options for word in pair]
    document = json.loads(run(checker, sample, "--quiet", "--json", "-", *wanted))
    compared = json.loads(run(checker, sample, sample, "--compare", "--quiet", "--json", "-"))["comparison"]
    for key in sorted(list_keys(document) | {"comparison"} | list_keys(compared)):
        checker.check(key in words, f"the user guide does not name the key {key} of the JSON")
    columns = next(csv.reader(io.StringIO(run(checker, sample, "--quiet", "--csv", "-"))))
    for column in columns:
        checker.check(column in words, f"the user guide does not name the column {column} of the CSV")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--root", default=os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__)))))
    parser.add_argument("--program", help="path of solidmoments")
    parser.add_argument("--sample", default="Examples/Models/sample_part.step", help="file for JSON and CSV, below the root")
    parser.add_argument("--write", action="store_true")
    options = parser.parse_args()
    checker = Checker(options.root, options.write)
    if options.program:
        checker.program = os.path.abspath(options.program)
        check_sample(checker, "README.md")
        check_guide(checker, options.sample)
    else:
        check_files(checker)
    for failure in checker.failures:
        print("FAIL", failure)
    print(f"{checker.checks} checks, {len(checker.failures)} failed")
    return 1 if checker.failures or not checker.checks else 0


if __name__ == "__main__":
    sys.exit(main())
