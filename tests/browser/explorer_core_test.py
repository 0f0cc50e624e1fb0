"""The committed core of the explorer page, experiments/explorer/explorer_core.js, is what its sources build."""

import pathlib
import shutil
import subprocess
import sys
import tempfile

SKIPPED = 77
FOLDER = pathlib.Path(__file__).resolve().parents[2] / "experiments" / "explorer"


def main():
    if shutil.which("em++") is None:
        print("Skipped: em++ is missing; experiments/setup --browser installs what builds the explorer's core")
        return SKIPPED
    with tempfile.TemporaryDirectory(prefix="subdivlab-explorer-") as scratch:
        built = pathlib.Path(scratch) / "explorer_core.js"
        subprocess.run([FOLDER / "build", built], check=True)
        if built.read_bytes() != (FOLDER / "explorer_core.js").read_bytes():
            print("experiments/explorer/explorer_core.js is not what its sources build: run experiments/explorer/build and "
                  "commit it")
            return 1
    print("experiments/explorer/explorer_core.js is what its sources build")
    return 0


if __name__ == "__main__":
    sys.exit(main())
