"""Every command that the text shows exists, and every link leads somewhere.

Checks the ```sh blocks, and `./timestep …` in sentences: commands of ./timestep, presets of CMake, and executables with
their options, scenes, methods, presets and parameters, against what these say of
themselves. Given --self-test, shows that wrong ones are found.
"""
from __future__ import annotations

import argparse
import json
import re
import shlex
import subprocess
import sys
import tempfile
from functools import cache
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
BLOCK = re.compile(r"^[ ]*```sh\n(.*?)^[ ]*```", re.DOTALL | re.MULTILINE)
INLINE = re.compile(r"`(\./timestep [^`\n]*)`")
LINK = re.compile(r"\]\(([^()\s:#]+)(?:#[^()\s]*)?\)")
FENCED = re.compile(r"^[ ]*```.*?^[ ]*```", re.DOTALL | re.MULTILINE)
# Not ours to check: everyone's commands
COMMON = {"cd", "git", "open", "xdg-open", "sudo", "apt-get", "dnf", "pacman", "brew"}


class Fault(Exception):
    """What is wrong with a command, in one line."""


def commands(text: str) -> list[tuple[int, list[str]]]:
    """Each command of the text with its line, as words."""
    found = [(text.count("\n", 0, span.start()) + 1, span[1].split())
             for span in INLINE.finditer(text)]
    for block in BLOCK.finditer(text):
        first = text.count("\n", 0, block.start(1)) + 1
        body = re.sub(r"\\\n", "  ", block[1])
        for offset, line in enumerate(body.splitlines()):
            lexer = shlex.shlex(line, posix=True, punctuation_chars="&|;<>")
            lexer.whitespace_split = True
            words: list[str] = []
            for word in [*lexer, ";"]:
                if set(word) <= set("&|;"):
                    if words:
                        found.append((first + offset, words))
                    words = []
                else:
                    words.append(word)
    return found


@cache
def output_of(*command: str) -> str:
    run = subprocess.run(command, capture_output=True, text=True, cwd=ROOT, timeout=300,
                         stdin=subprocess.DEVNULL)
    if run.returncode != 0:
        raise Fault(f"{' '.join(command)} fails: {(run.stderr or run.stdout).strip()}")
    return run.stdout


def must_be(what: str, name: str, valid: list[str]) -> None:
    if name not in valid:
        raise Fault(f"no {what} '{name}' (there are: {', '.join(valid)})")


def option_values(words: list[str]) -> list[tuple[str, str]]:
    """Each option with the word that follows it."""
    words = [part for w in words for part in
             (w.split("=", 1) if re.match(r"--[\w-]+=", w) else [w])]
    return [(word, (words + [""])[i + 1]) for i, word in enumerate(words)
            if word.startswith("--")]


def check_options(words: list[str], *help_command: str) -> None:
    known = re.findall(r"--[\w-]+", output_of(*help_command))
    for option, _ in option_values(words):
        must_be("option", option, sorted(set(known)))


def check_chapter(program: str, words: list[str]) -> None:
    """Names that a chapter's executable lists: scenes, methods, presets, parameters."""
    scenes = json.loads(output_of(program, "--list", "--json"))["scenes"]
    values = option_values(words)
    chosen = dict(values).get("--scene", scenes[0]["name"])
    must_be("scene", chosen, [scene["name"] for scene in scenes])
    scene = next(scene for scene in scenes if scene["name"] == chosen)

    def names(what: str) -> list[str]:
        return [one["name"] for one in scene[what]]

    for option, value in values:
        if option == "--method":
            for method in value.split(","):
                must_be("method", method, [*names("methods"), "all"])
        elif option == "--preset":
            must_be("preset", value, names("presets"))
        elif option == "--set":
            must_be("parameter", value.split("=")[0], names("parameters"))


def check_program(path: str, words: list[str], bin_folder: Path) -> None:
    program = bin_folder / Path(path).name
    if not program.is_file():
        raise Fault(f"no executable '{path}'")
    check_options(words, str(program), "--help")
    if re.match(r"\d\d-", program.name):
        check_chapter(str(program), words)


def check_preset(words: list[str]) -> None:
    presets = json.loads((ROOT / "CMakePresets.json").read_text())["configurePresets"]
    for option, value in option_values(words):
        if option == "--preset":
            must_be("preset", value, [preset["name"] for preset in presets])


