"""The Python package over libquoin; run with QUOIN_LIBRARY, QUOIN_HEADER and QUOIN_EXAMPLES set."""

import copy
import gc
import json
import os
import pathlib
import pickle
import threading
import warnings

import numpy
import pytest

import quoin

EXAMPLES = pathlib.Path(os.environ["QUOIN_EXAMPLES"])
WALLS = EXAMPLES / "ferris-tin-loi"


def test_wall_of_a_file():
    model = quoin.open(WALLS / "wall3.quoin")
    assert (len(model.blocks), len(model.faces)) == (47, 102)
    assert model.blocks[0].fixed == (True, True, True)
    assert len(model.pair_faces) == 204
    result = model.solve()
    assert result.outcome == "collapse"
    assert result.multiplier == pytest.approx(0.356, abs=0.002)
    assert result.displacements.shape == (len(result.multipliers), 47, 3)
    assert result.mechanism.shape == (47, 3)
    assert result.bounds is None
    assert len(result.states) == len(result.forces) == 204


def test_records_and_free_modes():
    """As the command line: a record is read with its project, and what stands free vibrates."""
    shaken = quoin.open(EXAMPLES / "43-shaken-wall.quoin",
                        values={"analysis.dynamic.ground[0].record": "none.csv"})
    with pytest.raises(quoin.FileError, match="none.csv"):
        shaken.solve()
    omega = quoin.open(EXAMPLES / "25-four-bricks.quoin").modal(4).omega
    assert omega[2] < 1e-3 * omega[3]
    assert omega[3] / (2 * numpy.pi) == pytest.approx(2402.27, abs=0.01)


def test_ties():
    result = quoin.open(WALLS.parent / "38-tied-walls.quoin").solve()
    assert result.ties[0][0]["force"] == pytest.approx(1000)
    assert result.ties[-1][0]["force"] == pytest.approx(4500)
    assert result.ties[-1][0]["state"] == "anchor"
    rigid = quoin.open(WALLS.parent / "38-tied-walls.quoin").limit()
    assert rigid.ties[0] == [None]


def test_what_an_answer_is_worth():
    result = quoin.open(WALLS / "wall3.quoin").solve()
    assert min(s["multiplier"] for s in result.solutions) == result.multiplier
    assert result.solutions[0]["found_by"] == "work"
    assert result.solutions[0]["displacement"] > 0
    least, bound = result.collapse_interval
    assert least == result.multiplier < bound
    assert result.beyond_linear == (result.beyond_linear_multiplier is not None)
    collapse = result.events[-1]
    assert (collapse["kind"], collapse["multiplier"]) == ("collapse", result.multiplier)
    assert 0 < collapse["displacements"][0] < collapse["displacements"][1]
    assert collapse["energy"] >= 0 and len(collapse["blocks"]) > 0
    rigid = quoin.open(WALLS / "wall1.quoin").limit()
    assert rigid.events == [] and not rigid.beyond_linear
    assert [s["displacement"] for s in rigid.solutions] == [None]


def test_overrides_leave_the_model():
    model = quoin.open(WALLS / "wall1.quoin")
    less = model.set({"laws[0].friction": 0.5})
    assert less.to_dict()["laws"][0]["friction"] == 0.5
    assert model.to_dict()["laws"][0]["friction"] == 0.65
    lower, upper = model.limit().bounds
    assert lower == pytest.approx(0.64285900, abs=1e-6) and lower <= upper
    assert less.limit().bounds[1] < lower


def test_a_misspelt_key_is_no_answer():
    model = quoin.open(WALLS / "wall1.quoin")
    for key in ("laws[0].frictoin", "laws[1].friction", "analysis.incrments", "laws[0].yield"):
        with pytest.raises(quoin.UsageError) as caught:
            model.set({key: 0.5})
        assert key in str(caught.value)
        with pytest.raises(quoin.UsageError):
            quoin.open(WALLS / "wall1.quoin", {key: 0.5})


def test_loads_on_edges_and_factors_of_cases():
    path = EXAMPLES / "27-retaining-wall.quoin"
    for factor in (0, 1.5):
        push = (18000 * 3**3 / 6 + factor * 10000 * 3**2 / 2) / 3
        result = quoin.open(path, {"loads.cases.traffic": factor}).solve()
        assert result.multiplier == pytest.approx(24000 * 1.2 * 3 * 0.6 / push, rel=1e-3)


