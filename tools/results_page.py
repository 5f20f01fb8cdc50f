"""docs/results.md from what scripts/results measured: plain formatting, nothing is measured or judged here."""

TITLES = {  # of measurements, in the page's order
    "haptic-step": "Haptic step",
    "row-solve": "Constraint rows",
    "convex-pair": "Convex pairs",
    "front": "Front tracking",
    "exact-query": "Exact query of two jaws",
    "levels": "Contact queries",
    "spoon-drop": "Simulation",
    "texture": "Textures",
    "worlds": "Worlds",
    "growth": "Worlds that grow",
    "build": "Building",
}


def three(x):
    """Three digits."""
    if x is None:
        return ""
    if x == 0 or abs(x) >= 99.95:
        return f"{x:,.0f}"
    if abs(x) >= 9.995:
        return f"{x:.1f}"
    return f"{x:.2f}" if abs(x) >= 0.0995 else f"{x:.2g}"


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    return lines + ["| " + " | ".join(row) + " |" for row in rows] + [""]


def accuracy(row):
    words = []
    for key, word in (("recall", "recall"), ("error", "separation off by at most")):
        ours, theirs = row[f"{key}_ours"], row[f"{key}_baseline"]
        if ours is None:
            continue
        shown = three(ours) if key == "recall" else f"{three(100 * ours)} %"
        if theirs is not None:
            shown += f" (baseline {three(theirs) if key == 'recall' else three(100 * theirs) + ' %'})"
        words.append(f"{word} {shown}")
    return ", ".join(words)


def time_of(figure):
    tail = [three(figure[k]) for k in ("p50", "p99", "p999", "max") if figure.get(k) is not None]
    return " / ".join(tail)


def instructions_of(row, data):
    pair, _, way = row["name"].partition(", ")
    found = data["queries"]["pairs"].get(pair, {}).get(way)
    return three(1e-3 * found["instructions"]) if found else ""


def bench_section(rows, data):
    has_counts = any(instructions_of(row, data) for row in rows)
    has_accuracy = any(accuracy(row) for row in rows)
    head = ["measured", "p50 / p99 / p99.9 / max"]
    has_notes = not has_accuracy and any(row.get("note") for row in rows)
    head += ["k instructions"] * has_counts + ["accuracy"] * has_accuracy + ["baseline, p50 / p99", "times ours"]
    head += ["note"] * has_notes
    lines = []
    for row in rows:
        baseline = row["baseline"]
        cells = [row["name"], f"{time_of(row['ours'])} {row['unit']}"]
        cells += [instructions_of(row, data)] * has_counts + [accuracy(row)] * has_accuracy
        cells += [f"{baseline['name']}: {three(baseline['p50'])} / {three(baseline['p99'])}" if baseline else "",
                  three(row["ratio"]) if row["ratio"] else ""]
        cells += [row.get("note", "")] * has_notes
        lines.append(cells)
    return table(head, lines)


def called(names, data):
    """A sentence of the instructions of what these measurements time."""
    functions = data["calls"]["functions"]
    found = [(name, functions[name]) for name in sorted(names) if functions.get(name)]
    return [f"Instructions a call, mean of {count:,} calls of `{name}`'s quick run: {cost:,.0f}." for name, (cost, count) in found] + [""] * bool(found)


def quality_section(queries):
    rows = []
    for pair, ways in queries.items():
        for way, found in ways.items():
            rows.append([pair, way, three(1e-3 * found["instructions"]), three(found["contacts"]), f"{found['force_error']:.3f}",
                         f"{found['force_step']:.3f}", f"{100 * found['separation_error']:.4f}"])
    head = ["pair", "way", "k instructions a query", "contacts", "force error", "force step", "least separation off [% of the radius]"]
    return table(head, rows)


PROXY_HEAD = ["scene", "way", "p50 / p99 / p99.9 / max [us]", "of the shell's p50, p99", "contacts", "recall",
              "least separation off by at most [% of the radius]", "force error", "entered [% of the radius]"]


def percent(x):
    return "" if x is None else three(100 * x)


def proxy_row(scene, way, figure, shell, contacts, row, whose):
    times = [f"{three(figure[k] / shell[k])}" for k in ("p50", "p99")]
    recall, force = row[f"recall_{whose}"], row[f"force_error_{whose}"]
    return [scene, way, time_of(figure), ", ".join(times), three(contacts), "" if recall is None else three(recall), percent(row[f"error_{whose}"]),
            "" if force is None else f"{force:.4f}", percent(row[f"entered_{whose}"])]


