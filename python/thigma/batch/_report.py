"""The report page: HTML with its plots inside."""

from __future__ import annotations

import html
import io
import pathlib
from typing import Any, Callable

import numpy as np

from ._store import DONE, Row, Store, canonical, library

_STYLE = """
body{font:15px/1.45 system-ui,sans-serif;max-width:64rem;margin:2rem auto;padding:0 1rem;color:#222}
table{border-collapse:collapse;margin:1rem 0}td,th{padding:.2rem .7rem;border-bottom:1px solid #ddd;
text-align:left}td.n{text-align:right;font-variant-numeric:tabular-nums}.bad{color:#a40000}
div{overflow-x:auto}svg{max-width:100%;height:auto}@media(prefers-color-scheme:dark){body{background:#16181c;color:#ddd}
td,th{border-color:#444}.bad{color:#ff8a80}figure{background:#fff}}
"""


def _cell(value: Any) -> str:
    if isinstance(value, bool) or value is None:
        return f"<td>{'' if value is None else value}</td>"
    if isinstance(value, (int, float)):
        return f"<td class=n>{value:,}</td>" if isinstance(value, int) else f"<td class=n>{value:.4g}</td>"
    return f"<td>{html.escape(str(value))}</td>"


def _table(names: list[str], rows: list[list[Any]]) -> str:
    head = "".join(f"<th>{html.escape(name)}</th>" for name in names)
    body = "".join(f"<tr>{''.join(map(_cell, row))}</tr>\n" for row in rows)
    return f"<div><table><tr>{head}</tr>\n{body}</table></div>\n"


def _plot(draw: Callable[[Any], None]) -> str:
    """An SVG, or a line that says why not."""
    try:
        import matplotlib
        from matplotlib.figure import Figure
    except ImportError:
        return "<p>No plot: matplotlib is not installed.</p>\n"
    with matplotlib.rc_context({"svg.hashsalt": "thigma", "svg.fonttype": "none"}):
        figure = Figure(figsize=(8, 3.2), layout="constrained")
        draw(figure.add_subplot())
        text = io.StringIO()
        figure.savefig(text, format="svg", metadata={"Date": None})
    svg = text.getvalue()
    return f"<figure>{svg[svg.index('<svg') :]}</figure>\n"


def _set_of(row: Row) -> dict[str, Any]:
    p = row["parameters"]
    shown = {**p.get("set", {}), **{k: p[k] for k in ("device", "delay", "seed") if k in p}}
    return {k: v for k, v in shown.items() if v is not None and v != ""}


_CHUNK = ("first", "count", "chunk")
"""Parameters of a row that say which part of a piece of work it is."""


def _others_of(row: Row) -> dict[str, Any]:
    """What else decides a row: parameters that _set_of leaves out, inputs, library."""
    p = {k: v for k, v in row["parameters"].items() if k not in ("against", "set", *_CHUNK)}
    inputs = {role: digest[:8] for role, digest in row["inputs"].items()}
    others = {**p, **inputs, "library": row["library"]}
    return {k: v for k, v in others.items() if k not in _set_of(row)}


def _mark(rows: list[Row]) -> None:
    """Gives each row what tells it apart from others of its kind and part, under "mark"."""
    values: dict[tuple[str, str, str], set[str]] = {}
    for row in rows:
        for name, value in _others_of(row).items():
            values.setdefault((row["kind"], row["part"], name), set()).add(canonical(value))
    for row in rows:
        row["mark"] = {
            name: value
            for name, value in _others_of(row).items()
            if len(values[row["kind"], row["part"], name]) > 1
        }


def _said(row: Row) -> str:
    return ", ".join(f"{k} {v}" for k, v in {**_set_of(row), **row["mark"]}.items())


