# SPDX-License-Identifier: BSD-3-Clause
"""Tables in Markdown, and numbers with as many digits as are worth reading."""


def _row(cells):
    return "| " + " | ".join(cells) + " |\n"


def table(header, rows):
    """A table whose first column is text and whose others are numbers; short rows are filled."""
    header = list(header)
    rule = "|---|" + "---:|" * (len(header) - 1) + "\n"
    filled = (list(row) + [""] * (len(header) - len(row)) for row in rows)
    return _row(header) + rule + "".join(_row(row) for row in filled) + "\n"


def milliseconds(value):
    digits = 0 if value >= 100 else 1 if value >= 10 else 2 if value >= 1 else 3
    return f"{value:.{digits}f}"


def percent(value):
    return f"{value:.{1 if value >= 10 else 2 if value >= 1 else 3}f}"


def times(value):
    return f"{value:.2f}"


def mebibytes(value):
    return f"{value / 1048576:.1f}"
