#pragma once
/// \file
/// The look of a stage's page: light and dark, on paper, and on a screen as narrow as a phone's.

namespace rayproof::viz {

inline constexpr const char* stage_style = R"css(
:root{--page:#fff;--ink:#16181c;--soft:#5a626c;--line:#c9ced6;--mark:#b84a00;--good:#00734f;--tint:#f4f6f8;color-scheme:light dark}
@media screen and (prefers-color-scheme:dark){:root{--page:#16181c;--ink:#e8eaed;--soft:#a3abb5;--line:#3a404a;--mark:#ff8f4d;--good:#2fc99a;--tint:#20242a}}
*{box-sizing:border-box}body{margin:0;background:var(--page);color:var(--ink);font:16px/1.5 'DejaVu Sans',system-ui,sans-serif}
main{max-width:1240px;margin:0 auto;padding:20px 16px 40px}
h1{font-size:1.5rem;line-height:1.25;margin:0 0 .25rem}h2{font-size:1.15rem;margin:0 0 .5rem}p{margin:.4rem 0}
.soft{color:var(--soft)}a{color:inherit}.lesson{font-size:1.05rem;max-width:60em}
.conclusion{border-left:4px solid var(--mark);padding:.25rem 0 .25rem 1rem;max-width:60em}
#walk{margin:14px 0}#scene{display:block;width:100%;height:auto;border:1px solid var(--line);border-radius:6px;touch-action:none;cursor:grab;user-select:none}
#scene:active{cursor:grabbing}.flat #scene{cursor:default;touch-action:auto}
#live-part{display:none}
.live #walk{display:grid;grid-template-columns:minmax(0,11fr) minmax(0,9fr);gap:8px 24px;align-items:start}.live #live-part{display:block}
.bar{display:flex;flex-wrap:wrap;gap:6px;align-items:center;margin:0 0 8px}
button{font:inherit;color:inherit;background:var(--tint);border:1px solid var(--line);border-radius:6px;padding:4px 11px;min-width:38px;min-height:36px;cursor:pointer}
button[aria-current=step]{border:2px solid var(--ink);font-weight:bold;background:var(--page)}
button:disabled{opacity:.45;cursor:default}:focus-visible{outline:3px solid var(--mark);outline-offset:2px}
#steps{display:contents}#place{position:absolute;width:1px;height:1px;overflow:hidden;clip-path:inset(50%)}
#magnified{font-size:.8125rem;min-height:1.3em;margin:2px 0 8px}
.slide{display:grid;grid-template-columns:minmax(0,1fr) auto;gap:4px 14px;align-items:center}.slide input{width:100%;min-height:32px;accent-color:var(--mark)}
.slide output{font-weight:bold;font-variant-numeric:tabular-nums;min-width:9em}
.step{border:1px solid var(--line);border-radius:6px;padding:12px 16px;margin:0 0 12px;break-inside:avoid}
.step figure{margin:0 0 8px;max-width:640px}.step figure svg{display:block;width:100%;height:auto}
.equation{margin:.5rem 0;line-height:1.9}.equation span{display:inline-block;max-width:100%;overflow-wrap:anywhere;overflow-x:auto;overflow-y:hidden;vertical-align:middle}math{font-size:1.12em}
.wide{overflow-x:auto}table{border-collapse:collapse;font-variant-numeric:tabular-nums;font-size:.875rem}
th,td{text-align:left;padding:3px 10px 3px 0;white-space:nowrap;font-weight:normal;vertical-align:top}thead th{color:var(--soft);border-bottom:1px solid var(--line)}
tbody th{font-weight:bold}td.lost{color:var(--mark);font-weight:bold}.claimed{color:var(--mark)}.exact{color:var(--good)}
.legend{display:flex;flex-wrap:wrap;gap:4px 18px;list-style:none;margin:8px 0;padding:0;font-size:.8125rem;color:var(--soft)}.legend li{display:flex;gap:6px;align-items:center}
details{margin:12px 0}summary{cursor:pointer}pre{white-space:pre-wrap;overflow-wrap:anywhere;background:var(--tint);padding:10px;border-radius:6px;font-size:.8125rem}
kbd{border:1px solid var(--line);border-radius:4px;padding:0 5px;font:inherit;font-size:.8125rem}
@media screen{.live .step{display:none;margin:0}.live .step.shown{display:block}.live .step figure{display:none}}
@media screen and (max-width:30rem){math{font-size:.92em}}
@media screen and (max-width:72rem){.readings thead{position:absolute;clip-path:inset(50%)}#live th,#live td{display:block;white-space:normal;overflow-wrap:anywhere;padding:1px 0}#live td:empty{display:none}#live td::before{content:attr(data-of) ' ';color:var(--soft)}}
@media screen and (max-width:52rem){.live #walk{grid-template-columns:minmax(0,1fr)}h1{font-size:1.25rem}main{padding:12px 12px 32px}}
@media print{.live #walk{display:block}.live #live-part,.screen{display:none!important}main{max-width:none;padding:0}body{font-size:11pt}.step{border-color:#999}h1{font-size:15pt}}
.gallery{display:grid;grid-template-columns:repeat(auto-fill,minmax(17rem,1fr));gap:16px;list-style:none;padding:0}.gallery a{display:block;text-decoration:none;border:1px solid var(--line);border-radius:6px;padding:10px;height:100%}
.gallery a:hover b,.gallery a:focus-visible b{text-decoration:underline}.gallery svg{display:block;width:100%;height:auto;margin-bottom:8px}
)css";

}  // namespace rayproof::viz
