"""The lab's page as a test sees it: what it says, shows and asks for, and what a person does to it."""

from __future__ import annotations

import json
import time
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any
from urllib.parse import unquote

from plategait.lab.scenario_json import plain_scenario
from plategait.model.presets import preset
from plategait.model.scenario import Scenario


@dataclass
class Tab:
    """A page in a browser, and everything that it said, threw or asked of the network meanwhile."""

    page: Any
    messages: list[str] = field(default_factory=list)
    errors: list[str] = field(default_factory=list)
    requests: list[str] = field(default_factory=list)

    def __post_init__(self) -> None:
        self.page.on("console", lambda message: self.messages.append(f"{message.type}: {message.text}"))
        self.page.on("pageerror", lambda error: self.errors.append(str(error)))
        self.page.context.on("request", self._asked)

    def _asked(self, request: Any) -> None:
        # What is in the file itself, and the file.
        if not request.url.startswith(("blob:", "data:", "file:")):
            self.requests.append(request.url)

    def open(self, path: Path, fragment: str = "") -> None:
        """Open a file as a double click does."""
        self.page.goto(path.as_uri() + fragment)

    def until(self, said: str, limit: float = 20.0, of: Any = None) -> Any:
        """What an expression of JavaScript says once it is true; the page's policy forbids playwright's own waiting."""
        end = time.monotonic() + limit
        while not (value := self.page.evaluate(said, of)):
            assert time.monotonic() < end, f"not within {limit} s: {said}"
            self.page.wait_for_timeout(20)
        return value

    def check(self) -> None:
        """Nothing was said, thrown or asked for."""
        assert (self.messages, self.errors, self.requests) == ([], [], [])


class Lab:
    """The page, by what people see of it."""

    def __init__(self, tab) -> None:
        self.tab, self.page = tab, tab.page

    def button(self, name: str):
        return self.page.get_by_role("button", name=name, exact=True)

    def row(self, field: str):
        return self.page.locator(f"[data-field='{field}']")

    def type(self, field: str, text: str) -> None:
        box = self.row(field).locator("input.number")
        box.fill(text)
        box.press("Enter")

    def value(self, field: str) -> str:
        return self.row(field).locator("input.number").input_value()

    def fault(self, field: str) -> str:
        return self.row(field).locator(".fault").inner_text()

    @property
    def notice(self) -> str:
        return self.page.locator("#notice").inner_text()

    @property
    def word(self) -> str:
        """What the sheet does, in words."""
        return self.page.locator(".scene .word").first.inner_text()

    @property
    def clock(self) -> float:
        return float(self.page.locator(".clock").inner_text().split()[0])

    def scenario(self) -> Scenario:
        """Scenario on the plate, from the link that the page gives."""
        self.button("Copy link").click()
        return linked(self.page.evaluate("location.hash"))

    def begin(self, name: str = "cheese") -> None:
        """Lay a preset down, with all its parts in sight."""
        self.page.get_by_label("Begin from a preset").select_option(name)
        self.page.evaluate("document.querySelectorAll('#controls details').forEach((each) => { each.open = true })")

    def reset(self) -> None:
        """As the page was when it was opened."""
        if self.button("Only one").count():
            self.button("Only one").click()
        self.page.get_by_role("slider", name="Speed", exact=True).press("Home")
        self.page.get_by_role("tab", name="Now").click()
        self.page.evaluate("document.querySelector('#notice').textContent = ''")
        self.begin()

    def says(self, text: str) -> None:
        """Wait for a notice, and take it away."""
        self.tab.until("(text) => document.querySelector('#notice').textContent.includes(text)", of=text)
        self.page.evaluate("document.querySelector('#notice').textContent = ''")

    def until_clock(self, condition: str, **of: float) -> None:
        """Wait for a condition on the clock, `now`."""
        said = (
            f"(of) => {{ const now = parseFloat(document.querySelector('.clock').textContent); return {condition}; }}"
        )
        self.tab.until(said, of=of)

    def moves(self, limit: float = 30.0) -> None:
        """The sheet is alive: its clock goes on, three times in a row, as it may just be laid down anew."""
        end, times = time.monotonic() + limit, [self.clock]
        while not (len(times) > 3 and times[-4] < times[-3] < times[-2] < times[-1]):
            assert time.monotonic() < end, f"no life within {limit} s: {self.word}, {self.notice}"
            self.page.wait_for_timeout(60)
            if self.clock != times[-1]:
                times.append(self.clock)


def linked(fragment: str) -> Scenario:
    """Scenario of a link."""
    held = json.loads(unquote(fragment.removeprefix("#")))
    plain = plain_scenario(preset(held["of"]).scenario)[0]
    for name, value in held["with"].items():
        part = plain
        *path, last = name.split(".")
        for step in path:
            part[step] = part[step] if part.get(step) is not None else {}
            part = part[step]
        part[last] = value
    return Scenario(**plain)
