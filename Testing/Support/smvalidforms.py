"""Programs that weigh small bodies in valid but unusual forms: each function check_MODE(runner) of a script is a mode of it."""
import argparse
import os
import sys

from smcheck import check_equal, check_true, finish
from smprogram import compute
from smstepbody import format_real

TOLERANCE = 1e-9


class Runner:
    def __init__(self, options):
        self.program, self.folder = options.program, options.output

    def run(self, name, text, arguments=()):
        path = os.path.join(self.folder, f"valid_{name.replace(' ', '_').replace('/', '_')}.step")
        with open(path, "w", encoding="ascii") as file:
            file.write(text)
        result = compute(self.program, path, *arguments)
        os.remove(path)
        return result

    def check_value(self, name, text, volume, mass=None, allowed=None, center=None, arguments=()):
        """`allowed` may be in a message; others are none."""
        code, entry = self.run(name, text, arguments)
        got = entry["total"]["volume"]
        messages = [message for message in entry["messages"] if not allowed or allowed not in message]
        check_true(name, code == 0 and entry["status"] == "ok" and abs(got - volume) <= TOLERANCE * volume and not messages,
                   f"{entry['status']}, volume {got} for {volume}, {messages}")
        if center is not None:
            middle = entry["total"]["center_of_mass"]
            check_true("  centre", all(abs(a - b) <= 100.0 * TOLERANCE for a, b in zip(middle, center)), f"{middle} for {center}")
        if mass is not None:
            check_true("  mass", entry["total"]["mass"] is not None and abs(entry["total"]["mass"] - mass) <= TOLERANCE * mass, f"{entry['total']['mass']} for {mass}")

    def check_flagged(self, name, text, allowed=("suspect", "open", "unreadable")):
        code, entry = self.run(name, text)
        check_true(name, entry["status"] in allowed and code != 0 and any("#" in message for message in entry["messages"]),
                   f"{code} {entry['status']}, volume {entry['total']['volume']}, {entry['messages']}")


def run_modes():
    """Runs the function check_MODE of the calling script that its first argument names, or all of them."""
    script = vars(sys.modules["__main__"])
    modes = {name[len("check_"):]: work for name, work in script.items() if name.startswith("check_") and work.__module__ == "__main__"}
    parser = argparse.ArgumentParser()
    parser.add_argument("mode", choices=sorted(modes) + ["all"])
    for option in ("--program", "--output"):
        parser.add_argument(option, required=True)
    options = parser.parse_args()
    check_equal("format of reals", ["1.0", "1.E-07", "0.25"], [format_real(x) for x in (1, 1e-7, 0.25)])
    for name in sorted(modes) if options.mode == "all" else [options.mode]:
        modes[name](Runner(options))
    finish()
