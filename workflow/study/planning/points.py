"""The points of a tier: every run that is known beforehand, as (group, labels, case overlay), and the
brackets that add runs while they narrow. A section that a tier does not have asks for nothing."""

from itertools import product

from study.planning.arrays import device_of, placed

#: What a tier may consist of.
SECTIONS = (
    "streamlines",
    "stokes",
    "stretching",
    "passages",
    "boundary",
    "uncertainty",
    "sensitivity",
    "accuracy",
    "stability",
    "figures",
)

#: Groups of runs that make up the study; the others belong to targets of their own (accuracy, stability).
STUDY_GROUPS = (
    "streamlines",
    "stokes",
    "stretching",
    "passages",
    "boundary",
    "sensitivity",
    "sensitivity-flow",
)


def merged(*overlays):
    """Nested dictionaries laid over one another; the last one wins, leaf by leaf."""
    result = {}
    for overlay in overlays:
        for key, value in overlay.items():
            if isinstance(value, dict):
                below = result.get(key)
                result[key] = merged(below if isinstance(below, dict) else {}, value)
            else:
                result[key] = value
    return result


def described(overlay, prefix=""):
    """An overlay in words, such as `cell.skalak_denominator=4 fluid.walls=half_way`; `default` if empty."""
    words = []
    for key, value in sorted(overlay.items()):
        if isinstance(value, dict):
            words += [described(value, f"{prefix}{key}.")] if value else []
        else:
            words.append(f"{prefix}{key}={value:g}" if isinstance(value, float) else f"{prefix}{key}={value}")
    return " ".join(words) or ("" if prefix else "default")


def _at(shift, capillary):
    return {"scene": "passage", "geometry": {"row_shift_um": shift}, "cell": {"capillary_number": capillary}}


def streamlines(tier):
    part = tier["streamlines"]
    for device in part.get("devices", [None]):
        names, array = device_of(tier, device)
        for name, variant in part["variants"].items():
            for shift in variant.get("row_shifts_um", part["row_shifts_um"]):
                shifted = {"scene": "streamlines", "geometry": {"row_shift_um": shift}}
                labels = {"variant": name, "row_shift_um": shift} | names
                yield "streamlines", labels, merged(array, part["case"], variant["case"], shifted)


def stokes(tier):
    part = tier["stokes"]
    names, array = device_of(tier)
    for shift, force in product(part["row_shifts_um"], part["force_densities"]):
        point = {"geometry": {"row_shift_um": shift}, "fluid": {"force_density": force}}
        labels = {"row_shift_um": shift, "force_density": force} | names
        yield "stokes", labels, merged(array, part["case"], point, {"scene": "streamlines"})


def stretching(tier):
    for name, part in tier["stretching"].items():
        labels, cell = {"series": name}, {}
        if "cell" in part:
            labels, cell = labels | {"cell": part["cell"]}, tier["cells"][part["cell"]]
            if modulus := tier["shear_moduli_uN_per_m"][part["cell"]]:
                cell = cell | {"stretching": {"shear_modulus_uN_per_m": modulus}}
        for denominator in part["skalak_denominators"]:
            point = {"scene": "stretching", "cell": {"skalak_denominator": denominator}}
            yield "stretching", labels, merged(cell, part["case"], point)


def _drives(tier, part, cell):
    """Parts of a case, one for each capillary number of a sweep or, in SI units, each pressure gradient."""
    if "capillary_numbers" in part:
        return [{"cell": {"capillary_number": capillary}} for capillary in part["capillary_numbers"]]
    modulus = tier["shear_moduli_uN_per_m"][cell]
    return [
        {"operating": {"pressure_gradient_Pa_per_m": 1e5 * gradient, "shear_modulus_uN_per_m": modulus}}
        for gradient in part["pressure_gradients_bar_per_m"]
    ]


def passages(tier):
    for name, part in tier["passages"].items():
        labels, parts = placed(tier, part)
        for shift, drive in product(part["row_shifts_um"], _drives(tier, part, labels["cell"])):
            point = merged({"scene": "passage", "geometry": {"row_shift_um": shift}}, drive)
            yield "passages", {"sweep": name} | labels, merged(*parts, part["case"], point)


def choices(tier):
    """(choice, value, entry) of the sensitivity study, the default settings first."""
    yield "default", "", {"case": {}}
    for choice, values in tier["sensitivity"]["choices"].items():
        for value, entry in values.items():
            yield choice, value, entry


def sensitivity(tier):
    """The passages of every choice at the points of the study, and the flow without a cell at their row
    shifts.
    """
    part = tier["sensitivity"]
    _, place = placed(tier, part)
    for choice, value, entry in choices(tier):
        for point in part["points"]:
            shift, capillary = point["row_shift_um"], point["capillary_number"]
            labels = {"choice": choice, "value": value, "row_shift_um": shift, "capillary_number": capillary}
            run_at = _at(shift, capillary * entry.get("capillary_factor", 1))
            yield "sensitivity", labels, merged(*place, part["case"], entry["case"], run_at)
        for shift in dict.fromkeys(point["row_shift_um"] for point in part["points"]):
            labels = {"choice": choice, "value": value, "row_shift_um": shift}
            overlay = merged(*place, part["case"], entry["case"], part["flow_case"])
            flow = {"scene": "streamlines", "geometry": {"row_shift_um": shift}}
            yield "sensitivity-flow", labels, merged(overlay, flow)


