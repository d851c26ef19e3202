"""Runs the cells of a notebook one after the other; 77 where a module that it needs is not there.

    notebook.py NOTEBOOK.ipynb
"""

import importlib.util
import json
import pathlib
import sys

notebook = json.loads(pathlib.Path(sys.argv[1]).read_text(encoding="utf-8"))
for module in notebook["metadata"]["quoin"]["needs"]:
    if importlib.util.find_spec(module) is None:
        print(f"skipped: the module {module} is not installed")
        sys.exit(77)
names = {"__name__": "__main__"}
for number, cell in enumerate(notebook["cells"]):
    assert cell.get("outputs", []) == [], "notebooks are kept without outputs"
    if cell["cell_type"] == "code":
        exec(compile("".join(cell["source"]), f"cell {number}", "exec"), names)
