"""Models: read from files, drawings and COMPAS assemblies, generated, or built here."""

from __future__ import annotations

import io
import json
import os
import typing

import numpy
import numpy.typing

from . import _library, cases
from ._library import Array, Path, ProgressFunc, Value, ffi, lib
from .cases import Study
from .result import Modes, Result, draw

#: Values by their path in the project file: {"laws[0].friction": 0.5}.
Values = typing.Mapping[str, Value]


class Block(typing.NamedTuple):
    """A rigid block. Numbers are SI."""

    name: str
    vertices: Array  #: (n, 2), m, counter-clockwise
    centroid: Array  #: (2,), m
    area: float  #: m2
    thickness: float  #: m
    weight: float  #: N
    fixed: tuple[bool, ...]  #: (ux, uy, rz), whether each is supported


class Face(typing.NamedTuple):
    """A contact face between two blocks."""

    blocks: tuple[int, int]  #: (a, b), numbers of the blocks
    ends: Array  #: (2, 2), m


def _value(value: Value) -> str:
    """As after --set of the command line: JSON, or a plain string."""
    try:
        return value if isinstance(value, str) else _library.dumps(value, allow_nan=False)
    except ValueError as error:
        raise ValueError(f"{value!r}: number is not finite") from error


def _overrides(values: Values | None) -> tuple[typing.Any, typing.Any]:
    given = (values or {}).items()
    return _library.strings(f"{path}={_value(value)}" for path, value in given)


