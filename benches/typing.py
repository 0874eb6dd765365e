#!/usr/bin/env python3
"""How soon the language server marks what is typed in `quartic.basis`.

    python3 benches/typing.py target/release/basis [ROUNDS]

types a claim false and true again, and prints how many milliseconds pass from a change to the diagnostics of all claims; then
how many versions are published of those that are typed at once, the last of which is the newest. The budget is 10 ms.
"""
import json
import pathlib
import statistics
import subprocess
import sys
import time

SPEC = pathlib.Path(__file__).parent.parent / "specs" / "quartic.basis"
BURST = 40


class Editor:
    """An editor with one text."""

    def __init__(self, command, text):
        self.server = subprocess.Popen([command, "lsp"], stdin=subprocess.PIPE, stdout=subprocess.PIPE)
        self.version = 0
        self.uri = "file:///typed/quartic.basis"
        self.send("initialize", {"capabilities": {}}, id=1)
        self.receive()
        self.send("initialized", {})
        document = {"uri": self.uri, "languageId": "basis", "version": 0, "text": text}
        self.send("textDocument/didOpen", {"textDocument": document})

    def send(self, method, params, **id):
        body = json.dumps({"jsonrpc": "2.0", "method": method, "params": params, **id}).encode()
        self.server.stdin.write(b"Content-Length: %d\r\n\r\n%s" % (len(body), body))
        self.server.stdin.flush()

    def receive(self):
        length = 0
        while line := self.server.stdout.readline().strip():
            name, value = line.split(b":")
            if name.lower() == b"content-length":
                length = int(value)
        return json.loads(self.server.stdout.read(length))

    def type(self, line, start, end, text):
        """Replaces a part of a line."""
        self.version += 1
        span = {"start": {"line": line, "character": start}, "end": {"line": line, "character": end}}
        document = {"uri": self.uri, "version": self.version}
        self.send("textDocument/didChange", {"textDocument": document, "contentChanges": [{"range": span, "text": text}]})

    def published(self):
        """The versions that are published up to the newest one, and the messages about that."""
        versions = []
        while not versions or versions[-1] < self.version:
            message = self.receive()
            if message.get("method") == "textDocument/publishDiagnostics":
                versions.append(message["params"]["version"])
        return versions, message["params"]["diagnostics"]


def main(command, rounds="20"):
    text = SPEC.read_text()
    editor = Editor(command, text)
    editor.published()
    lines = text.splitlines()
    line = next(k for k, content in enumerate(lines) if "D(b[1], λ) >= 0" in content)
    column = lines[line].index("0;")
    milliseconds = []
    for k in range(2 * int(rounds)):
        false = k % 2 == 0
        start = time.perf_counter()
        editor.type(line, column, column + 1, "1" if false else "0")
        versions, messages = editor.published()
        milliseconds.append(1000 * (time.perf_counter() - start))
        assert versions == [editor.version], versions
        assert any("refuted" in m["message"] for m in messages) == false, messages
    milliseconds.sort()
    print(f"{statistics.median(milliseconds):6.1f} ms from a change to its diagnostics, at most {milliseconds[-1]:.1f} of {len(milliseconds)}")
    start = time.perf_counter()
    for k in range(BURST):
        editor.type(line, column, column + 1, str((k + 1) % 2))
    versions, _ = editor.published()
    passed = 1000 * (time.perf_counter() - start)
    print(f"{passed:6.1f} ms from the first of {BURST} changes to the diagnostics of the last; {len(versions)} published")
    editor.send("shutdown", None, id=2)
    while "id" not in editor.receive():
        pass
    editor.send("exit", None)
    sys.exit(editor.server.wait())


if __name__ == "__main__":
    main(*sys.argv[1:])