def test_errors_name_the_place():
    project = quoin.open(WALLS / "wall1.quoin").to_dict()
    project["laws"][0]["kn"] = -1
    with pytest.raises(quoin.InvalidError) as caught:
        quoin.from_dict(project, "mine")
    assert caught.value.key == "laws[0].kn"
    assert caught.value.file == "mine" and caught.value.line == 1
    with pytest.raises(quoin.FileError):
        quoin.open("/no/such/file.quoin")
    with pytest.raises(OSError):
        quoin.open("/no/such/file.quoin")
    with pytest.raises(quoin.UsageError):
        quoin.open(WALLS / "wall1.quoin").draw("no-such-view")


def test_wall_equals_the_example():
    even, odd = [0.5, 1, 1, 1, 1, 0.5], [1, 1, 1, 1, 1]
    built = quoin.wall([even, odd, even, odd, even, odd], unit=(0.4, 0.175), unit_weight=10000,
                       kn=1e7)
    drawn = quoin.open(WALLS / "wall1.quoin")
    assert built.limit().multiplier == drawn.limit().multiplier


def test_arrays_outlive_their_result():
    result = quoin.open(WALLS / "wall1.quoin").solve()
    view = result.displacements
    copy = numpy.array(view)
    assert not view.flags.writeable
    assert not view.flags.owndata
    del result
    gc.collect()
    assert (view == copy).all()


def test_one_set_of_defaults():
    """A wall, polygons, generated masonry and a drawing have the joints, loads and settings of new
    drawings, and the same blocks where one says the same."""
    models = [quoin.wall([[1, 1]]), quoin.from_polygons(SQUARES, [0], geometry="nonlinear"),
              quoin.generate("wall"),
              quoin.read_drawing(EXAMPLES / "dxf" / "wall-clean.dxf")]
    projects = [model.to_dict() for model in models]
    for key in ("laws", "contact", "analysis"):
        assert len({json.dumps(project[key]) for project in projects}) == 1
    for project in projects:
        assert project["loads"] == projects[0]["loads"]
    brick, generated = models[0].blocks[1], models[2].blocks[1]
    assert brick[3:6] == pytest.approx(generated[3:6])  # area, thickness, weight
    assert quoin.wall([[1]], kn=1e7).to_dict()["laws"][0]["basis"] == "contact"


def test_generate():
    arch = quoin.generate("arch", span=3, rise=1.5, voussoirs=11, friction=0.8, title="An \"arch\"")
    assert arch.title == "An \"arch\"" and len(arch.blocks) == 13
    assert arch.to_dict()["laws"][0]["friction"] == 0.8
    assert quoin.generate("wall", unit="0.5x0.25", bond="english").check()["sound"]
    with pytest.raises(quoin.UsageError, match="tower"):
        quoin.generate("tower")
    with pytest.raises(quoin.UsageError, match="lenth"):
        quoin.generate("wall", lenth=3)
    with pytest.raises(quoin.InvalidError, match="length"):
        quoin.generate("wall", length=-3)


def test_check_says_what_is_wrong():
    sound = quoin.open(WALLS / "wall1.quoin").check()
    assert sound["sound"] and len(sound["faces"]) == 83 and sound["findings"] == []
    apart = [SQUARES[0], [(x, y + 2e-3) for x, y in SQUARES[1]]]
    loose = quoin.from_polygons(apart, [0])
    findings = loose.check()["findings"]
    assert not loose.check()["sound"]
    assert {finding["problem"] for finding in findings} >= {"near-miss-gap"}
    assert all(finding["text"] in loose.warnings for finding in findings)


def test_drawings_are_read_with_a_report(tmp_path):
    mortar = EXAMPLES / "dxf" / "wall-mortar.dxf"
    closed = quoin.read_drawing(mortar, close_joints=0.02)
    assert any("joints of mortar" in line for line in closed.import_report)
    assert len(quoin.read_drawing(mortar, mortar_joints=0.02).blocks) > len(closed.blocks)
    ignored = quoin.read_drawing(mortar, unit="mm", layers={"SUP*": "ignored"})
    assert len(ignored.blocks) == len(closed.blocks) - 1
    for wrong in ({"unit": "parsec"}, {"layers": {"NONE": "block"}}, {"tolerance": -1},
                  {"close_joints": 0.01, "mortar_joints": 0.01}, {"friction": float("nan")}):
        with pytest.raises(quoin.UsageError):
            quoin.read_drawing(mortar, **wrong)
    empty = tmp_path / "empty.svg"
    empty.write_text('<svg xmlns="http://www.w3.org/2000/svg"><text x="1" y="1">no</text></svg>')
    with pytest.raises(quoin.InvalidError) as caught:
        quoin.read_drawing(empty)
    assert caught.value.import_report != []


