#include "experiments/report/html_page.h"

namespace subdiv {

const std::string& html_style() {
  static const std::string style = R"css(:root {
  color-scheme: light dark;
  --paper: #ffffff; --card: #f6f7f9; --ink: #1b1f24; --faint: #555d66; --line: #d3d8de; --link: #0550ae;
  --good: #116329; --good-back: #dcf5e3; --bad: #a40e26; --bad-back: #ffe5e5; --open: #7a4a00; --open-back: #fff1d1;
  --own: #4b2a99; --own-back: #eee7fd; --target: #fff7cc;
}
@media (prefers-color-scheme: dark) {
  :root {
    --paper: #14171b; --card: #1d2127; --ink: #e4e7eb; --faint: #a9b2bc; --line: #3a414a; --link: #7ab7ff;
    --good: #7ee2a0; --good-back: #12351f; --bad: #ffa3a8; --bad-back: #471a1f; --open: #f5c869; --open-back: #3d2e0c;
    --own: #c9b3ff; --own-back: #2f2350; --target: #3b3511;
  }
}
* { box-sizing: border-box; }
html { scroll-padding-top: 1rem; }
body {
  margin: 0; background: var(--paper); color: var(--ink);
  font: 1rem/1.5 system-ui, "Segoe UI", "Liberation Sans", Arial, sans-serif; overflow-wrap: anywhere;
}
header, .columns, footer { max-width: 88rem; margin: 0 auto; padding: 0 1rem; }
h1 { font-size: 1.7rem; line-height: 1.2; margin: 1.2rem 0 0.4rem; }
h2 { font-size: 1.4rem; line-height: 1.25; margin: 2.2rem 0 0.4rem; padding-top: 0.4rem; border-top: 3px solid var(--line); }
h3 { font-size: 1.12rem; margin: 1.6rem 0 0.5rem; }
h4 { font-size: 1rem; margin: 0; }
p { margin: 0.4rem 0; }
a { color: var(--link); }
a:focus-visible, button:focus-visible, input:focus-visible, main:focus-visible, [tabindex]:focus-visible {
  outline: 3px solid var(--link); outline-offset: 2px; border-radius: 3px;
}
main:focus { outline: none; }
code, q, kbd { font-family: ui-monospace, "DejaVu Sans Mono", "Liberation Mono", monospace; font-size: 0.9em; }
.skip { position: absolute; left: -100rem; }
.skip:focus { left: 1rem; top: 0.5rem; background: var(--paper); padding: 0.4rem 0.8rem; z-index: 2; }
nav ul, .contents { list-style: none; margin: 0.4rem 0; padding: 0; }
nav.pages ul { display: flex; flex-wrap: wrap; gap: 0.2rem 1.2rem; }
nav li, .contents li { padding: 0.15rem 0; }
[aria-current] { color: inherit; font-weight: 600; text-decoration: none; }
.contents { columns: 20rem; }
.count, .sections, .place, .ends { color: var(--faint); font-size: 0.9rem; }
.sections { font-weight: 400; }
fieldset { border: 1px solid var(--line); border-radius: 6px; margin: 0.6rem 0; padding: 0.2rem 0.7rem 0.5rem; min-width: 0; }
legend { font-weight: 600; padding: 0 0.3rem; }
#filters label { display: inline-block; margin-right: 0.9rem; padding: 0.15rem 0; }
input[type="search"] {
  font: inherit; width: 100%; padding: 0.3rem 0.5rem; color: var(--ink); background: var(--paper);
  border: 1px solid var(--faint); border-radius: 6px;
}
input[type="search"]::placeholder { color: var(--faint); opacity: 1; }
button {
  font: inherit; padding: 0.2rem 0.8rem; color: var(--ink); background: var(--card); border: 1px solid var(--faint);
  border-radius: 6px; cursor: pointer;
}
.result { display: flex; flex-wrap: wrap; gap: 0.5rem 1rem; align-items: baseline; }
summary { cursor: pointer; padding: 0.3rem 0; font-weight: 600; }
summary:focus-visible { outline: 3px solid var(--link); outline-offset: 2px; border-radius: 3px; }
.wide { overflow-x: auto; }
table { border-collapse: collapse; }
caption { text-align: left; color: var(--faint); padding: 0.3rem 0; }
th, td { border: 1px solid var(--line); padding: 0.25rem 0.5rem; text-align: right; overflow-wrap: normal; font-size: 0.9rem; }
th { background: var(--card); text-align: left; }
dl { margin: 0.4rem 0 0; }
dl > div { display: grid; grid-template-columns: 7.5rem minmax(0, 1fr); gap: 0 0.8rem; padding: 0.15rem 0; }
dl.words > div { grid-template-columns: 11rem minmax(0, 1fr); }
dt { color: var(--faint); }
dd { margin: 0; }
dd ul { margin: 0; padding-left: 1.1rem; }
.claim, .erratum {
  border: 1px solid var(--line); border-radius: 8px; padding: 0.6rem 0.9rem; margin: 0.7rem 0; background: var(--card);
}
.claim:target, .erratum:target, figure:target, .linked { outline: 3px solid var(--link); background: var(--target); }
.marks { display: flex; flex-wrap: wrap; gap: 0.2rem 0.5rem; align-items: baseline; margin: 0.25rem 0; }
.mark { border: 1px solid currentColor; border-radius: 1rem; padding: 0 0.6rem; font-size: 0.88rem; color: var(--faint); background: var(--paper); }
.mark.reproduced, .mark.consistent { color: var(--good); background: var(--good-back); }
.mark.refuted, .mark.inconsistent { color: var(--bad); background: var(--bad-back); font-weight: 600; }
.mark.undecided, .mark.not-reproducible { color: var(--open); background: var(--open-back); }
.mark.established, .mark.sharpened { color: var(--own); background: var(--own-back); }
.deep { font-family: ui-monospace, "DejaVu Sans Mono", "Liberation Mono", monospace; text-decoration: none; }
.deep:hover { text-decoration: underline; }
.deep::after { content: " #"; color: var(--faint); }
figure { margin: 0.6rem 0 0; background: #ffffff; color: #1b1f24; border: 1px solid var(--line); border-radius: 6px; padding: 0.4rem; }
figure a { color: #0550ae; }
figure:target { background: #fff7cc; }
img { display: block; width: 100%; height: auto; }
figcaption { font-size: 0.9rem; padding: 0.2rem 0.3rem; }
.gallery { display: grid; grid-template-columns: repeat(auto-fill, minmax(min(26rem, 100%), 1fr)); gap: 0 0.8rem; }
.notice { border-left: 4px solid var(--open); padding-left: 0.7rem; }
blockquote { margin: 0.4rem 0; padding: 0.2rem 0.8rem; border-left: 4px solid var(--line); }
pre { overflow-x: auto; margin: 0.3rem 0; }
[hidden] { display: none !important; }
footer { border-top: 1px solid var(--line); margin-top: 2rem; color: var(--faint); }
@media (min-width: 64rem) {
  .columns:has(.aside) { display: grid; grid-template-columns: 17rem minmax(0, 1fr); gap: 2rem; }
  .aside { position: sticky; top: 0; align-self: start; max-height: 100vh; overflow-y: auto; padding: 0.2rem 0.4rem 1rem 0.2rem; }
  #filters label { display: block; }
  .illustrated { display: grid; grid-template-columns: minmax(0, 1fr) minmax(0, 24rem); gap: 0 1.2rem; }
}
@media (min-width: 84rem) {
  .illustrated { grid-template-columns: minmax(0, 1fr) minmax(0, 32rem); }
}
@media (max-width: 34rem) {
  dl > div, dl.words > div { grid-template-columns: minmax(0, 1fr); padding: 0.25rem 0; }
  .claim, .erratum { padding: 0.5rem 0.6rem; }
  h1 { font-size: 1.4rem; }
}
@media print {
  @page { size: A4; margin: 18mm 15mm; }
  :root {
    --paper: #ffffff; --card: #ffffff; --ink: #000000; --faint: #444444; --line: #bbbbbb; --link: #000000;
    --good: #116329; --good-back: #ffffff; --bad: #a40e26; --bad-back: #ffffff; --open: #7a4a00; --open-back: #ffffff;
    --own: #4b2a99; --own-back: #ffffff; --target: #ffffff;
  }
  html { font-size: 9.5pt; }
  body { line-height: 1.35; }
  .aside, .skip, nav.pages { display: none; }
  .columns { display: block !important; }
  header, .columns, footer { max-width: none; padding: 0; }
  .wide { overflow: visible; }
  th, td { font-size: 8pt; padding: 0.1rem 0.3rem; white-space: normal; }
  h1, h2, h3, h4 { break-after: avoid; }
  figure, tr, dl > div { break-inside: avoid; }
  .erratum { break-inside: avoid-page; }
  .claim, .erratum { border-width: 0 0 1px; border-radius: 0; padding: 0.3rem 0; margin: 0.3rem 0; }
  .illustrated { display: block; }
  figure { max-width: 13cm; border: 0; }
  .gallery { grid-template-columns: 1fr 1fr; }
  .deep::after { content: ""; }
  pre { white-space: pre-wrap; }
}
)css";
  return style;
}

}  // namespace subdiv
