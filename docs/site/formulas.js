// Typesets the formulas, which Sphinx leaves between \( \) and \[ \].
document.addEventListener("DOMContentLoaded", () => {
  if (!window.katex) return; // a page without a formula
  for (const formula of document.querySelectorAll(".math")) renderMathInElement(formula, { throwOnError: false });
});
