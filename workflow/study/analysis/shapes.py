"""Pillar shapes as the schema of a case declares them."""


def shapes_of(schema):
    """The schema of every shape, in the order of the solver's list."""
    return schema["properties"]["geometry"]["properties"]["pillar"]["oneOf"]


def name_of(shape):
    return shape["properties"]["shape"]["const"]


def parameters_of(shape):
    """{name: schema} of the parameters of a shape."""
    return {name: part for name, part in shape["properties"].items() if name != "shape"}


def example_of(shape):
    """The pillar that the examples of a shape make; what has none keeps its default."""
    given = {name: part["examples"][0] for name, part in parameters_of(shape).items() if "examples" in part}
    return {"shape": name_of(shape)} | given
