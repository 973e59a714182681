// SPDX-License-Identifier: MIT-0
// Formulas become typeset as they scroll into view; where KaTeX is missing, or cannot read one, the text stays.
(() => {
"use strict";
const options = { throwOnError: true, trust: false, strict: "ignore", maxExpand: 100000 };

/// On paper nothing scrolls: what would be wider than a line of A4 is set smaller there, by --on-paper in style.css. Widths are
/// compared in units of the letters', so that the width of the screen does not matter. Below half the size nobody reads: such a
/// formula stands there as its text, which breaks anywhere.
function fitToPaper(element, text) {
  const line = 674, letter = 13.6, short = 100;  // pixels of A4 between margins; KaTeX's em in print, 1.21 times 0.7 rem; characters
  const least = 0.5;
  if (element.dataset.latex.length < short) return;
  const html = element.querySelector(".katex-html"), label = element.parentElement.querySelector(".label");
  if (!html) return;
  const width = [...html.children].reduce((sum, part) => sum + part.getBoundingClientRect().width, 0) / parseFloat(getComputedStyle(html).fontSize);
  const room = (line - Math.max(24, label ? label.getBoundingClientRect().width : 0)) / letter;
  const share = Math.floor((1000 * room) / width) / 1000;
  if (share >= 1) return;
  element.style.setProperty("--on-paper", Math.max(share, least));
  if (share >= least) return;
  element.classList.add("not-on-paper");
  const plain = Object.assign(document.createElement("pre"), { className: "on-paper", textContent: text });
  element.after(plain, Object.assign(document.createElement("p"), { className: "remark on-paper", textContent: "«Too wide for a line of A4: as text.»" }));
}

function typeset(element) {
  const { latex, inline, mixed } = element.dataset;
  if (element.dataset.done) return;
  element.dataset.done = "yes";
  const text = element.textContent;
  try {
    if (latex !== undefined) {
      katex.render(latex, element, { ...options, displayMode: true });
    } else if (inline !== undefined) {
      katex.render(inline, element, options);
    } else {
      const parts = mixed.split("\u2063").map((part, i) => {
        const span = document.createElement("span");
        if (i % 2 === 0) span.textContent = part;
        else katex.render(part, span, options);
        return span;
      });
      element.replaceChildren(...parts);
    }
    if (latex !== undefined) fitToPaper(element, text);
    // What is wider than the page is scrolled, by the keyboard too.
    if (latex !== undefined && element.scrollWidth > element.clientWidth + 1) {
      element.tabIndex = 0;
      element.setAttribute("role", "group");
      element.setAttribute("aria-label", "«Formula»");
    }
  } catch (error) {
    element.textContent = text;
    element.classList.add("formula-error");
    element.title = String(error.message);
  }
}

function start() {
  const formulas = [...document.querySelectorAll("[data-latex], [data-inline], [data-mixed]")];
  for (const each of formulas) {
    if (each.dataset.latex === undefined) continue;
    const button = document.createElement("button");
    button.type = "button";
    button.className = "copy";
    button.textContent = "LaTeX";
    button.setAttribute("aria-label", "«Show the LaTeX of this formula»");
    button.addEventListener("click", () => {
      const shown = each.parentElement.querySelector("textarea");
      if (shown) return shown.remove();
      const area = document.createElement("textarea");
      area.readOnly = true;
      area.value = each.dataset.latex;
      area.rows = Math.min(12, 1 + area.value.split("\n").length + area.value.length / 90);
      area.setAttribute("aria-label", "LaTeX");
      each.after(area);
      area.select();
      if (navigator.clipboard) navigator.clipboard.writeText(area.value).catch(() => {});
    });
    each.parentElement.append(button);
  }
  if (typeof katex === "undefined") return;
  const all = () => formulas.forEach(typeset);
  torsorReport.typesetAll = all;
  window.addEventListener("beforeprint", () => {
    document.querySelectorAll("details").forEach((each) => { each.open = true; });
    all();
  });
  if (typeof IntersectionObserver === "undefined") return all();
  const observer = new IntersectionObserver((entries) => {
    for (const entry of entries) {
      if (!entry.isIntersecting) continue;
      observer.unobserve(entry.target);
      typeset(entry.target);
    }
  }, { rootMargin: "600px" });
  formulas.forEach((each) => observer.observe(each));
}

if (typeof document !== "undefined") start();
})();
