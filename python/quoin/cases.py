"""Many cases of a model, on all cores: studies and records that grow. Cases are computed by processes of
quoin-cli, the program that QUOIN_CLI names or the one of PATH."""

from __future__ import annotations

import contextlib
import csv
import os
import pathlib
import tempfile
import typing

from . import _library
from ._library import FileError, Path, ProgressFunc, Value, ffi, lib

if typing.TYPE_CHECKING:
    from .model import Model
    from .result import Result

#: A row of a table: numbers, words, or None where a case has no value.
Row = typing.Dict[str, typing.Union[float, str, None]]


def command(*arguments: str | os.PathLike[str], progress: ProgressFunc | None = None) -> str:
    """Runs quoin-cli with these arguments, and gives what it prints: command("check", path). Its
    errors are those of this package. `progress` is told the cases of a study or of ida; where it
    returns False the command is cancelled, with a NoAnswerError, and goes on when it is run again."""
    given, _kept = _library.strings(os.fspath(argument) for argument in arguments)
    output = ffi.new("char **")
    _library.watched(progress, lib.quoin_command_watched, given, output)
    return _library.owned(output[0])


def options(**values: Value) -> list[str]:
    """Options of the command line: time_step=0.01 is --time-step 0.01, keep=True --keep; None and
    False are left out, lists are given again and again."""
    made: list[str] = []
    for name, value in values.items():
        for one in value if isinstance(value, (list, tuple)) else [value]:
            if one is not None and one is not False:
                made.append(f"--{name.replace('_', '-')}" + ("" if one is True else f"={one}"))
    return made


@contextlib.contextmanager
def files(model: Model, result: Result | None = None) -> typing.Iterator[list[str]]:
    """A model and a result as arguments of the command line: its own file with its values, or one that
    goes again."""
    with tempfile.TemporaryDirectory(prefix="quoin-") as folder:
        path = pathlib.Path(folder, "model.quoin")
        if model.is_of_file:
            arguments = [model.path, *options(set=model.overrides)]
        else:
            model.save(path)
            arguments = [str(path)]
        if result is not None:
            result.save(pathlib.Path(folder, "result.json"))
            # Overrides are in the result already.
            arguments = [arguments[0], "--result", str(pathlib.Path(folder, "result.json"))]
        yield arguments


def _number(text: str) -> float | str | None:
    try:
        return float(text)
    except ValueError:
        return text or None


def rows(table: str) -> list[Row]:
    """A table of the command line."""
    return [{key: _number(value) for key, value in row.items()}
            for row in csv.DictReader(table.splitlines())]


class Study:
    """The folder of a study: its cases, computed or not yet."""

    def __init__(self, folder: Path) -> None:
        self.folder = os.fspath(folder)

    def run(self, jobs: int | None = None, keep: bool = False, retry: bool = False,
            progress: ProgressFunc | None = None) -> Study:
        """Computes the cases that have no row yet; with `keep` their full results too, with `retry`
        also those that failed."""
        if not os.path.isdir(self.folder):
            raise FileError(f"{self.folder}: there is no such folder of a study", self.folder)
        command("study", "run", self.folder, "--quiet",
                *options(jobs=jobs, keep=keep, retry=retry), progress=progress)
        return self

    def table(self) -> list[Row]:
        """A row for every case: its parameters, outputs, outcome and reason."""
        return rows(command("study", "table", self.folder))

    def to_dataframe(self) -> typing.Any:
        """The same for pandas."""
        import pandas

        return pandas.DataFrame(self.table())

    def summary(self) -> str:
        """Mean, deviation, quantiles, sensitivities, mechanisms, in words."""
        return command("study", "summary", self.folder)

    def plot(self, path: Path, kind: str = "scatter", of: str | None = None,
             by: str | typing.Sequence[str] = (), **picture: Value) -> None:
        """Draws "scatter", "histogram", "cumulative", "tornado", "surface", "envelope" or
        "mechanisms" as PNG, SVG or PDF."""
        names = [by] if isinstance(by, str) else list(by)
        command("study", "plot", self.folder, "--output", path,
                *options(kind=kind, of=of, by=names, **picture))

    def __repr__(self) -> str:
        return f"<quoin.Study {self.folder}>"


def study(source: Path, folder: Path, jobs: int | None = None, keep: bool = False,
          progress: ProgressFunc | None = None) -> Study:
    """Computes the study of a file in a folder, which is made where there is none. Cases that are
    there are not computed again."""
    command("study", "run", source, "--quiet", "--output", folder,
            *options(jobs=jobs, keep=keep), progress=progress)
    return Study(folder)


def study_of(model: Model, parameters: typing.Sequence[typing.Mapping[str, Value]],
             outputs: typing.Sequence[str], folder: Path, run: str, plan: Value,
             jobs: int | None, progress: ProgressFunc | None,
             members: typing.Mapping[str, Value]) -> Study:
    with files(model) as arguments, tempfile.TemporaryDirectory(prefix="quoin-") as place:
        path = pathlib.Path(place, "study.quoin-study")
        if arguments[1:]:  # a study has no values of its own
            model.save(pathlib.Path(place, "model.quoin"))
            arguments = [str(pathlib.Path(place, "model.quoin"))]
        path.write_text(_library.dumps({
            "format": "quoin-study", "version": 1, "title": model.title,
            "model": os.path.abspath(arguments[0]), "run": run, "plan": plan,
            "parameters": list(parameters), "outputs": list(outputs), **members,
        }), encoding="utf-8")
        return study(path, folder, jobs, progress=progress)


def ida(model: Model, records: typing.Sequence[Path], scale: tuple[float, float, float],
        folder: Path, picture: Path | None, progress: ProgressFunc | None,
        values: typing.Mapping[str, Value]) -> list[Row]:
    with files(model) as arguments:
        return rows(command(
            "ida", *arguments, "--output", folder, "--csv", "-", "--quiet",
            *options(record=[os.fspath(record) for record in records],
                     scale=":".join(f"{number:.12g}" for number in scale),
                     picture=picture, **values), progress=progress))
