"""Headless Chromium for the tests of pages: it opens files, and reports errors and requests.

Chromium and its driver come from the system (Debian: ``chromium`` and ``chromium-driver``). Where
they are missing the tests of pages are left out, and the run says so. ``BROWSER_TESTS=1`` demands
them: then a missing browser is a failure. ``BROWSER_TESTS=0`` leaves them out on purpose.
"""

import contextlib
import json
import os
import shutil
import tempfile
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any
from urllib.parse import unquote, urlsplit

CHROMIUM = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable")
#: A fresh profile, no sandbox (tests may run as root), and nothing that talks to the network.
FLAGS = (
    "--headless",
    "--no-sandbox",
    "--disable-gpu",
    "--disable-quic",
    "--disable-dev-shm-usage",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
    "--disable-extensions",
    "--hide-scrollbars",
)
MISSING = "Chromium or its driver is missing (Debian: apt-get install chromium chromium-driver)"


def left_out() -> str | None:
    """Return in one line why the tests of pages are left out, or None when they are to run."""
    choice = os.environ.get("BROWSER_TESTS", "")
    if choice == "0":
        return "the tests of pages are left out: BROWSER_TESTS=0"
    if not choice and programs() is None:
        return f"the tests of pages are left out: {MISSING}"
    return None


def programs() -> tuple[str, str] | None:
    """Return the paths of Chromium and of its driver, or None when one is missing."""
    chromium = next(filter(None, map(shutil.which, CHROMIUM)), None)
    driver = shutil.which("chromedriver")
    return (chromium, driver) if chromium and driver else None


