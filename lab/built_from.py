"""What the shipped page was built from: the hash of each source and of each file, kept beside them.

`python lab/built_from.py write FOLDER` writes the record, as `make lab` does; `python lab/built_from.py check` says
what has changed since, which needs neither the compiler nor node. `make lab-check` builds it anew and compares bytes.
"""

from __future__ import annotations

import hashlib
import json
import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
SHIPPED = ROOT / "src" / "plategait" / "lab" / "shipped"
RECORD = "built_from.json"
# What decides about the bytes beside the core's headers and the page's modules: versions, flags, the bundler's calls.
MADE_WITH = ("lab/build.mjs", "lab/build_engine.py", "lab/package.json", "lab/package-lock.json")

_INCLUDE = re.compile(r'^\s*#\s*include\s+"([^"]+)"', re.MULTILINE)


def native_sources(first: str = "native/browser.cpp") -> list[str]:
    """The core's door for a browser and every header that it includes, by their paths in the tree."""
    found, to_read = set(), [ROOT / first]
    while to_read:
        path = to_read.pop()
        if path not in found:
            found.add(path)
            to_read += [path.parent / name for name in _INCLUDE.findall(path.read_text(encoding="utf-8"))]
    return sorted(str(path.relative_to(ROOT)) for path in found)


def hashes(paths: list[Path], root: Path) -> dict[str, str]:
    """SHA-256 of each file, by its path below a folder."""
    return {str(path.relative_to(root)): hashlib.sha256(path.read_bytes()).hexdigest() for path in sorted(paths)}


def sources() -> dict[str, str]:
    """SHA-256 of everything that the shipped files follow from."""
    page = [path for path in (ROOT / "lab" / "src").rglob("*") if path.is_file()]
    return hashes([*page, *(ROOT / name for name in (*native_sources(), *MADE_WITH))], ROOT)


def shipped(folder: Path) -> dict[str, str]:
    """SHA-256 of each shipped file."""
    return hashes([path for path in folder.iterdir() if path.is_file() and path.name != RECORD], folder)


def write(folder: Path) -> None:
    """Write the record of what was just built into a folder."""
    record = {"sources": sources(), "shipped": shipped(folder)}
    (folder / RECORD).write_text(json.dumps(record, indent=1) + "\n", encoding="utf-8")


def differences(folder: Path = SHIPPED) -> list[str]:
    """What is not as it was when the files were built, a line each; none where the files are what the sources give."""
    try:
        record = json.loads((folder / RECORD).read_text(encoding="utf-8"))
    except FileNotFoundError:
        return [f"{folder / RECORD} is missing"]
    now = {"sources": sources(), "shipped": shipped(folder)}
    lines = []
    for kind, files in now.items():
        then = record[kind]
        lines += [f"{name} is new" for name in files if name not in then]
        lines += [f"{name} is missing" for name in then if name not in files]
        lines += [f"{name} has changed" for name in files if name in then and files[name] != then[name]]
    return lines


def main(arguments: list[str]) -> int:
    """Write or check the record; the exit status."""
    if arguments[:1] == ["write"] and len(arguments) == 2:
        write(Path(arguments[1]))
        return 0
    if arguments != ["check"]:
        print(f"{' '.join(arguments) or 'nothing'}: must be write FOLDER or check", file=sys.stderr)
        return 2
    for line in (found := differences()):
        print(f"{line}; try make lab", file=sys.stderr)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
