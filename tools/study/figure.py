"""figure DIR WHAT FILE.svg [RESPONSE...]: a picture of a study's report by itself, WHAT being responses, sensitivities, pareto
or search; of a grid of two parameters the chosen responses only."""

import re
import sys
from pathlib import Path

from .files import replace_file
from .manifest import Manifest
from .report import Outcome, measures_of, pictures_of


def main(directory, what, file, *chosen):
    outcome = Outcome(Manifest.read(Path(directory)))
    pictures = pictures_of(outcome, measures_of(outcome), chosen or None)
    if what not in pictures:
        sys.exit(f"{directory}: has no picture of `{what}`; there are {', '.join(pictures)}")
    # Without links to runs that are not where the picture goes.
    replace_file(file, re.sub(r"</?a\b[^>]*>|<title>[^<]*</title>", "", pictures[what]))


if __name__ == "__main__":
    main(*sys.argv[1:])