class Browser:
    """One running browser; every page is opened anew."""

    def __init__(self, driver: Any) -> None:
        self.driver = driver

    def open(self, path: Path | str, width: int = 1280, height: int = 800) -> None:
        """Open a file in a window of a given inner size, and forget what earlier pages did."""
        self.resize(width, height)
        self.driver.get("about:blank")
        for kind in ("browser", "performance"):
            self.driver.get_log(kind)
        self.driver.get(path if isinstance(path, str) else path.resolve().as_uri())

    def resize(self, width: int, height: int) -> None:
        """Give the window another inner size."""
        self.driver.execute_cdp_cmd(
            "Emulation.setDeviceMetricsOverride",
            {"width": width, "height": height, "deviceScaleFactor": 1, "mobile": False},
        )

    def run(self, script: str, *arguments: Any) -> Any:
        """Run JavaScript in the page; the value of its ``return`` comes back."""
        return self.driver.execute_script(script, *arguments)

    def show(self, page: str, folder: Path, width: int = 1280, height: int = 1000) -> Path:
        """Write a page into a folder, open it, and wait until it is drawn; return its file."""
        path = folder / "page.html"
        path.write_text(page, encoding="utf-8")
        self.open(path, width, height)
        self.settled()
        return path

    def text(self, name: str) -> str:
        """Return the text of the element of an id."""
        found: str = self.run("return document.getElementById(arguments[0]).textContent", name)
        return found

    def texts(self, selector: str) -> list[str]:
        """Return the texts of all elements."""
        script = "return [...document.querySelectorAll(arguments[0])].map((e) => e.textContent)"
        found: list[str] = self.run(script, selector)
        return found

    def count(self, selector: str) -> int:
        """Return how many elements there are."""
        found: int = self.run("return document.querySelectorAll(arguments[0]).length", selector)
        return found

    def middle(self, selector: str) -> tuple[float, float]:
        """Return the place of the window where the middle of an element is."""
        x, y = self.run(
            "const r = document.querySelector(arguments[0]).getBoundingClientRect();"
            "return [r.x + r.width / 2, r.y + r.height / 2]",
            selector,
        )
        return x, y

    def put(self, name: str, value: object, event: str = "change") -> None:
        """Give the field of an id a value, as if it were unfolded, and typed or chosen."""
        self.run(
            "const box = document.getElementById(arguments[0]);"
            "for (let one = box; one = one.closest('details:not([open])');) one.open = true;"
            "box.focus();"
            "box.value = arguments[1]; box.dispatchEvent(new Event(arguments[2]));",
            *(name, str(value), event),
        )
        self.settled()

    def settled(self) -> None:
        """Wait until the page has drawn what was asked for."""
        self.driver.execute_async_script(
            "const done = arguments[0];"
            "requestAnimationFrame(() => requestAnimationFrame(() => done()));"
        )

    def pointer(self, kind: str, x: float, y: float) -> None:
        """Send a real mouse event (``mouseMoved``, ``mousePressed``, ``mouseReleased``)."""
        button = "none" if kind == "mouseMoved" else "left"
        event = {"type": kind, "x": x, "y": y, "button": button, "clickCount": 1}
        self.driver.execute_cdp_cmd("Input.dispatchMouseEvent", event)
        self.settled()

    def click_at(self, x: float, y: float) -> None:
        """Move to a place of the window and click."""
        for kind in ("mouseMoved", "mousePressed", "mouseReleased"):
            self.pointer(kind, x, y)

    def drag(self, start: tuple[float, float], stop: tuple[float, float]) -> None:
        """Press at one place, move to another in steps, let go."""
        self.pointer("mouseMoved", *start)
        self.pointer("mousePressed", *start)
        for k in range(1, 6):
            x, y = (a + (b - a) * k / 5 for a, b in zip(start, stop, strict=True))
            self.driver.execute_cdp_cmd(
                "Input.dispatchMouseEvent",
                {"type": "mouseMoved", "x": x, "y": y, "button": "left", "buttons": 1},
            )
        self.pointer("mouseReleased", *stop)

    def fingers(self, *steps: Sequence[tuple[float, float]]) -> None:
        """Put fingers on the window, move them from step to step, lift them."""
        for k, places in enumerate(steps):
            self._touch("touchMove" if k else "touchStart", places)
        self._touch("touchEnd", ())
        self.settled()

    def _touch(self, kind: str, places: Sequence[tuple[float, float]]) -> None:
        points = [{"x": x, "y": y, "id": k} for k, (x, y) in enumerate(places)]
        event = {"type": kind, "touchPoints": points}
        self.driver.execute_cdp_cmd("Input.dispatchTouchEvent", event)

    def key(self, name: str) -> None:
        """Press a key on what has the focus, such as ``ArrowLeft`` or ``n``."""
        text = {"text": name} if len(name) == 1 else {}
        for kind in ("keyDown", "keyUp"):
            event = {"type": kind, "key": name, **(text if kind == "keyDown" else {})}
            self.driver.execute_cdp_cmd("Input.dispatchKeyEvent", event)
        self.settled()

    def messages(self) -> list[str]:
        """Return what the console has said since the page was opened."""
        return [entry["message"] for entry in self.driver.get_log("browser")]

    def requests(self) -> list[str]:
        """Return the address of every request since the page was opened."""
        found = []
        for entry in self.driver.get_log("performance"):
            message = json.loads(entry["message"])["message"]
            if message["method"] == "Network.requestWillBeSent":
                found.append(message["params"]["request"]["url"])
            if message["method"] == "Network.webSocketCreated":
                found.append(message["params"]["url"])
        return found

    def outside(self, folder: Path | None = None) -> list[str]:
        """Return the requests that leave the page: all but data, blobs and files below `folder`."""
        return [url for url in self.requests() if not _is_inside(url, folder)]

    def screenshot(self, path: Path) -> None:
        """Write a PNG of the window."""
        self.driver.save_screenshot(str(path))


def _is_inside(url: str, folder: Path | None) -> bool:
    parts = urlsplit(url)
    if parts.scheme in ("data", "blob", "about"):
        return True
    if parts.scheme != "file" or parts.netloc:
        return False
    return folder is None or Path(unquote(parts.path)).is_relative_to(folder.resolve())


@contextlib.contextmanager
def running() -> Iterator[Browser]:
    """Start Chromium with an empty profile of its own; end it and remove the profile after.

    Raises:
        FileNotFoundError: Chromium or its driver is missing.
    """
    from selenium import webdriver

    found = programs()
    if found is None:
        raise FileNotFoundError(MISSING)
    options = webdriver.ChromeOptions()
    options.binary_location = found[0]
    options.set_capability("goog:loggingPrefs", {"browser": "ALL", "performance": "ALL"})
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as profile:
        for flag in (*FLAGS, f"--user-data-dir={profile}"):
            options.add_argument(flag)
        driver = webdriver.Chrome(options, webdriver.ChromeService(found[1]))
        try:
            driver.set_page_load_timeout(60)
            driver.set_script_timeout(30)
            yield Browser(driver)
        finally:
            driver.quit()
