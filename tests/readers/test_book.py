"""The documentation as a book: every page is in it, every link leads somewhere."""

import re

from conftest import ROOT

DOCS = ROOT / "docs"
LINK = re.compile(r"\]\(([^)#:]+?)(?:#[^)]*)?\)")


def test_every_page_is_in_the_book():
    listed = set(LINK.findall((DOCS / "SUMMARY.md").read_text()))
    assert listed == {page.name for page in DOCS.glob("*.md")} - {"SUMMARY.md"}


def test_every_link_leads_somewhere():
    missing = [
        f"{page.name}: {target}"
        for page in [*DOCS.glob("*.md"), ROOT / "README.md", ROOT / "ARCHITECTURE.md"]
        for target in LINK.findall(page.read_text())
        if not (page.parent / target).exists()
    ]
    assert not missing
