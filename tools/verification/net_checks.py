"""The hemisphere beside the exact net: four meshes along the yarns, four unstructured."""

import math

from verification.compared import compared, rms
from verification.rows import bounded, reported
from verification.runs import Run

REFERENCE = "hemisphere_net.csv"
OPTIONS = ("--centre", "0,0,-9.5", "--to", "150,150", "--nodal", "--where", "polar_angle_deg<=75")
ELEMENTS = (1800, 3200, 12800, 51200)  # of the whole sheet


def net(workshop):
    rows = []
    for pattern in ("diagonal", "unstructured"):
        name = "hemisphere, mesh along the yarns" if pattern == "diagonal" else "hemisphere, unstructured mesh"
        before = None
        for elements in ELEMENTS:
            run = Run(f"net_{pattern}_{elements}", "hemisphere_net", (f"blank.elements={elements}", f"blank.pattern={pattern}"))
            error = rms(compared(workshop, run, REFERENCE, OPTIONS))
            order = ""
            if before:
                ratio = math.sqrt(elements / before[0])  # of the edges
                order = f"order {math.log(before[1] / error) / math.log(ratio):.2f}"
            what = f"shear on the bias diagonal to 75 deg polar, RMS, {elements} elements"
            if elements == ELEMENTS[-1]:
                rows.append(bounded(name, what, "exact net", order, error, 0.3, "deg", run.command))
            else:
                rows.append(reported(name, what, "exact net", order, run.command, f"{error:.3g} deg"))
            before = (elements, error)
    return rows
