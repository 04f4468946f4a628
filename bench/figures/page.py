"""The page out/figures/index.html: plain HTML beside its pictures, so that it opens offline."""
import html

STYLE = """body { font: 16px/1.5 sans-serif; max-width: 75em; margin: 2em auto; padding: 0 1em }
img { max-width: 100% } table { border-collapse: collapse } td, th { padding: 0.1em 0.8em; text-align: right }
td:first-child, th:first-child { text-align: left } tr:nth-child(even) { background: #eee }
pre { background: #f4f4f4; padding: 0.5em; overflow-x: auto }"""


def write(context, title):
    body = "\n".join(RENDER[kind](content) for kind, content in context.items)
    page = f"""<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><title>{title}</title><style>{STYLE}</style></head>
<body><h1>{title}</h1>
{body}
</body></html>
"""
    (context.out / "index.html").write_text(page, encoding="utf-8")


def table(content):
    header, rows = content
    head = "".join(f"<th>{html.escape(str(cell))}</th>" for cell in header)
    lines = ["<tr>" + "".join(f"<td>{html.escape(str(cell))}</td>" for cell in row) + "</tr>" for row in rows]
    return f"<table><tr>{head}</tr>\n" + "\n".join(lines) + "</table>"


def picture(content):
    path, caption = content
    text = html.escape(caption)
    return f'<figure><a href="{path}"><img src="{path}" alt="{text}"></a><figcaption>{text}</figcaption></figure>'


RENDER = {
    "heading": lambda text: f"<h2>{html.escape(text)}</h2>",
    "text": lambda text: f"<p>{html.escape(text)}</p>",
    "command": lambda text: f"<pre>{html.escape(text)}</pre>",
    "table": table,
    "picture": picture,
}
