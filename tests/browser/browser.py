"""A real browser for the tests of the report's pages: Debian's chromium, driven by chromium-driver and selenium.

    class MyPage(browser.PageTest):                  # tests/browser/my_page_test.py
        page = "report/my_page.html"                 # below the results folder
        def test_title(self):
            self.open()                              # query="verdict=refuted", fragment="fit.b2.l1"
            self.assertEqual(self.driver.title, "...")

    if __name__ == "__main__":
        browser.main()

The pages come from a copy of results/ into which the program named by SUBDIVLAB_PROGRAM has written its pages anew.
browser.main() exits with 77, which ctest takes for "skipped", where a package is missing; experiments/setup --browser
installs them. SUBDIVLAB_SCREENSHOTS names a folder where screenshots() puts pictures for people.
"""

import atexit
import base64
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

SKIPPED = 77
ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = os.environ.get("SUBDIVLAB_PROGRAM", str(ROOT / "build" / "subdivlab"))
# The fewest claims that make the program write a folder's pages anew: those of a quick experiment.
QUICK_CLAIM = "limit.mask"


def _missing():
    """What the tests lack, in words; None when nothing does."""
    try:
        import selenium  # noqa: F401
    except ImportError:
        return "python3-selenium"
    for program, package in (("chromium", "chromium"), ("chromedriver", "chromium-driver")):
        if shutil.which(program) is None:
            return package
    if not os.access(PROGRAM, os.X_OK):
        return f"the program {PROGRAM}"
    return None


def main():
    """Runs the tests of the calling file, or skips them with a message."""
    missing = _missing()
    if missing is not None:
        print(f"Skipped: {missing} is missing; experiments/setup --browser installs what tests in a browser need")
        sys.exit(SKIPPED)
    unittest.main(module="__main__", verbosity=2)


class _Shared:
    """One browser and one folder of pages for all tests of a run."""

    driver = None
    scratch = None

    @classmethod
    def folder(cls):
        if cls.scratch is None:
            cls.scratch = pathlib.Path(tempfile.mkdtemp(prefix="subdivlab-browser-"))
            atexit.register(cls.close)
            results = cls.scratch / "results"
            shutil.copytree(ROOT / "results", results)
            subprocess.run([PROGRAM, "reproduce", QUICK_CLAIM, "--out", str(results)], check=True, timeout=300,
                           stdout=subprocess.DEVNULL)
        return cls.scratch / "results"

    @classmethod
    def browser(cls):
        if cls.driver is None:
            from selenium import webdriver
            from selenium.webdriver.chrome.service import Service

            profile = cls.folder().parent / "profile"
            profile.mkdir()
            options = webdriver.ChromeOptions()
            options.binary_location = shutil.which("chromium")
            for argument in ("--headless=new", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run",
                             "--disable-background-networking", "--disable-component-update", "--disable-sync",
                             "--disable-dev-shm-usage", "--hide-scrollbars", f"--user-data-dir={profile}"):
                options.add_argument(argument)
            options.set_capability("goog:loggingPrefs", {"browser": "ALL", "performance": "ALL"})
            cls.driver = webdriver.Chrome(service=Service(shutil.which("chromedriver")), options=options)
            cls.driver.set_page_load_timeout(120)
        return cls.driver

    @classmethod
    def close(cls):
        if cls.driver is not None:
            cls.driver.quit()
            cls.driver = None
        shutil.rmtree(cls.scratch, ignore_errors=True)


