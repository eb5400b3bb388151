"""File lengths (400 lines, headers 250) and function lengths (60 lines)."""

import re

import sources

LONGEST_FILE, LONGEST_HEADER, LONGEST_FUNCTION = 400, 250, 60
_NO_FUNCTION = ("namespace", "class", "struct", "enum", "union", "extern")


def _without_template(head):
    """What follows `template <…>`; the head itself where it does not begin so."""
    match = re.match(r"\s*template\s*<", head)
    if match is None:
        return head
    depth, at = 1, match.end()
    while at < len(head) and depth > 0:
        depth += (head[at] == "<") - (head[at] == ">")
        at += 1
    return _without_template(head[at:])


def _opens_function(head):
    """Whether a brace after this text opens a function's body, outside of any other function."""
    head = _without_template(re.sub(r"^\s*(?:(?:public|private|protected|inline)\b\s*:?\s*)+", "", head))
    words = head.split()
    if not words or words[0] in _NO_FUNCTION or "(" not in head:
        return False
    depth, assigned = 0, -1
    for position, letter in enumerate(head):
        depth += (letter in "([") - (letter in ")]")
        if letter == "=" and depth == 0 and "operator" not in head[:position]:
            assigned = position
    return assigned < 0 or head[assigned + 1:].lstrip().startswith("[")  # a value, unless it is a lambda


def functions(text):
    """(first line, last line, head) of every function body; lambdas inside a function belong to it."""
    text = sources.without_preprocessor(sources.without_comments_and_literals(text))
    found, scopes, head_start, inside = [], [], 0, None
    for position, letter in enumerate(text):
        if letter == "{":
            head = text[head_start:position]
            if inside is None and _opens_function(head):
                first = head_start + len(head) - len(head.lstrip())
                inside = (len(scopes), first, " ".join(head.split()))
            scopes.append(letter)
            head_start = position + 1 if inside is None else head_start
        elif letter == "}" and scopes:
            scopes.pop()
            if inside is not None and len(scopes) > inside[0]:
                continue
            if inside is not None:
                follows = text[position + 1:].lstrip()[:1]
                if follows in (",", "{"):  # the braces were a member's initializer
                    inside = None
                    continue
                lines = [text.count("\n", 0, at) + 1 for at in (inside[1], position)]
                found.append((lines[0], lines[1], inside[2]))
                inside = None
            head_start = position + 1
        elif letter == ";" and inside is None:
            head_start = position + 1
    return found


def check(root):
    faults = []
    for path in sources.cpp_files(root, "core", "ui", "app", "tests"):
        text, place = path.read_text(encoding="utf-8"), path.relative_to(root)
        lines, limit = text.count("\n"), LONGEST_HEADER if path.suffix == ".h" else LONGEST_FILE
        if lines > limit:
            faults.append(f"{place}:1: {lines} lines, the limit is {limit}")
        for first, last, head in functions(text):
            if last - first + 1 > LONGEST_FUNCTION:
                faults.append(f"{place}:{first}: {last - first + 1} lines, the limit is {LONGEST_FUNCTION}: {head[:80]}")
    return faults


if __name__ == "__main__":
    sources.run(check)
