"""The documentation as a book: every page is in it, every link leads somewhere."""

import re

from conftest import ROOT

DOCS = ROOT / "docs"
PAGES = [*DOCS.glob("*.md"), ROOT / "README.md", ROOT / "ARCHITECTURE.md"]
# Target and, behind #, the heading; links into the web have a colon.
LINK = re.compile(r"\]\(([^)#:]*)(?:#([^)]*))?\)")
HEADING = re.compile(r"^#+ (.+)$", re.MULTILINE)


def links(page):
    """The files and headings that a page leads to."""
    for target, heading in LINK.findall(page.read_text()):
        yield (page.parent / target).resolve() if target else page, heading


def anchors(page):
    """The names that mdBook and GitHub make of a page's headings."""
    for heading in HEADING.findall(page.read_text()):
        kept = "".join(c for c in heading.lower() if c.isalnum() or c in " -_")
        yield kept.replace(" ", "-")


def test_every_page_is_in_the_book():
    listed = {target.name for target, _ in links(DOCS / "SUMMARY.md")}
    assert listed == {page.name for page in DOCS.glob("*.md")} - {"SUMMARY.md"}


def test_every_link_leads_somewhere():
    found = [(page, target, heading) for page in PAGES for target, heading in links(page)]
    assert len(found) > 50
    missing = [f"{page.name}: {target}" for page, target, _ in found if not target.exists()]
    assert not missing
    lost = [
        f"{page.name}: {target.name}#{heading}"
        for page, target, heading in found
        if heading and heading not in anchors(target)
    ]
    assert not lost


def test_no_page_of_the_book_leads_out_of_it():
    """The book has the files of docs/ and no others."""
    out = [
        f"{page.name}: {target}"
        for page in DOCS.glob("*.md")
        for target, _ in links(page)
        if not target.is_relative_to(DOCS)
    ]
    assert not out
