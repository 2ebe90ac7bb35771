"""Checks the words and the width of sources and documents: CheckLanguage.py [--root FOLDER]

- Comments, messages, help texts, texts of ParaView's XML and documents have none of the words of WORDS: each has
  a better one, which is printed with the file and the line. Words of a sentence are found across its lines.
  Strings without a space are names, and not checked.
- Names in code have none of the words of NAMES.
- Lines of sources in C++ and GLSL, and comment lines of scripts, have at most WIDTH characters; clang-format
  alone leaves strings wider.
The notes of Documentation/notes are left as they were written. Exit status 1 where something is found, or where
there was next to nothing to check.
"""
import argparse
import os
import re
import sys

WIDTH = 110
COMPARED = ("longer|more|less|fewer|larger|smaller|wider|farther|higher|lower|cheaper|better|worse|faster|slower|later|"
            "earlier")
# Pattern and what to write instead. Texts are compared with single spaces.
WORDS = (
    (r"(?<!\|)\b(told|tells?|telling)\b", "report, show, decide or distinguish"),
    (r"\bby need\b", "on demand"),
    (r"\bbut for\b", "except for"),
    (r"(?<![`*])\bbeside\b(?!`)", "next to, adjacent to, near, off, outside, compared with or in addition to"),
    (rf"\b(?<!there )(?<!there that )(is|are|was|were|be|been) no (?!(?:{COMPARED})\b)",
     "is not a, is not an, are not, is not; NaN; negligible"),
    (r"(?<![`|])\bturned\b(?! (?:out|into|on|off)\b)", "reversed, rotated or inverted"),
    (r"(?<!\bat )(?<![`{-])\bleast\b(?! (?:squares|significant|recently))", "smallest or minimum"),
    (r"`most`|\bmost (?:lines|rows|seconds|halvings|portions|steps|bytes|number)\b|\bthe most of\b",
     "largest or maximum"),
    (r"(?:^|[.:;!?] )(?-i:Of) (?:an?|the|each|every|all|one|this|that|[a-z]+ #)\b", "begin with the subject"))
NAMES = (
    (r"\b\w*[a-z](?:Most|Least)\b|\b(?:Most|Least)[A-Z]\w*|\b(?:most|least)[A-Z]\w*|\bGet(?:Most|Least)\w*",
     "Max, Min, Maximum, Minimum"),
    (r"\b\w*Turned\w*", "Reversed, Rotated, Inverted"),
    (r"\b(?:most|least) = ", "maximum, minimum"))
ALLOWED_NAMES = ("FindMostUsed", "leastUsed", "atLeast", "AtLeast")
# Folders and files that are not checked: results of builds, and the history.
LEFT_OUT = ("Documentation/notes", "CHANGELOG.md", "findings", "Testing/Temporary", "Testing/Programs/CheckLanguage.py")
# Names of these rooms follow when they are rebuilt.
OLD_NAMES = ("Readers/STEP/", "Testing/Readers/STEP/", "ParaViewPlugin/Extensions/")
CXX = (".h", ".cxx", ".glsl", ".h.in", ".cxx.in")
SCRIPTS = (".cmake", ".txt", ".sh", ".module")
PROSE = (".md", ".xml", ".xml.in")
# Comments (c) and strings (s) of a language.
TOKENS = {CXX: r"""(?P<c>//[^\n]*|/\*.*?\*/)|(?P<s>"(?:\\.|[^"\\\n])*")|'(?:\\.|[^'\\\n])'""",
          (".py",): r"""(?P<c>\#[^\n]*)"""
                    r"""|(?P<s>[rfb]{0,2}(?:\"{3}.*?\"{3}|"(?:\\.|[^"\\\n])*"|'(?:\\.|[^'\\\n])*'))""",
          SCRIPTS: r"""(?P<c>(?<![\w$"'{])\#[^\n]*)|(?P<s>"(?:\\.|[^"\\])*")"""}