def proxy_section(rows):
    """A row a way, and the shell's own before those of its scene."""
    lines, notes = [], []
    for row in rows:
        scene, _, way = row["name"].partition(", ")
        shell = row["baseline"]
        if not lines or lines[-1][0] != scene:
            lines.append(proxy_row(scene, shell["name"], shell, shell, row["contacts_baseline"], row, "baseline"))
            notes.append(f"{scene}: {row['note']}.")
        lines.append(proxy_row(scene, way, row["ours"], shell, row["contacts_ours"], row, "ours"))
    return [*table(PROXY_HEAD, lines), *notes, ""]


def session_section(sessions):
    rows = []
    for scene, s in sessions.items():
        query, step = s["contact"]["query_cpu_us"], s["haptic"]["step_cpu_us"]
        law = "clusters of springs" if s["constraint"] is None else "rows: the object stays outside"
        rows.append([scene, law, f"{three(query['p50'])} / {three(query['p99'])}", f"{three(step['p50'])} / {three(step['p99'])}",
                     three(s["contact"]["contacts_mean"]), f"{1e3 * s['penetration_max']:.4f}", three(s["force"]["max"]),
                     f"{1e6 * s['energy_min']:.2f}"])
    head = ["scene", "contact", "query [us], p50 / p99", "haptic step [us], p50 / p99", "contacts, mean", "deepest [mm]", "largest force [N]", "least energy [uJ]"]
    return table(head, rows)


def made(part):
    return f"({part['date']}, commit {part['commit']}.)"


def introduction(data):
    bench = data["bench"]
    machine, late = bench["machine"], bench["machine"]["empty_loop_late_us"]
    return [
        "# Measured", "",
        "Made by `scripts/results`, which measures all of it again; not edited by hand. What was measured before, with what was tried and why,",
        "is the journal: [results](journal/results.md), [contact queries](journal/contact_query.md). What each experiment claims: [claims](claims.md).", "",
        f"{bench['date']}, commit {bench['commit']}. {bench['processor']}, two shared processors; g++ -O3 for plain x86-64. No haptic device: untested on hardware.",
        f"The machine: dependent additions at {machine['dependent_adds_ghz']:.2f} GHz; an empty 1 kHz loop was late by p50 {three(late['p50'])},"
        f" p99 {three(late['p99'])}, p99.9 {three(late['p999'])}, largest {three(late['max'])} us.", "",
        "Times are CPU time of one thread. Instructions are counted by callgrind: no other job on the machine changes them. A baseline does the same work on the",
        "same poses, in the same run; *times ours* is its median over ours, so above 1 ours is faster.", "",
    ]


def page(data):
    lines = introduction(data)
    sections = {}
    for row in data["bench"]["rows"]:
        name = next((key for key in TITLES if row["measurement"].startswith(key)), row["measurement"])
        sections.setdefault(name, []).append(row)
    for name in [*TITLES, *(n for n in sections if n not in TITLES)]:
        if name not in sections:
            continue
        lines += [f"## {TITLES.get(name, name)}", ""]
        lines += called({row["measurement"] for row in sections[name]}, data)
        lines += bench_section(sections[name], data)
    lines += [
        "## Contact queries of a constrained object", "",
        "The path that the object takes in 4 s (2 s of ball_joint and conforming) of a lockstep session in the simulated hand (comes down, presses, slides, twists,",
        "taps, lifts), kept outside by rows: what its contact frames asked, asked again, best of three by turns. The point shell gets the same poses and the tolerance",
        "that the exact query answered; like the query alone it makes no rows. Recall and error against fresh exact queries on 80 of the frames (10 of conforming): share of the exact contacts with a reported",
        "one within 2 % of the radius; least separation no more than the tolerance. *Force error*: of a session whose rows are of these contacts, RMS of its force",
        "less the exact session's, by that one's RMS; *entered*: how deep the exact surfaces got through each other in it. Levels far away answer at tolerances of",
        f"their own. {made(data['proxy'])}", "",
        *proxy_section(data["proxy"]["rows"]),
        "## What a contact query costs and buys", "",
        "90 poses of each pair's path are counted; accuracy is of every eighth pose of 1,000, against the exact query: RMS difference of the force of 16 clusters",
        f"by its RMS, its step from pose to pose by the exact one's, mean error of the least separation. {made(data['queries'])}", "",
        *quality_section(data["queries"]["pairs"]),
        "## Sessions", "",
        f"In lockstep with the simulated hand at the scenes' own settings; depth as the session measures it. {made(data['sessions'])}", "",
        *session_section(data["sessions"]["scenes"]),
    ]
    return "\n".join(lines).rstrip() + "\n"
