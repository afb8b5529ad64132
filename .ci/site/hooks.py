"""Makes a site of pages that were written for a repository: links to sources lead to copies, apps have a run to play."""

import posixpath
import re
from pathlib import Path

from mkdocs.structure.files import File

ROOT = Path(__file__).resolve().parents[2]
LINK = re.compile(r"(\]\()(?!\w+:|#)([^)#\s]+)")
TOP = ["CHANGELOG.md", "CONTRIBUTING.md", "SECURITY.md"]
# The pages with a run, and the apps.
RUNS = {f"apps/{app}.md": app for app in ("fleet", "hello", "intersection", "lightpaint", "maze", "race", "search")}
RUNS["kotlin.md"] = "lineup"
PLAYER = '\n<iframe style="width: 100%; height: 40rem; border: 0" src="{}" title="A run of {}, to play" loading="lazy"></iframe>\n'


def origin(uri):
    """The path in the repository of a page of the site."""
    return "README.md" if uri == "index.md" else uri if uri in TOP else "docs/" + uri


def text(uri):
    return (ROOT / origin(uri)).read_text(encoding="utf-8")


def target(uri, link):
    """Where a link of a page leads in the site, and the file of the repository that it must have there."""
    path = posixpath.normpath(posixpath.join(posixpath.dirname(origin(uri)), link))
    if not (ROOT / path).exists():
        return path, None  # strict MkDocs refuses it
    if path.startswith("docs/") and (ROOT / path).is_file():
        return path[len("docs/"):], None
    if path == "README.md" or path in TOP:
        return "index.md" if path == "README.md" else path, None
    return f"source/{path}.txt", ROOT / path


def on_files(files, config):
    pages = [file.src_uri for file in files if file.src_uri.endswith(".md")]
    for uri in ["index.md", *TOP]:
        files.append(File.generated(config, uri, content=text(uri)))
        pages.append(uri)
    copies = {}
    for uri in pages:
        for _, link in LINK.findall(text(uri)):
            copy, path = target(uri, link)
            if path is not None:
                copies[copy] = path
    for copy, path in sorted(copies.items()):
        content = "\n".join(sorted(each.name for each in path.iterdir())) if path.is_dir() else path.read_text(encoding="utf-8")
        files.append(File.generated(config, copy, content=content))
    files.append(File.generated(config, "api/index.html", content=""))  # the javadoc takes its place
    return files


def on_page_markdown(markdown, page, config, files):
    uri = page.file.src_uri
    here = posixpath.dirname(uri) or "."

    def moved(match):
        return match[1] + posixpath.relpath(target(uri, match[2])[0], here)

    markdown = LINK.sub(moved, markdown)
    if uri in RUNS:
        run = posixpath.relpath(f"runs/{RUNS[uri]}.html", here)
        title, rest = markdown.split("\n", 1)
        markdown = title + "\n" + PLAYER.format(run, RUNS[uri]) + rest
    return markdown
