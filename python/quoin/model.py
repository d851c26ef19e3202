"""Models: read from files, drawings and COMPAS assemblies, or built here."""

import json
import os
import typing

import numpy

from . import _library
from ._library import ffi, lib
from .result import Modes, Result, draw


class Block(typing.NamedTuple):
    """A rigid block. Numbers are SI."""

    name: str
    vertices: numpy.ndarray  #: (n, 2), m, counter-clockwise
    centroid: numpy.ndarray  #: (2,), m
    area: float  #: m2
    thickness: float  #: m
    weight: float  #: N
    fixed: tuple  #: (ux, uy, rz), whether each is supported


class Face(typing.NamedTuple):
    """A contact face between two blocks."""

    blocks: tuple  #: (a, b), numbers of the blocks
    ends: numpy.ndarray  #: (2, 2), m


def _plain(value):
    """Numbers and arrays of numpy as JSON takes them."""
    if isinstance(value, (numpy.generic, numpy.ndarray)):
        return value.tolist()
    raise TypeError(f"{type(value).__name__} is no value of a project")


def _value(value):
    """As after --set of the command line: JSON, or a plain string."""
    if isinstance(value, str):
        return value
    return json.dumps(value, default=_plain)


def _overrides(values):
    return _library.strings(f"{path}={_value(value)}" for path, value in values.items())