class Model:
    """A structure of blocks with its contact faces. Read-only: `set` gives another one."""

    #: What reading a drawing has found, repaired and left out: a line each.
    import_report: list[str]

    def __init__(self, handle: typing.Any, import_report: list[str] | None = None) -> None:
        self._handle = ffi.gc(handle, lib.quoin_model_unref)
        self.import_report = import_report or []

    @property
    def title(self) -> str:
        return _library.text(lib.quoin_model_get_title(self._handle))

    @property
    def path(self) -> str:
        """The name of its file; files that the project names lie beside it."""
        return _library.text(lib.quoin_model_get_path(self._handle))

    @property
    def overrides(self) -> list[str]:
        """Values that were set after it was read, as of --set: "laws[0].friction=0.5"."""
        found: list[str] = []
        while override := _library.text(
                lib.quoin_model_get_override(self._handle, len(found))):
            found.append(override)
        return found

    def _source(self) -> bytes:
        length = ffi.new("size_t *")
        source = lib.quoin_model_get_source(self._handle, length)
        return bytes(ffi.buffer(source, length[0]))

    @property
    def is_of_file(self) -> bool:
        """Whether the file of its path has what it was read from."""
        try:
            with io.open(self.path, "rb") as file:
                return file.read() == self._source()
        except OSError:
            return False

    @property
    def warnings(self) -> list[str]:
        """What reading and detection found to be looked at: unknown keys, gaps, loose blocks."""
        count = lib.quoin_model_get_warning_count(self._handle)
        return [_library.text(lib.quoin_model_get_warning(self._handle, i))
                for i in range(count)]

    @property
    def blocks(self) -> list[Block]:
        """All blocks, in the order of every array of a result."""
        return [self._block(i) for i in range(lib.quoin_model_get_block_count(self._handle))]

    def _block(self, i: int) -> Block:
        count = ffi.new("size_t *")
        vertices = lib.quoin_model_get_block_vertices(self._handle, i, count)
        centroid = lib.quoin_model_get_block_centroid(self._handle, i)
        return Block(
            _library.text(lib.quoin_model_get_block_name(self._handle, i)),
            _library.array(vertices, (count[0], 2), self._handle),
            _library.array(centroid, (2,), self._handle),
            lib.quoin_model_get_block_area(self._handle, i),
            lib.quoin_model_get_block_thickness(self._handle, i),
            lib.quoin_model_get_block_weight(self._handle, i),
            tuple(lib.quoin_model_is_block_fixed(self._handle, i, dof) for dof in range(3)),
        )

    @property
    def faces(self) -> list[Face]:
        """All contact faces."""
        a, b, ends = ffi.new("size_t *"), ffi.new("size_t *"), ffi.new("double[4]")
        faces = []
        for i in range(lib.quoin_model_get_face_count(self._handle)):
            lib.quoin_model_get_face_blocks(self._handle, i, a, b)
            lib.quoin_model_get_face_ends(self._handle, i, ends)
            faces.append(Face((a[0], b[0]), numpy.array(list(ends)).reshape(2, 2)))
        return faces

    @property
    def pair_faces(self) -> numpy.typing.NDArray[numpy.int_]:
        """(pairs,): the face of every contact pair."""
        count = lib.quoin_model_get_pair_count(self._handle)
        return numpy.array([lib.quoin_model_get_pair_face(self._handle, i)
                            for i in range(count)], dtype=int)

    def check(self) -> dict[str, Value]:
        """Blocks, faces, pairs, loads and findings, whether the model is sound: keys as in
        data/check-format.md."""
        return json.loads(_library.owned(lib.quoin_model_check(self._handle)))

    def set(self, values: Values | None = None, **by_name: Value) -> Model:
        """The same model with other values: model.set({"laws[0].friction": 0.5})."""
        given, _kept = _overrides({**(values or {}), **by_name})
        return Model(_library.call(lib.quoin_model_with, self._handle, given))

    def solve(self, progress: ProgressFunc | None = None) -> Result:
        """Runs the analysis that the project names. `progress` is called at every iteration with
        a Progress, and cancels where it returns False. Other threads of Python run meanwhile."""
        return Result(_library.watched(progress, lib.quoin_solve, self._handle))

    def stability(self, progress: ProgressFunc | None = None) -> Result:
        """Where the path first loses its stability: `first_limit_multiplier`, and the buckling
        mode as `mechanism`. Needs nonlinear geometry."""
        return Result(_library.watched(progress, lib.quoin_stability, self._handle))

    def limit(self, associative: bool = True, progress: ProgressFunc | None = None) -> Result:
        """Limit analysis of rigid blocks."""
        return Result(_library.watched(progress, lib.quoin_limit, self._handle, associative))

    def modal(self, count: int = 6, loaded: bool = False, slip: bool = False,
              progress: ProgressFunc | None = None) -> Modes:
        """The lowest frequencies and modes, about dead load or the last equilibrium. Closed joints are
        elastic; with `slip` those that slide have their tangent stiffness."""
        function = lib.quoin_modal_sliding if slip else lib.quoin_modal
        return Modes(_library.watched(progress, function, self._handle, count, loaded))

    def read_result(self, path: Path) -> Result:
        """A result file of this model. Values that it was computed with, as of --set, are those of
        the result's model. A ChangedWarning where the project was another one then."""
        handle = _library.call(lib.quoin_result_read, self._handle, _library.encoded(path))
        result = Result(handle)
        result.warn_if_changed(os.fspath(path))
        return result

    def save(self, path: Path) -> None:
        """Writes a project file."""
        _library.call(lib.quoin_model_save, self._handle, _library.encoded(path))

    def to_dict(self) -> dict[str, Value]:
        """The project file as a dictionary."""
        return json.loads(_library.owned(lib.quoin_model_to_text(self._handle)))

    def __copy__(self) -> Model:
        return self

    def __deepcopy__(self, _memo: Value) -> Model:
        return self

    def __reduce__(self) -> tuple[Value, ...]:
        """As it was read, with the place of its file."""
        return _restore, (self._source(), os.path.abspath(self.path), self.overrides,
                          self.import_report)

    def to_polygons(self) -> list[typing.Any]:
        """The blocks as polygons of shapely."""
        from shapely.geometry import Polygon

        return [Polygon(block.vertices) for block in self.blocks]

    def to_compas(self) -> dict[str, Value]:
        """The blocks as an assembly of COMPAS: a dictionary to be written as JSON. Every block
        is a prism as deep as it is thick, seen along y, with z upwards. Its `density` is kg/m3."""
        gravity = self.to_dict().get("gravity", 9.81)
        nodes = {}
        for number, block in enumerate(self.blocks):
            corners = [[float(x), y, float(z)] for y in (0.0, block.thickness)
                       for x, z in block.vertices]
            n = len(block.vertices)
            faces = [list(range(n)), list(range(2 * n - 1, n - 1, -1))]
            faces += [[i, n + i, n + (i + 1) % n, (i + 1) % n] for i in range(n)]
            mesh = {
                "attributes": {
                    "name": block.name,
                    "density": block.weight / (block.area * block.thickness) / gravity},
                "vertex": {str(i): dict(zip("xyz", c)) for i, c in enumerate(corners)},
                "face": {str(i): face for i, face in enumerate(faces)},
            }
            nodes[str(number)] = {
                "block": {"dtype": "compas_assembly.datastructures/Block", "data": mesh},
                "is_support": all(block.fixed),
            }
        graph = {"node": nodes, "edge": {}, "adjacency": {}}
        return {"dtype": "compas_assembly.datastructures/Assembly",
                "data": {"graph": {"dtype": "compas.datastructures/Graph", "data": graph}}}

    def capacity(self, spectrum: Path | None = None, ag: float | str | None = None,
                 soil: str | None = None, damping: float | None = None,
                 unit: str | None = None, confidence: float | None = None,
                 control: str | None = None, picture: Path | None = None,
                 progress: ProgressFunc | None = None,
                 mechanism: bool | None = None, **more: Value) -> dict[str, Value]:
        """The capacity curve, and the displacement checks of EN 1998-3 and NTC 2018, as
        `quoin-cli capacity --json` writes them. spectrum: "type1", "type2" with `ag` (m/s2, or
        "0.25g") and `soil`, or a table of period and acceleration with `unit`; what is not given is
        the project's. mechanism: the kinematic curve of what limit analysis finds, not the path.
        picture: PNG, SVG, PDF or CSV of the curve. More options of the command line by their names:
        tie_strain, part_period, height, building_height, storeys, building_period."""
        given = {"spectrum": spectrum, "ag": ag, "soil": soil, "damping": damping,
                 "unit": unit, "confidence": confidence, "control": control,
                 "mechanism": mechanism if mechanism is None else str(mechanism).lower(),
                 **{name.replace("_", "-"): value for name, value in more.items()}}
        options, _kept = _library.strings(
            f"{name}={value}" for name, value in given.items() if value is not None)
        place = ffi.NULL if picture is None else ffi.new("char[]", _library.encoded(picture))
        return json.loads(_library.owned(
            _library.watched(progress, lib.quoin_capacity, self._handle, options, place)))

    def study(self, parameters: typing.Sequence[typing.Mapping[str, Value]],
              outputs: typing.Sequence[str], folder: Path, run: str = "solve",
              plan: typing.Mapping[str, Value] | None = None, jobs: int | None = None,
              progress: ProgressFunc | None = None, **members: Value) -> Study:
        """Computes many cases on all cores: members as of a study file, "parameters" with "name",
        "path" and "values", "range" or a distribution, plan {"kind": "grid"} where none is given.
        Cases that are in the folder already are not computed again."""
        return cases.study_of(self, parameters, outputs, folder, run,
                              plan or {"kind": "grid"}, jobs, progress, members)

    def ida(self, records: typing.Sequence[Path], scale: tuple[float, float, float],
            folder: Path, picture: Path | None = None, unit: str | None = None,
            time_step: float | None = None, jobs: int | None = None,
            progress: ProgressFunc | None = None) -> list[cases.Row]:
        """Incremental dynamic analysis: every record at every factor, (least, greatest, step). A row
        for each with record, scale, peaks and whether it overturned."""
        return cases.ida(self, records, scale, folder, picture, progress,
                         {"unit": unit, "time_step": time_step, "jobs": jobs})

    def export(self, path: Path, **options: Value) -> None:
        """Writes the blocks as DXF, PVD, or a project of plain polygons, by the ending."""
        with cases.files(self) as arguments:
            cases.command("export", *arguments, "--output", path, *cases.options(**options))

    def report(self, path: Path, results: typing.Sequence[Result] | None = None,
               progress: ProgressFunc | None = None, **options: Value) -> None:
        """Writes a report as PDF on the model and results of it; solves it where none are given.
        options: paper "a4" or "letter", sections=["model", "results"], demand=0.3."""
        draw(self._handle, [self.solve(progress)] if results is None else results, "report", path,
             None, options)

    def figures(self, folder: Path, names: typing.Sequence[str] = ()) -> list[str]:
        """Makes the figures that the project keeps, and gives their files."""
        with cases.files(self) as arguments:
            made = cases.command("figures", *arguments, "--output", folder,
                                 *cases.options(figure=list(names)))
        return made.splitlines()

    def draw(self, view: str = "model", path: Path | None = None, format: str | None = None,
             **options: Value) -> bytes | None:
        """Draws into a file by its ending, or returns the bytes of a format ("svg")."""
        return draw(self._handle, [], view, path, format, options)

    def _repr_svg_(self) -> str:
        return (self.draw(format="svg", size="640x480") or b"").decode()

    def __repr__(self) -> str:
        blocks = lib.quoin_model_get_block_count(self._handle)
        faces = lib.quoin_model_get_face_count(self._handle)
        return f"<quoin.Model '{self.title}': {blocks} blocks, {faces} contact faces>"


