#pragma once
/// \file
/// The fixed parts of a page: style and script.

namespace rayproof::viz {

/// Light and dark, on paper and on a screen as narrow as a phone's.
inline constexpr const char* page_style = R"css(
:root{--page:#fff;--ink:#16181c;--soft:#5a626c;--line:#d5d9de;--mark:#b84a00;--tint:#f4f6f8;color-scheme:light dark}
@media screen and (prefers-color-scheme:dark){:root{--page:#16181c;--ink:#e8eaed;--soft:#a3abb5;--line:#3a404a;--mark:#ff8f4d;--tint:#20242a}}
body{margin:0;background:var(--page);color:var(--ink);font:16px/1.5 system-ui,'DejaVu Sans',sans-serif}
main{max-width:920px;margin:0 auto;padding:24px 16px}
h1{font-size:1.5rem;margin:0 0 .25rem}h2{font-size:1.15rem;margin:0 0 .25rem}
.soft{color:var(--soft)}.conclusion{border-left:4px solid var(--mark);padding:.25rem 0 .25rem 1rem;font-size:1.1rem}
figure{margin:1.5rem 0}figure svg{display:block;max-width:100%;height:auto}
.step{border:1px solid var(--line);border-radius:6px;padding:12px 16px;margin:12px 0;break-inside:avoid}
.step.worst{border-color:var(--mark);border-width:2px}
.wide{overflow-x:auto}table{border-collapse:collapse;font-variant-numeric:tabular-nums;min-width:100%}
th,td{text-align:left;padding:3px 14px 3px 0;white-space:nowrap}th{color:var(--soft);font-weight:normal;border-bottom:1px solid var(--line)}
td.lost{color:var(--mark);font-weight:bold}
nav{display:none;gap:8px;align-items:center}.paged nav{display:flex}
button{font:inherit;color:inherit;background:var(--tint);border:1px solid var(--line);border-radius:6px;padding:4px 14px;cursor:pointer}
button:disabled{opacity:.45;cursor:default}:focus-visible{outline:3px solid var(--mark);outline-offset:2px}
@media screen{.paged .step{display:none}.paged .step.shown{display:block}}
@media print{nav{display:none!important}}
pre{white-space:pre-wrap;overflow-wrap:anywhere;background:var(--tint);padding:12px;border-radius:6px}
)css";

/// Shows one step at a time: buttons, arrow keys, Home and End. Without it, and on paper, all steps are
/// there.
inline constexpr const char* page_script = R"js(
(() => {
  const all = [...document.querySelectorAll('.step')], walk = document.getElementById('walk');
  if (all.length < 2) return;
  const [first, back, next, every] = walk.querySelectorAll('button'), place = document.getElementById('place');
  let at = Math.max(0, all.findIndex(step => step.classList.contains('worst')));
  const show = to => {
    at = Math.min(Math.max(to, 0), all.length - 1);
    all.forEach((step, i) => step.classList.toggle('shown', i === at));
    place.textContent = `${at + 1} of ${all.length}`;
    first.disabled = back.disabled = at === 0;
    next.disabled = at === all.length - 1;
  };
  first.onclick = () => show(0);
  back.onclick = () => show(at - 1);
  next.onclick = () => show(at + 1);
  every.onclick = () => {
    const open = walk.classList.toggle('open');
    all.forEach(step => step.style.display = open ? 'block' : '');
    every.textContent = open ? 'One at a time' : 'All steps';
  };
  document.addEventListener('keydown', event => {
    if (event.altKey || event.ctrlKey || event.metaKey) return;
    const to = {ArrowLeft: at - 1, ArrowRight: at + 1, Home: 0, End: all.length - 1}[event.key];
    if (to !== undefined) { show(to); event.preventDefault(); }
  });
  walk.classList.add('paged');
  show(at);
})();
)js";

}  // namespace rayproof::viz
