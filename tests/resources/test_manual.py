"""The pages of the manual: each is in the list, and what they link to is there."""

import re

import pytest

from resources import path
from resources.manual_pages import FIRST, pages

FOLDER = path("manual")


def test_every_page_is_in_the_list_and_has_a_title_of_its_own():
    assert {page.file.name for page in pages()} == {file.name for file in FOLDER.glob("*.md")}
    assert pages()[0].file.name == FIRST
    titles = [page.title for page in pages()]
    assert len(set(titles)) == len(titles)
    assert all(page.text.startswith(f"# {page.title}\n\n") for page in pages())


@pytest.mark.parametrize("page", pages(), ids=lambda page: page.file.stem)
def test_links_of_manual_pages_lead_somewhere(page):
    links = re.findall(r"\]\((?!https?:)([^)#]+)\)", page.text)
    files = re.findall(r"`((?:workbench|ui|resources)/[^`]*)`", page.text)
    missing = [link for link in links if not (FOLDER / link).is_file()]
    assert not missing + [file for file in files if not (FOLDER.parents[1] / file).exists()]


def test_every_picture_is_shown_on_a_page():
    shown = {link for page in pages() for link in re.findall(r"\(images/([^)]+)\)", page.text)}
    assert shown == {file.name for file in (FOLDER / "images").glob("*.png")}
