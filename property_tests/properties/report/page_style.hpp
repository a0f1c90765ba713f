#pragma once
/// \file
/// What all pages share: how they begin, and their look in light and dark, on paper and on a screen as narrow
/// as a phone's.

#include <string>

#include "case/escape.hpp"

namespace rayproof {

/// Colours that the colour-blind can distinguish; ink, paper, soft, claimed and exact are those of the
/// pictures (viz/picture/picture.hpp).
inline constexpr const char* page_style = R"css(
:root { color-scheme: light dark; --ink: #16181c; --paper: #fff; --soft: #5a626c; --line: #c9ced6; --panel: #f4f6f8;
        --claimed: #b84a00; --exact: #00734f; --known: #6a4a00; --bad: #a8123e; }
@media screen and (prefers-color-scheme: dark) {
  :root { --ink: #e8eaed; --paper: #16181c; --soft: #a3abb5; --line: #3a404a; --panel: #20242a;
          --claimed: #ff8f4d; --exact: #2fc99a; --known: #e8bb55; --bad: #ff7d9c; } }
* { box-sizing: border-box; }
body { margin: 0; background: var(--paper); color: var(--ink); font: 16px/1.5 system-ui, 'DejaVu Sans', sans-serif; }
main { max-width: 77.5rem; margin: 0 auto; padding: 20px 16px 40px; }
h1 { font-size: 1.5rem; line-height: 1.25; margin: 0 0 .25rem; } h2 { font-size: 1.2rem; margin: 1.5rem 0 .5rem; }
h3 { font-size: 1rem; margin: 0 0 .25rem; } p { margin: .4rem 0; } a { color: inherit; } .soft { color: var(--soft); }
.conclusion { border-left: 4px solid var(--claimed); padding: .25rem 0 .25rem 1rem; max-width: 60em; font-size: 1.1rem; }
figure { margin: 0; } figure svg { display: block; max-width: 100%; height: auto; }
.step { border: 1px solid var(--line); border-radius: 6px; padding: 12px 16px; margin: 0 0 12px; break-inside: avoid; }
.step h2 { margin-top: 0; } .step.worst { border: 2px solid var(--claimed); }
.wide { overflow-x: auto; } table { border-collapse: collapse; font-size: .875rem; font-variant-numeric: tabular-nums; }
th, td { padding: 3px 12px 3px 0; text-align: left; white-space: nowrap; vertical-align: top; } th { font-weight: normal; }
thead th { color: var(--soft); border-bottom: 1px solid var(--line); } td.lost { color: var(--claimed); font-weight: bold; }
details { margin: 12px 0; } summary { cursor: pointer; }
pre { white-space: pre-wrap; overflow-wrap: anywhere; background: var(--panel); padding: 10px 12px; border-radius: 6px;
      font-size: .8125rem; }
button { font: inherit; color: inherit; background: var(--panel); border: 1px solid var(--line); border-radius: 6px;
         padding: 4px 11px; min-width: 38px; min-height: 36px; cursor: pointer; }
button:disabled { opacity: .45; cursor: default; } :focus-visible { outline: 3px solid var(--claimed); outline-offset: 2px; }
@media print { main { max-width: none; padding: 0; } h2, h3 { break-after: avoid; } body { font-size: 11pt; } h1 { font-size: 15pt; } .screen { display: none; } }
)css";

/// What the tables of figures look like, in a check and in a report.
inline constexpr const char* figures_style = R"css(
main { max-width: 96rem; } h2 { margin-top: 2.5rem; } table { font-size: .8125rem; }
th, td { padding: .25rem .375rem; border-bottom: 1px solid var(--line); text-align: right; }
th { white-space: normal; font-weight: bold; } th:first-child, td:first-child, td.text { text-align: left; }
thead th { color: inherit; vertical-align: bottom; border-bottom: 2px solid; }
.verdict { font-weight: bold; font-size: 1.1rem; } figure svg { width: 100%; }
@media print { body { font-size: 11px; } table { font-size: 7.5px; } .wide { overflow: visible; } }
)css";

/// The page up to the end of its head, which is left open; `own_style` is what its look has beyond
/// page_style.
[[nodiscard]] inline std::string html_head(const std::string& title, const std::string& own_style) {
  return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>" +
         escaped(title) + "</title>\n<style>" + page_style + own_style + "</style>\n";
}

/// The page's end, with a script that stands beside it; empty for none.
[[nodiscard]] inline std::string html_end(const std::string& script) {
  const std::string element = script.empty() ? "" : "<script src=\"" + escaped(script) + "\"></script>\n";
  return "</main>\n" + element + "</body>\n</html>\n";
}

}  // namespace rayproof
