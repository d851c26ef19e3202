"""Results: paths of equilibria, mechanisms, modes, figures."""

from __future__ import annotations

import copy
import functools
import json
import os
import typing
import warnings

import numpy

from . import _library, cases
from ._library import (Array, ChangedWarning, Path, ProgressFunc, Value, ffi, lib,
                       number)

if typing.TYPE_CHECKING:
    from .model import Model


def _sheet(view: str, results: typing.Sequence[Result], path: Path | None, format: str,
           options: typing.Mapping[str, Value]) -> bytes | None:
    if not results:
        raise ValueError("results: there is none")
    model = lib.quoin_result_get_model(results[0]._handle)
    return draw(model, results, view, path, format, options)


def curve(results: typing.Sequence[Result], path: Path | None = None, format: str = "svg",
          **options: Value) -> bytes | None:
    """The load-displacement curves of results, of one model or several, over the same axes: a file
    by its ending (.png, .svg, .pdf, .csv), or the bytes of a format. options: title, until=0.05 (m
    or rad), whole=True, reference=[0.36, "0.4=published"], size, monochrome."""
    return _sheet("curve", results, path, format, options)


def compare(results: typing.Sequence[Result], path: Path | None = None, format: str = "svg",
            **options: Value) -> bytes | None:
    """Their mechanisms on one sheet, at one scale; a table with the ending .csv. options: title,
    columns, size, monochrome."""
    return _sheet("compare", results, path, format, options)


def draw(model: typing.Any, results: typing.Sequence[Result], view: str, path: Path | None,
         format: str | None, options: typing.Mapping[str, Value],
         progress: ProgressFunc | None = None) -> bytes | None:
    """Draws into a file, or returns the bytes of a format."""
    first = results[0]._handle if results else ffi.NULL
    figure = ffi.gc(_library.call(lib.quoin_figure_new, model, first, view.encode()),
                    lib.quoin_figure_free)
    for result in results[1:]:
        lib.quoin_figure_add(figure, result._handle)
    for name, value in options.items():
        if name == "sections" and not isinstance(value, str):
            value = ",".join(value)
        for one in value if isinstance(value, (list, tuple)) else [value]:
            if isinstance(one, bool):
                one = "on" if one else "off"
            _library.call(lib.quoin_figure_set, figure, name.encode(), str(one).encode())
    if path is not None:
        _library.watched(progress, lib.quoin_figure_write_watched, figure,
                         _library.encoded(path))
        return None
    length = ffi.new("size_t *")
    content = _library.call(lib.quoin_figure_encode, figure, (format or "svg").encode(),
                            length)
    return bytes(ffi.buffer(ffi.gc(content, lib.quoin_free), length[0]))


