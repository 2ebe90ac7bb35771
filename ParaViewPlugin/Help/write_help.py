"""write_help.py FOLDER XML...: a page of HTML per source, filter and writer of the server manager's XML files, for the "?" of ParaView's
panel, which looks for GROUP.NAME.html."""
import html
import os
import re
import sys
import xml.etree.ElementTree as ElementTree

folder, paths = sys.argv[1], sys.argv[2:]
# (group, name): the element.
proxies = {(group.get("name"), element.get("name")): element for path in paths for group in ElementTree.parse(path).getroot()
           for element in group}


def list_bases(element):
    """The element and those that it is derived from, the last base first."""
    base = (element.get("base_proxygroup"), element.get("base_proxyname"))
    return (list_bases(proxies[base]) if base in proxies else []) + [element]


def get_paragraphs(element):
    found = element.find("Documentation")
    text = found.text if found is not None and found.text else ""
    return [" ".join(paragraph.split()) for paragraph in text.strip().split("\n\n") if paragraph.strip()]


def get_text(element):
    return " ".join(get_paragraphs(element))


def part_outputs(paragraphs, names):
    """The paragraphs without what is said of the outputs ("Solids: a table ..."), and that by their names."""
    texts, rest = {}, []
    for paragraph in paragraphs:
        pieces = re.split("(?:(?<=^)|(?<=[.] ))(" + "|".join(re.escape(name) for name in names) + "): ", paragraph) if names else [paragraph]
        texts.update((name, text.strip()) for name, text in zip(pieces[1::2], pieces[2::2]))
        rest += [pieces[0].strip()] if pieces[0].strip() else []
    return rest, texts


def get_label(element):
    """As ParaView's: the label, or the name with a blank before each capital letter."""
    name = element.get("name")
    return element.get("label") or "".join(" " + c if i and c.isupper() and not name[i - 1].isupper() else c for i, c in enumerate(name))


def make_page(element):
    rows = {}
    for source in list_bases(element):
        for each in source:
            if each.tag.endswith("Property") and each.get("panel_visibility") != "never" and get_text(each):
                rows[each.get("name")] = (get_label(each), get_text(each))
    ports = {}
    for source in list_bases(element):
        for port in source.findall("OutputPort"):
            ports[int(port.get("index"))] = port.get("name")
    title = html.escape(get_label(element))
    paragraphs, outputs = part_outputs(get_paragraphs(element), list(ports.values()))
    lines = [f"<html><head><title>{title}</title></head><body><h2>{title}</h2>"] + [f"<p>{html.escape(text)}</p>" for text in paragraphs]
    if ports:
        named = [(ports[i], outputs.get(ports[i])) for i in sorted(ports)]
        lines.append("<h3>Outputs</h3><ol start=\"0\">" + "".join(
            f"<li><b>{html.escape(name)}</b>{': ' + html.escape(text) if text else ''}</li>" for name, text in named) + "</ol>")
    lines.append("<h3>Properties</h3><table border=\"1\" cellpadding=\"4\"><tr><th>Property</th><th>Description</th></tr>")
    lines += [f"<tr><td>{html.escape(label)}</td><td>{html.escape(text)}</td></tr>" for label, text in rows.values()]
    return "\n".join(lines + ["</table></body></html>", ""])


os.makedirs(folder, exist_ok=True)
for (group, name), proxy in sorted(proxies.items()):
    if group in ("sources", "filters", "writers"):
        with open(os.path.join(folder, f"{group}.{name}.html"), "w", encoding="utf-8") as file:
            file.write(make_page(proxy))