def _pieces(rows: list[Row]) -> list[list[Row]]:
    """Rows of one piece of work each: the same but for their chunks, which do not overlap."""
    found: dict[str, list[list[Row]]] = {}
    for row in sorted(rows, key=lambda r: [r["parameters"][n] for n in ("first", "count")]):
        p = {k: v for k, v in row["parameters"].items() if k not in _CHUNK}
        same = found.setdefault(canonical([row["part"], p, row["inputs"], row["library"]]), [])
        for piece in same:
            last = piece[-1]["parameters"]
            if last["first"] + last["count"] <= row["parameters"]["first"]:
                piece.append(row)
                break
        else:
            same.append([row])
    pieces = [piece for same in found.values() for piece in same]
    return sorted(pieces, key=lambda piece: (piece[0]["part"], _said(piece[0])))


def _label(text: str) -> str:
    """For a plot, where "$" begins a formula and "_" hides an entry."""
    plain = text.replace("$", r"\$")
    return f" {plain}" if plain.startswith("_") else plain


def _assets(rows: list[Row], _store: Store) -> str:
    def draw(axes: Any) -> None:
        values = [row["values"] for row in rows]
        axes.loglog([v["triangles"] for v in values], [v["bytes"] / 1e6 for v in values], "o")
        axes.set(xlabel="triangles", ylabel="size of the .clod file [MB]")

    names = ["triangles", "radius_m", "levels", "coarsest_triangles", "deviation_max_m", "bytes"]
    table = [
        [r["part"], _said(r), *(r["values"][n] for n in names), len(r["values"]["repairs"])]
        for r in rows
    ]
    return _plot(draw) + _table(["part", "of", *names, "repairs"], table)


def _contacts(rows: list[Row], store: Store) -> str:
    distances: list[tuple[str, Any]] = []
    table = []
    for chunks in _pieces(rows):
        part, said = chunks[0]["part"], _said(chunks[0])
        against = chunks[0]["parameters"]["against"]
        held = []
        for row in chunks:
            with np.load(store.file_path(row["key"], "npz")) as arrays:
                held.append(arrays["distance"])
        distance = np.concatenate(held)
        name = ", ".join(filter(None, (f"{part} on {against}", said)))
        distances.append((name, distance[np.isfinite(distance)]))
        values = [row["values"] for row in chunks]
        sums = [sum(v[n] for v in values) for n in ("poses", "near", "overlapping", "contacts")]
        least = min((v["least_m"] for v in values if v["least_m"] is not None), default=None)
        table.append([part, against, said, *sums, least, max(v["bound_max_m"] for v in values)])

    def draw(axes: Any) -> None:
        for name, distance in distances[:8]:
            if len(distance):
                axes.hist(1e3 * distance, bins=60, histtype="step", label=_label(name))
        axes.set(xlabel="least distance [mm]", ylabel="poses")
        if axes.has_data():
            axes.legend(fontsize=7)

    names = ["part", "against", "of", "poses", "near", "overlapping", "contacts", "least [m]", "bound [m]"]
    return _plot(draw) + _table(names, table)


def _axis(rows: list[Row]) -> str:
    """The parameter with the most values."""
    values: dict[str, set[str]] = {}
    for row in rows:
        for name, value in _set_of(row).items():
            values.setdefault(name, set()).add(str(value))
    return max(values, key=lambda name: len(values[name]), default="")


def _curves(rows: list[Row], value: str, label: str) -> str:
    axis = _axis(rows)
    curves: dict[str, list[tuple[Any, float]]] = {}
    for row in rows:
        shown = {**_set_of(row), **row["mark"]}
        x = shown.pop(axis, 0)
        name = ", ".join([row["part"], *(f"{k} {v}" for k, v in shown.items())])
        curves.setdefault(name, []).append((x, row["values"][value]))

    def draw(axes: Any) -> None:
        for name, points in list(curves.items())[:12]:
            is_text = not all(isinstance(x, (int, float)) for x, _ in points)
            points.sort(key=lambda point: str(point[0]) if is_text else point[0])
            x = [_label(str(x)) if is_text else x for x, _ in points]
            axes.plot(x, [y for _, y in points], "o-", label=_label(name))
        axes.set(xlabel=_label(axis), ylabel=label)
        if axes.has_data():
            axes.legend(fontsize=7)

    return _plot(draw)


