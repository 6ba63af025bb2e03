"""The rendered pictures that the chapters' text shows, and whether they are still true.

chapters/NN-name/pictures/digests.json holds, for each picture, the digest of the run
that it shows: rendering differs a little between drivers, what is rendered does not.
"""
from __future__ import annotations

import json
import shutil
import subprocess
import tempfile
from pathlib import Path

from weave_runs import Chapter, execute


def arguments(chapter: Chapter, name: str) -> list[str]:
    """A declared run of that name, else the scene as it is by default."""
    return chapter.runs.get(name, ["--scene", name])


def digest_file(chapter: Chapter) -> Path:
    return chapter.folder / "pictures" / "digests.json"


def digests(chapter: Chapter) -> dict[str, str]:
    file = digest_file(chapter)
    return json.loads(file.read_text()) if file.is_file() else {}


def path(chapter: Chapter, name: str) -> Path:
    """The picture's file: WebP where that is much smaller, else PNG."""
    webp = chapter.folder / "pictures" / f"{name}.webp"
    return webp if webp.is_file() else webp.with_suffix(".png")


def is_fresh(chapter: Chapter, name: str) -> bool:
    run = chapter.run_with(name, arguments(chapter, name))
    return path(chapter, name).is_file() and digests(chapter).get(name) == run.digest


def render(chapter: Chapter, name: str) -> None:
    run = chapter.run_with(name, arguments(chapter, name))
    folder = digest_file(chapter).parent
    folder.mkdir(exist_ok=True)
    with tempfile.TemporaryDirectory() as scratch:
        execute([str(chapter.program()), *arguments(chapter, name), "--offscreen",
                 "--no-movie", "--out", scratch], f"picture '{name}'")
        strip = Path(scratch) / "filmstrip.png"
        small = compressed(strip)
        target = folder / f"{name}{small.suffix}"
        (folder / f"{name}.webp").unlink(missing_ok=True)
        (folder / f"{name}.png").unlink(missing_ok=True)
        shutil.copyfile(small, target)
    known = {**digests(chapter), name: run.digest}
    digest_file(chapter).write_text(json.dumps(known, indent=2, sort_keys=True) + "\n")


def compressed(png: Path) -> Path:
    """The picture as WebP, if ffmpeg is there and makes it less than half as large."""
    webp = png.with_suffix(".webp")
    if not shutil.which("ffmpeg"):
        return png
    made = subprocess.run(["ffmpeg", "-v", "error", "-y", "-i", png, "-c:v", "libwebp",
                           "-quality", "90", webp], stdin=subprocess.DEVNULL,
                          capture_output=True)
    fits = made.returncode == 0 and webp.stat().st_size < png.stat().st_size / 2
    return webp if fits else png