def _settings_of(method, part):
    """{setting: case} of a method: those that it names, from the method that it `extends` or the ladder, and
    its own on top.
    """
    entry = part["methods"][method]
    own, ladder = entry.get("settings", {}), entry.get("ladder", [])
    known = _settings_of(entry["extends"], part) if "extends" in entry else {}
    known |= {name: part["ladder"][name] for name in ladder}
    return {name: merged(known.get(name, {}), own.get(name, {})) for name in dict.fromkeys([*ladder, *own])}


def accuracy(tier):
    """Every method with all its settings at the points of the accuracy studies."""
    for study, part in tier["accuracy"]["studies"].items():
        for method, entry in part["methods"].items():
            settings = _settings_of(method, part)
            for (setting, how), (point, where) in product(settings.items(), part["points"].items()):
                labels = {"study": study, "method": method, "setting": setting, "point": point}
                yield f"accuracy-{study}", labels, merged(part["case"], how, entry["case"], where)


def settings_check(tier):
    """The same passages with fast settings and with conservative ones."""
    part = tier["accuracy"]["settings_check"]
    for name, how in part["settings"].items():
        sides = {"fast": {}, "conservative": how["conservative"]}
        for (side, overlay), point in product(sides.items(), part["points"]):
            shift, capillary = point["row_shift_um"], point["capillary_number"]
            labels = {"settings": name, "side": side, "row_shift_um": shift, "capillary_number": capillary}
            yield "settings-check", labels, merged(how["case"], overlay, _at(shift, capillary))


def boundary_brackets(tier):
    """(name, definition, overlay) of the brackets of the capillary number, one for each series and row
    shift.
    """
    part = tier["boundary"]
    for series, entry in part["series"].items():
        yield from _along_capillary_number(tier, series, entry, part, entry["case"])
    for series, entry in part.get("mirror", {}).items():
        labels, parts = placed(tier, entry)
        for capillary in entry["capillary_numbers"]:
            low, high = entry["row_shift_range_um"]
            definition = {
                "kind": "mirror",
                "series": series,
                "axis": "row_shift_um",
                "step": entry["step_um"],
                "ends": [low, high],
                "levels": entry["levels"],
                "settings": described(entry["case"]),
                "confirm": {},
            } | labels
            overlay = merged(*parts, part["case"], entry["case"], _at(low, capillary))
            yield f"{series}/ca{capillary:g}", definition, overlay


def sensitivity_brackets(tier):
    """The same for the choices whose critical capillary number is asked for."""
    part = tier["sensitivity"]
    boundary = part["boundary"] | {key: part[key] for key in ("device", "cell") if key in part}
    for choice, value, entry in choices(tier):
        if choice in boundary["choices"] and "series" not in entry and "capillary_factor" not in entry:
            series = f"sensitivity/{choice}/{value}"
            yield from _along_capillary_number(
                tier, series, boundary, part, entry["case"], kind="sensitivity"
            )


def uncertainty_brackets(tier):
    """The same for the settings that are varied one at a time to know how sure the boundary is."""
    part = tier["uncertainty"]
    for series, entry in part["series"].items():
        yield from _along_capillary_number(tier, series, entry, part, entry["case"], kind="uncertainty")


def uncertainty_cells(tier):
    """Passages of single cells with other settings, for the target `uncertainty`."""
    for name, part in tier["uncertainty"].get("cells", {}).items():
        labels, parts = placed(tier, part)
        for shift, capillary in product(part["row_shifts_um"], part["capillary_numbers"]):
            point = merged({"scene": "passage"}, _at(shift, capillary))
            yield "uncertainty-cells", {"sweep": name} | labels, merged(*parts, part["case"], point)


def _along_capillary_number(tier, series, entry, part, overlay, kind="boundary"):
    labels, parts = placed(tier, entry)
    own_ranges = entry.get("ca_ranges", {})
    shifts = [f"{shift:g}" for shift in entry["row_shifts_um"]]
    if unknown := sorted(set(own_ranges) - set(shifts)):
        raise ValueError(
            f"series {series}: /ca_ranges/{unknown[0]}: allowed are its row shifts, {', '.join(shifts)}"
        )
    for shift in entry["row_shifts_um"]:
        low, high = own_ranges.get(f"{shift:g}", entry["ca_range"])
        definition = {
            "kind": kind,
            "series": series,
            "axis": "capillary_number",
            "tolerance": entry.get("tolerance", 0.03),
            "ends": [low, high],
            "levels": entry["levels"],
            "settings": described(overlay),
            "confirm": entry.get("confirm", {}),
        } | labels
        yield f"{series}/d{shift:g}", definition, merged(*parts, part["case"], overlay, _at(shift, low))
