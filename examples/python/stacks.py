"""Projects that show how the pairs of a joint bend: see docs/method/contact-pairs.md.

    python3 stacks.py

Writes wall-2, wall-50, gable and drums.quoin: stacks of blocks on a fixed one. The depth into the
page is a function of the height, from 0 to 1.
"""

import json


def stack(name, count, height, breadth, depth, stiffness, live):
    step = height / count

    def block(i, share, **more):
        low, high = (i - 1) * step, i * step
        return {"name": f"b{i}", "thickness": depth(share), "unit_weight": 20000,
                "vertices": [[0, low], [breadth, low], [breadth, high], [0, high]], **more}

    base = block(0, 0.5 / count, support=[True, True, True])
    project = {
        "format": "quoin", "version": 1,
        "laws": [{"name": "joint", "kind": "coulomb", "basis": "surface",
                  "kn": stiffness, "ks": stiffness, "friction": 0.65}],
        "blocks": [base] + [block(i, (i - 0.5) / count) for i in range(1, count + 1)],
        "contact": {"law": "joint"},
        "loads": {"dead": [{"kind": "weight", "direction": [0, -1]}], "live": live},
        "analysis": {"procedure": "load", "geometry": "nonlinear"},
    }
    with open(name + ".quoin", "w", encoding="utf-8") as file:
        json.dump(project, file)


def push(off):
    """100 kN down on the top block, off its centre, m."""
    return [{"kind": "force", "block": "b40", "value": [0, -1e5], "moment": -1e5 * off}]


sway = [{"kind": "weight", "direction": [1, 0]}]
stack("wall-2", 40, 6, 0.2, lambda share: 1, 2e10, push(0.002))
stack("wall-50", 40, 6, 0.2, lambda share: 1, 2e10, push(0.05))
stack("gable", 20, 5, 0.3, lambda share: 6 * (1 - share), 2e9, sway)
stack("drums", 6, 6, 1, lambda share: 1, 5e9, sway)
