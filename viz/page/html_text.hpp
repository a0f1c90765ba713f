#pragma once
/// \file
/// The fixed parts of a page: style and script.

namespace rayproof::viz {

/// Where a script runs, one step at a time; on paper all of them.
inline constexpr const char* steps_style = R"css(
main { max-width: 920px; } figure { margin: 1.5rem 0; } table { min-width: 100%; font-size: 1rem; }
th { color: var(--soft); border-bottom: 1px solid var(--line); }
nav { display: none; gap: 8px; align-items: center; margin: 12px 0; } .paged nav { display: flex; }
@media screen { .paged .step { display: none; } .paged .step.shown { display: block; } }
@media print { nav { display: none !important; } }
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
