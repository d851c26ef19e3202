"""libquoin, loaded through cffi: the one place that knows of pointers."""

from __future__ import annotations

import json
import os
import pathlib
import re
import typing

import cffi
import numpy
import numpy.typing

ffi: typing.Any = cffi.FFI()

#: Numbers of the library: read-only.
Array = numpy.typing.NDArray[numpy.float64]
#: What numbers, names and JSON become of.
Value = typing.Any
Path = typing.Union[str, "os.PathLike[str]"]


def _declarations(header: str) -> str:
    """What cffi reads of quoin.h: no comments, no lines of the preprocessor."""
    text = re.sub(r"/\*.*?\*/", "", header, flags=re.DOTALL)
    text = re.sub(r"#ifdef __cplusplus.*?#endif", "", text, flags=re.DOTALL)
    return re.sub(r"^#.*$", "", text, flags=re.MULTILINE)


def _load() -> typing.Any:
    folder = pathlib.Path(__file__).parent
    header = os.environ.get("QUOIN_HEADER", folder / "quoin.h")
    ffi.cdef(_declarations(pathlib.Path(header).read_text(encoding="utf-8")))
    # A wheel has library and program beside this file, a package of a distribution where they are.
    if (folder / "quoin-cli").exists():
        os.environ.setdefault("QUOIN_CLI", str(folder / "quoin-cli"))
    own = folder / "libquoin.so"
    library = os.environ.get("QUOIN_LIBRARY", own if own.exists() else "libquoin.so.0")
    try:
        return ffi.dlopen(str(library))
    except OSError as error:
        raise ImportError(f"libquoin was not found: {error}") from error


lib = _load()


class Error(Exception):
    """What Quoin refuses. `file`, `line`, `column` and `key` tell the place, or are None; `import_report` is what
    reading a drawing had found by then."""

    def __init__(self, message: str | None, file: str | None = None, line: int | None = None,
                 column: int | None = None, key: str | None = None) -> None:
        super().__init__(message)
        self.file, self.line, self.column, self.key = file, line, column, key
        self.import_report: list[str] = []


class InvalidError(Error, ValueError):
    """The content of a file, or a value, breaks a rule."""


class FileError(Error, OSError):
    """A file cannot be read or written."""


class UsageError(Error, ValueError):
    """No such view, format, option …"""


class NoAnswerError(Error):
    """The state that was found does not allow what was asked."""


class ChangedWarning(UserWarning):
    """A result was computed when its project had other bytes, or with other values."""


_KINDS: dict[int, type[Error]] = {
    lib.QUOIN_ERROR_INVALID: InvalidError,
    lib.QUOIN_ERROR_FILE: FileError,
    lib.QUOIN_ERROR_USAGE: UsageError,
    lib.QUOIN_ERROR_NO_ANSWER: NoAnswerError,
}


def text(pointer: typing.Any) -> str:
    """A C string; "" where there is none."""
    return "" if pointer == ffi.NULL else ffi.string(pointer).decode()


def owned(pointer: typing.Any) -> str:
    """A C string that is the caller's, who frees it here."""
    return text(ffi.gc(pointer, lib.quoin_free))


def call(function: typing.Any, *arguments: typing.Any) -> typing.Any:
    """Calls a function whose last parameter takes an error, and raises what it sets."""
    error = ffi.new("QuoinError **")
    answer = function(*arguments, error)
    if error[0] == ffi.NULL:
        return answer
    cause = ffi.gc(error[0], lib.quoin_error_free)
    message = text(lib.quoin_error_get_message(cause))
    kind = lib.quoin_error_get_kind(cause)
    if kind == lib.QUOIN_ERROR_NO_MEMORY:
        raise MemoryError(message)
    raise _KINDS[kind](
        message,
        text(lib.quoin_error_get_file(cause)) or None,
        lib.quoin_error_get_line(cause) or None,
        lib.quoin_error_get_column(cause) or None,
        text(lib.quoin_error_get_key(cause)) or None,
    )


def array(pointer: typing.Any, shape: tuple[int, ...], owner: typing.Any) -> Array:
    """Numbers of the library as a read-only array, without a copy; keeps `owner` alive."""
    count = int(numpy.prod(shape))
    if pointer == ffi.NULL or count == 0:
        return numpy.zeros(shape)
    held = ffi.gc(ffi.cast("double *", pointer), lambda _, kept=owner: None)
    numbers = numpy.frombuffer(ffi.buffer(held, count * 8), dtype=float)
    numbers.flags.writeable = False
    return numbers.reshape(shape)


def number(value: float) -> float | None:
    """None for what the library says is not known."""
    return None if numpy.isnan(value) else value


class Progress(typing.NamedTuple):
    """How far an analysis has come."""

    done: float  #: from 0 to 1, never less than before; 1 once, at its end
    what: str  #: "path", "time", "limit analysis" (of a path: its bound), "modes", "cases", "frames" …
    reached: float  #: load multiplier, s in time, or how many cases or frames
    steps: int
    iterations: int  #: of a study: failed cases


#: Called at every iteration; False cancels.
ProgressFunc = typing.Callable[[Progress], typing.Optional[bool]]


def watched(progress: ProgressFunc | None, function: typing.Any,
            *arguments: typing.Any) -> typing.Any:
    """Calls an analysis with a callback. What Python raises in it cancels, and is raised again."""
    raised: list[BaseException] = []

    @ffi.callback("bool(double, int32_t, int32_t, void *)")
    def report(reached: float, steps: int, iterations: int, _data: typing.Any) -> bool:
        try:
            state = Progress(lib.quoin_progress_get_done(),
                             text(lib.quoin_progress_get_what()), reached, steps, iterations)
            return progress is None or progress(state) is not False
        except BaseException as error:  # raised again where Python can see it
            raised.append(error)
            return False

    try:
        answer = call(function, *arguments, ffi.NULL if progress is None else report, ffi.NULL)
    except Error:
        if not raised:
            raise
    if raised:
        raise raised[0]
    return answer


def _plain(value: Value) -> Value:
    """Numbers and arrays of numpy as JSON takes them."""
    if isinstance(value, (numpy.generic, numpy.ndarray)):
        return value.tolist()
    raise TypeError(f"{type(value).__name__} is no value of a project")


def dumps(value: Value, allow_nan: bool = True) -> str:
    """JSON, with numbers and arrays of numpy."""
    return json.dumps(value, default=_plain, allow_nan=allow_nan)


def encoded(path: Path) -> bytes:
    """A path as C takes it."""
    return os.fsencode(path)


def strings(values: typing.Iterable[str]) -> tuple[typing.Any, typing.Any]:
    """A NULL-terminated list of C strings, and what keeps them alive."""
    kept = [ffi.new("char[]", value.encode()) for value in values]
    return ffi.new("char *[]", kept + [ffi.NULL]), kept
