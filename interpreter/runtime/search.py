"""SDL: ``#include "colors.inc"``: where the files that a scene names are found.

As given (from the working directory), beside the file that names it and beside the main scene, then in each library
path. Where nothing is found, the usual extensions are tried. ``files`` of the options come first: sources without a
file.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from difflib import get_close_matches
from pathlib import Path

INCLUDE_EXTENSIONS = (".inc", ".INC", ".pov", ".POV")


@dataclass(slots=True)
class FileSearch:
    """Finds files. ``beside`` holds the folders of the files being read, the innermost last."""

    library_paths: tuple[Path, ...]
    files: dict[str, bytes]
    beside: list[Path]

    def find(self, name: str, extensions: tuple[str, ...] = ()) -> Path | None:
        """The first file called ``name``, or ``name`` with one of the extensions."""
        for candidate in self._names(name, extensions):
            if str(candidate) in self.files:
                return Path(candidate)
            for folder in self._folders(Path(candidate)):
                path = folder / candidate
                try:
                    if path.is_file():
                        return path
                except (OSError, ValueError):
                    continue
        return None

    def hint(self, name: str) -> str:
        """What was probably meant by a name that is not found, or else where it was looked for."""
        there = {entry.name for folder in self._folders(Path(name)) if folder.is_dir() for entry in folder.iterdir()}
        close = get_close_matches(Path(name).name, sorted(there), 1, 0.75)
        if close:
            return f"did you mean '{close[0]}'?"
        folders = ["the working directory", "the folder of the scene", *map(str, self.library_paths)]
        return f"looked in {', '.join(folders)}"

    def read(self, path: Path) -> bytes:
        """A file's content.

        Raises:
            OSError: it cannot be read.
        """
        given = self.files.get(str(path))
        return path.read_bytes() if given is None else given

    def _names(self, name: str, extensions: tuple[str, ...]) -> Iterator[str]:
        names = [name] if "\\" not in name else [name, name.replace("\\", "/")]
        for text in names:
            yield text
            for extension in extensions:
                if not text.endswith(extension):
                    yield text + extension

    def _folders(self, candidate: Path) -> Iterator[Path]:
        yield Path()
        if not candidate.is_absolute():
            yield from reversed(self.beside)
            yield from self.library_paths
