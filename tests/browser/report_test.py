"""The report and the errata in a browser: content, links, filters, deep links, keyboard, names, narrow, dark, printed."""

import json
import re

import browser


def without_explorer(folder, links):
    """Links but for those to the explorer, where the folder has none yet."""
    has_one = (folder / "report" / "explorer.html").exists()
    return [link for link in links if has_one or not link.endswith("/explorer.html")]


class ReportPage(browser.PageTest):
    page = "report/index.html"

    def claims(self):
        return json.loads((self.folder / "claims.json").read_text(encoding="utf-8"))["claims"]

    def shown(self):
        """The ids of the claims that are displayed."""
        return self.script("return [...document.querySelectorAll('.claim')]"
                           ".filter((e) => e.offsetParent !== null).map((e) => e.id)")

    def status(self):
        return self.find("#status").text

    def box(self, name, value):
        return self.find(f"input[name='{name}'][value='{value}']")

    def expect(self, wanted):
        """Exactly the claims for which wanted(claim) is true are shown and counted."""
        ids = sorted(c["id"] for c in self.claims() if wanted(c))
        self.wait(lambda: sorted(self.shown()) == ids)
        self.assertTrue(self.status().startswith(f"{len(ids)} of {len(self.claims())} claims shown"), self.status())

    # -- content -----------------------------------------------------------------------------------------------------

    def test_every_claim_with_its_verdict(self):
        self.open()
        articles = self.script("""return Object.fromEntries([...document.querySelectorAll(".claim")].map((e) =>
            [e.id, { text: e.textContent, printed: e.querySelector("q")?.textContent ?? null,
                     mark: e.querySelector(".mark").textContent, rigour: e.querySelectorAll(".mark")[1].textContent }]))""")
        claims = self.claims()
        self.assertEqual(sorted(articles), sorted(c["id"] for c in claims))
        for claim in claims:
            article = articles[claim["id"]]
            self.assertEqual(article["mark"], claim["verdict"], claim["id"])
            self.assertEqual(article["rigour"], claim["rigour"], claim["id"])
            self.assertEqual(article["printed"], claim["printed"], claim["id"])
            for text in (claim["definition"], claim["note"], claim["value"].get("exact", "")):
                self.assertIn(text, article["text"], claim["id"])

    def test_every_figure_is_drawn_and_described(self):
        self.open()
        self.script("document.querySelectorAll('img').forEach((i) => (i.loading = 'eager'))")
        self.wait(lambda: self.script("return [...document.images].every((i) => i.complete)"), 60)
        manifest = json.loads((self.folder / "manifest.json").read_text(encoding="utf-8"))
        figures = self.script("return Object.fromEntries([...document.querySelectorAll('figure')].map((f) => "
                              "[f.id, { width: f.querySelector('img').naturalWidth, alt: f.querySelector('img').alt }]))")
        self.assertEqual(sorted(figures), sorted("figure:" + f["name"] for f in manifest["figures"]))
        for figure in manifest["figures"]:
            drawn = figures["figure:" + figure["name"]]
            self.assertGreater(drawn["width"], 0, figure["name"])
            self.assertTrue(drawn["alt"].startswith(figure["title"]), figure["name"])
            self.assertIn(figure.get("shows", ""), drawn["alt"])

    def test_links_lead_somewhere(self):
        self.open()
        self.assertEqual(without_explorer(self.folder, self.broken_links()), [])

    def test_needs_nothing_else(self):
        self.open()
        self.script("document.querySelectorAll('img').forEach((i) => (i.loading = 'eager'))")
        self.wait(lambda: self.script("return [...document.images].every((i) => i.complete)"), 60)
        self.assertEqual(self.network_requests(), [])
        self.assertEqual(self.console_errors(), [])

    def test_works_without_scripts(self):
        self.without_scripts()
        try:
            self.open(query="verdict=refuted")
            self.assertFalse(self.find("#filters").is_displayed())
            self.assertTrue(self.find(".no-script").is_displayed())
            self.assertTrue(all(article.is_displayed() for article in self.find_all(".claim")[::50]))
        finally:
            self.without_scripts(False)

    # -- filters -----------------------------------------------------------------------------------------------------

    def test_filters_by_verdict(self):
        self.open()
        self.expect(lambda c: True)
        self.box("verdict", "refuted").click()
        self.expect(lambda c: c["verdict"] == "refuted")
        self.box("verdict", "inconsistent").click()
        self.expect(lambda c: c["verdict"] in ("refuted", "inconsistent"))
        self.box("document", "polyloops").click()
        self.expect(lambda c: c["verdict"] in ("refuted", "inconsistent") and c["document"] == "polyloops")
        self.find("button[type=reset]").click()
        self.expect(lambda c: True)

    def test_filters_by_rigour(self):
        self.open()
        self.box("rigour", "certified").click()
        self.expect(lambda c: c["rigour"] == "certified")

    def test_each_number_beside_a_choice_is_what_it_shows(self):
        self.open()
        for label in self.find_all("#filters label:has(input)"):
            number = int(label.find_element("css selector", ".count").text)
            label.click()
            self.wait(lambda: self.status().startswith(f"{number} of "))
            self.assertEqual(len(self.shown()), number)
            label.click()
            self.wait(lambda: self.status().startswith(f"{len(self.claims())} of "))

    def test_sharpened_claims_say_what_more_is_proved(self):
        self.open(query="sharpened=yes")
        ids = self.shown()
        # The continuity ranges that jsplines prints are contained in those that are proved.
        for id in ("smooth.sufficient.c1.lower", "smooth.sufficient.c3.upper"):
            self.assertIn(id, ids)
        claims = {c["id"]: c for c in self.claims()}
        for id in ids:
            self.assertEqual(claims[id]["verdict"], "reproduced")
            self.assertIn("More is proved", self.script("return document.getElementById(arguments[0]).textContent", id))
        self.assertIn("smooth.exact.c1.lower", self.find("[id='smooth.sufficient.c1.lower']").text)

    def test_searches(self):
        self.open()
        self.find("#words").send_keys("FOUR-POINT  tension")
        self.wait(lambda: 0 < len(self.shown()) < 100)
        for id in self.shown():
            text = self.script("return document.getElementById(arguments[0]).textContent", id).lower()
            self.assertTrue("four-point" in text and "tension" in text, id)
        self.find("#words").clear()
        self.find("#words").send_keys("there is no such word")
        self.expect(lambda c: False)

    def test_the_address_keeps_the_filters(self):
        self.open()
        self.box("verdict", "refuted").click()
        self.find("#words").send_keys("area")
        self.wait(lambda: "q=area" in self.driver.current_url)
        shown = self.shown()
        address = self.driver.current_url
        self.assertIn("verdict=refuted", address)
        self.driver.get("about:blank")
        self.driver.get(address)
        self.wait(lambda: self.shown() == shown)
        self.assertTrue(self.box("verdict", "refuted").is_selected())
        self.assertEqual(self.find("#words").get_attribute("value"), "area")

    def test_the_overview_leads_to_its_claims(self):
        self.open()
        link = next(a for a in self.find_all("#overview td a") if "refuted&document=speed" in a.get_attribute("href"))
        number = int(link.text)
        link.click()
        self.expect(lambda c: c["verdict"] == "refuted" and c["document"] == "speed")
        self.assertEqual(len(self.shown()), number)

    # -- deep links --------------------------------------------------------------------------------------------------

    def at_the_top(self, id):
        top = self.script("return document.getElementById(arguments[0]).getBoundingClientRect().top", id)
        return -5 < top < 100

    def test_deep_link(self):
        self.open(fragment="fit.b2.l1")
        self.wait(lambda: self.at_the_top("fit.b2.l1"))
        self.assertIn("linked", self.find("[id='fit.b2.l1']").get_attribute("class"))

    def test_deep_link_to_what_a_filter_hides(self):
        self.open(query="verdict=refuted", fragment="fit.b2.l1")
        self.wait(lambda: self.at_the_top("fit.b2.l1"))
        self.assertIn("fit.b2.l1", self.shown())
        self.assertIn("fit.b2.l1 is shown because a link leads to it", self.status())
        self.script("location.hash = 'edge.s'")
        self.wait(lambda: self.at_the_top("edge.s"))
        self.assertNotIn("linked", self.find("[id='fit.b2.l1']").get_attribute("class"))

    def test_each_claim_has_a_link_to_copy(self):
        self.open()
        links = self.script("return [...document.querySelectorAll('.claim')]"
                            ".map((e) => [e.id, e.querySelector('.deep').getAttribute('href')])")
        self.assertTrue(all(href == "#" + id for id, href in links))
        self.command("Browser.grantPermissions", permissions=["clipboardReadWrite", "clipboardSanitizedWrite"])
        self.script("document.querySelector('[id=\"edge.s\"] .deep').click()")
        self.wait(lambda: "edge.s copied" in self.status())

    # -- for everyone ------------------------------------------------------------------------------------------------

    def test_names_and_order(self):
        self.open()
        self.assertEqual(self.nameless(), [])
        self.assertEqual(self.skipped_headings(), [])
        self.assertEqual(len(self.find_all("h1")), 1)
        names = {(n["role"], n["name"]) for n in self.accessibility()}
        for landmark in (("navigation", "Pages"), ("navigation", "Documents"), ("search", "Filter the claims")):
            self.assertIn(landmark, names)
        roles = {role for role, _ in names}
        self.assertLessEqual({"main", "banner", "contentinfo", "status"}, roles)
        self.assertIn(("searchbox", "Search"), names)
        self.assertTrue(any(role == "checkbox" and name.startswith("refuted") for role, name in names))
        self.assertTrue(any(role == "table" and name.startswith("Verdicts by document") for role, name in names))
        self.assertEqual(self.script("return document.documentElement.lang"), "en")

    def test_keyboard(self):
        self.open()
        self.keys("TAB")
        focused = "return document.activeElement"
        self.assertEqual(self.script(focused).text, "Skip to the content")
        self.keys("ENTER")
        self.assertEqual(self.script(focused).tag_name, "main")
        self.open()
        reached = []
        for _ in range(60):
            self.keys("TAB")
            element = self.script(focused)
            outline = self.script("return getComputedStyle(document.activeElement).outlineStyle")
            self.assertNotEqual(outline, "none", element.get_attribute("outerHTML")[:120])
            reached.append((element.tag_name, element.get_attribute("name"), element.get_attribute("value")))
        self.assertIn(("input", "q", ""), reached)
        self.assertIn(("input", "verdict", "refuted"), reached)
        self.assertIn(("input", "document", "speed"), reached)
        self.script("document.querySelector('input[value=refuted]').focus()")
        self.keys("SPACE")
        self.expect(lambda c: c["verdict"] == "refuted")

    def test_the_choices_give_way_on_a_narrow_page(self):
        self.size(360, 800)
        self.open()
        visible = "return document.querySelector('input[value=refuted]').checkVisibility()"
        self.assertFalse(self.script(visible))
        self.find("#choices summary").click()
        self.box("verdict", "refuted").click()
        self.expect(lambda c: c["verdict"] == "refuted")
        self.open(query="verdict=refuted")
        self.assertTrue(self.script(visible))

    def test_contrast(self):
        for scheme in ("light", "dark"):
            self.scheme(scheme)
            self.open(fragment="area.rs.r.js-report")
            self.assertEqual(self.low_contrast(), [], scheme)

    def test_narrow(self):
        for scheme, width in (("light", 320), ("dark", 360), ("light", 768), ("light", 1280), ("light", 1920)):
            self.scheme(scheme)
            self.size(width, 800)
            self.open()
            self.assertEqual(self.sticking_out(), [], width)
            self.screenshots(f"report-{width}-{scheme}")

    def test_prints(self):
        self.open(query="document=speed")
        self.expect(lambda c: c["document"] == "speed")
        self.scheme("dark", media="print")
        self.assertEqual(self.script("return getComputedStyle(document.body).backgroundColor"), "rgb(255, 255, 255)")
        self.assertFalse(self.find("#filters").is_displayed())
        self.scheme("light")
        pages = len(re.findall(rb"/Type\s*/Page\b", self.pdf()))
        self.assertGreater(pages, 5)


