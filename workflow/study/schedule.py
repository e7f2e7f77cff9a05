"""Which job first: the one with the most work behind it, so that no core waits for a long chain at the
end."""

#: Node updates of a typical passage are this times (tau - 1/2) / (f dx^2), dx in um, on every lattice: the
#: median of the committed passages.
PASSAGE = 1.6e5
#: Of a flow without a cell this over dx^5: nodes, times the steps in which momentum crosses the device.
FLOW = 5.5e5
#: Of a stretched cell this times the mesh frequency to the fourth, in node updates that take as long: the
#: vertices of the mesh, times steps that go with them.
STRETCHING = 2.2e3


def expected_updates(case):
    """Node updates that a resolved case will take, about."""
    if case["scene"] == "stretching":
        return STRETCHING * case["cell"]["mesh_frequency"] ** 4
    fluid, halves = case["fluid"], 2 if case["geometry"]["height"] == "full" else 1
    dx = fluid["lattice_spacing_um"]
    if case["scene"] == "streamlines":
        return FLOW * halves / dx**5
    return PASSAGE * halves * (fluid["relaxation_time"] - 0.5) / (fluid["force_density"] * dx**2)


def priority(updates):
    """Node updates as Snakemake's priority: a whole number of millions."""
    return int(updates / 1e6)


def bracket_priority(bracket, level):
    """Priority of the jobs of a level of a bracket: its levels run one after the other."""
    return priority(expected_updates(bracket["case"]) * (bracket["levels"] - level + 1))


def run_priorities(plan):
    """Priority of every run of the plan, by identity.

    Snakemake's priorities do not reach the jobs that a job waits for, so a run that a bracket begins with has
    that of the whole chain behind it.
    """
    found = {run["id"]: priority(expected_updates(run["case"])) for run in plan["runs"]}
    for bracket in plan["brackets"].values():
        for _, run in bracket["known"]:
            found[run] = max(found.get(run, 0), bracket_priority(bracket, 0))
    return found
