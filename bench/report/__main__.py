"""report RESULTS.json FOLDER

Writes FOLDER/performance.md and FOLDER/performance.svg from a run of limn_bench.
"""

import os
import sys

from page import page
from plot import plot
from results import Results


def main(source, folder):
    results = Results(source)
    for case in results.failures():
        print(f"{case.name}: {case.error}", file=sys.stderr)
    if results.failures():
        return 1
    for name, text in {"performance.svg": plot(results), "performance.md": page(results)}.items():
        with open(os.path.join(folder, name), "w", encoding="utf-8") as file:
            file.write(text)
    return 0


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    sys.exit(main(*sys.argv[1:]))