class ErrataPage(browser.PageTest):
    page = "report/errata.html"

    def test_holds_what_is_refuted_or_open(self):
        self.open()
        claims = json.loads((self.folder / "claims.json").read_text(encoding="utf-8"))["claims"]
        text = self.find("main").get_attribute("textContent")
        for claim in claims:
            listed = claim["verdict"] in ("refuted", "inconsistent", "not-reproducible")
            commands = re.search(r"reproduce[^\n]*(?<![\w.-])" + re.escape(claim["id"]) + r"(?![\w.-])", text)
            self.assertEqual(listed, commands is not None, claim["id"])
            if listed:
                self.assertIn(claim["printed"], text)
                self.assertRegex(text, self.with_references(claim["note"]))

    def with_references(self, note):
        """The note as a pattern: ids of claims are [1], [2], .."""
        ids = {c["id"] for c in json.loads((self.folder / "claims.json").read_text(encoding="utf-8"))["claims"]}
        words = re.split(r"((?<![\w/])[a-z0-9-]+(?:\.[a-z0-9-]+)+)", note)
        return "".join(r"\[\d+\]" if word in ids else re.escape(word) for word in words)

    def test_links_names_headings_and_console(self):
        self.open()
        self.assertEqual(without_explorer(self.folder, self.broken_links()), [])
        self.assertEqual(self.nameless(), [])
        self.assertEqual(self.skipped_headings(), [])
        self.assertEqual(self.network_requests(), [])
        self.assertEqual(self.console_errors(), [])

    def test_narrow_dark_and_printed(self):
        for scheme in ("light", "dark"):
            self.scheme(scheme)
            for width in (320, 1280):
                self.size(width, 800)
                self.open()
                self.assertEqual(self.sticking_out(), [], width)
                self.assertEqual(self.low_contrast(), [], scheme)
                self.screenshots(f"errata-{width}-{scheme}")
        self.assertTrue(self.pdf().startswith(b"%PDF"))


if __name__ == "__main__":
    browser.main()