def test_progress_runs_once_from_0_to_1():
    """It never goes back, ends with 1, and tells the path from its bound; in time it is exact."""
    wall = quoin.open(WALLS / "wall1.quoin")
    told = []
    result = wall.solve(told.append)
    done = [state.done for state in told]
    assert done[0] == 0 and done[-1] == 1 and done == sorted(done) and done.count(1) == 1
    assert [state.what for state in told][0] == "path"
    assert {state.what for state in told} == {"path", "limit analysis"}
    assert told[-1].reached == pytest.approx(result.multiplier, rel=1e-3)
    assert [s.reached for s in told] == sorted(s.reached for s in told)
    told.clear()
    wall.limit(progress=told.append)
    assert {state.what for state in told} == {"limit analysis"} and told[-1].done == 1
    told.clear()
    wall.modal(2, progress=told.append)
    assert {state.what for state in told} == {"modes"} and told[-1].done == 1
    told.clear()
    rocking = quoin.open(EXAMPLES / "40-rocking-in-time.quoin",
                         {"analysis.dynamic.duration": 0.1})
    rocking.solve(told.append)
    assert {state.what for state in told} == {"time"}
    assert all(s.done == pytest.approx(s.reached / 0.1) for s in told[:-1])


def test_progress_cancels_and_raises():
    model = quoin.open(WALLS / "wall6.quoin")
    calls = []
    result = model.solve(lambda *arguments: calls.append(arguments) or len(calls) < 3)
    assert result.outcome == "cancelled" and len(calls) == 3

    def fail(*_arguments):
        raise KeyError("mine")

    with pytest.raises(KeyError, match="mine"):
        model.solve(fail)


def test_other_threads_run_meanwhile():
    """A callback waits for another thread of Python, which could not run under the lock."""
    ran, started = threading.Event(), threading.Event()

    def other():
        started.wait()
        ran.set()

    thread = threading.Thread(target=other)
    thread.start()

    def progress(*_arguments):
        started.set()
        assert ran.wait(60)
        return False

    quoin.open(WALLS / "wall1.quoin").solve(progress)
    thread.join()
    assert ran.is_set()


def test_results_are_read_back(tmp_path):
    model = quoin.open(WALLS / "wall2.quoin")
    result = model.solve()
    result.save(tmp_path / "r.json")
    again = model.read_result(tmp_path / "r.json")
    assert (again.displacements == result.displacements).all()
    model.save(tmp_path / "m.quoin")
    assert quoin.open(tmp_path / "m.quoin").to_dict() == model.to_dict()


def test_dataframe():
    result = quoin.open(WALLS / "wall1.quoin").solve()
    frame = result.to_dataframe()
    assert list(frame.columns) == ["step", "multiplier", "block", "ux", "uy", "rz"]
    last = frame[frame.step == frame.step.max()].set_index("block")
    assert last.loc["w.6.1", "ux"] == result.displacements[-1, -5, 0]
    assert (frame[frame.block == "base"][["ux", "uy", "rz"]] == 0).all(axis=None)


def test_plot():
    import matplotlib

    matplotlib.use("Agg")
    result = quoin.open(WALLS / "wall1.quoin").solve()
    axes = result.plot(block="w.6.1")
    x, y = axes.lines[0].get_data()
    assert y[-1] == result.multiplier and len(x) == len(result.multipliers)
    assert axes.get_xlabel() == "ux [m]"


def test_pictures(tmp_path):
    model = quoin.open(WALLS / "wall1.quoin")
    result = model.solve()
    assert "<svg" in model._repr_svg_() and "<svg" in result._repr_svg_()
    result.draw("deformed", tmp_path / "d.png", step=0, loads=False, size="320x240")
    assert (tmp_path / "d.png").read_bytes()[:4] == b"\x89PNG"
    assert result.draw("forces", format="pdf")[:4] == b"%PDF"
    with pytest.raises(quoin.UsageError):
        result.draw("deformed", format="svg", step=len(result.multipliers))


