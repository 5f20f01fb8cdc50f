"""thigma-batch: the shell's side."""

from __future__ import annotations

import argparse
import contextlib
import json
import os
import sys
from collections.abc import Iterator, Sequence
from typing import Any, Callable

import thigma

from . import _plan
from ._report import write_report
from ._run import run
from ._store import DONE, FAILED, LOST, Store, Task


def _changes(entries: Sequence[str]) -> dict[str, list[Any]]:
    """KEY=V1,V2 as JSON values, text where they are none."""
    found: dict[str, list[Any]] = {}
    for entry in entries:
        key, equals, values = entry.partition("=")
        if not (key and equals and values):
            raise thigma.InputError(f"--set {entry}: expected SECTION.KEY=VALUE,VALUE")
        found[key] = []
        for value in values.split(","):
            try:
                found[key].append(json.loads(value))
            except ValueError:
                found[key].append(value)
    return found


def _pair(text: str) -> tuple[float, float]:
    least, _, most = text.partition(",")
    return float(least), float(most or least)


def _delay(text: str) -> float | None:
    return None if text == "device" else float(text)


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="thigma-batch",
        description="Work on many parts or scenes, on all processors or many machines. A run that "
        "was ended goes on where it was. Exit code 0: all rows are good, 1: some are not, 4: bad "
        "input, 130: ended by Ctrl-C.",
    )
    parser.add_argument("--version", action="version", version=thigma.__version__)
    verbs = parser.add_subparsers(dest="verb", required=True, metavar="VERB")

    common = argparse.ArgumentParser(add_help=False)
    common.add_argument("-o", "--output", required=True, metavar="RESULTS", help="result folder")
    common.add_argument("--workers", type=int, help="local processes; default one a processor")
    common.add_argument("--scheduler", help="address of a Dask scheduler, tcp://HOST:PORT")
    common.add_argument("--serial", action="store_true", help="in this process, without Dask")
    common.add_argument("--time-limit", type=float, default=float("inf"), help="of one row [s]")
    common.add_argument("--retry-failed", action="store_true", help="rows failed by their input too")
    common.add_argument("--dashboard", action="store_true", help="serve Dask's page of the cluster")
    common.add_argument("--quiet", action="store_true", help="no progress bar")

    mesh = argparse.ArgumentParser(add_help=False)
    mesh.add_argument("parts", nargs="+", help="mesh files, folders, procedural:MODEL, lists .txt")
    mesh.add_argument("--scale", type=float, default=1.0, help="metres per unit")
    mesh.add_argument("--repair", action="store_true", help="take parts that need it repaired")

    verbs.add_parser("assets", parents=[mesh, common], help="levels of detail, a .clod a part")

    verb = verbs.add_parser("contacts", parents=[mesh, common], help="contacts at many poses")
    verb.add_argument("--against", required=True, help="what stands at the origin")
    verb.add_argument("--poses", default="100000", help=".npy, .csv, or how many random ones")
    verb.add_argument("--chunk", type=int, default=10_000, help="poses a row")
    verb.add_argument("--seed", type=int, default=1)
    verb.add_argument("--reach", type=_pair, default=(0.8, 1.0), help="LEAST,MOST of random poses")
    verb.add_argument("--tolerance", type=float, help="[m]; default 1 %% of the smaller radius")
    verb.add_argument("--threshold", type=float, help="levels of detail; parts are .clod files")

    scene = argparse.ArgumentParser(add_help=False)
    scene.add_argument("scenes", nargs="+", help="scene files or built-in scenes")

    verb = verbs.add_parser("gains", parents=[scene, common], help="gains by device and delay")
    verb.add_argument("--device", action="append", help="address; again for more")
    verb.add_argument("--delay", type=_delay, action="append", help="[s], or 'device'; again")

    verb = verbs.add_parser("sweep", parents=[scene, common], help="sessions over scene keys")
    verb.add_argument("--set", action="append", default=[], metavar="KEY=V,V", help="again for more")
    verb.add_argument("--device", default="hand:")
    verb.add_argument("--duration", type=float, default=4.0, help="[s]")
    verb.add_argument("--seed", type=int, action="append", help="again for more")

    verb = verbs.add_parser("throws", parents=[scene, common], help="objects led through others")
    verb.add_argument("--count", type=int, default=100, help="throws a scene")
    verb.add_argument("--chunk", type=int, default=10, help="throws a row")
    verb.add_argument("--seed", type=int, default=1)
    verb.add_argument("--speeds", type=_pair, default=(0.05, 5.0), help="LEAST,MOST [m/s]")
    verb.add_argument("--set", action="append", default=[], metavar="KEY=V", help="again for more")

    verb = verbs.add_parser("report", help="write the page again")
    verb.add_argument("output", metavar="RESULTS")
    return parser


