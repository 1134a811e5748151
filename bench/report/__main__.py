"""report RESULTS.json FOLDER

Writes FOLDER/performance.md and FOLDER/performance.svg from a run of limn_bench, and prints the
sentence that sums it up.
"""

import os
import sys

from page import page, summary
from plot import plot
from results import Results


def main(source, folder):
    results = Results(source)
    for name, text in {"performance.svg": plot(results), "performance.md": page(results)}.items():
        with open(os.path.join(folder, name), "w", encoding="utf-8") as file:
            file.write(text)
    if summary(results):
        print(summary(results))


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
