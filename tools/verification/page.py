"""One page as Markdown and as HTML: headings, paragraphs, lists, tables, verbatim lines and a figure."""

import html
import re

class Page:
    def __init__(self, title):
        self.blocks = [("title", title)]

    def heading(self, text):
        self.blocks.append(("heading", text))

    def text(self, *paragraphs):
        self.blocks += [("text", " ".join(p.split())) for p in paragraphs]

    def items(self, *items):
        self.blocks.append(("items", [" ".join(i.split()) for i in items]))

    def table(self, head, rows):
        """A last column without a head is left out where it says nothing."""
        if not head[-1] and not any(row[-1] for row in rows):
            head, rows = head[:-1], [row[:-1] for row in rows]
        self.blocks.append(("table", (head, [[str(c) for c in row] for row in rows])))

    def verbatim(self, text):
        self.blocks.append(("verbatim", text))

    def picture(self, name, words):
        """A file in data/pictures, seen from tests/; only in the Markdown page."""
        self.blocks.append(("picture", (name, words)))

    def figure(self, svg):
        """Only in the HTML page."""
        self.blocks.append(("figure", svg))

    def markdown(self):
        out = []
        for kind, content in self.blocks:
            if kind in ("title", "heading"):
                out.append(("# " if kind == "title" else "## ") + content)
            elif kind == "text":
                out.append(wrap(content))
            elif kind == "items":
                out.append("\n".join(wrap(i, "- ", "  ") for i in content))
            elif kind == "picture":
                out.append("![{1}](../data/pictures/{0})".format(*content))
            elif kind == "verbatim":
                out.append("\n".join("    " + line for line in content.splitlines()))
            elif kind == "table":
                head, rows = content
                lines = [head, ["---"] * len(head), *rows]
                out.append("\n".join("| " + " | ".join(c.replace("|", "\\|") for c in line) + " |" for line in lines))
        return "\n\n".join(out) + "\n"

    def as_html(self):
        out = []
        for kind, content in self.blocks:
            if kind in ("title", "heading"):
                tag = "h1" if kind == "title" else "h2"
                out.append(f"<{tag}>{inline(content)}</{tag}>")
            elif kind == "text":
                out.append(f"<p>{inline(content)}</p>")
            elif kind == "items":
                out.append("<ul>" + "".join(f"<li>{inline(i)}</li>" for i in content) + "</ul>")
            elif kind == "verbatim":
                out.append(f"<pre>{html.escape(content)}</pre>")
            elif kind == "figure":
                out.append(content)
            elif kind == "table":
                head, rows = content
                out.append("<table><tr>" + "".join(f"<th>{inline(c)}</th>" for c in head) + "</tr>"
                           + "".join("<tr>" + "".join(f"<td>{inline(c)}</td>" for c in r) + "</tr>" for r in rows) + "</table>")
        style = ("body{font:15px/1.5 sans-serif;max-width:75em;margin:2em auto;padding:0 1em;color:#222}"
                 "table{border-collapse:collapse;margin:1em 0;font-size:13px}"
                 "th,td{border-bottom:1px solid #ccc;padding:.25em .7em;text-align:left;vertical-align:top}"
                 "th{background:#f2f2f2}pre,code{background:#f6f6f6}svg{max-width:100%;height:auto}")
        title = html.escape(self.blocks[0][1])
        return (f"<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>{title}</title>"
                f"<style>{style}</style></head><body>\n" + "\n".join(out) + "\n</body></html>\n")

def inline(text):
    """Code, bold and links of Markdown; a link to a file of the repository is shown as its text."""
    text = html.escape(text, quote=False)
    text = re.sub(r"`([^`]*)`", r"<code>\1</code>", text)
    text = re.sub(r"\*\*([^*]*)\*\*", r"<b>\1</b>", text)
    return re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", text)

def wrap(text, first="", rest="", width=120):
    lines, line = [], first
    for word in text.split():
        if len(line) + len(word) + 1 > width and line.strip() not in ("", "-"):
            lines.append(line.rstrip())
            line = rest
        line += word + " "
    return "\n".join([*lines, line.rstrip()])

def number(value, digits=6):
    return f"{value:.{digits}g}"

def percent(value):
    return "0" if value < 5e-16 else f"{100 * value:.2g} %"
