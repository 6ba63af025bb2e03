"""Renders every scene of every chapter into out/ and writes the page out/index.html.

Called by `./timestep tour` after the build. A scene whose executable and assets have
not changed since its last run is left as it is.
"""
from __future__ import annotations

import argparse
import hashlib
import json
import shlex
import shutil
import subprocess
import sys
import threading
import time
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

import tour_page

ROOT = Path(__file__).resolve().parent.parent
STAMP = "tour-stamp"
AT_ONCE = 2


@dataclass
class Job:
    """One scene to render, and what came of it."""

    program: Path
    chapter: dict
    scene: dict
    folder: Path
    state: str = "waiting"  # rendered, unchanged or failed
    message: str = ""

    @property
    def name(self) -> str:
        return f"{self.chapter['chapter']} {self.scene['name']}"

    @property
    def command(self) -> list[str]:
        return [relative(self.program), "--offscreen", "--scene", self.scene["name"],
                *tour_options(self.program.name, self.scene["name"]), *MOVIE,
                "--out", relative(self.folder)]


# Movies as large as the page shows them: without a graphics card they take the time
MOVIE = ("--size", "960x540", "--fps", "20")


def relative(path: Path) -> str:
    return str(path.relative_to(ROOT)) if path.is_relative_to(ROOT) else str(path)


def tour_options(chapter: str, scene: str) -> list[str]:
    """What shows a scene best, if that is not its defaults: "tour" in runs.json."""
    file = ROOT / "chapters" / chapter / "runs.json"
    if not file.is_file():
        return []
    return json.loads(file.read_text(encoding="utf-8")).get("tour", {}).get(scene, [])


class Progress:
    """Lines of progress with the time since the start, from several threads."""

    def __init__(self, total: int) -> None:
        self.start = time.monotonic()
        self.total, self.done = total, 0
        self.lock = threading.Lock()

    def seconds(self) -> float:
        return time.monotonic() - self.start

    def say(self, text: str, finished: bool = False) -> None:
        with self.lock:
            self.done += finished
            share = f"{self.done}/{self.total}"
            print(f"[{self.seconds():5.1f} s  {share}] {text}", flush=True)


def digest_of(paths: list[Path]) -> str:
    digest = hashlib.sha256()
    for path in paths:
        digest.update(str(path).encode() + b"\0" + path.read_bytes())
    return digest.hexdigest()


def describe(program: Path) -> dict:
    """What a chapter's executable says of itself."""
    listed = subprocess.run([program, "--list", "--json"], capture_output=True,
                            text=True, stdin=subprocess.DEVNULL, timeout=60)
    if listed.returncode != 0:
        said = listed.stderr.strip()
        raise SystemExit(f"tour: {program.name} --list --json failed: {said}")
    return json.loads(listed.stdout)


def find_jobs(bin_folder: Path, out: Path) -> list[Job]:
    programs = [p for p in sorted(bin_folder.glob("[0-9][0-9]-*")) if p.is_file()]
    chapters = [(p, describe(p)) for p in programs]
    return [Job(program, chapter, scene, out / program.name / scene["name"])
            for program, chapter in chapters for scene in chapter["scenes"]]


def render(job: Job, assets: str, progress: Progress) -> None:
    """Runs one scene, unless its stamp says that nothing has changed."""
    stamp = " ".join([digest_of([job.program]), assets, *job.command])
    stamp_file = job.folder / STAMP
    whole = all((job.folder / f).is_file() for f in ("results.json", "filmstrip.png"))
    if whole and stamp_file.is_file() and stamp_file.read_text() == stamp:
        job.state = "unchanged"
        progress.say(f"{job.name}: unchanged", finished=True)
        return
    shutil.rmtree(job.folder, ignore_errors=True)
    job.folder.mkdir(parents=True)
    progress.say(f"{job.name} …")
    started = time.monotonic()
    run_scene(job)
    if job.state == "rendered":
        stamp_file.write_text(stamp)
    progress.say(f"{job.name}: {job.state} in {time.monotonic() - started:.1f} s"
                 + (f": {job.message}" if job.message else ""), finished=True)