def test_shapely_there_and_back():
    from shapely.geometry import Polygon, box

    model = quoin.from_polygons([box(0, -1, 4, 0), box(1, 0, 2, 0.5)], supports=[0],
                                friction=0.4)
    assert model.limit().multiplier == pytest.approx(0.4, abs=1e-6)
    assert [p.area for p in model.to_polygons()] == pytest.approx([4, 0.5])
    holed = Polygon(box(0, 0, 4, 4).exterior, [box(1, 1, 2, 2).exterior])
    with pytest.raises(ValueError, match="holes"):
        quoin.from_polygons([holed], supports=[0])


def test_compas_there_and_back(tmp_path):
    model = quoin.open(WALLS / "wall1.quoin")
    path = tmp_path / "assembly.json"
    path.write_text(json.dumps(model.to_compas()), encoding="utf-8")
    again = quoin.read_drawing(path)
    assert len(again.faces) == len(model.faces)
    # The weights are those of the file, whatever the unit weight of the others.
    assert [b.weight for b in again.blocks] == pytest.approx([b.weight for b in model.blocks])
    # Vertices are welded on reading: not the same digits, but the same wall.
    assert again.limit().multiplier == pytest.approx(model.limit().multiplier, rel=1e-6)


def test_capacity(tmp_path):
    """What the command line writes; settings that the project keeps count."""
    wall = quoin.open(WALLS / "wall1.quoin")
    answer = wall.capacity("type1", ag="0.25g", soil="B", control="w.6.5",
                           picture=tmp_path / "curve.csv")
    assert [check["state"] for check in answer["checks"]] == ["SLV", "SLC", "SD", "NC"]
    quoin.command("capacity", WALLS / "wall1.quoin", "--spectrum", "type1", "--ag", "0.25g",
                  "--soil", "B", "--control", "w.6.5", "--json", tmp_path / "c.json", "-q")
    assert answer == json.loads((tmp_path / "c.json").read_text())
    assert len((tmp_path / "curve.csv").read_text().splitlines()) == len(answer["curve"]) + 1
    gable = quoin.open(EXAMPLES / "47-gable-with-tie.quoin")
    assert gable.capacity()["alpha0"] == pytest.approx(179 / 982.125, rel=1e-6)
    assert gable.capacity(mechanism=False)["source"] == "path"
    above = gable.capacity(height=6, building_height=9, storeys=3, building_period=0.3)
    assert above["linear"]["demand"] == pytest.approx(4.5 * 9 / 7 * 2 / 3 * 1.01 ** 0.5, rel=1e-6)
    with pytest.raises(quoin.Error, match="building-height is at least height"):
        gable.capacity(height=6, building_height=5, storeys=3, building_period=0.3)
    kept = wall.to_dict()
    kept["capacity"] = {"control": "w.6.1", "spectrum": "type2", "ag": 2, "soil": "A"}
    kept = quoin.from_dict(kept).capacity()
    assert kept["control_block"] == "w.6.1" and len(kept["checks"]) == 4
    with pytest.raises(quoin.UsageError, match="soil is"):
        wall.capacity("type1", ag=1, soil="F")
    with pytest.raises(quoin.NoAnswerError, match="cancelled"):
        wall.capacity(progress=lambda state: False)


