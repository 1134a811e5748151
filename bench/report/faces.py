"""faces RESULTS.json FOLDER

Writes FOLDER/faces.md, FOLDER/faces.svg and FOLDER/faces_rms.svg from a run of limn_faces_bench,
and prints the sentence that sums it up.
"""

import json
import os
import sys

from faces_page import page, summary
from faces_plot import plot


def main(source, folder):
    with open(source, encoding="utf-8") as file:
        results = json.load(file)
    texts = {"faces.svg": plot(results["meshes"], "greatest"),
             "faces_rms.svg": plot(results["meshes"], "rms"),
             "faces.md": page(results)}
    for name, text in texts.items():
        with open(os.path.join(folder, name), "w", encoding="utf-8") as file:
            file.write(text)
    print(summary(results["meshes"]))


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
