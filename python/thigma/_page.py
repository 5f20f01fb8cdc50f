"""The live page of the program, beside Python or in a cell of a notebook."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import threading
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
        self._said: list[str] = []
        self._known = threading.Event()
        self._address = ""
        self._process = subprocess.Popen(
            [*command, *options],
            stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.PIPE,
            encoding="utf-8",
            errors="replace",
        )
        self._reader = threading.Thread(target=self._read, daemon=True)
        self._reader.start()
        self._known.wait(600.0)
        if not self._address:
            self.close()
            raise Error(f"page: {self._said[-1] if self._said else 'the program said nothing'}")

    def _read(self) -> None:
        assert self._process.stderr is not None
        for line in self._process.stderr:
            self._said = [*self._said[-99:], line.strip()]
            found = re.search(r"the page is at (http://127\.0\.0\.1:\d+)", line)
            if found:
                self._address = found.group(1) + "/"
                self._known.set()
        self._known.set()

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
        self._reader.join(10.0)
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

    def __del__(self) -> None:
        process = getattr(self, "_process", None)
        if process is not None and process.poll() is None:
            process.terminate()

    def __repr__(self) -> str:
        return f"<thigma.Page {self._address if self.is_open else 'closed'}>"
