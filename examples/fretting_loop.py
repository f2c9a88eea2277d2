"""A notebook of cells (# %%): a fretting loop, a sweep over the coefficient of friction, pictures.

    python3 examples/fretting_loop.py [FOLDER]     writes its pictures into FOLDER (default: build/fretting)

It needs only the package contact2d (pip install ./port/python, or PYTHONPATH=port/python after make python).
"""

import pathlib
import sys

import contact2d

here = pathlib.Path(__file__).resolve().parent
folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else here.parent / "build" / "fretting")
folder.mkdir(parents=True, exist_ok=True)

# %% A pad is pressed on a flat and loaded tangentially in cycles; the mesh is refined for the narrowest slip zone
deck = contact2d.mesh(here / "fretting_pad.c2s", mu=1.0)
result = contact2d.solve(deck, options={"threads": 2})
result  # a notebook shows its main numbers and pictures
for picture in result.pictures.values():
    picture.save(folder / (picture.name + ".svg"))

# %% The pressure at the end, by name
last = result["contact"].where(step=-1)
print("%d pairs, peak pressure %.5g, outcome: %s" %
      (len(last), result.quantity("peak pressure", zone=1), result.outcome))

# %% The same deck in this process: assembled and eliminated once, followed for one coefficient of friction after the other
solver = contact2d.Solver.of_deck(deck, threads=2)
solver.prepare()
PLATEN = 3  # bodies 1 and 2 are block and pad; the platen on top of the pad moves as a rigid body


def loop(mu, steps=20):
    """Displacements of the platen and forces of the second cycle of the tangential load, and what friction dissipates in it."""
    solver.begin(mu)
    solver.advance([1, 0])  # load factors of the cases `normal` and `shear`
    moves, forces, dissipated = [], [], []
    turns = [0, 1, -1, 1, -1, 1]
    for begin, end in zip(turns, turns[1:]):
        for i in range(1, steps + 1):
            outcome = solver.advance([1, begin + (end - begin) * i / steps])
            if outcome != contact2d.Outcome.REACHED:
                raise RuntimeError("mu %g: %s" % (mu, outcome))
            moves.append(solver.get_body_state(PLATEN).motion[0])
            forces.append(solver.get_zone_state(1).force[0])
            dissipated.append(solver.get_summary().dissipated)
    cycle = slice(3 * steps - 1, 5 * steps)
    return moves[cycle], forces[cycle], dissipated[-1] - dissipated[3 * steps - 1]


def area(x, y):
    """What a closed curve encloses."""
    return abs(sum(x[i - 1] * y[i] - x[i] * y[i - 1] for i in range(len(x)))) / 2


# %% Sweep over the coefficient of friction
sweep = []
curves = []
for mu in (0.4, 0.5, 0.6, 0.8, 1.0):
    moves, forces, loss = loop(mu)
    sweep.append((mu, loss))
    curves.append((moves, forces, "mu %g" % mu))
    print("mu %.1f: dissipated per cycle %.6g, area of the loop %.6g, open by %.2g" %
          (mu, loss, area(moves, forces), abs(moves[-1] - moves[0])))

# %% Pictures
loops = contact2d.plot(*curves, title="Fretting loops", x="displacement of the platen (mm)", y="tangential force (N/mm)")
losses = contact2d.plot(([mu for mu, _ in sweep], [loss for _, loss in sweep]), title="Energy lost in a cycle",
                        x="coefficient of friction", y="N mm per mm")
loops.save(folder / "loops.svg")
losses.save(folder / "losses.svg")
print("pictures:", folder)
