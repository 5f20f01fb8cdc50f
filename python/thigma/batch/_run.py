"""Tasks to rows: in this process, on a local cluster, or on one that is there."""

from __future__ import annotations

import contextlib
import logging
import os
import pathlib
import socket
import time
import uuid
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field
from typing import Any

import thigma

from ._kinds import KINDS, TimeLimit, Work
from ._store import DONE, FAILED, LOST, Row, Store, Task, digest_of, library, row_of

_INPUT_ERRORS = (thigma.InputError, thigma.DeviceAddressError, ValueError, TypeError, IndexError)


@dataclass
class Outcome:
    """What a run did."""

    rows: list[Row] = field(default_factory=list)
    """Of the tasks, in their order."""
    worked: int = 0
    """Rows made by this run."""
    kept: int = 0
    """Rows that were there."""
    seconds: float = 0.0

    def count(self, status: str) -> int:
        return sum(row["status"] == status for row in self.rows)

    def __repr__(self) -> str:
        return (
            f"<thigma.batch.Outcome {self.worked} worked, {self.kept} kept, "
            f"{self.count(FAILED)} failed, {self.count(LOST)} lost, {self.seconds:.1f} s>"
        )


def _reason(error: BaseException, task: Task) -> str:
    """One line, with names of parts instead of where they lie."""
    line = str(error).strip().splitlines()
    said = line[0] if line else type(error).__name__
    if not isinstance(error, (thigma.Error, TimeLimit)):
        said = f"{type(error).__name__}: {said}"
    for path in sorted(task.inputs.values(), key=len, reverse=True):
        said = said.replace(path, pathlib.Path(path).name)
    return said


def work(task: Task, folder: str, limit: float) -> Row:
    """A task's row: the one that stands, or a new one. What goes wrong is its reason."""
    store = Store(folder)
    row = store.read(task.kind, task.key)
    if row is not None and row["status"] != LOST:
        return row
    try:
        at_work = Work(task, store, time.monotonic() + limit)
        at_work.check_inputs()
        values, files = KINDS[task.kind](at_work)
        at_work.check_inputs()
        row = row_of(task, DONE) | {"values": values, "files": files}
    except TimeLimit as error:
        row = row_of(task, LOST, _reason(error, task))
    except _INPUT_ERRORS as error:
        row = row_of(task, FAILED, _reason(error, task))
    except Exception as error:  # a full disk, no memory: another time it may go
        row = row_of(task, LOST, _reason(error, task))
    return store.add_row(row)


def _timed(task: Task, folder: str, limit: float) -> tuple[Row, float, str]:
    begin = time.perf_counter()
    row = work(task, folder, limit)
    return row, time.perf_counter() - begin, f"{socket.gethostname()}:{os.getpid()}"


_Done = tuple[Task, Row, float, str]


def _in_this_process(tasks: Sequence[Task], store: Store, limit: float) -> Iterator[_Done]:
    for task in tasks:
        yield (task, *_timed(task, os.fspath(store.folder), limit))


def _said_of_worker(token: str) -> tuple[str, bool]:
    return library(), os.path.exists(token)


def _check_workers(client: Any, store: Store) -> None:
    """Every worker has this library and sees the folder."""
    token = store.folder / "tmp" / f"{uuid.uuid4().hex}.seen"
    token.touch()
    try:
        for name, (version, sees) in client.run(_said_of_worker, os.fspath(token)).items():
            if version != library():
                raise thigma.InputError(
                    f"worker {name}: thigma {version}, expected {library()} as here"
                )
            if not sees:
                raise thigma.InputError(
                    f"worker {name}: does not see {store.folder}, expected a folder that all share"
                )
    finally:
        token.unlink()


@contextlib.contextmanager
def _client(workers: int, scheduler: Any, dashboard: bool) -> Iterator[Any]:
    try:
        from distributed import Client, LocalCluster
    except ImportError as error:
        raise thigma.InputError("Dask is missing: pip install 'thigma[batch]'") from error
    if scheduler is not None:
        with Client(scheduler, timeout=30) as client:
            yield client
        return
    quiet = logging.getLogger("distributed.scheduler"), logging.getLogger("distributed.nanny")
    for log in quiet:
        log.setLevel(logging.ERROR)
    cluster = LocalCluster(
        n_workers=workers,
        threads_per_worker=1,
        dashboard_address="127.0.0.1:8787" if dashboard else "127.0.0.1:0",
        silence_logs=logging.CRITICAL,
    )
    with cluster, Client(cluster) as client:
        yield client


