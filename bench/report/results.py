"""Reads what limn_bench left behind (Google Benchmark's JSON)."""

import json
from statistics import median


class Case:
    """All runs of one case: their times and what they counted."""

    def __init__(self, name):
        self.name = name
        self.path = name.split("/")
        self.times = []  # Seconds.
        self.processor_times = []  # Of the thread that runs the case.
        self.counters = {}
        self.label = ""
        self.error = None

    @property
    def seconds(self):
        return median(self.times)

    @property
    def faces_per_second(self):
        return self.counters["faces"] / self.seconds

    @property
    def nanoseconds_per_face(self):
        return 1e9 * self.seconds / self.counters["faces"]

    @property
    def peak_per_face(self):
        return self.counters["peak_bytes"] / self.counters["faces"]


UNITS = {"ns": 1e-9, "us": 1e-6, "ms": 1e-3, "s": 1.0}
# What Google Benchmark says of every run; the rest are counters.
FIELDS = {
    "name", "family_index", "per_family_instance_index", "run_name", "run_type", "repetitions",
    "repetition_index", "threads", "iterations", "real_time", "cpu_time", "time_unit", "label",
    "error_occurred", "error_message",
}
OPTIONS = ("iterations:", "repeats:", "manual_time", "real_time", "process_time", "min_time:",
           "threads:")


class Results:
    """The machine and the cases by name."""

    def __init__(self, path):
        with open(path, encoding="utf-8") as file:
            document = json.load(file)
        self.machine = document["context"]
        self.cases = {}
        for run in document["benchmarks"]:
            if run["run_type"] == "iteration":
                self._add(run)

    def _add(self, run):
        name = "/".join(part for part in run["run_name"].split("/")
                        if not part.startswith(OPTIONS))
        case = self.cases.setdefault(name, Case(name))
        case.label = run.get("label", "")
        if run.get("error_occurred"):
            case.error = run["error_message"]
            return
        case.times.append(run["real_time"] * UNITS[run["time_unit"]])
        case.processor_times.append(run["cpu_time"] * UNITS[run["time_unit"]])
        case.counters.update({key: value for key, value in run.items() if key not in FIELDS})

    def get(self, *path):
        """The case of a path, None where it was not run or failed."""
        case = self.cases.get("/".join(str(part) for part in path))
        return case if case and case.times and not case.error else None

    def group(self, *path):
        """The cases whose path begins so, in the order of their paths, numbers by size."""
        found = [case for case in self.cases.values()
                 if case.path[:len(path)] == [str(part) for part in path] and case.times]
        return sorted(found, key=lambda case: [(not part.isdigit(), int(part) if part.isdigit()
                                                else 0, part) for part in case.path])

    def failures(self):
        return [case for case in self.cases.values() if case.error]