def _tasks(o: argparse.Namespace) -> list[Task]:
    if o.verb == "assets":
        return _plan.assets_tasks(_plan.parts_of(o.parts), scale=o.scale, repair=o.repair)
    if o.verb == "contacts":
        is_count = o.poses.isdigit()
        return _plan.contacts_tasks(
            _plan.parts_of(o.parts),
            o.against,
            poses=None if is_count else o.poses,
            count=int(o.poses) if is_count else 1,
            chunk=o.chunk,
            seed=o.seed,
            reach=o.reach,
            scale=o.scale,
            repair=o.repair,
            tolerance=o.tolerance,
            threshold=o.threshold,
        )
    if o.verb == "gains":
        return _plan.gains_tasks(o.scenes, devices=o.device or [""], delays=o.delay or [None])
    changes = _changes(o.set)
    if o.verb == "sweep":
        return _plan.sweep_tasks(
            o.scenes, changes, device=o.device, duration=o.duration, seeds=o.seed or [1]
        )
    return _plan.throws_tasks(
        o.scenes,
        count=o.count,
        chunk=o.chunk,
        seed=o.seed,
        speeds=o.speeds,
        changes={key: values[0] for key, values in changes.items()},
    )


@contextlib.contextmanager
def _bar(quiet: bool) -> Iterator[Callable[[int, int, int], None] | None]:
    if quiet:
        yield None
        return
    try:
        from rich.console import Console
        from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn
        from rich.progress import TimeElapsedColumn, TimeRemainingColumn
    except ImportError:
        yield None
        return
    columns = (
        BarColumn(),
        MofNCompleteColumn(),
        TextColumn("{task.description}"),
        TimeElapsedColumn(),
        TimeRemainingColumn(),
    )
    with Progress(*columns, console=Console(stderr=True)) as bar:
        line = bar.add_task("")

        def show(done: int, total: int, bad: int) -> None:
            said = f"{bad} failed" if bad else ""
            bar.update(line, completed=done, total=total, description=said)

        yield show


def _work(o: argparse.Namespace) -> int:
    if o.verb == "report":
        if not os.path.isdir(os.path.join(o.output, "rows")):
            raise thigma.InputError(f"{o.output}: no rows, expected a folder of results")
        print(write_report(Store(o.output)))
        return 0
    with _bar(o.quiet) as progress:
        outcome = run(
            _tasks(o),
            o.output,
            workers=o.workers,
            scheduler=o.scheduler,
            serial=o.serial,
            time_limit=o.time_limit,
            retry_failed=o.retry_failed,
            dashboard=o.dashboard,
            progress=progress,
        )
    for row in outcome.rows:
        if row["status"] != DONE:
            print(f"{row['status']}: {row['part']}: {row['reason']}", file=sys.stderr)
    print(
        f"{len(outcome.rows)} rows: {outcome.worked} worked, {outcome.kept} kept, "
        f"{outcome.count(FAILED)} failed, {outcome.count(LOST)} lost; {outcome.seconds:.1f} s"
    )
    print(write_report(Store(o.output)))
    return 0 if outcome.count(DONE) == len(outcome.rows) else 1


def main(arguments: Sequence[str] | None = None) -> int:
    """The program; returns its exit code."""
    try:
        return _work(_parser().parse_args(arguments))
    except KeyboardInterrupt:
        print("thigma-batch: ended; the same command goes on from here", file=sys.stderr)
        return 130
    except thigma.InputError as error:
        print(f"thigma-batch: {error}", file=sys.stderr)
        return 4
    except OSError as error:
        print(f"thigma-batch: {error}", file=sys.stderr)
        return 1