TOKENS = {endings: re.compile(pattern, re.DOTALL) for endings, pattern in TOKENS.items()}
# What parts the words of a comment, a string, or a paragraph that goes on in the next line.
BREAKS = {"c": r"\s*\n\s*(?:(?://[/!]?<?|\#+|\*(?!/))[ \t]*)?|[ \t]{2,}|//[/!]?<?[ \t]*|/\*+[ \t]*|\*/",
          "s": r'"\s*\n\s*[rfb]?"|\\n|\s*\n\s*|[ \t]{2,}', "p": r"\s*\n\s*(?:\|[ \t]*)?|[ \t]{2,}"}
BREAKS = {kind: re.compile(pattern) for kind, pattern in BREAKS.items()}


def find_files(root):
    for folder, folders, files in os.walk(root):
        folders[:] = sorted(name for name in folders if not name.startswith((".", "build", "install", "__")))
        for name in sorted(files):
            path = os.path.relpath(os.path.join(folder, name), root)
            if name.endswith(CXX + (".py",) + SCRIPTS + PROSE) and not path.startswith(LEFT_OUT):
                yield path


def split_text(path, text):
    """(kind, begin, end) of comments, strings and paragraphs; those without code between them are one."""
    pattern = next((pattern for endings, pattern in TOKENS.items() if path.endswith(endings)), None)
    if pattern is None:
        return [("p", *found.span()) for found in re.finditer(r"(?:[^\n]|\n(?!\s*\n))+", text)]
    parts = []
    for found in pattern.finditer(text):
        kind = found.lastgroup
        gap = text[parts[-1][2]:found.start()] if parts else "code"
        if kind and parts and parts[-1][0] == kind and not gap.strip() and gap.count("\n") < 2:
            parts[-1] = (kind, parts[-1][1], found.end())
        elif kind:
            parts.append((kind, found.start(), found.end()))
    return parts


def join_lines(kind, text, begin, end):
    """The words of a part with single spaces, and the place in the text of each character."""
    words, places, last = [], [], begin
    for found in BREAKS[kind].finditer(text, begin, end):
        space = "" if found.group().startswith('"') else " "
        words += [text[last:found.start()], space]
        places += [*range(last, found.start()), *[found.end() - 1] * len(space)]
        last = found.end()
    return "".join([*words, text[last:end]]), [*places, *range(last, end + 1)]


def find_words(path, text):
    """(place, what was found, what to write) in comments, strings and documents."""
    for kind, begin, end in split_text(path, text):
        words, places = join_lines(kind, text, begin, end)
        if kind == "s":
            words = words.strip("\"'")
            if " " not in words.strip():
                continue
        for pattern, better in WORDS:
            for found in re.finditer(pattern, words, re.IGNORECASE):
                yield places[found.start()], found.group(), better


def find_names(path, text):
    if not path.endswith(CXX) or path.startswith(OLD_NAMES):
        return
    code = list(text)
    for _, begin, end in split_text(path, text):
        code[begin:end] = " " * (end - begin)
    code = "".join(code)
    for pattern, better in NAMES:
        for found in re.finditer(pattern, code):
            if found.group() not in ALLOWED_NAMES:
                yield found.start(), found.group(), better


def find_wide_lines(path, text):
    place = 0
    # A raw string of a sample or a help text is as wide as what it holds.
    raw = [range(*found.span()) for found in re.finditer(r'R"\(.*?\)"', text, re.DOTALL)]
    for line in text.splitlines(keepends=True):
        width = len(line.rstrip("\n"))
        is_limited = path.endswith(CXX) or re.match(r"\s*# ", line) and not path.endswith(PROSE)
        if width > WIDTH and is_limited and not any(place in part or place + width in part for part in raw):
            yield place, f"{width} characters", f"at most {WIDTH}"
        place += len(line)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--root", default=os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__)))))
    root = parser.parse_args().root
    files = failures = 0
    for path in find_files(root):
        with open(os.path.join(root, path), encoding="utf-8") as file:
            text = file.read()
        files += 1
        findings = [*find_words(path, text), *find_names(path, text), *find_wide_lines(path, text)]
        for place, found, better in findings:
            failures += 1
            print(f"{path}:{text.count(chr(10), 0, place) + 1}: {found.strip()!r}: {better}")
    print(f"{files} files, {failures} findings")
    return 1 if failures or files < 100 else 0


if __name__ == "__main__":
    sys.exit(main())