def test_sheets_films_and_reports(tmp_path):
    wall = quoin.open(WALLS / "wall1.quoin")
    rough, smooth = wall.solve(), wall.set({"laws[0].friction": 0.5}).solve()
    quoin.curve([rough, smooth], tmp_path / "c.csv", label=["0.65", "0.5"])
    rows = (tmp_path / "c.csv").read_text().splitlines()
    assert len(rows) == 1 + len(rough.multipliers) + len(smooth.multipliers)
    assert rows[1].startswith('"Wall 1 (0.65)"') and rows[-1].startswith('"Wall 1 (0.5)"')
    assert b"published" in rough.curve(reference=[0.64, "0.643=published"], until=0.01)
    quoin.compare([rough, smooth], tmp_path / "m.pdf", columns=2, title="Walls")
    assert b"Sliding" in quoin.compare([rough, smooth], format="csv")
    rough.animate(tmp_path / "m.gif", frames=3, size="160x120")
    assert (tmp_path / "m.gif").read_bytes()[:4] == b"GIF8"
    rough.animate(f"{tmp_path}/film/", "deformed", frames=2, size="160x120", curve=False)
    assert len(list((tmp_path / "film").iterdir())) == 2
    wall.report(tmp_path / "both.pdf", [rough, smooth], demand=0.6, paper="letter")
    rough.report(tmp_path / "one.pdf", sections=["title", "results"])
    assert (tmp_path / "one.pdf").stat().st_size < (tmp_path / "both.pdf").stat().st_size
    for wrong in ({"frames": 1}, {"speed": 1}, {"rate": 0}):
        with pytest.raises(quoin.UsageError):
            rough.animate(tmp_path / "n.gif", **wrong)
    with pytest.raises(quoin.UsageError, match="modl"):
        rough.report(tmp_path / "n.pdf", sections=["modl"])
    with pytest.raises(quoin.InvalidError, match="in time"):
        rough.energy()
    with pytest.raises(ValueError, match="there is none"):
        quoin.curve([])
    rocking = quoin.open(EXAMPLES / "40-rocking-in-time.quoin",
                         {"analysis.dynamic.duration": 0.1}).solve()
    assert b"<svg" in rocking.energy()
    with pytest.raises(quoin.InvalidError, match="no axes in common"):
        quoin.curve([rough, rocking])


def test_studies(tmp_path):
    """On processes of quoin-cli; of a file with values, which are those of the cases too."""
    wall = quoin.open(WALLS / "wall1.quoin", {"laws[0].dilatancy": 0.1})
    friction = [{"name": "mu", "path": "laws[0].friction", "values": [0.4, 0.6]}]
    outputs = ["associative_multiplier", "mechanism_kind"]
    study = wall.study(friction, outputs, tmp_path / "s", run="limit", jobs=1)
    table = study.table()
    assert [row["mu"] for row in table] == [0.4, 0.6]
    for row in table:
        bound = wall.set({"laws[0].friction": row["mu"]}).limit().multiplier
        assert row["associative_multiplier"] == pytest.approx(bound, rel=1e-6)
    model = quoin.open(tmp_path / "s" / "model.quoin").to_dict()
    assert model["laws"][0]["dilatancy"] == 0.1
    assert "2 of 2 cases" in study.summary()
    study.plot(tmp_path / "s.svg", "scatter", of="associative_multiplier", by="mu")
    assert quoin.Study(tmp_path / "s").run().table() == table
    assert list(study.to_dataframe()["mu"]) == [0.4, 0.6]
    with pytest.raises(quoin.InvalidError, match="no such output"):
        wall.study(friction, ["mystery"], tmp_path / "t")
    with pytest.raises(quoin.FileError):
        quoin.Study(tmp_path / "none").table()


def test_studies_tell_how_far_they_are(tmp_path):
    wall = quoin.open(EXAMPLES / "01-sliding-block.quoin")
    friction = [{"name": "mu", "path": "laws[0].friction", "range": [0.4, 0.8, 5]}]
    told = []
    study = wall.study(friction, ["associative_multiplier"], tmp_path / "s", run="limit",
                       progress=lambda state: told.append(state))
    shares = [state.done for state in told]
    assert shares == sorted(shares) and shares[-1] == 1 and told[-1].steps == 5
    assert {state.what for state in told} == {"cases"} and len(study.table()) == 5

    with pytest.raises(quoin.NoAnswerError, match="cancelled"):
        wall.study(friction, ["associative_multiplier"], tmp_path / "t", run="limit",
                   progress=lambda state: False)

    def fails(state):
        raise KeyError("seen by the caller")

    with pytest.raises(KeyError):
        quoin.Study(tmp_path / "t").run(progress=fails)
    assert len(quoin.Study(tmp_path / "t").run().table()) == 5


def test_films_tell_how_far_they_are(tmp_path):
    result = quoin.open(EXAMPLES / "01-sliding-block.quoin").limit()
    frames = []
    result.animate(tmp_path / "a.gif", frames=3, size="80x60", progress=frames.append)
    assert [(state.steps, state.what) for state in frames] == [(n, "frames") for n in (1, 2, 3)]
    assert frames[-1].done == 1
    with pytest.raises(quoin.NoAnswerError, match="cancelled"):
        result.animate(tmp_path / "b.gif", frames=3, size="80x60", progress=lambda state: False)
    assert not (tmp_path / "b.gif").exists()


