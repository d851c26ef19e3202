"""What mypy must accept of a program that uses the package, and what it must refuse: each line that
ends in "type: ignore" is an error, or mypy tells that it is none."""

import pathlib
from typing import Optional

import numpy
import numpy.typing

import quoin

Numbers = numpy.typing.NDArray[numpy.float64]


def friction_study(path: pathlib.Path) -> dict[float, Optional[float]]:
    wall = quoin.open(path, {"analysis.increments": 20})
    return {mu: wall.set({"laws[0].friction": mu}).solve().multiplier for mu in (0.4, 0.6)}


def watch(state: quoin.Progress) -> bool:
    return state.done < 0.5 or state.what == "path"


def use(model: quoin.Model) -> None:
    result: quoin.Result = model.solve(progress=watch)
    displacements: Numbers = result.displacements
    names: list[str] = [block.name for block in model.blocks]
    picture: Optional[bytes] = result.draw("forces", format="pdf")
    fixed: int = "three"  # type: ignore[assignment]
    multiplier: float = result.multiplier  # type: ignore[assignment]
    model.solve(progress=lambda: True)  # type: ignore[misc, arg-type]
    quoin.wall(3)  # type: ignore[arg-type]
    model.modal(count="many")  # type: ignore[arg-type]
    print(displacements, names, picture, fixed, multiplier)
