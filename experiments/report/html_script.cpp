#include "experiments/report/html_page.h"

namespace subdiv {

const std::string& html_script() {
  static const std::string script = R"js("use strict";
// Filters: the address holds them (?verdict=refuted&document=speed&q=ring), so that a filtered view can be linked.
const form = document.getElementById("filters");
const announced = document.getElementById("status");
const claims = [...document.querySelectorAll(".claim")].map((element) => ({ element, words: null }));
const boxes = [...form.querySelectorAll("input[type=checkbox]")];
const search = document.getElementById("words");

// Lower case, without accents, one space between words, hyphens and minus signs alike.
const plain = (text) =>
  text.toLowerCase().normalize("NFKD").replace(/[\u0300-\u036f]/g, "").replace(/[\u2010-\u2015\u2212]/g, "-").replace(/\s+/g, " ");

const chosen = () => {
  const result = new Map();
  for (const box of boxes.filter((b) => b.checked)) result.set(box.name, [...(result.get(box.name) ?? []), box.value]);
  return result;
};

const matches = (claim, choices, words) => {
  for (const [name, values] of choices) if (!values.includes(claim.element.dataset[name])) return false;
  if (words.length === 0) return true;
  claim.words ??= plain(claim.element.textContent);
  return words.every((word) => claim.words.includes(word));
};

const hideEmpty = () => {
  for (const kind of [".group", ".document"])
    for (const section of document.querySelectorAll(kind)) section.hidden = !section.querySelector(".claim:not([hidden])");
};

const apply = () => {
  const choices = chosen();
  const words = plain(search.value).split(" ").filter(Boolean);
  let shown = 0;
  for (const claim of claims) {
    const fits = matches(claim, choices, words);
    claim.element.hidden = !fits;
    claim.element.classList.remove("linked");
    if (fits) ++shown;
  }
  hideEmpty();
  announced.textContent = `${shown} of ${claims.length} claims shown`;
};

const query = () => {
  const parts = new URLSearchParams();
  for (const [name, values] of chosen()) for (const value of values) parts.append(name, value);
  if (search.value.trim()) parts.append("q", search.value.trim());
  const text = parts.toString();
  return text ? "?" + text : "";
};

const remember = () => {
  try {
    history.replaceState(null, "", location.pathname + query() + location.hash);
  } catch {
    // some browsers refuse for local files: the filters work all the same
  }
};

const restore = () => {
  const parts = new URLSearchParams(location.search);
  for (const box of boxes) box.checked = parts.getAll(box.name).includes(box.value);
  search.value = parts.get("q") ?? "";
};

// A link shows what it leads to, whatever the filters say, and marks it.
const followLink = () => {
  const target = document.getElementById(decodeURIComponent(location.hash.slice(1)));
  if (!target) return;
  const claim = target.closest(".claim");
  const wasHidden = target.closest("[hidden]") !== null;
  for (let element = target; element; element = element.parentElement) element.hidden = false;
  if (claim) claim.classList.add("linked");
  if (wasHidden && claim) announced.textContent += `; ${claim.id} is shown because a link leads to it`;
  if (wasHidden || claim) target.scrollIntoView();
};

const copyLink = async (event) => {
  const link = event.target.closest?.(".deep");
  if (!link || event.ctrlKey || event.metaKey || event.shiftKey) return;
  try {
    await navigator.clipboard.writeText(link.href);
    announced.textContent = `Link to ${link.textContent} copied`;
  } catch {
    // without leave to copy the link still leads to the claim
  }
};

let pending = 0;
const changed = () => {
  clearTimeout(pending);
  pending = setTimeout(() => {
    apply();
    remember();
  }, 120);
};

form.hidden = false;
for (const note of document.querySelectorAll(".no-script")) note.hidden = true;
form.addEventListener("input", changed);
form.addEventListener("submit", (event) => event.preventDefault());
form.addEventListener("reset", () => setTimeout(changed));
document.addEventListener("click", copyLink);
addEventListener("hashchange", () => {
  for (const element of document.querySelectorAll(".linked")) element.classList.remove("linked");
  followLink();
});
restore();
apply();
followLink();
// On a narrow page the choices would stand before all claims.
if (!matchMedia("(min-width: 64rem)").matches && chosen().size === 0) document.getElementById("choices").open = false;
)js";
  return script;
}

}  // namespace subdiv
