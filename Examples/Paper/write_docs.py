#!/usr/bin/env python3
"""Writes the output of regenerate.sh into the page: write_docs.py OUTDIR

Pictures go to images/; in README.md the table between <!-- Table --> and <!-- /Table -->, and, where OUTDIR's table has a section
"Real files", its end between <!-- RealFiles --> and <!-- /RealFiles --> and the whole of it in real_files.md. Sentences about the
numbers are people's: read them again.
"""
import pathlib
import re
import shutil
import sys
import textwrap

HERE = pathlib.Path(__file__).resolve().parent


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


def main():
    if len(sys.argv) != 2:
        print("usage: write_docs.py OUTDIR", file=sys.stderr)
        return 1
    made = pathlib.Path(sys.argv[1])
    try:
        caption, sections = split_sections((made / "table.md").read_text(encoding="utf-8"))
        page = (HERE / "README.md").read_text(encoding="utf-8")
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
    except (OSError, ValueError, KeyError) as error:
        print(f"write_docs.py: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
