"""libquoin, loaded through cffi: the one place that knows of pointers."""

import os
import pathlib
import re

import cffi
import numpy

ffi = cffi.FFI()


def _declarations(header):
    """What cffi reads of quoin.h: no comments, no lines of the preprocessor."""
    text = re.sub(r"/\*.*?\*/", "", header, flags=re.DOTALL)
    text = re.sub(r"#ifdef __cplusplus.*?#endif", "", text, flags=re.DOTALL)
    return re.sub(r"^#.*$", "", text, flags=re.MULTILINE)


def _load():
    folder = pathlib.Path(__file__).parent
    header = os.environ.get("QUOIN_HEADER", folder / "quoin.h")
    ffi.cdef(_declarations(pathlib.Path(header).read_text(encoding="utf-8")))
    # A wheel has the library beside this file, a package of a distribution where libraries are.
    own = folder / "libquoin.so"
    library = os.environ.get("QUOIN_LIBRARY", own if own.exists() else "libquoin.so.0")
    try:
        return ffi.dlopen(str(library))
    except OSError as error:
        raise ImportError(f"libquoin was not found: {error}") from error


lib = _load()


class Error(Exception):
    """What Quoin refuses. `file`, `line`, `column` and `key` tell the place, or are None."""

    def __init__(self, message, file=None, line=None, column=None, key=None):
        super().__init__(message)
        self.file, self.line, self.column, self.key = file, line, column, key


class InvalidError(Error, ValueError):
    """The content of a file, or a value, breaks a rule."""


class FileError(Error, OSError):
    """A file cannot be read or written."""


class UsageError(Error, ValueError):
    """No such view, format, option …"""


class NoAnswerError(Error):
    """The state that was found does not allow what was asked."""


_KINDS = {
    lib.QUOIN_ERROR_INVALID: InvalidError,
    lib.QUOIN_ERROR_FILE: FileError,
    lib.QUOIN_ERROR_USAGE: UsageError,
    lib.QUOIN_ERROR_NO_ANSWER: NoAnswerError,
}


def text(pointer):
    """A C string, or None."""
    return None if pointer == ffi.NULL else ffi.string(pointer).decode()


def call(function, *arguments):
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
        text(lib.quoin_error_get_file(cause)),
        lib.quoin_error_get_line(cause) or None,
        lib.quoin_error_get_column(cause) or None,
        text(lib.quoin_error_get_key(cause)),
    )


def array(pointer, shape, owner):
    """Numbers of the library as a read-only array, without a copy; keeps `owner` alive."""
    if pointer == ffi.NULL:
        return None
    count = int(numpy.prod(shape))
    if count == 0:
        return numpy.zeros(shape)
    held = ffi.gc(ffi.cast("double *", pointer), lambda _, kept=owner: None)
    numbers = numpy.frombuffer(ffi.buffer(held, count * 8), dtype=float)
    numbers.flags.writeable = False
    return numbers.reshape(shape)


class Progress:
    """A callback as C sees it. What Python raises in it cancels, and is raised again after."""

    def __init__(self, func):
        self.error = None
        self.handle = ffi.NULL
        if func is None:
            return

        @ffi.callback("bool(double, int32_t, int32_t, void *)")
        def report(multiplier, steps, iterations, _data):
            try:
                return func(multiplier, steps, iterations) is not False
            except BaseException as error:  # raised again where Python can see it
                self.error = error
                return False

        self.handle = report

    def call(self, function, *arguments):
        """Runs an analysis that takes this callback."""
        answer = call(function, *arguments, self.handle, ffi.NULL)
        if self.error is not None:
            raise self.error
        return answer


def strings(values):
    """A NULL-terminated list of C strings, and what keeps them alive."""
    kept = [ffi.new("char[]", value.encode()) for value in values]
    return ffi.new("char *[]", kept + [ffi.NULL]), kept