def test_sensitivity():
    wall = quoin.open(EXAMPLES / "ferris-tin-loi" / "wall1.quoin")
    by_friction = wall.limit().sensitivity()["laws"][0]["friction"]
    steps = [wall.set({"laws[0].friction": mu}).limit().multiplier for mu in (0.649, 0.651)]
    assert by_friction == pytest.approx((steps[1] - steps[0]) / 0.002, rel=1e-3)
    with pytest.raises(quoin.NoAnswerError):
        wall.limit(associative=False).sensitivity()


def test_records_that_grow(tmp_path):
    block = quoin.open(EXAMPLES / "02-overturning-block.quoin")
    rows = block.ida([EXAMPLES / "43-synthetic-record.csv"], (0.5, 1, 0.5), tmp_path / "ida",
                     picture=tmp_path / "ida.svg", jobs=1)
    assert [row["scale"] for row in rows] == [0.5, 1]
    assert rows[1]["peak acceleration [m/s2]"] == 2 * rows[0]["peak acceleration [m/s2]"]
    assert (tmp_path / "ida.svg").exists()


def test_exports_and_kept_figures(tmp_path):
    wall = quoin.generate("wall", length=1, height=0.4)
    result = wall.limit()
    result.export(tmp_path / "t.csv", table="contacts")
    assert len((tmp_path / "t.csv").read_text().splitlines()) > len(result.states)
    wall.export(tmp_path / "w.dxf", unit="mm")
    assert len(quoin.read_drawing(tmp_path / "w.dxf").blocks) == len(wall.blocks)
    wall.export(tmp_path / "p.quoin")
    assert len(quoin.open(tmp_path / "p.quoin").to_dict()["blocks"]) == len(wall.blocks)
    figures = quoin.open(EXAMPLES / "12-facade.quoin").figures(tmp_path, ["elevation"])
    assert figures == [str(tmp_path / "facade.pdf")]


def test_the_program(monkeypatch):
    assert quoin.command("--version").split() == ["quoin", quoin.__version__]
    with pytest.raises(quoin.UsageError, match="chek"):
        quoin.command("chek")
    monkeypatch.setenv("QUOIN_CLI", "/no/such/program")
    with pytest.raises(quoin.FileError, match="/no/such/program"):
        quoin.command("--version")


def test_modes():
    wall = quoin.open(WALLS / "wall1.quoin")
    assert wall.modal(4).omega[0] > 0  # closed joints are elastic
    modes = wall.set({"laws[0].dilatancy": 0.65}).modal(4)
    assert modes.omega.shape == (4,) and modes.shapes.shape == (4, 34, 3)
    assert (numpy.diff(modes.omega) >= 0).all() and modes.omega[0] > 0
    every = wall.modal(count=100)
    free = sum(block.weight for block in wall.blocks if not any(block.fixed)) / 9.81
    assert every.effective_masses.sum(axis=0) == pytest.approx([free, free])
    mass, stiffness = every.damping(0.05)
    assert mass + stiffness * every.omega[0] ** 2 == pytest.approx(0.1 * every.omega[0])
    associative = wall.set({"laws[0].dilatancy": 0.65})
    slides = associative.modal(2, slip=True).omega
    assert slides.shape == (2,) and slides[0] <= modes.omega[0] * (1 + 1e-9)
    with pytest.raises(quoin.NoAnswerError, match="slip without dilatancy"):
        wall.modal(2, slip=True)


SQUARES = [[(-1, -1), (1, -1), (1, 0), (-1, 0)],
           [(-.5, 0), (.5, 0), (.5, 1), (-.5, 1)],
           [(-.5, 1), (.5, 1), (.5, 2), (-.5, 2)]]


@pytest.mark.parametrize("supports", [[0], (0,), {0}, numpy.array([0]), [numpy.int64(0)],
                                      [True, False, False], numpy.array([True, False, False])])
def test_supports_are_numbers_or_a_mask(supports):
    model = quoin.from_polygons(SQUARES, supports)
    assert [block.fixed[0] for block in model.blocks] == [True, False, False]
    assert model.solve().multiplier == pytest.approx(0.5, abs=1e-3)


@pytest.mark.parametrize("supports, error", [
    ([3], IndexError), ([-1], IndexError), ([True, False], ValueError), (["b0"], TypeError),
    ([0.0], TypeError), ([True, 2, 0], TypeError), (numpy.array([1, 0, 0]), ValueError)])
