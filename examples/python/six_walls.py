"""The table of the six walls, and a variation of friction, in Python.

    python3 six_walls.py ../ferris-tin-loi
"""

import pathlib
import sys

import quoin

folder = pathlib.Path(sys.argv[1])

print(f"{'wall':8} {'blocks':>6} {'faces':>6} {'collapse':>9} {'bound':>9}")
for number in range(1, 7):
    model = quoin.open(folder / f"wall{number}.quoin")
    result = model.solve()
    _, bound = model.limit().bounds
    print(f"{model.title:8} {len(model.blocks):6} {len(model.faces):6} "
          f"{result.multiplier:9.4f} {bound:9.4f}")

print("\nfriction and the bound of wall 3")
wall = quoin.open(folder / "wall3.quoin")
for friction in (0.4, 0.5, 0.6, 0.7):
    _, bound = wall.set({"laws[0].friction": friction}).limit().bounds
    print(f"{friction:8} {bound:9.4f}")
