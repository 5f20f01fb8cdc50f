"""For the documentation site: aligned lines of docstrings, parameters and their meaning, stay aligned."""

import re

from griffe import Extension


class AlignedDocstrings(Extension):
    """Paragraphs with columns become blocks of text."""

    def on_object(self, *, obj, **_):
        if obj.docstring is None:
            return
        parts = obj.docstring.value.split("\n\n")
        for i, part in enumerate(parts):
            if re.search(r"\S {2,}\S", part) and not part.startswith("    "):
                parts[i] = "```text\n" + part + "\n```"
        obj.docstring.value = "\n\n".join(parts)