# Elements with text of their own whose contrast with what lies behind them is too small (WCAG 2.1, 1.4.3). Backgrounds
# are blended down the ancestors; the text of pictures is not looked at.
_CONTRAST = r"""
const parse = (text) => {
  const n = text.match(/[\d.]+/g).map(Number);
  return [n[0], n[1], n[2], n.length > 3 ? n[3] : 1];
};
const over = (a, b) => [0, 1, 2].map((i) => a[i] * a[3] + b[i] * (1 - a[3])).concat([1]);
const luminance = (c) => {
  const [r, g, b] = c.slice(0, 3).map((v) => v / 255).map((v) => (v <= 0.03928 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4));
  return 0.2126 * r + 0.7152 * g + 0.0722 * b;
};
const backdrop = (element) => {
  const layers = [];
  for (let e = element; e; e = e.parentElement) layers.push(parse(getComputedStyle(e).backgroundColor));
  const dark = matchMedia("(prefers-color-scheme: dark)").matches;
  return layers.reverse().reduce((below, layer) => over(layer, below), dark ? [18, 18, 18, 1] : [255, 255, 255, 1]);
};
const bad = [];
for (const element of document.querySelectorAll("body *")) {
  if (element.closest("svg, canvas, [hidden], script, style")) continue;
  const own = [...element.childNodes].some((n) => n.nodeType === 3 && n.textContent.trim());
  if (!own || element.getClientRects().length === 0 || element.matches(":disabled")) continue;
  const style = getComputedStyle(element);
  const back = backdrop(element);
  const front = over(parse(style.color), back);
  const [hi, lo] = [luminance(front), luminance(back)].sort((a, b) => b - a);
  const ratio = (hi + 0.05) / (lo + 0.05);
  const size = parseFloat(style.fontSize);
  const large = size >= 24 || (size >= 18.66 && parseInt(style.fontWeight) >= 700);
  if (ratio < (large ? 3 : 4.5))
    bad.push(`${element.tagName}.${element.className} "${element.textContent.trim().slice(0, 40)}" ${ratio.toFixed(2)}`);
}
return bad;
"""

# Elements that stick out of the page to the right, unless a box of their own scrolls or clips them.
_STICKING_OUT = r"""
const width = document.documentElement.clientWidth;
const contained = (element) => {
  for (let e = element.parentElement; e && e !== document.body; e = e.parentElement)
    if (getComputedStyle(e).overflowX !== "visible") return true;
  return false;
};
return [...document.querySelectorAll("body *")]
  .filter((e) => e.getBoundingClientRect().right > width + 1 && !contained(e))
  .map((e) => `${e.tagName}#${e.id}.${e.className}: ${e.getBoundingClientRect().right}`);
"""


