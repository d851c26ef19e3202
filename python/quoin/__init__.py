"""Block masonry: contact faces, load multipliers and collapse mechanisms.

    import quoin
    result = quoin.open("wall3.quoin").solve()
    print(result.multiplier)

All numbers are SI (m, N, rad, s).
"""

from ._library import (ChangedWarning, Error, FileError, InvalidError, NoAnswerError, Progress,
                       UsageError, lib, text)
from .cases import Study, command, study
from .model import Block, Face, Model, from_dict, from_polygons, generate, open, read_drawing, wall
from .result import Modes, Result, compare, curve

__version__ = text(lib.quoin_version())

__all__ = [
    "Block", "ChangedWarning", "Error", "Face", "FileError", "InvalidError", "Model", "Modes",
    "NoAnswerError", "Progress", "Result", "Study", "UsageError", "command", "compare", "curve",
    "from_dict", "from_polygons", "generate", "open", "read_drawing", "study", "wall",
]
