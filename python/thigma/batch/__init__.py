"""Many parts, many machines: the same work on one process, a local cluster or a real one.

Results lie in a folder under the digest of what decides them, and appear whole or not at all: a run
that was killed goes on where it was, and a second run does nothing. What cannot be done is a row
with its reason. `thigma-batch` is the same from a shell; docs/batch.md has both.
"""

from ._plan import (
    assets_tasks,
    contacts_tasks,
    gains_tasks,
    parts_of,
    sweep_tasks,
    throws_tasks,
)
from ._report import write_report
from ._run import Outcome, run
from ._store import Row, Store, Task, library

__all__ = [
    "Outcome",
    "Row",
    "Store",
    "Task",
    "assets_tasks",
    "contacts_tasks",
    "gains_tasks",
    "library",
    "parts_of",
    "run",
    "sweep_tasks",
    "throws_tasks",
    "write_report",
]
