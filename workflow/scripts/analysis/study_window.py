"""The window in which a device tells two cells apart: for every row shift the pressure gradients at which one
is displaced and the other zigzags. Empty where the study does not give the shear modulus of its cells."""

from itertools import combinations

from study.analysis.arguments import required_arguments
from study.analysis.devices import pressure_gradient_bar_per_m, shear_modulus
from study.analysis.tables import read_table, write_table
from study.planning.documents import read_json

COLUMNS = ["device", "row_shift_um", "displaced_cell", "zigzag_cell", "from_bar_per_m", "to_bar_per_m"]
COLUMNS += ["ratio"]
STYLES = {"row_shift_um": ".1f", "from_bar_per_m": ".4g", "to_bar_per_m": ".4g", "ratio": ".3f"}


def in_pressure(plan, devices, row):
    """(largest pressure gradient known to displace, smallest known to zigzag) of a row, bar/m."""
    radius = plan["radius_um"][row.cell]
    scale = devices.loc[row.device, "length_scale_um"]
    kS = shear_modulus(plan, row.cell)
    return [pressure_gradient_bar_per_m(ca, kS, scale, radius) for ca in (row.ca_displaced, row.ca_zigzag)]


def windows(rows, plan, devices):
    """The windows between every two cells of one device and row shift: the softer one already zigzags, the
    stiffer one is still displaced."""
    for first, second in combinations(rows, 2):
        ends = {row.cell: in_pressure(plan, devices, row) for row in (first, second)}
        soft, stiff = sorted(ends, key=lambda cell: ends[cell][1])
        low, high = ends[soft][1], ends[stiff][0]
        yield {
            "device": first.device,
            "row_shift_um": first.row_shift_um,
            "displaced_cell": stiff,
            "zigzag_cell": soft,
            "from_bar_per_m": low,
            "to_bar_per_m": high,
            "ratio": high / low,
        }


def main():
    arguments = required_arguments(__doc__, "plan", "boundary", "devices", "output")
    plan, boundary = read_json(arguments.plan), read_table(arguments.boundary)
    devices = read_table(arguments.devices).set_index("device")
    known = [cell for cell in plan["cells"] if shear_modulus(plan, cell) and plan["radius_um"][cell]]
    closed = boundary[boundary.cell.isin(known)].dropna(subset=["ca_displaced", "ca_zigzag"])
    rows = [
        window
        for _, group in closed.groupby(["device", "row_shift_um"])
        for window in windows(list(group.itertuples()), plan, devices)
        if window["ratio"] > 1
    ]
    write_table(rows, COLUMNS, arguments.output, ["device", "row_shift_um"], STYLES)


main()
