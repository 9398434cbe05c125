"""What tests of both labs do in the browser."""

from tests.browser import Browser


def enter(browser: Browser, name: str, text: str) -> None:
    """Type into a field."""
    browser.run(
        "const box = document.getElementById(arguments[0]); box.focus(); box.value = arguments[1];"
        "box.dispatchEvent(new Event('input'));",
        name,
        text,
    )
    browser.settled()


def problem(browser: Browser) -> str:
    """Return why the page did not take what was given."""
    text: str = browser.run("return document.getElementById('problem').textContent")
    return text


def invalid(browser: Browser) -> int:
    """Return how many fields are marked."""
    number: int = browser.run("return document.querySelectorAll('[aria-invalid=\"true\"]').length")
    return number


def open_file(browser: Browser, text: str) -> None:
    """Choose a file with a text."""
    browser.run(
        "const files = new DataTransfer(); files.items.add(new File([arguments[0]], 'a.json'));"
        "const box = document.getElementById('file'); box.files = files.files;"
        "box.dispatchEvent(new Event('change'))",
        text,
    )
    browser.settled()


def choose(browser: Browser, name: str, value: object) -> None:
    """Choose an option of a list."""
    browser.run(
        "const box = document.getElementById(arguments[0]); box.value = arguments[1];"
        "box.dispatchEvent(new Event('change'))",
        name,
        str(value),
    )


def checked(browser: Browser) -> str:
    """Let the page check the exercise, and return what it says."""
    browser.run("document.getElementById('exercise-check').click()")
    said: str = browser.run("return document.getElementById('exercise-said').textContent")
    return said