def open(path: Path, values: Values | None = None) -> Model:
    """Reads a project file; `values` override keys: {"analysis.increments": 37}."""
    given, _kept = _overrides(values)
    return Model(_library.call(lib.quoin_model_open, _library.encoded(path), given))


def _restore(content: bytes, path: str, overrides: list[str], import_report: list[str]) -> Model:
    given, _kept = _library.strings(overrides)
    return Model(_library.call(lib.quoin_model_parse, content, len(content), path.encode(),
                               given), import_report)


def from_dict(project: typing.Mapping[str, Value], name: str = "model",
              values: Values | None = None) -> Model:
    """A model of a project file as a dictionary. name: stands for the file in messages; files
    that the project names lie beside it."""
    content = _library.dumps(project).encode()
    given, _kept = _overrides(values)
    return Model(_library.call(lib.quoin_model_parse, content, len(content), name.encode(),
                               given))


def read_drawing(path: Path, unit: float | str = 0.0, thickness: float = 1.0,
                 unit_weight: float = 20000.0, friction: float = 0.65, *,
                 tolerance: float = 0.0, layers: typing.Mapping[str, str] | None = None,
                 close_joints: float | None = None,
                 mortar_joints: float | None = None) -> Model:
    """Reads a drawing (DXF, SVG, text of HybriDFEM) or a COMPAS assembly (JSON, OBJ). unit: m per
    unit of the drawing, or "mm", "in" …; 0: as the file says. layers: {"VAULT*": "block"}, with
    "block", "support", "opening" or "ignored". close_joints, mortar_joints: joints of mortar up to
    this width, m (0: automatic), are closed, or filled with blocks of mortar. The model's
    `import_report` says what was found, repaired and left out, that of an error what was by then."""
    number = _library.dumps
    options = [f"thickness={number(thickness)}", f"unit-weight={number(unit_weight)}",
               f"friction={number(friction)}", f"tolerance={number(tolerance)}"]
    if unit:
        options.append(f"unit={unit}")
    for option, width in (("close-joints", close_joints), ("mortar-joints", mortar_joints)):
        if width is not None:
            options.append(f"{option}={number(width)}")
    options += [f"layer={name}={role}" for name, role in (layers or {}).items()]
    given, _kept = _library.strings(options)
    told = ffi.new("char **")
    try:
        handle = _library.call(lib.quoin_model_import_with, _library.encoded(path), given, told)
    except _library.Error as error:
        error.import_report = _library.owned(told[0]).splitlines()
        raise
    return Model(handle, _library.owned(told[0]).splitlines())


