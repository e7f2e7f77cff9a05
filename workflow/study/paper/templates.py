"""Pages made from templates."""

from pathlib import Path

from jinja2 import Environment, FileSystemLoader, StrictUndefined


def filled(template, values, **options):
    """The text of a template file with these values, every one of them needed; `options` go to Jinja."""
    path = Path(template)
    loader = FileSystemLoader(path.parent)
    look = {"undefined": StrictUndefined, "trim_blocks": True, "lstrip_blocks": True}
    return Environment(loader=loader, **look, **options).get_template(path.name).render(values)
