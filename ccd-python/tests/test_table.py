"""The table of public calls (docs/python-calls.md): what it says stands here does."""

import inspect
import pathlib
import re

import meshccd

TABLE = pathlib.Path(__file__).resolve().parents[2] / "docs/python-calls.md"
NAME = re.compile(r"`([A-Za-z_][\w.]*)(?:\(([\w, ]*)\))?`")


def named(table):
    """Names and arguments of the right column, of rows that name something."""
    rows = [line.split(" | ", 1) for line in table.splitlines() if line.startswith("| `")]
    return [found for _, right in rows if not right.startswith("none: ") for found in
            NAME.findall(right)]


def missing(table):
    """What is named and is not there."""
    wrong = []
    for name, arguments in named(table):
        thing = meshccd
        for part in name.split("."):
            thing = getattr(thing, part, None)
        wanted = {word for word in arguments.split(", ") if word}
        if thing is None or wanted and not wanted <= set(inspect.signature(thing).parameters):
            wrong.append((name, arguments))
    return wrong


def test_every_name_is_there():
    table = TABLE.read_text()
    assert len(named(table)) > 150 and missing(table) == []


def test_a_wrong_name_is_seen():
    for right, want in [
        ("`Session.stride`", ("Session.stride", "")),
        ("`read_mesh(paths)`", ("read_mesh", "paths")),
        ("`Options(tolerance)`, `Options(sharpness)`", ("Options", "sharpness")),
    ]:
        assert missing(f"| `x` | {right} |") == [want]
    assert missing("| `x` | none: `nothing` |") == []


def test_the_module_has_no_more_than_the_table():
    """Calls of the module that no row names belong to Python alone."""
    there = {name.split(".")[0] for name, _ in named(TABLE.read_text())}
    alone = {"Approach", "__version__"}
    assert set(meshccd.__all__) - there == alone
