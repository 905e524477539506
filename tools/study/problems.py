"""What is wrong with the input, all of it at once, and how a study ends."""

import difflib

DONE, USAGE, CASE_FILE, FILES, INTERRUPTED = 0, 2, 3, 4, 75  # exit codes of towform


class Refused(Exception):
    """Ends a study with messages for the user and an exit code."""

    def __init__(self, messages, code=CASE_FILE):
        self.messages = [messages] if isinstance(messages, str) else list(messages)
        self.code = code
        super().__init__("\n".join(self.messages))


class Problems:
    """Collects `file:line:column: message`; `refuse` raises them together, in the file's order."""

    def __init__(self, file):
        self.file = file
        self._found = []

    def add(self, at, message):
        """`at` is [line, column], or None for the file as a whole."""
        place = tuple(at or (0, 0))
        if (place, message) not in self._found:
            self._found.append((place, message))

    def __bool__(self):
        return bool(self._found)

    def refuse(self):
        if self._found:
            raise Refused([self.file + (f":{line}:{column}" if line else "") + f": {message}"
                           for (line, column), message in sorted(self._found, key=lambda found: found[0])])


def listed(words):
    """`a`, `b` and `c`"""
    quoted = [f"`{word}`" for word in words]
    return " and ".join([", ".join(quoted[:-1]), quoted[-1]] if len(quoted) > 1 else quoted)


def did_you_mean(word, known):
    """A suggestion when one of the known words is near, else what there is to choose from."""
    near = difflib.get_close_matches(str(word), [str(name) for name in known], 1)
    return f"; did you mean `{near[0]}`?" if near else f"; there {'is' if len(known) == 1 else 'are'} {listed(known)}"
