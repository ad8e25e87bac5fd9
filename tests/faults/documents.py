# SPDX-License-Identifier: GPL-3.0-or-later
"""JSON files that `ehd report` reads: cut, deep, with numbers that are too large, with entries of other types."""

TITLE = "results.json, bench.json, stress.json, submissions: wrong content"

DEEP = 200000
TEXTS = {
    "no JSON": "results",
    "null": "null",
    "a list": "[]",
    "cut": '{"schema": SCHEMA, "claims": [',
    "two objects": '{"schema": SCHEMA}{"schema": SCHEMA}',
    "without schema": "{}",
    "another schema": '{"schema": 99}',
    "a text as schema": '{"schema": "SCHEMA"}',
    "a schema that is too large": '{"schema": 1e400}',
    "a number that is too large": '{"schema": SCHEMA, "claims": [{"id": "a", "error": 1e400}]}',
    "a number that is too small for its sign": '{"schema": SCHEMA, "claims": [{"id": "a", "error": -1e999}]}',
    "nan": '{"schema": SCHEMA, "wall_s": nan}',
    "a key twice": '{"schema": SCHEMA, "schema": SCHEMA}',
    "deep": '{"schema": SCHEMA, "claims": ' + "[" * DEEP + "]" * DEEP + "}",
    "deep and open": '{"schema": SCHEMA, "claims": ' + "[" * DEEP,
    "very many keys": "{" + ",".join(f'"k{i}": 1' for i in range(200000)) + "}",
    "bytes that are no text": b'{"schema": SCHEMA, "claims": "\xff\xfe"}',
}
OF_RESULTS = {
    "claims of another type": '{"schema": 2, "claims": {}}',
    "a number as claim": '{"schema": 2, "claims": [1]}',
    "a text as rung": '{"schema": 2, "claims": [{"id": "a", "rung": "x"}]}',
    "a number as verdict": '{"schema": 2, "claims": [{"id": "a", "rung": 1, "verdict": 1}]}',
}
SCHEMAS = {"results.json": 2, "bench.json": 1, "stress.json": 1}


def refusal(name, content):
    def attack(room):
        room.write("d/results.json", '{"schema": 2}')
        room.write("d/" + name, content)
        return room.refused("report", "d", says=[name])
    return attack


def wide(room):
    """A submission whose header has more columns than anybody needs."""
    room.write("mine.csv", "case," + ",".join(f"c{i}" for i in range(1000000)) + "\n")
    return room.refused("judge", "mine.csv", says=["mine.csv:1: ", "columns"])


def inputs():
    yield "judge: a million columns", wide
    for name, schema in SCHEMAS.items():
        for what, content in TEXTS.items():
            if isinstance(content, str):
                content = content.encode()
            yield f"{name}: {what}", refusal(name, content.replace(b"SCHEMA", str(schema).encode()))
    for what, content in OF_RESULTS.items():
        yield f"results.json: {what}", refusal("results.json", content)