class Model:
    """A structure of blocks with its contact faces. Read-only: `set` gives another one."""

    def __init__(self, handle):
        self._handle = ffi.gc(handle, lib.quoin_model_unref)

    @property
    def title(self):
        return _library.text(lib.quoin_model_get_title(self._handle))

    @property
    def warnings(self):
        """What reading and detection found to be looked at: unknown keys, gaps, loose blocks."""
        count = lib.quoin_model_get_warning_count(self._handle)
        return [_library.text(lib.quoin_model_get_warning(self._handle, i))
                for i in range(count)]

    @property
    def blocks(self):
        """All blocks (list of Block), in the order of every array of a result."""
        return [self._block(i) for i in range(lib.quoin_model_get_block_count(self._handle))]

    def _block(self, i):
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
    def faces(self):
        """All contact faces (list of Face)."""
        a, b, ends = ffi.new("size_t *"), ffi.new("size_t *"), ffi.new("double[4]")
        faces = []
        for i in range(lib.quoin_model_get_face_count(self._handle)):
            lib.quoin_model_get_face_blocks(self._handle, i, a, b)
            lib.quoin_model_get_face_ends(self._handle, i, ends)
            faces.append(Face((a[0], b[0]), numpy.array(list(ends)).reshape(2, 2)))
        return faces

    @property
    def pair_faces(self):
        """(pairs,): the face of every contact pair."""
        count = lib.quoin_model_get_pair_count(self._handle)
        return numpy.array([lib.quoin_model_get_pair_face(self._handle, i)
                            for i in range(count)], dtype=int)

    def set(self, values=None, **by_name):
        """The same model with other values: model.set({"laws[0].friction": 0.5})."""
        given, _kept = _overrides({**(values or {}), **by_name})
        return Model(_library.call(lib.quoin_model_with, self._handle, given))

    def solve(self, progress=None):
        """Runs the analysis that the project names. `progress` (multiplier, steps, iterations)
        is called at every iteration, and cancels where it returns False. Other threads of
        Python run meanwhile."""
        return self._run(progress, lib.quoin_solve)

    def stability(self, progress=None):
        """Where the path first loses its stability: `first_limit_multiplier`, and the buckling
        mode as `mechanism`. Needs nonlinear geometry."""
        return self._run(progress, lib.quoin_stability)

    def limit(self, associative=True, progress=None):
        """Limit analysis of rigid blocks."""
        return self._run(progress, lib.quoin_limit, associative)

    def _run(self, progress, function, *arguments):
        handle = _library.Progress(progress).call(function, self._handle, *arguments)
        return Result(handle)

    def modal(self, count=6, loaded=False, progress=None):
        """The lowest frequencies and modes, about dead load or the last equilibrium."""
        handle = _library.Progress(progress).call(lib.quoin_modal, self._handle, count,
                                                  loaded)
        return Modes(handle)

    def read_result(self, path):
        """A result file of this model."""
        name = os.fspath(path).encode()
        return Result(_library.call(lib.quoin_result_read, self._handle, name))

    def save(self, path):
        """Writes a project file."""
        _library.call(lib.quoin_model_save, self._handle, os.fspath(path).encode())

    def to_dict(self):
        """The project file as a dictionary."""
        pointer = ffi.gc(lib.quoin_model_to_text(self._handle), lib.quoin_free)
        return json.loads(_library.text(pointer))

    def __reduce__(self):
        pointer = ffi.gc(lib.quoin_model_to_text(self._handle), lib.quoin_free)
        return _parse, (_library.text(pointer),)

    def to_polygons(self):
        """The blocks as polygons of shapely."""
        from shapely.geometry import Polygon

        return [Polygon(block.vertices) for block in self.blocks]

    def to_compas(self):
        """The blocks as an assembly of COMPAS: a dictionary to be written as JSON. Every block
        is a prism as deep as it is thick, seen along y, with z upwards."""
        nodes = {}
        for number, block in enumerate(self.blocks):
            corners = [[x, y, z] for y in (0.0, block.thickness)
                       for x, z in block.vertices.tolist()]
            n = len(block.vertices)
            faces = [list(range(n)), list(range(2 * n - 1, n - 1, -1))]
            faces += [[i, n + i, n + (i + 1) % n, (i + 1) % n] for i in range(n)]
            mesh = {
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

    def draw(self, view="model", path=None, format=None, **options):
        """Draws into a file by its ending, or returns the bytes of a format ("svg")."""
        return draw(self._handle, ffi.NULL, view, path, format, options)

    def _repr_svg_(self):
        return self.draw(format="svg", size="640x480").decode()

    def __repr__(self):
        blocks = lib.quoin_model_get_block_count(self._handle)
        faces = lib.quoin_model_get_face_count(self._handle)
        return f"<quoin.Model '{self.title}': {blocks} blocks, {faces} contact faces>"


def open(path, values=None):  # pylint: disable=redefined-builtin
    """Reads a project file; `values` override keys: {"analysis.increments": 37}."""
    given, _kept = _overrides(values or {})
    return Model(_library.call(lib.quoin_model_open, os.fspath(path).encode(), given))


def _parse(text, name="model", values=None):
    content = text.encode()
    given, _kept = _overrides(values or {})
    return Model(_library.call(lib.quoin_model_parse, content, len(content), name.encode(),
                               given))


def from_dict(project, name="model", values=None):
    """A model of a project file as a dictionary."""
    return _parse(json.dumps(project, default=_plain), name, values)


def read_drawing(path, unit=0.0, thickness=1.0, unit_weight=20000.0, friction=0.65):
    """Reads a drawing (DXF, SVG) or a COMPAS assembly (JSON). unit: m per unit of the drawing,
    0: as the file says."""
    return Model(_library.call(lib.quoin_model_import, os.fspath(path).encode(), unit,
                               thickness, unit_weight, friction))


def _project(title, friction, dilatancy, kn, live):
    return {
        "format": "quoin", "version": 1, "title": title,
        "laws": [{"name": "joint", "kind": "coulomb", "basis": "contact", "kn": kn, "ks": kn,
                  "friction": friction, "dilatancy": dilatancy}],
        "contact": {"law": "joint"},
        "loads": {"dead": [{"kind": "weight", "direction": [0, -1]}],
                  "live": [{"kind": "weight", "direction": list(live)}]},
    }


def wall(courses, unit=(0.4, 0.175), thickness=1.0, unit_weight=10000.0, friction=0.65,
         dilatancy=0.0, kn=1e7, live=(1, 0), title="Wall"):
    """A wall on a fixed base. courses: from the bottom, lengths in multiples of unit[0],
    negative: an opening. unit: length and height of a full block, m. live: horizontal and
    vertical load per weight."""
    courses = [list(course) for course in courses]
    if not courses or not all(courses):
        raise ValueError("courses: a wall has one course or more, each of one block or more")
    length = max(sum(abs(part) for part in course) for course in courses) * unit[0]
    project = _project(title, friction, dilatancy, kn, live)
    project["blocks"] = [{
        "name": "base", "thickness": thickness, "unit_weight": unit_weight,
        "vertices": [[0, -unit[1]], [length, -unit[1]], [length, 0], [0, 0]],
        "support": [True, True, True]}]
    project["walls"] = [{
        "name": "w", "origin": [0, 0], "unit": list(unit), "thickness": thickness,
        "unit_weight": unit_weight, "courses": courses}]
    return from_dict(project, title)


def _numbers(supports, count):
    """The numbers of blocks that a list of numbers or a mask means."""
    supports = list(supports)
    if supports and all(isinstance(entry, (bool, numpy.bool_)) for entry in supports):
        if len(supports) != count:
            raise ValueError(f"supports: a mask of {len(supports)} for {count} blocks")
        return {number for number, fixed in enumerate(supports) if fixed}
    for entry in supports:
        if isinstance(entry, (bool, numpy.bool_)) \
                or not isinstance(entry, (int, numpy.integer)):
            raise TypeError("supports: expected numbers of blocks, or whether each is fixed")
        if not 0 <= entry < count:
            raise IndexError(f"supports: there is no block {entry} of {count}")
    return {int(entry) for entry in supports}


def from_polygons(polygons, supports, thickness=1.0, unit_weight=20000.0, friction=0.65,
                  dilatancy=0.0, kn=1e7, live=(1, 0), title="Blocks"):
    """A model of polygons: of shapely, or arrays (n, 2) in m, closed or not. supports: numbers of
    those that are fixed, or for each whether it is."""
    polygons = list(polygons)
    if not polygons:
        raise ValueError("polygons: there is none")
    fixed = _numbers(supports, len(polygons))
    project = _project(title, friction, dilatancy, kn, live)
    project["blocks"] = []
    for number, polygon in enumerate(polygons):
        if hasattr(polygon, "exterior"):
            if len(polygon.interiors) > 0:
                raise ValueError(f"polygons[{number}]: a block has no holes")
            corners = numpy.asarray(polygon.exterior.coords)[:-1, :2]
        else:
            corners = numpy.asarray(polygon, dtype=float)
            if corners.ndim != 2 or corners.shape[1] != 2:
                raise ValueError(f"polygons[{number}]: expected corners (n, 2)")
            if len(corners) > 3 and (corners[0] == corners[-1]).all():
                corners = corners[:-1]
        block = {"name": f"b{number}", "vertices": corners.tolist(), "thickness": thickness,
                 "unit_weight": unit_weight}
        if number in fixed:
            block["support"] = [True, True, True]
        project["blocks"].append(block)
    return from_dict(project, title)