def test_supports_that_mean_no_block(supports, error):
    with pytest.raises(error, match="supports"):
        quoin.from_polygons(SQUARES, supports)


def test_masked_corners():
    masked = numpy.ma.array(SQUARES[0], mask=[[0, 0], [1, 1], [0, 0], [0, 0]])
    with pytest.raises(ValueError, match=r"polygons\[0\]: some of its corners are masked"):
        quoin.from_polygons([masked], [0])


def test_numbers_of_numpy():
    model = quoin.from_polygons(numpy.array(SQUARES[:2]), [0], thickness=numpy.float32(1))
    for value in (numpy.float64(.25), numpy.float32(.25), numpy.array(.25), numpy.int64(1)):
        laws = model.set({"laws[0].friction": value}).to_dict()["laws"]
        assert laws[0]["friction"] == float(value)
    live = model.set({"loads.live[0].direction": numpy.array([1, 0])})
    assert live.to_dict()["loads"]["live"][0]["direction"] == [1, 0]
    assert len(quoin.wall(numpy.ones((3, 4), dtype=int)).blocks) == 13
    with pytest.raises(TypeError, match="no value of a project"):
        model.set({"laws[0].friction": object()})


def test_values_that_are_none_name_themselves(tmp_path):
    wall = quoin.wall([[1, 1]])
    for call, error, words in (
            (lambda: quoin.from_polygons(SQUARES, supports=0), TypeError, "supports: expected"),
            (lambda: quoin.from_polygons([[(0, 0, 0), (1, 0, 0), (1, 0, 1)]], [0]), ValueError,
             "plane of equal z"),
            (lambda: quoin.from_polygons([numpy.array([0, 1, 1j])], [0]), ValueError, "corners"),
            (lambda: quoin.wall("abc"), TypeError, "courses: expected lists of lengths"),
            (lambda: wall.set({"gravity": float("nan")}), ValueError, "nan: number is not finite"),
            (lambda: wall.modal(0), quoin.UsageError, "count"),
            (lambda: wall.modal(1).damping(1.5), ValueError, "ratio"),
            (lambda: quoin.Study(tmp_path / "none").run(), quoin.FileError, "no such folder")):
        with pytest.raises(error, match=words):
            call()
    friction = [{"name": "mu", "path": "laws[0].friction", "values": numpy.array([0.4, 0.5])}]
    study = wall.study(friction, ["associative_multiplier"], tmp_path / "s", run="limit")
    assert [row["mu"] for row in study.table()] == [0.4, 0.5]


def test_closed_rings_and_what_is_none():
    closed = quoin.from_polygons([ring + ring[:1] for ring in SQUARES], [0])
    assert [len(block.vertices) for block in closed.blocks] == [4, 4, 4]
    with pytest.raises(ValueError, match="corners"):
        quoin.from_polygons([[1, 2, 3]], [0])
    with pytest.raises(ValueError, match="there is none"):
        quoin.from_polygons([], [])
    for courses in ([], [[]], [[1], []]):
        with pytest.raises(ValueError, match="courses"):
            quoin.wall(courses)


def test_models_copy_and_pickle():
    model = quoin.from_polygons(SQUARES, [0])
    for other in (copy.copy(model), copy.deepcopy(model), pickle.loads(pickle.dumps(model))):
        assert other.to_dict() == model.to_dict()


def test_what_a_project_names_is_found_again(tmp_path, monkeypatch):
    """A model with other values, a copy and a pickle have the place of their file, and a dictionary
    that of its name."""
    path = EXAMPLES / "43-shaken-wall.quoin"
    model = quoin.open(os.path.relpath(path)).set({"title": "shaken"})
    other = pickle.loads(pickle.dumps(model))
    monkeypatch.chdir(tmp_path)
    for shaken in (other, copy.deepcopy(other), pickle.loads(pickle.dumps(other)),
                   other.set({"title": "again"}), quoin.from_dict(other.to_dict(), str(path))):
        assert shaken.warnings == [] and shaken.path == str(path)
    assert other.title == "shaken"
    with pytest.raises(quoin.FileError, match="synthetic"):
        quoin.from_dict(other.to_dict()).solve()


