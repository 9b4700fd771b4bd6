"""README's quick start, line by line, in a folder of its own."""

import os
import re
import subprocess
import sys

from conftest import BINARY, ROOT
from PIL import Image


def blocks(language):
    """The code of README's quick start in this language."""
    text = (ROOT / "README.md").read_text()
    section = text.split("## Quick start")[1].split("\n## ")[0]
    return re.findall(rf"```{language}\n(.*?)```", section, re.DOTALL)


def test_the_lines_as_printed_give_a_plot(tmp_path):
    path = f"{BINARY.parent.resolve()}{os.pathsep}{os.environ['PATH']}"
    environment = {**os.environ, "PATH": path, "MPLBACKEND": "agg"}
    [commands], [plot] = blocks("sh"), blocks("python")
    subprocess.run(["sh", "-ec", commands], cwd=tmp_path, env=environment, check=True)
    subprocess.run([sys.executable, "-c", plot], cwd=tmp_path, env=environment, check=True)
    with Image.open(tmp_path / "first-plot.png") as image:
        darkest, brightest = image.convert("L").getextrema()
    assert darkest < 64 and brightest > 192