def check_timestep(words: list[str]) -> None:
    listed = re.findall(r"^  ([a-z]+)", output_of("./timestep", "help"), re.MULTILINE)
    words = words or ["help"]
    must_be("command", words[0], listed)
    for label in words[1:] if words[0] == "test" else []:
        if label.isdigit() and not list(ROOT.glob(f"chapters/{label}-*")):
            raise Fault(f"no chapter {label}")
    if words[0] == "exercise" and words[1:]:
        known = [line.split()[0] for line in
                 output_of("./timestep", "exercise").splitlines()]
        must_be("exercise", words[1], known)
        must_be("option", "".join(words[2:]) or "--solution", ["--solution"])


def check_command(words: list[str], bin_folder: Path) -> None:
    while words and re.fullmatch(r"[A-Z_]+=.*", words[0]):
        words = words[1:]
    name, rest = words[0], words[1:]
    if name == "./timestep":
        check_timestep(rest)
    elif name in ("cmake", "ctest"):
        check_preset(rest)
    elif re.fullmatch(r"build/\w+/bin/[\w-]+", name):
        check_program(name, rest, bin_folder)
    elif name in ("python3", "bash") and rest:
        if not (ROOT / rest[0]).is_file():
            raise Fault(f"no file '{rest[0]}'")
        if name == "python3":
            check_options(rest[1:], "python3", rest[0], "--help")
    elif name not in COMMON:
        raise Fault(f"unknown command '{name}'")


def check_file(file: Path, bin_folder: Path) -> list[str]:
    text = file.read_text(encoding="utf-8")
    faults = []
    for line, words in commands(text):
        try:
            check_command(words, bin_folder)
        except Fault as fault:
            faults.append(f"{file.name}:{line}: {' '.join(words)}: {fault}")
    prose = FENCED.sub("", text)  # a lambda in C++ looks like a link
    faults += [f"{file}: the link {link} leads nowhere" for link in LINK.findall(prose)
               if not (file.parent / link).exists()]
    return faults


# --- the test of the test -------------------------------------------------------------

PROGRAM = """#!/bin/sh
case $1 in
  --help) echo "--scene --method --set=X --preset --dt" ;;
  --list) echo '{"scenes": [{"name": "fall", "methods": [{"name": "euler"}],
            "presets": [{"name": "ball"}], "parameters": [{"name": "mass"}]}]}' ;;
esac
"""
SOUND = """./timestep help  # a comment
cmake --preset release && ctest --preset=debug
build/release/bin/01-x --scene fall --method euler,all \\
  --set mass=1 --preset ball --dt 0.1 > file
TIMESTEP_NO_INSTALL=1 ./timestep test
./timestep exercise 1.1 --solution
python3 docs/weave.py --check"""
WRONG = ["./timestep fly", "./timestep test 99", "./timestep exercise 9.9",
         "./timestep exercise 1.1 --hint", "cmake --preset fast", "make",
         "build/release/bin/02-y", "build/release/bin/01-x --sceme fall",
         "build/release/bin/01-x --scene rise", "build/release/bin/01-x --method=rk4",
         "build/release/bin/01-x --set weight=1",
         "cd x; build/release/bin/01-x --preset egg",
         "python3 docs/none.py", "python3 docs/weave.py --chekc"]


def self_test() -> list[str]:
    failures = []
    with tempfile.TemporaryDirectory() as scratch:
        program = Path(scratch) / "01-x"
        program.write_text(PROGRAM)
        program.chmod(0o755)
        page = Path(scratch) / "README.md"
        for block in [SOUND, *WRONG]:
            page.write_text(f"text\n\n```sh\n{block}\n```\n")
            found = check_file(page, Path(scratch))
            if len(found) != (block != SOUND):
                failures.append(f"self-test: {block!r} gave {found}")
        page.write_text("[a](README.md) ![b](none.png)")
        if len(check_file(page, Path(scratch))) != 1:
            failures.append("self-test: a broken link was not found")
        page.write_text("```cpp\n[](double) {}\n```\n")
        if check_file(page, Path(scratch)):
            failures.append("self-test: a lambda was taken for a link")
        page.write_text("type `./timestep`, `./timestep help` or `./timestep fly`")
        if len(check_file(page, Path(scratch))) != 1:
            failures.append("self-test: a wrong command in a sentence was not found")
    return failures


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--bin", type=Path, default=ROOT / "build/release/bin")
    parser.add_argument("--self-test", action="store_true")
    options = parser.parse_args()
    files = [ROOT / "README.md", *sorted(ROOT.glob("chapters/*/README.md"))]
    faults = self_test() if options.self_test else [
        fault for file in files if file.is_file()
        for fault in check_file(file, options.bin)]
    for fault in faults:
        print(fault)
    print(f"{len(faults)} faults")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