def generate(kind: str, friction: float = 0.65, title: str | None = None,
             **members: Value) -> Model:
    """Parametric masonry with its defaults: "wall", "arch", "column", "buttress", "portal",
    "rubble", "grid", "voronoi". members: of the object in the project file, as length=6,
    unit=[0.4, 0.2], bond="english"."""
    given, _kept = _library.strings(f"{key}={_value(value)}" for key, value in members.items())
    model = Model(_library.call(lib.quoin_model_generate, kind.encode(), given, friction))
    return model if title is None else model.set({"title": json.dumps(title)})


def _begin(title: str, friction: float, dilatancy: float, kn: float | None,
           live: typing.Sequence[float], geometry: str) -> dict[str, Value]:
    """What a new drawing has, with these values."""
    project = Model(_library.call(lib.quoin_model_new)).to_dict()
    law = project["laws"][0]
    law.update(friction=friction, dilatancy=dilatancy)
    if kn is not None:
        law.update(basis="contact", kn=kn, ks=kn)
    project["title"] = title
    project["loads"]["live"][0]["direction"] = list(live)
    project["analysis"]["geometry"] = geometry
    return project


def wall(courses: typing.Iterable[typing.Iterable[float]],
         unit: tuple[float, float] = (0.4, 0.2), thickness: float = 1.0,
         unit_weight: float = 20000.0, friction: float = 0.65, dilatancy: float = 0.0,
         kn: float | None = None, live: typing.Sequence[float] = (1, 0),
         title: str = "Wall", geometry: str = "nonlinear") -> Model:
    """A wall on a fixed base. courses: from the bottom, lengths in multiples of unit[0],
    negative: an opening. unit: length and height of a full block, m. kn: N/m of each contact pair;
    None: joints as of new drawings. live: horizontal and vertical load per weight."""
    try:
        rows = [[float(part) for part in course] for course in courses]
    except (TypeError, ValueError) as error:
        raise TypeError("courses: expected lists of lengths") from error
    if not rows or not all(rows):
        raise ValueError("courses: a wall has one course or more, each of one block or more")
    length = max(sum(abs(part) for part in row) for row in rows) * unit[0]
    project = _begin(title, friction, dilatancy, kn, live, geometry)
    project["blocks"] = [{
        "name": "base", "thickness": thickness, "unit_weight": unit_weight,
        "vertices": [[0, -unit[1]], [length, -unit[1]], [length, 0], [0, 0]],
        "support": [True, True, True]}]
    project["walls"] = [{
        "name": "w", "origin": [0, 0], "unit": list(unit), "thickness": thickness,
        "unit_weight": unit_weight, "courses": rows}]
    return from_dict(project, title)