class Result:
    """What an analysis found. Arrays are read-only views of the library's memory; rows are
    blocks, then nodes of beams."""

    def __init__(self, handle: typing.Any) -> None:
        self._handle = ffi.gc(handle, lib.quoin_result_free)

    @property
    def model(self) -> Model:
        """The model that was solved, with the values of the analysis."""
        from .model import Model

        return Model(lib.quoin_model_ref(lib.quoin_result_get_model(self._handle)))

    @property
    def model_changed(self) -> bool:
        """Whether it was read of a file whose project had other bytes or values: the same blocks
        and contact pairs, but loads, laws or settings may differ."""
        return lib.quoin_result_is_of_changed_model(self._handle)

    def warn_if_changed(self, name: str) -> None:
        """A ChangedWarning where it is so."""
        if self.model_changed:
            warnings.warn(f"{name}: the model has changed since it was computed",
                          ChangedWarning, stacklevel=3)

    @property
    def outcome(self) -> str:
        """"collapse", "target-reached", "snap", "unbounded", "dead-load-unstable",
        "cancelled", "not-converged"."""
        return _library.text(lib.quoin_result_get_outcome(self._handle))

    @property
    def reason(self) -> str:
        """Sentences: the outcome, what made the analysis end there, and how the structure
        moves."""
        return _library.owned(lib.quoin_result_describe(self._handle))

    def to_dict(self) -> dict[str, Value]:
        """All that a result file holds, with the forces of every step: contacts with points and
        normals, history and energies of an analysis in time, beams, bars, ties, the kind of the
        mechanism. Keys as in data/result-format.md."""
        return json.loads(_library.owned(lib.quoin_result_to_text(self._handle)))

    @functools.cached_property
    def _content(self) -> dict[str, Value]:
        """The same, parsed once, for the properties below, which do not change it."""
        return self.to_dict()

    def check(self) -> tuple[bool, list[str]]:
        """Whether it passes the independent check, by the laws alone; and what of the result is not
        true, as a list of sentences."""
        faults = ffi.new("char **")
        passes = _library.call(lib.quoin_result_check, self._handle, faults)
        return passes, _library.owned(faults[0]).splitlines()

    def sensitivity(self) -> dict[str, Value]:
        """How the multiplier of an associative limit analysis changes: "laws", each with "name" and
        the changes by its "friction", "cohesion", "tension" (per 1, per N or Pa), "weight" and
        "thickness" of its blocks (per factor); "dead_loads", "live_loads" (per factor)."""
        return json.loads(_library.owned(
            _library.call(lib.quoin_limit_sensitivity, self._handle)))

    @property
    def multiplier(self) -> float | None:
        """The collapse multiplier, or None."""
        return number(lib.quoin_result_get_collapse_multiplier(self._handle))

    @property
    def first_limit_multiplier(self) -> float | None:
        """The multiplier of the first snap, or None."""
        return number(lib.quoin_result_get_first_limit_multiplier(self._handle))

    @property
    def bounds(self) -> tuple[float, float] | None:
        """(lower, upper) of limit analysis, or None."""
        lower = lib.quoin_result_get_lower_bound(self._handle)
        upper = lib.quoin_result_get_upper_bound(self._handle)
        return None if numpy.isnan(lower) else (lower, upper)

    @property
    def solutions(self) -> list[dict[str, Value]]:
        """Every collapse that was met and proved: dictionaries of "multiplier", "found_by"
        ("load", "displacement", "work", "arc-length" or "limit") and "displacement" (largest
        since the dead load, m; None of rigid blocks)."""
        handle = self._handle
        return [{
            "multiplier": lib.quoin_result_get_solution_multiplier(handle, i),
            "found_by": _library.text(lib.quoin_result_get_solution_found_by(handle, i)),
            "displacement": number(lib.quoin_result_get_solution_displacement(handle, i)),
        } for i in range(lib.quoin_result_get_solution_count(handle))]

    @property
    def collapse_interval(self) -> tuple[float | None, float | None]:
        """(least of the solutions, associative bound), which no equilibrium exceeds; None
        where one is not known."""
        ends = ffi.new("double[2]")
        lib.quoin_result_get_collapse_interval(self._handle, ends)
        return number(ends[0]), number(ends[1])

    @property
    def beyond_linear(self) -> bool:
        """Whether, in linear geometry, blocks moved farther than it holds for before the
        answer was settled."""
        return lib.quoin_result_is_beyond_linear(self._handle)

    @property
    def beyond_linear_multiplier(self) -> float | None:
        """The multiplier at which they did, or None."""
        return number(lib.quoin_result_get_beyond_linear_multiplier(self._handle))

    @property
    def events(self) -> list[dict[str, Value]]:
        """What happens as the load grows: dictionaries of "multiplier", "kind" ("local",
        "snap", "collapse"), "displacements" (largest before and after, m), "energy" set free
        (J) and "blocks" (numbers of those that move)."""
        return [self._event(i)
                for i in range(lib.quoin_result_get_event_count(self._handle))]

    def _event(self, i: int) -> dict[str, Value]:
        handle, ends, count = self._handle, ffi.new("double[2]"), ffi.new("size_t *")
        lib.quoin_result_get_event_displacements(handle, i, ends)
        blocks = lib.quoin_result_get_event_blocks(handle, i, count)
        return {
            "multiplier": lib.quoin_result_get_event_multiplier(handle, i),
            "kind": _library.text(lib.quoin_result_get_event_kind(handle, i)),
            "displacements": tuple(ends),
            "energy": lib.quoin_result_get_event_energy(handle, i),
            "blocks": ffi.unpack(blocks, count[0]) if count[0] > 0 else [],
        }

    @property
    def multipliers(self) -> Array:
        """(steps,): of every equilibrium; the first is the dead load alone."""
        return _library.array(lib.quoin_result_get_multipliers(self._handle),
                              (self._steps,), self._handle)

    @property
    def displacements(self) -> Array:
        """(steps, bodies, 3): ux, uy in m at the centroid, rz in rad."""
        return _library.array(lib.quoin_result_get_displacements(self._handle),
                              (self._steps, self._bodies, 3), self._handle)

    @property
    def mechanism(self) -> Array | None:
        """(bodies, 3): velocities, the largest displacement 1; None where there is none."""
        pointer = lib.quoin_result_get_mechanism(self._handle)
        return None if pointer == ffi.NULL \
            else _library.array(pointer, (self._bodies, 3), self._handle)

    @property
    def forces(self) -> Array:
        """(pairs, 2): normal (<= 0 in compression) and shear force at the last equilibrium, N."""
        count = lib.quoin_result_get_pair_count(self._handle)
        return _library.array(lib.quoin_result_get_forces(self._handle), (count, 2),
                              self._handle)

    @property
    def states(self) -> list[str]:
        """States of the contact pairs: "stick", "slip", "open", "yield"."""
        count = lib.quoin_result_get_pair_count(self._handle)
        return [_library.text(lib.quoin_result_get_pair_state(self._handle, i))
                for i in range(count)]

    @property
    def ties(self) -> list[list[dict[str, Value] | None]]:
        """Of every step, for every tie: {"force": N, "elongation": m, "state": ...}; None of a step
        that does not tell them."""
        count = lib.quoin_result_get_tie_count(self._handle)
        return [[self._tie(step, i) for i in range(count)] for step in range(self._steps)]

    def _tie(self, step: int, i: int) -> dict[str, Value] | None:
        numbers = ffi.new("double[2]")
        if not lib.quoin_result_get_tie(self._handle, step, i, numbers, numbers + 1):
            return None
        state = _library.text(lib.quoin_result_get_tie_state(self._handle, step, i))
        return {"force": numbers[0], "elongation": numbers[1], "state": state}

    @property
    def history(self) -> dict[str, Value] | None:
        """Of an analysis in time, None of others: `time` (rows,) in s; `ground` {"x", "y"} in m/s2
        and `energy` {"input", "kinetic", "elastic", "friction", "damping", "numerical"} in J, each
        (rows,); `tracks`, displacements of chosen blocks; `peak`, the largest displacement of every
        block; and the rest of the member "history" of data/result-format.md."""
        held = self._content.get("history")
        if held is None:
            return None
        history = {key: copy.deepcopy(value) for key, value in held.items()
                   if key not in ("time", "ground", "energy")}
        history["time"] = numpy.array(held["time"], float)
        for name in ("ground", "energy"):
            history[name] = {key: numpy.array(values, float)
                             for key, values in held[name].items()}
        return history

    @property
    def times(self) -> Array | None:
        """(steps,): of the kept steps of an analysis in time, s; None of others."""
        return self._of_steps("time")

    @property
    def velocities(self) -> Array | None:
        """(steps, bodies, 3) in m/s and rad/s, in time; None of others."""
        return self._of_steps("velocities")

    @property
    def supports(self) -> list[int]:
        """Numbers of the blocks that have fixed components."""
        return list(self._content.get("supports", []))

    @property
    def reactions(self) -> Array | None:
        """(steps, supports, 3): forces in N and moment about the centroid in N m that fixed
        components put on their block; None where a step does not tell them."""
        return self._of_steps("reactions")

    def _of_steps(self, key: str) -> Array | None:
        found = [step.get(key) for step in self._content["steps"]]
        return None if None in found or not found else numpy.array(found, float)

    @property
    def iterations(self) -> int:
        return lib.quoin_result_get_iterations(self._handle)

    @property
    def factorizations(self) -> int:
        return lib.quoin_result_get_factorizations(self._handle)

    @property
    def _steps(self) -> int:
        return lib.quoin_result_get_step_count(self._handle)

    @property
    def _bodies(self) -> int:
        return lib.quoin_result_get_body_count(self._handle)

    def _names(self) -> list[str]:
        model = lib.quoin_result_get_model(self._handle)
        return [_library.text(lib.quoin_model_get_block_name(model, i))
                for i in range(lib.quoin_model_get_block_count(model))]

    def to_dataframe(self) -> typing.Any:
        """A row for every step and block: step, multiplier, block, ux, uy (m), rz (rad)."""
        import pandas

        names = self._names()
        blocks, steps = len(names), self._steps
        moved = numpy.asarray(self.displacements)[:, :blocks, :].reshape(-1, 3)
        return pandas.DataFrame({
            "step": numpy.repeat(numpy.arange(steps), blocks),
            "multiplier": numpy.repeat(self.multipliers, blocks),
            "block": names * steps,
            "ux": moved[:, 0], "uy": moved[:, 1], "rz": moved[:, 2],
        })

    def plot(self, axes: typing.Any = None, block: str | None = None,
             component: str = "ux") -> typing.Any:
        """The multiplier over a displacement: of a block (name), or the largest of all.
        Returns the axes of matplotlib."""
        import matplotlib.pyplot

        axes = axes if axes is not None else matplotlib.pyplot.gca()
        column = ("ux", "uy", "rz").index(component)
        values = numpy.asarray(self.displacements)[:, :, column]
        if block is not None:
            if block not in self._names():
                raise ValueError(f"block: there is no {block!r}")
            shown = values[:, self._names().index(block)]
        else:
            shown = values[:, numpy.abs(values[-1]).argmax()]
        axes.plot(shown, self.multipliers, marker=".", markersize=3)
        unit = "rad" if component == "rz" else "m"
        axes.set_xlabel(f"{component} [{unit}]")
        axes.set_ylabel("load multiplier")
        return axes

    def save(self, path: Path) -> None:
        """Writes a result file."""
        _library.call(lib.quoin_result_write, self._handle, _library.encoded(path))

    def draw(self, view: str = "mechanism", path: Path | None = None,
             format: str | None = None, **options: Value) -> bytes | None:
        """Draws into a file by its ending, or returns the bytes of a format ("svg")."""
        model = lib.quoin_result_get_model(self._handle)
        return draw(model, [self], view, path, format, options)

    def animate(self, path: Path, view: str | None = None, size: str = "960x720",
                progress: ProgressFunc | None = None, **options: Value) -> None:
        """Moves the mechanism, or with view="deformed" the path: GIF, WebM, or pictures in FOLDER/.
        options: frames, rate (pictures per second), speed (of an analysis in time, 1 is real time),
        scale, once, curve=False, monochrome."""
        first = "mechanism" if self.mechanism is not None else "deformed"
        model = lib.quoin_result_get_model(self._handle)
        draw(model, [self], view or first, path, None, {"size": size, **options}, progress)

    def curve(self, path: Path | None = None, format: str = "svg",
              **options: Value) -> bytes | None:
        """Its load-displacement curve; see quoin.curve."""
        return curve([self], path, format, **options)

    def energy(self, path: Path | None = None, format: str = "svg",
               **options: Value) -> bytes | None:
        """The energies of an analysis in time, over its time."""
        return _sheet("energy", [self], path, format, options)

    def report(self, path: Path, **options: Value) -> None:
        """Writes a report on it as PDF; see Model.report."""
        self.model.report(path, [self], **options)

    def export(self, path: Path, **options: Value) -> None:
        """Writes it as DXF, PVD, or a table (.csv): table="curve", "displacements", "contacts",
        "beams" or "ties"; scale of displacements, unit of a DXF."""
        with cases.files(self.model, self) as arguments:
            cases.command("export", *arguments, "--output", path, *cases.options(**options))

    def __reduce__(self) -> tuple[Value, ...]:
        """As its file would be, with the model."""
        return _restore, (self.model, _library.owned(lib.quoin_result_to_text(self._handle)))

    def __copy__(self) -> Result:
        return self

    def __deepcopy__(self, _memo: Value) -> Result:
        return self

    def _repr_svg_(self) -> str:
        view = "mechanism" if self.mechanism is not None else "deformed"
        return (self.draw(view, format="svg", size="640x480") or b"").decode()

    def __repr__(self) -> str:
        return f"<quoin.Result {self.outcome}: multiplier {self.multiplier}>"