def _gains(rows: list[Row], _store: Store) -> str:
    names = ["linear_stiffness", "linear_damping", "linear_binds", "angular_stiffness"]
    names += ["contact_stiffness", "max_force_N"]
    table = [[r["part"], _said(r), *(r["values"][n] for n in names)] for r in rows]
    plot = _curves(rows, "linear_stiffness", "linear stiffness [N/m]")
    return plot + _table(["scene", "of", *names], table)


def _sweep(rows: list[Row], _store: Store) -> str:
    names = ["end", "force_max_N", "force_jitter_N", "penetration_max_m", "energy_min_J"]
    table = [[r["part"], _said(r), *(r["values"][n] for n in names)] for r in rows]
    plots = _curves(rows, "force_max_N", "largest force [N]")
    plots += _curves(rows, "force_jitter_N", "change of force in 10 frames [N]")
    return plots + _table(["scene", "of", *names], table)


def _throws(rows: list[Row], store: Store) -> str:
    speed, force = [], []
    for row in rows:
        with np.load(store.file_path(row["key"], "npz")) as arrays:
            speed.append(arrays["speed"])
            force.append(arrays["force"])
    table = []
    for chunks in _pieces(rows):
        values = [row["values"] for row in chunks]
        sums = (sum(v[n] for v in values) for n in ("throws", "entered", "faults"))
        most = (max(v[n] for v in values) for n in ("penetration_max_m", "force_max_N"))
        table.append([chunks[0]["part"], _said(chunks[0]), *sums, *most])

    def draw(axes: Any) -> None:
        axes.plot(np.concatenate(speed), np.concatenate(force), ".")
        axes.set(xlabel="speed [m/s]", ylabel="largest force [N]")

    names = ["scene", "of", "throws", "entered", "faults", "penetration_max_m", "force_max_N"]
    return _plot(draw) + _table(names, table)


_SECTIONS: dict[str, tuple[str, Callable[[list[Row], Store], str]]] = {
    "assets": ("Levels of detail", _assets),
    "contacts": ("Contacts", _contacts),
    "gains": ("Gains", _gains),
    "sweep": ("Sessions", _sweep),
    "throws": ("Throws", _throws),
}


def _runs(store: Store) -> str:
    table = []
    for run in store.runs():
        work = sum(task["seconds"] for task in run["tasks"])
        rate = len(run["tasks"]) / run["seconds"] if run["seconds"] else 0.0
        table.append(
            [run["begin"], run["workers"], len(run["tasks"]), run["seconds"], work, rate]
        )
    names = ["begin (UTC)", "workers", "rows", "time [s]", "work [s]", "rows a second"]
    return "<h2>Runs</h2>\n" + _table(names, table)


def write_report(store: Store) -> pathlib.Path:
    """Writes report.html of all rows of a folder; its path."""
    rows = store.rows()
    _mark(rows)
    bad = [row for row in rows if row["status"] != DONE]
    text = [
        "<!doctype html><html lang=en><meta charset=utf-8><title>Thigma batch</title>",
        '<meta name="viewport" content="width=device-width">',
        f"<style>{_STYLE}</style>\n<h1>Thigma batch</h1>\n",
        f"<p>{len(rows)} rows, {len(rows) - len(bad)} good, {len(bad)} not. ",
        f"Library {html.escape(', '.join(sorted({row['library'] for row in rows} or {library()})))}.",
        "</p>\n",
    ]
    if bad:
        table = [[r["kind"], r["part"], _said(r), r["status"], r["reason"]] for r in bad]
        text.append("<h2 class=bad>What is not good</h2>\n")
        text.append(_table(["kind", "part", "of", "status", "reason"], table))
    for kind, (title, section) in _SECTIONS.items():
        good = [row for row in rows if row["kind"] == kind and row["status"] == DONE]
        if good:
            text.append(f"<h2>{title}</h2>\n{section(good, store)}")
    text.append(_runs(store))
    target = store.folder / "report.html"
    with store.writing(target) as path:
        path.write_text("".join(text), "utf-8")
    return target
