# SPDX-License-Identifier: MIT
"""What a notebook shows of a mechanism: its equations, and the report with its animation."""

from __future__ import annotations

import html
import re
from typing import Any


def displayed_formulas(latex: str) -> str | None:
    """Of a LaTeX fragment the displayed formulas, each group below its heading. A notebook's MathJax sets formulas, and shows
    sections and paragraphs as their source."""
    shown, heading = [], ""
    for part in re.finditer(r"\\(?:sub)?section\*\{([^\n]*)\}|\\begin\{align\*\}.*?\\end\{align\*\}", latex, re.DOTALL):
        if part[1] is not None:
            heading = re.sub(r"\\([_&%#$])", r"\1", part[1])
            continue
        if heading:
            shown.append(f"$$\\textbf{{{heading}}}$$")
            heading = ""
        shown.append(part[0])
    return "\n".join(shown) or None


class Displayed:
    """Equations by LaTeX and the report by HTML, where the file that the mechanism was loaded from is known."""

    _source: Any = None

    def latex(self) -> str:
        """The equations of motion as LaTeX, without a document around them. Raises LookupError for a mechanism that was
        opened as a library."""
        if self._source is None:
            raise LookupError("the library alone does not hold its equations: torsor.load() the file it is made from")
        return self._source.run("equations", "--format", "latex")

    def report(self, seconds: float = 10.0) -> str:
        """The report as one HTML page: mechanism, equations, animation of the motion from the start."""
        if self._source is None:
            raise LookupError("the library alone cannot draw its mechanism: torsor.load() the file it is made from")
        return self._source.run("report", "--to", repr(float(seconds)))

    def _repr_latex_(self) -> str | None:
        try:
            return displayed_formulas(self.latex())
        except (LookupError, OSError, RuntimeError, ValueError):
            return None

    def _repr_html_(self) -> str | None:
        try:
            page = self.report()
        except (LookupError, OSError, RuntimeError, ValueError):
            return None
        return f'<iframe srcdoc="{html.escape(page)}" width="100%" height="640" style="border: 0"></iframe>'
