"""Prints the lines and branches of a JaCoCo report that were not reached, by the reason that their text tells."""
import collections
import pathlib
import re
import sys
import xml.etree.ElementTree as xml

MODULES = ["starl-core", "starl-primitives", "starl-apps"]
MONITOR = re.compile(
    r"(Spec|Conformance|Automaton|Action|Record|Run|Check|Progress|Requests|Effects|Fact|Monitor|History|Casts|Phase)\.java$"
    r"|/spec/|/monitor/")
OUTSIDE = re.compile(r"/view/|/files/|/robot/|/launch/|Demo\.java$|Story\.java$|/apps/[A-Z]|/starl/(trace|shape)/")
REASONS = {
    "refuses": "a check of an argument, of a foreign byte or of the machine: it throws",
    "monitor": "monitors and what they are made of: a violation, and the text of one; their own tests run these lines",
    "outside": "what runs before or after a simulation: parameters, files, pictures, stories, traces as text",
    "text": "for people: toString, logs, what a robot waits for",
    "plain": "a constructor or method of one plain statement: a default, a getter, a setter, a delegate",
    "close": "the end of an app's primitive, and what comes after it",
    "rest": "not explained by its text",
}


def source(package, name):
    for module in MODULES:
        file = pathlib.Path(module, "src/main/java", package, name)
        if file.exists():
            return file.read_text(encoding="utf-8").split("\n")
    return None


def statement(lines, at):
    first = at
    while first > 0 and not re.search(r"[;{}]\s*(//.*)?$", lines[first - 1]):
        first -= 1
    last = at
    while last < len(lines) - 1 and not re.search(r"[;{}]\s*(//.*)?$", lines[last]):
        last += 1
    return " ".join(lines[first:last + 1])


def method(lines, at):
    """The name of the method around a line, and the number of its lines."""
    first = at
    while first > 0 and not re.match(r"  ( {2})?\S.*[({]$|  ( {2})?[\w@].*\) (throws .*)?\{$", lines[first]):
        first -= 1
    last = at
    while last < len(lines) - 1 and not re.match(r"  ( {2})?\}$", lines[last]):
        last += 1
    name = re.search(r"(\w+)\(", lines[first])
    return (name.group(1) if name else ""), last - first - 1


def reason(path, lines, at):
    text = statement(lines, at)
    name, size = method(lines, at)
    if MONITOR.search(path):
        return "monitor"
    if OUTSIDE.search(path):
        return "outside"
    if "throw " in text or "catch (" in text or "drop(" in text:
        return "refuses"
    if name in ("toString", "waitsFor", "failureText", "state", "occupants") or ".log." in text or "new Wait(" in text:
        return "text"
    if name in ("close", "end") or "closed" in text:
        return "close"
    if size == 1 or (size == 2 and "return this;" in " ".join(lines[at - 2:at + 2])):
        return "plain"
    return "rest"


def main():
    counts = collections.defaultdict(lambda: [0, 0])
    rest = []
    for package in xml.parse(sys.argv[1]).iter("package"):
        for file in package.iter("sourcefile"):
            lines = source(package.get("name"), file.get("name"))
            if lines is None:
                continue
            path = package.get("name") + "/" + file.get("name")
            for line in file.iter("line"):
                number, reached, missed = (int(line.get(key)) for key in ("nr", "ci", "mb"))
                counts["lines"][0] += 1
                if reached and not missed:
                    continue
                why = reason(path, lines, number - 1)
                counts[why][1 if reached else 0] += 1
                if why == "rest":
                    rest.append(f"{path}:{number}:{' half:' if reached else ''} {lines[number - 1].strip()}")
    print(f"{counts['lines'][0]} lines")
    for why, text in REASONS.items():
        print(f"{counts[why][0]} never, {counts[why][1]} in part: {text}")
    print("\n".join(rest))


main()