def run_scene(job: Job) -> None:
    try:
        run = subprocess.run(job.command, cwd=ROOT, capture_output=True, text=True,
                             stdin=subprocess.DEVNULL, timeout=600)
    except (OSError, subprocess.TimeoutExpired) as error:
        job.state, job.message = "failed", str(error)
        return
    said = (run.stderr or run.stdout).strip().splitlines()
    if run.returncode != 0:
        job.state = "failed"
        job.message = f"exit code {run.returncode}" + (f": {said[-1]}" if said else "")
    elif not (job.folder / "results.json").is_file():
        job.state, job.message = "failed", "it wrote no results.json"
    else:
        job.state = "rendered"


def page_scene(job: Job) -> tour_page.SceneResult:
    results = job.folder / "results.json"
    return tour_page.SceneResult(
        chapter=job.chapter, scene=job.scene,
        folder=f"{job.program.name}/{job.scene['name']}",
        files={f.name for f in job.folder.iterdir()} if job.folder.is_dir() else set(),
        results=json.loads(results.read_text()) if results.is_file() else None,
        failure=job.message if job.state == "failed" else "",
        command=shlex.join(job.command))


def study(bin_folder: Path, out: Path) -> str:
    """The quick study, last of all; what went wrong, if anything did."""
    command = [bin_folder / "study", "--quick", "--out", out / "study"]
    try:
        run = subprocess.run(command, cwd=ROOT, stdin=subprocess.DEVNULL, timeout=600,
                             capture_output=True, text=True)
    except (OSError, subprocess.TimeoutExpired) as error:
        return str(error)
    said = run.stderr.strip().splitlines()
    return "" if run.returncode == 0 else said[-1] if said else f"code {run.returncode}"


def summary(jobs: list[Job], page: Path, seconds: float) -> str:
    states = [job.state for job in jobs]
    counts = ", ".join(f"{states.count(state)} {state}"
                       for state in ("rendered", "unchanged", "failed"))
    return f"{relative(page)}: {len(jobs)} scenes ({counts}) in {seconds:.1f} s"


def main() -> int:
    parser = argparse.ArgumentParser(prog="./timestep tour", usage=argparse.SUPPRESS,
                                     description=__doc__.splitlines()[0])
    parser.add_argument("--bin", type=Path, default=ROOT / "build/release/bin",
                        help="folder of the chapters' executables")
    parser.add_argument("--out", type=Path, default=ROOT / "out")
    options = parser.parse_args()

    out = options.out.resolve()
    jobs = find_jobs(options.bin.resolve(), out)
    if not jobs:
        raise OSError(f"{options.bin} has no chapter's executable")
    # A movie needs ffmpeg: once it is installed, scenes are rendered again
    assets = digest_of(sorted(f for f in (ROOT / "assets").rglob("*") if f.is_file()))
    assets += " ffmpeg" if shutil.which("ffmpeg") else " no-ffmpeg"
    progress = Progress(len(jobs))
    with ThreadPoolExecutor(AT_ONCE) as pool:
        list(pool.map(lambda job: render(job, assets, progress), jobs))

    out.mkdir(parents=True, exist_ok=True)
    progress.say("study --quick …")
    study_failed = study(options.bin.resolve(), out)
    progress.say(f"study: {study_failed or 'done'}")
    page = out / "index.html"
    page.write_text(tour_page.page([page_scene(job) for job in jobs]), encoding="utf-8")
    failed = [job for job in jobs if job.state == "failed"]
    for job in failed:
        print(f"tour: {job.name} failed: {job.message}", file=sys.stderr)
    if study_failed:
        print(f"tour: the study failed: {study_failed}", file=sys.stderr)
    print(summary(jobs, page, progress.seconds()))
    return 1 if failed or study_failed else 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except OSError as problem:
        print(f"tour: {problem}", file=sys.stderr)
        sys.exit(2)
