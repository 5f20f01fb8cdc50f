"""The live page of the program, beside Python or in a cell of a notebook."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import threading
import weakref
from types import TracebackType

from ._core import Error, InputError


def _program(program: str | os.PathLike[str]) -> str:
    named = os.fspath(program) or os.environ.get("THIGMA_PROGRAM", "")
    found = shutil.which(named or "thigma")
    if found is None:
        raise InputError(
            f"page: no program {named or 'thigma'!r}, expected one of the path, or its name in "
            "THIGMA_PROGRAM"
        )
    return found


def _end(process: subprocess.Popen[str]) -> None:
    if process.poll() is None:
        process.terminate()


class _Reader:
    """What the program says on standard error. Its thread holds this and no Page, which may go."""

    def __init__(self, process: subprocess.Popen[str]) -> None:
        self.said: list[str] = []
        self.known = threading.Event()
        self.address = ""
        self._process = process
        self.thread = threading.Thread(target=self._read, daemon=True)
        self.thread.start()

    def _read(self) -> None:
        assert self._process.stderr is not None
        for line in self._process.stderr:
            self.said = [*self.said[-99:], line.strip()]
            found = re.search(r"the page is at (http://127\.0\.0\.1:\d+)", line)
            if found:
                self.address = found.group(1) + "/"
                self.known.set()
        self.known.set()


class Page:
    """The program's page of a scene: a session on threads of another process. A context manager.

    scene      scene file or built-in scene; "": none, with a recording
    device     address; "web:" is the mouse on the page
    recording  .mcap to show instead of a session
    program    path; "": THIGMA_PROGRAM, or `thigma` of the path
    options    more of `thigma run`, as on a command line
    height     in a notebook [pixels]

    The last line of a cell shows it there. It is served to this machine alone, and ends with
    `close`, with Python, or when the page's session ends. Raises InputError, Error.
    """

    def __init__(
        self,
        scene: str | os.PathLike[str] = "",
        *,
        device: str = "web:",
        recording: str | os.PathLike[str] = "",
        program: str | os.PathLike[str] = "",
        options: tuple[str, ...] = (),
        height: int = 600,
    ) -> None:
        command = [_program(program), "run", "--embed"]
        if os.fspath(scene):
            command += [os.fspath(scene), "--device", device]
        if os.fspath(recording):
            command += ["--replay", os.fspath(recording)]
        self._height = height
        self._process = subprocess.Popen(
            [*command, *options],
            stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.PIPE,
            encoding="utf-8",
            errors="replace",
        )
        weakref.finalize(self, _end, self._process)  # also where Python ends
        self._reader = _Reader(self._process)
        self._reader.known.wait(600.0)
        self._address = self._reader.address
        if not self._address:
            self.close()
            said = self._reader.said
            raise Error(f"page: {said[-1] if said else 'the program said nothing'}")

    @property
    def address(self) -> str:
        """For a browser of this machine."""
        return self._address

    @property
    def is_open(self) -> bool:
        """False: it was closed, or the program has ended."""
        return self._process.poll() is None

    def close(self) -> None:
        """Ends the session with zero force, and the program; again: nothing."""
        if self._process.poll() is None:
            self._process.terminate()
            try:
                self._process.wait(10.0)
            except subprocess.TimeoutExpired:
                self._process.kill()
                self._process.wait()
        self._reader.thread.join(10.0)
        if self._process.stderr is not None:
            self._process.stderr.close()

    def _repr_html_(self) -> str:
        return (
            f'<iframe src="{self._address}" width="100%" height="{self._height}" '
            'style="border:0" allow="gamepad"></iframe>'
        )

    def __enter__(self) -> Page:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self.close()

    def __repr__(self) -> str:
        return f"<thigma.Page {self._address if self.is_open else 'closed'}>"
