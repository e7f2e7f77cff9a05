"""What changes the bytes of a run, and what its last digits: passages with several binaries and settings,
compared with the first binary.

    python tests/bench/reproducibility.py native=build/dld portable=build/portable/dld clang=build/clang/dld

Prints the Markdown table of docs/reproducibility.md.
"""

import json
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

#: Cells of the phase space on the paper's lattice: one that is displaced, one that zigzags.
CASES = {
    "d = 4.4 um, Ca = 0.7": {"geometry": {"row_shift_um": 4.4}, "cell": {"capillary_number": 0.7}},
    "d = 6.8 um, Ca = 0.5": {"geometry": {"row_shift_um": 6.8}, "cell": {"capillary_number": 0.5}},
}
#: Circumstances that must not matter: environment, words, folder below the temporary one.
CIRCUMSTANCES = {
    "two threads": ({"OMP_NUM_THREADS": "2"}, ["--threads", "2"], "a"),
    "locale de_DE, time zone Pacific/Chatham": ({"LC_ALL": "de_DE.UTF-8", "TZ": "Pacific/Chatham"}, [], "a"),
    "another folder": ({}, [], "b/with spaces é"),
}


def ran(solver, case, environment=(), words=(), folder="a"):
    """(summary, bytes of both files short of the number of threads) of a run."""
    with tempfile.TemporaryDirectory() as name:
        place = Path(name) / folder
        place.mkdir(parents=True)
        (place / "case.json").write_text(json.dumps(case), encoding="utf-8")
        command = [solver, "run", "case.json", "run.h5", "--summary", "summary.json", *words]
        subprocess.run(
            command,
            cwd=place,
            env={**os.environ, **dict(environment)},
            stderr=subprocess.DEVNULL,
            check=True,
        )
        files = [(place / name).read_bytes() for name in ("run.h5", "summary.json")]
        return json.loads(files[1]), [re.sub(rb'"threads":\d', b"", content) for content in files]


def difference(summary, reference):
    """(class, D_perp in um, its relative difference) in words."""
    if not isinstance(summary.get("d_perp_um"), float):
        return summary["status"], "", ""
    d_perp, other = summary["d_perp_um"], reference["d_perp_um"]
    return summary["status"], f"{d_perp:.5f}", f"{abs(d_perp / other - 1):.1e}"


def main():
    binaries = dict(word.split("=", 1) for word in sys.argv[1:])
    binaries = {name: str(Path(path).resolve()) for name, path in binaries.items()}
    first = next(iter(binaries))
    print("| passage | run | class | D_perp / um | relative difference | same bytes |")
    print("| --- | --- | --- | ---: | ---: | --- |")
    for label, change in CASES.items():
        case = {"scene": "passage", **change}
        double = case | {"fluid": {"precision": "double"}}
        runs = {name: (path, case) for name, path in binaries.items()}
        runs |= {f"{first}, {name}": (binaries[first], case, *how) for name, how in CIRCUMSTANCES.items()}
        runs[f"{first}, double precision"] = (binaries[first], double)
        summary, files = ran(*runs[first])
        for name, how in runs.items():
            found, content = (summary, files) if name == first else ran(*how)
            same = "yes" if content == files else "no"
            print(f"| {label} | {name} | {' | '.join(difference(found, summary))} | {same} |", flush=True)


if __name__ == "__main__":
    main()