def _on_cluster(
    tasks: Sequence[Task], store: Store, limit: float, client: Any
) -> Iterator[_Done]:
    from distributed import as_completed

    folder = os.fspath(store.folder)
    # Tasks of one key are one to the scheduler, whoever asks: results of another folder are others.
    where = digest_of(f"{os.path.abspath(folder)} {limit}")[:12]  # the limit may be infinite
    futures = {
        client.submit(
            _timed, task, folder, limit, key=f"{task.kind}-{task.key}-{where}", pure=False
        ): task
        for task in tasks
    }
    try:
        for future in as_completed(list(futures)):
            task = futures.pop(future)
            error = future.exception()
            if error is None:
                yield (task, *future.result())
            else:  # its workers died, each time
                died = type(error).__name__ == "KilledWorker"
                reason = "the worker died every time" if died else _reason(error, task)
                yield task, store.add_row(row_of(task, LOST, reason)), 0.0, ""
            future.release()
    finally:
        client.cancel(list(futures))


def run(
    tasks: Sequence[Task],
    folder: str | os.PathLike[str],
    *,
    workers: int | None = None,
    scheduler: Any = None,
    serial: bool = False,
    time_limit: float = float("inf"),
    retry_failed: bool = False,
    dashboard: bool = False,
    progress: Callable[[int, int, int], None] | None = None,
) -> Outcome:
    """Makes the rows that are not there yet.

    folder        of results; seen by all workers under the same path
    workers       of a local cluster; None: one a processor
    scheduler     address of a Dask scheduler, or a cluster of dask-jobqueue
    serial        in this process, without Dask
    time_limit    of one task [s]
    retry_failed  parts that failed by their inputs, too
    progress      called with how many are done, of how many, and how many of them are not good

    Another run on the same folder at the same time is fine. Ctrl-C ends it; rows that are there
    stay.
    """
    if workers is not None and workers < 1:
        raise thigma.InputError("batch: workers must be a whole number above 0")
    if not time_limit > 0.0:
        raise thigma.InputError("batch: time limit must be above 0 s")
    begin = time.time()
    clock = time.perf_counter()
    store = Store(folder)
    store.sweep_out()
    rows: dict[str, Row] = {}
    wanted: dict[str, Task] = {}
    for task in tasks:
        row = store.read(task.kind, task.key)
        again = (LOST, FAILED) if retry_failed else (LOST,)
        if row is None or row["status"] in again:
            if row is not None and row["status"] == FAILED:
                store.row_path(task.kind, task.key).unlink(missing_ok=True)
            wanted[task.key] = task
        else:
            rows[task.key] = row
    outcome = Outcome(kept=len(rows))
    bad = sum(row["status"] != DONE for row in rows.values())
    log: list[dict[str, Any]] = []
    total = len(rows) + len(wanted)
    if progress:
        progress(len(rows), total, bad)

    def take(done: Iterator[_Done]) -> None:
        nonlocal bad
        for task, row, seconds, worker in done:
            rows[task.key] = row
            outcome.worked += 1
            bad += row["status"] != DONE
            log.append({"key": task.key, "seconds": round(seconds, 4), "worker": worker})
            if progress:
                progress(len(rows), total, bad)

    count = workers or os.cpu_count() or 1
    try:
        if wanted and serial:
            take(_in_this_process(list(wanted.values()), store, time_limit))
        elif wanted:
            with _client(min(count, len(wanted)), scheduler, dashboard) as client:
                _check_workers(client, store)
                take(_on_cluster(list(wanted.values()), store, time_limit, client))
    finally:
        outcome.seconds = time.perf_counter() - clock
        if log:
            store.add_run(
                {
                    "begin": time.strftime("%Y-%m-%d %H:%M:%S", time.gmtime(begin)),
                    "seconds": round(outcome.seconds, 3),
                    "workers": len({entry["worker"] for entry in log if entry["worker"]}),
                    "tasks": log,
                }
            )
    outcome.rows = [rows[task.key] for task in tasks]
    return outcome