class PageTest(unittest.TestCase):
    """A test of one page, at 1200 x 900 in the light scheme unless it says otherwise."""

    page = ""

    @classmethod
    def setUpClass(cls):
        cls.folder = _Shared.folder()
        cls.driver = _Shared.browser()

    def setUp(self):
        self.size(1200, 900)
        self.scheme("light")
        self.driver.get("about:blank")
        self._console = []
        self.driver.get_log("browser")
        self.driver.get_log("performance")

    # -- the page ----------------------------------------------------------------------------------------------------

    def url(self, query="", fragment="", page=None):
        address = (self.folder / (page or self.page)).as_uri()
        return address + ("?" + query if query else "") + ("#" + fragment if fragment else "")

    def open(self, query="", fragment="", page=None):
        self.driver.get("about:blank")  # a new fragment alone would not load the page again
        self.driver.get(self.url(query, fragment, page))

    def script(self, text, *arguments):
        return self.driver.execute_script(text, *arguments)

    def command(self, name, **parameters):
        """A command of the Chrome DevTools protocol."""
        return self.driver.execute_cdp_cmd(name, parameters)

    def find(self, selector):
        from selenium.webdriver.common.by import By

        return self.driver.find_element(By.CSS_SELECTOR, selector)

    def find_all(self, selector):
        from selenium.webdriver.common.by import By

        return self.driver.find_elements(By.CSS_SELECTOR, selector)

    def keys(self, *keys):
        """Types into whatever has the focus; names of selenium.webdriver.common.keys.Keys, or plain text."""
        from selenium.webdriver.common.action_chains import ActionChains
        from selenium.webdriver.common.keys import Keys

        for key in keys:
            ActionChains(self.driver).send_keys(getattr(Keys, key, key)).perform()

    def wait(self, condition, seconds=10):
        """Until condition() is true; fails when it never is."""
        from selenium.webdriver.support.ui import WebDriverWait

        WebDriverWait(self.driver, seconds, poll_frequency=0.05).until(lambda _: condition())

    # -- how it is shown ---------------------------------------------------------------------------------------------

    def size(self, width, height):
        """The size of the page's area in CSS pixels, also below the least window of the system."""
        self.command("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=False)

    def scheme(self, name, media=""):
        """"light" or "dark"; media "print" for the style sheet of printing."""
        self.command("Emulation.setEmulatedMedia", media=media,
                     features=[{"name": "prefers-color-scheme", "value": name}])

    def without_scripts(self, off=True):
        self.command("Emulation.setScriptExecutionDisabled", value=off)

    def pdf(self):
        """The bytes of the page printed on A4."""
        printed = self.command("Page.printToPDF", paperWidth=8.27, paperHeight=11.69, printBackground=False)
        return base64.b64decode(printed["data"])

    def screenshots(self, name):
        """A picture of what is shown now, for people; nothing without SUBDIVLAB_SCREENSHOTS."""
        folder = os.environ.get("SUBDIVLAB_SCREENSHOTS")
        if folder:
            pathlib.Path(folder).mkdir(parents=True, exist_ok=True)
            self.driver.save_screenshot(str(pathlib.Path(folder) / (name + ".png")))

    # -- what must hold of every page --------------------------------------------------------------------------------

    def console_errors(self):
        """Messages of the console that tell of errors or warnings, since the last call or the test's begin."""
        return [entry["message"] for entry in self.driver.get_log("browser") if entry["level"] in ("SEVERE", "WARNING")]

    def network_requests(self):
        """Addresses asked for that are no files, since the last call or the test's begin."""
        addresses = []
        for entry in self.driver.get_log("performance"):
            message = json.loads(entry["message"])["message"]
            if message["method"] == "Network.requestWillBeSent":
                addresses.append(message["params"]["request"]["url"])
        return [a for a in addresses if not a.startswith(("file:", "data:", "blob:", "about:", "chrome:"))]

    def low_contrast(self):
        return self.script(_CONTRAST)

    def sticking_out(self):
        """What makes the page scroll sideways; empty where nothing does."""
        wide = self.script("return document.documentElement.scrollWidth > document.documentElement.clientWidth")
        return (self.script(_STICKING_OUT) or ["the page is wider than its window"]) if wide else []

    def broken_links(self):
        """Links of the page to anchors and files that do not exist."""
        broken = []
        here = self.url()
        ids = set(self.script("return [...document.querySelectorAll('[id]')].map((e) => e.id)"))
        for href in set(self.script("return [...document.querySelectorAll('a[href]')].map((e) => e.href)")):
            if not href.startswith("file:"):
                continue
            address, _, fragment = href.partition("#")
            address = address.partition("?")[0]
            if address != here:
                path = pathlib.Path(_file_of(address))
                if not path.exists():
                    broken.append(href)
                elif fragment and f'id="{_unquoted(fragment)}"' not in path.read_text(encoding="utf-8"):
                    broken.append(href)
            elif fragment and _unquoted(fragment) not in ids:
                broken.append(href)
        return sorted(broken)

    def accessibility(self):
        """The nodes of the accessibility tree that are not ignored: [{"role", "name", "node"}]."""
        nodes = self.command("Accessibility.getFullAXTree")["nodes"]
        return [{"role": node.get("role", {}).get("value", ""), "name": node.get("name", {}).get("value", ""),
                 "node": node} for node in nodes if not node.get("ignored")]

    def nameless(self):
        """Roles of controls, links, pictures and landmarks that a screen reader could not name."""
        named = {"button", "link", "checkbox", "radio", "textbox", "searchbox", "slider", "combobox", "spinbutton", "img",
                 "image", "figure", "table", "form", "region", "group", "listbox", "option", "heading"}
        return [n["role"] for n in self.accessibility() if n["role"] in named and not n["name"].strip()]

    def skipped_headings(self):
        """Headings that stand more than one level below the one before them, and a first one that is no h1."""
        levels = self.script("return [...document.querySelectorAll('h1, h2, h3, h4, h5, h6')]"
                             ".map((e) => [+e.tagName[1], e.textContent])")
        return [text for (before, _), (level, text) in zip([[0, ""]] + levels, levels) if level > before + 1]


def _unquoted(text):
    import urllib.parse

    return urllib.parse.unquote(text)


def _file_of(address):
    import urllib.parse
    import urllib.request

    return urllib.request.url2pathname(urllib.parse.urlparse(address).path)
