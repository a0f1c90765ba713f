#pragma once

namespace rayproof {

/// The page's look. Marks differ in sign and border as well as in colour, and the colour-blind can
/// distinguish the colours.
inline constexpr const char* page_style = R"css(
:root { color-scheme: light dark; --ink: #1a1a1a; --paper: #ffffff; --faint: #6b6b6b; --line: #d0d0d0; --panel: #f5f5f3;
        --good: #00664c; --known: #6a4a00; --bad: #a8123e; }
@media (prefers-color-scheme: dark) {
  :root { --ink: #e8e8e6; --paper: #161618; --faint: #a0a0a0; --line: #3a3a3e; --panel: #202024;
          --good: #5fd3ae; --known: #e8bb55; --bad: #ff7d9c; } }
body { font: 16px/1.5 system-ui, sans-serif; color: var(--ink); background: var(--paper); margin: 0 auto; max-width: 96rem;
       padding: 1.5rem; }
h1 { font-size: 1.6rem; margin: 0 0 .25rem; } h2 { font-size: 1.25rem; margin: 2.5rem 0 .75rem; }
h3 { font-size: 1rem; margin: 0 0 .25rem; }
p { margin: .25rem 0; } .faint { color: var(--faint); } .wide { overflow-x: auto; }
table { border-collapse: collapse; font-size: .8125rem; font-variant-numeric: tabular-nums; }
th, td { padding: .25rem .375rem; border-bottom: 1px solid var(--line); text-align: right; white-space: nowrap; }
th { white-space: normal; }
th:first-child, td:first-child, td.text { text-align: left; } td.mark { text-align: center; font-weight: 600; }
thead th { vertical-align: bottom; border-bottom: 2px solid var(--ink); }
.holds { color: var(--good); } .refuted { color: var(--known); } .broken { color: var(--bad); }
.mark.refuted { outline: 1px dashed; outline-offset: -4px; } .mark.broken { outline: 2px solid; outline-offset: -3px; }
p.legend { font-size: .875rem; } p.legend span { display: inline-block; min-width: 1.6em; text-align: center; }
.verdict { font-weight: 600; font-size: 1.1rem; }
article { border: 1px solid var(--line); border-radius: 6px; padding: 1rem; margin: 0 0 1rem; break-inside: avoid;
          display: grid; grid-template-columns: minmax(0, 3fr) minmax(0, 2fr); gap: 1rem 1.5rem; }
article.declared { border-style: dashed; }
.number { border: 1px solid; border-radius: 4px; padding: 0 .35em; margin-right: .25em; } p.words { font-size: 1.0625rem; }
dl.words { display: grid; grid-template-columns: max-content 1fr; gap: .25rem 1rem; max-width: 64rem; }
dl.words dt { font-weight: 600; color: inherit; } dl.words dd { margin: 0; }
@media (max-width: 48rem) { dl.words { grid-template-columns: 1fr; } }
figure { margin: 0; } figure svg { width: 100%; height: auto; display: block; }
pre { background: var(--panel); padding: .6rem .75rem; margin: .4rem 0; overflow-x: auto; font-size: .8rem; line-height: 1.4;
      white-space: pre-wrap; overflow-wrap: anywhere; border-radius: 4px; }
dl { margin: .5rem 0 0; font-size: .875rem; } dt { color: var(--faint); } dd { margin: 0 0 .4rem; overflow-wrap: anywhere; }
details summary { cursor: pointer; }
@media (max-width: 48rem) { article { grid-template-columns: minmax(0, 1fr); } }
@media print { body { max-width: none; padding: 0; font-size: 11px; } table { font-size: 7.5px; } details { display: block; } .wide { overflow: visible; } }
)css";

}  // namespace rayproof
