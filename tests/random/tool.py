#!/usr/bin/env python3
"""Runs the tool `../shared/random/random_scenes.py` with the generator `scenes.py` and with what the tool takes.

The tool draws at the default quality alone. Here a scene that says `// quality N` is drawn so by both programs.
"""

import importlib.util
import pathlib
import re
import subprocess
import sys
import types

HERE = pathlib.Path(__file__).resolve().parent
ROOM = 4 << 30  # bytes of addresses
TOOL = HERE.parent.parent.parent / "shared" / "random" / "random_scenes.py"


def words_for(words, folder):
    """What POV-Ray or durer is called with, and the quality that the scene among them asks for."""
    theirs = str(words[0]) == "povray"
    scene = next(str(word) for word in words if str(word).endswith(".pov")).removeprefix("+I")
    asked = re.search(r"^// quality (\d+)$", (pathlib.Path(folder) / scene).read_text(), re.MULTILINE)
    if not asked:
        return words
    return [*words, *([f"+Q{asked[1]}"] if theirs else ["--quality", asked[1]])]


def run(words, cwd, **more):
    """As `subprocess.run`, in at most `ROOM` of memory: some scenes would take POV-Ray all of the machine's."""
    command = ["prlimit", f"--as={ROOM}", *words_for(words, cwd)]
    try:
        return subprocess.run(command, cwd=cwd, **more)
    except subprocess.TimeoutExpired:
        if str(words[0]) != "povray":
            raise
        # A scene that POV-Ray does not finish is not counted, as one that it refuses.
        return subprocess.CompletedProcess(command, 1, b"", b"")


def use(path, generator):
    """The tool at a path, with one of its generators: `given`, or a file beside this one."""
    spec = importlib.util.spec_from_file_location("random_scenes", path)
    tool = importlib.util.module_from_spec(spec)
    sys.modules["random_scenes"] = tool
    spec.loader.exec_module(tool)
    tool.subprocess = types.SimpleNamespace(**{**vars(subprocess), "run": run})
    if generator != "given":
        tool.use(HERE / generator)
    return tool


if __name__ == "__main__":
    raise SystemExit(use(TOOL, "scenes.py").main())