def test_results_copy_and_pickle():
    result = quoin.open(WALLS / "wall2.quoin", {"analysis.increments": 20}).solve()
    other = pickle.loads(pickle.dumps(result))
    for name in ("multipliers", "displacements", "forces", "mechanism"):
        assert (getattr(other, name) == getattr(result, name)).all()
    assert not other.model_changed
    assert other.model.to_dict() == result.model.to_dict()
    assert copy.copy(result) is result
    modes = quoin.open(WALLS / "wall1.quoin").modal(2)
    assert (pickle.loads(pickle.dumps(modes)).omega == modes.omega).all()


def test_a_result_of_another_project_is_told(tmp_path):
    """By the bytes of the project and the values that it was computed with, as of --set."""
    wall = quoin.open(WALLS / "wall1.quoin")
    slippery = wall.set({"laws[0].friction": 0.5})
    slippery.limit().save(tmp_path / "slippery.json")
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        again = wall.read_result(tmp_path / "slippery.json")
        assert again.model.to_dict()["laws"][0]["friction"] == 0.5
        assert again.check()[0]
    with pytest.warns(quoin.ChangedWarning, match="slippery.json"):
        wall.set({"title": "x"}).read_result(tmp_path / "slippery.json")
    other = wall.to_dict()
    other["laws"][0]["friction"] = 0.4
    with pytest.warns(quoin.ChangedWarning):
        result = quoin.from_dict(other).read_result(tmp_path / "slippery.json")
    assert result.model_changed
    with pytest.raises(quoin.InvalidError):
        quoin.open(WALLS / "wall2.quoin").read_result(tmp_path / "slippery.json")


def test_everything_that_a_result_says():
    """Words, the file as a dictionary, and the independent check."""
    result = quoin.open(WALLS / "wall1.quoin").solve()
    data = result.to_dict()
    assert f"{result.multiplier:.4g}" in result.reason
    assert result.check() == (True, [])
    assert len(data["contacts"]) == len(result.states)
    assert set(data["contacts"][0]) >= {"point", "normal", "normal_force", "shear_force"}
    assert "forces" in data["steps"][1] and "kind" in data["mechanism_facts"]
    column = quoin.open(EXAMPLES / "21-column-pinned.quoin")
    assert column.stability().first_limit_multiplier == pytest.approx(2467.4, abs=5)
    with pytest.raises(quoin.InvalidError, match="nonlinear"):
        column.set({"analysis.geometry": "linear"}).stability()


def test_history_of_an_analysis_in_time():
    """Time, energies and tracks are in the dictionary."""
    rocking = quoin.open(EXAMPLES / "40-rocking-in-time.quoin",
                         {"analysis.dynamic.duration": 0.1})
    data = rocking.solve().to_dict()
    assert data["history"]["time"][-1] > 0


def test_arrays_of_an_analysis_in_time():
    """Supports carry the weight of all blocks, and energies add up at every row."""
    result = quoin.open(EXAMPLES / "40-rocking-in-time.quoin").solve()
    steps, bodies = len(result.multipliers), result.displacements.shape[1]
    assert result.times.shape == (steps,)
    assert (numpy.diff(result.times) >= 0).all()
    assert result.velocities.shape == (steps, bodies, 3)
    assert result.reactions.shape == (steps, len(result.supports), 3)
    weight = sum(block.weight for block in result.model.blocks)
    carried = result.reactions[0, :, 1].sum()
    assert carried == pytest.approx(weight, rel=1e-6)
    energy = result.history["energy"]
    rest = energy["input"] - sum(energy[key] for key in energy if key != "input")
    assert energy["kinetic"].shape == result.history["time"].shape
    assert abs(rest).max() < 1e-3 * abs(energy["input"]).max()


def test_a_result_is_parsed_once(monkeypatch):
    """However often its properties are asked; what callers do to them or to the dictionary stays
    theirs."""
    result = quoin.open(WALLS / "wall1.quoin").solve()
    loads, parsed = json.loads, []
    monkeypatch.setattr(json, "loads", lambda text: parsed.append(1) or loads(text))
    supports, steps = result.supports, len(result.reactions)
    assert result.times is None and result.velocities is None and len(parsed) == 1
    result.supports.clear()
    result.reactions.fill(0)
    result.to_dict()["steps"].clear()
    assert result.supports == supports and len(result.reactions) == steps
    assert result.reactions.any() and result.to_dict()["steps"]


def test_reactions_of_a_path():
    result = quoin.open(WALLS / "wall1.quoin").solve()
    assert result.times is None and result.velocities is None and result.history is None
    assert result.reactions.shape == (len(result.multipliers), len(result.supports), 3)
