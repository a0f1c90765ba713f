#pragma once
/// \file
/// What the look of a stage's page has beyond that of all pages.

namespace rayproof::viz {

inline constexpr const char* stage_style = R"css(
.lesson { font-size: 1.05rem; max-width: 60em; }
#walk { margin: 14px 0; } #scene { display: block; width: 100%; height: auto; border: 1px solid var(--line); border-radius: 6px;
  touch-action: none; cursor: grab; user-select: none; }
#scene:active { cursor: grabbing; } .flat #scene { cursor: default; touch-action: auto; }
#live-part { display: none; } .live #live-part { display: block; }
.live #walk { display: grid; grid-template-columns: minmax(0, 11fr) minmax(0, 9fr); gap: 8px 24px; align-items: start; }
.bar { display: flex; flex-wrap: wrap; gap: 6px; align-items: center; margin: 0 0 8px; }
button[aria-current=step] { border: 2px solid var(--ink); font-weight: bold; background: var(--paper); }
#steps { display: contents; } #place { position: absolute; width: 1px; height: 1px; overflow: hidden; clip-path: inset(50%); }
#magnified { font-size: .8125rem; min-height: 1.3em; margin: 2px 0 8px; }
.slide { display: grid; grid-template-columns: minmax(0, 1fr) auto; gap: 4px 14px; align-items: center; }
.slide input { width: 100%; min-height: 32px; accent-color: var(--claimed); }
.slide output { font-weight: bold; font-variant-numeric: tabular-nums; min-width: 9em; }
.step figure { margin: 0 0 8px; max-width: 640px; } .step figure svg { width: 100%; }
.equation { margin: .5rem 0; line-height: 1.9; } math { font-size: 1.12em; }
.equation span { display: inline-block; max-width: 100%; overflow-wrap: anywhere; overflow-x: auto; overflow-y: hidden;
  vertical-align: middle; }
tbody th { font-weight: bold; } #live td { white-space: normal; } .claimed { color: var(--claimed); } .exact { color: var(--exact); }
.legend { display: flex; flex-wrap: wrap; gap: 4px 18px; list-style: none; margin: 8px 0; padding: 0; font-size: .8125rem;
  color: var(--soft); } .legend li { display: flex; gap: 6px; align-items: center; }
kbd { border: 1px solid var(--line); border-radius: 4px; padding: 0 5px; font: inherit; font-size: .8125rem; }
.gallery { display: grid; grid-template-columns: repeat(auto-fill, minmax(17rem, 1fr)); gap: 16px; list-style: none; padding: 0; }
.gallery a { display: block; text-decoration: none; border: 1px solid var(--line); border-radius: 6px; padding: 10px; height: 100%; }
.gallery a:hover b, .gallery a:focus-visible b { text-decoration: underline; }
.gallery svg { display: block; width: 100%; height: auto; margin-bottom: 8px; }
@media screen { .live .step { display: none; margin: 0; } .live .step.shown { display: block; } .live .step figure { display: none; } }
@media screen and (max-width: 30rem) { math { font-size: .92em; } }
@media screen and (max-width: 72rem) { .readings thead { position: absolute; clip-path: inset(50%); }
  #live th, #live td { display: block; white-space: normal; overflow-wrap: anywhere; padding: 1px 0; } #live td:empty { display: none; }
  #live td::before { content: attr(data-of) ' '; color: var(--soft); } }
@media screen and (max-width: 52rem) { .live #walk { grid-template-columns: minmax(0, 1fr); } h1 { font-size: 1.25rem; }
  main { padding: 12px 12px 32px; } }
@media print { .live #walk { display: block; } .live #live-part { display: none; } .step { border-color: #999; } }
)css";

}  // namespace rayproof::viz