def _restore(model: Model, content: str) -> Result:
    data = content.encode()
    return Result(_library.call(lib.quoin_result_parse, model._handle, data, len(data),
                                b"result"))


class Modes:
    """Small vibrations: `omega` (n,) in rad/s and `shapes` (n, bodies, 3), largest displacement
    1 m; `masses` (n,) of the modes so scaled and `effective_masses` (n, 2) in x and y, in kg: those
    of all modes sum up to the mass that moves."""

    omega: Array
    shapes: Array
    masses: Array
    effective_masses: Array

    def __init__(self, handle: typing.Any) -> None:
        handle = ffi.gc(handle, lib.quoin_modes_free)
        count = lib.quoin_modes_get_count(handle)
        bodies = lib.quoin_modes_get_body_count(handle)
        self.omega = _library.array(lib.quoin_modes_get_omega(handle), (count,), handle)
        self.shapes = _library.array(lib.quoin_modes_get_shapes(handle), (count, bodies, 3),
                                     handle)
        masses = _library.array(lib.quoin_modes_get_masses(handle), (count, 3), handle)
        self.masses, self.effective_masses = masses[:, 0], masses[:, 1:]

    def damping(self, ratio: float) -> tuple[float, float]:
        """Rayleigh's coefficients of mass, 1/s, and of stiffness, s, that give the first mode that is
        no rigid motion and the last one this part of critical damping."""
        if not 0 <= ratio < 1:
            raise ValueError("ratio: is from 0 to less than 1")
        moving = self.omega[self.omega > 0]
        first, last = (moving[0], moving[-1]) if moving.size else (0.0, 0.0)
        stiffness = 2 * ratio / (first + last) if moving.size else 0.0
        return stiffness * first * last, stiffness