def _numbers(supports: typing.Iterable[typing.Any], count: int) -> set[int]:
    """The numbers of blocks that a list of numbers or a mask means."""
    try:
        entries = list(supports)
    except TypeError:
        entries = [None]  # said below
    if entries and all(isinstance(entry, (bool, numpy.bool_)) for entry in entries):
        if len(entries) != count:
            raise ValueError(f"supports: a mask of {len(entries)} for {count} blocks")
        return {number for number, fixed in enumerate(entries) if fixed}
    for entry in entries:
        if isinstance(entry, (bool, numpy.bool_)) \
                or not isinstance(entry, (int, numpy.integer)):
            raise TypeError("supports: expected numbers of blocks, or whether each is fixed")
        if not 0 <= entry < count:
            raise IndexError(f"supports: there is no block {entry} of {count}")
    if len(set(entries)) < len(entries):
        raise ValueError("supports: a block is there twice; a mask has values of bool")
    return {int(entry) for entry in entries}


def _corners(polygon: typing.Any, number: int) -> Array:
    """The corners of a polygon of shapely, or of an array, open."""
    if hasattr(polygon, "exterior"):
        if len(polygon.interiors) > 0:
            raise ValueError(f"polygons[{number}]: a block has no holes")
        polygon = polygon.exterior.coords
    corners = numpy.asarray(polygon)
    if numpy.any(getattr(polygon, "mask", False)):
        raise ValueError(f"polygons[{number}]: some of its corners are masked")
    if corners.ndim != 2 or corners.shape[1] not in (2, 3) or numpy.iscomplexobj(corners):
        raise ValueError(f"polygons[{number}]: expected corners (n, 2)")
    corners = corners.astype(float)
    if (corners[:, 2:] != corners[:1, 2:]).any():
        raise ValueError(f"polygons[{number}]: does not lie in a plane of equal z")
    closed = len(corners) > 3 and (corners[0] == corners[-1]).all()
    return corners[:-1, :2] if closed else corners[:, :2]


def from_polygons(polygons: typing.Iterable[typing.Any], supports: typing.Iterable[typing.Any],
                  thickness: float = 1.0, unit_weight: float = 20000.0, friction: float = 0.65,
                  dilatancy: float = 0.0, kn: float | None = None,
                  live: typing.Sequence[float] = (1, 0), title: str = "Blocks",
                  geometry: str = "linear") -> Model:
    """A model of polygons: of shapely, or arrays (n, 2) in m, closed or not. supports: numbers of
    those that are fixed, or for each whether it is. kn: as of `wall`. All else is as of new drawings
    too, but for the geometry."""
    polygons = list(polygons)
    if not polygons:
        raise ValueError("polygons: there is none")
    fixed = _numbers(supports, len(polygons))
    project = _begin(title, friction, dilatancy, kn, live, geometry)
    project["blocks"] = [
        {"name": f"b{number}", "vertices": _corners(polygon, number).tolist(),
         "thickness": thickness, "unit_weight": unit_weight, "support": [number in fixed] * 3}
        for number, polygon in enumerate(polygons)]
    return from_dict(project, title)
