# SPDX-License-Identifier: MIT
"""Tune a contact: where the stack rests in its contacts, against their thickness d̂.

Psi'(d) is kappa / d̂ times a function of d/d̂. So with the same kappa a thicker contact is softer, and carries the same
weight further in: at a smaller part of d̂.
"""
import pabd

rows = []
for d_hat in (0.005, 0.01, 0.02, 0.04, 0.08):
    sim = pabd.load("stack", set={"contact.d_hat": d_hat, "contact.kappa": 2000})
    gap = sim.run(1.5)["min_gap"]
    rows.append((d_hat, gap))
    print(f"d_hat {d_hat:.3f} m: gap at rest {gap:.5f} m = {gap / d_hat:.2f} d_hat")


def chart(rows, width=480, height=300, edge=50):
    """Gap over d̂ against d̂ (each twice the one before) as an SVG of its own, with nothing but text."""
    lo = 0.8

    def right(k):
        return edge + 20 + k / (len(rows) - 1) * (width - 2 * edge - 40)

    def down(part):
        return height - edge - (part - lo) / (1 - lo) * (height - 2 * edge)

    places = [(right(k), down(gap / d_hat)) for k, (d_hat, gap) in enumerate(rows)]
    line = " ".join(f"{x:.1f},{y:.1f}" for x, y in places)
    dots = "".join(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="4" fill="#0072b2"/>'
                   f'<text x="{x:.1f}" y="{height - edge + 18}" text-anchor="middle">{d_hat:g}</text>'
                   for (x, y), (d_hat, _) in zip(places, rows))
    marks = "".join(f'<line x1="{edge}" x2="{width - edge}" y1="{down(part):.1f}" y2="{down(part):.1f}" stroke="#ccc"/>'
                    f'<text x="{edge - 8}" y="{down(part) + 4:.1f}" text-anchor="end">{part:g}</text>'
                    for part in (0.8, 0.85, 0.9, 0.95, 1))
    return (f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" font-family="sans-serif" '
            f'font-size="12"><rect width="100%" height="100%" fill="white"/>{marks}'
            f'<polyline points="{line}" fill="none" stroke="#0072b2" stroke-width="2"/>{dots}'
            f'<text x="{width / 2}" y="{height - 8}" text-anchor="middle">thickness [m]</text>'
            f'<text x="{edge}" y="24">smallest gap at rest over thickness [1], kappa = 2000 J</text></svg>')


with open("tune_contact.svg", "w", encoding="utf-8") as file:
    file.write(chart(rows))
print("wrote tune_contact.svg")
