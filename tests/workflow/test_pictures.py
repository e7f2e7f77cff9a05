"""A palette makes pictures smaller and changes no colour that one could see."""

from io import BytesIO

import numpy
from PIL import Image
from study.drawing.pictures import png_with_palette


def read_back(picture):
    data = png_with_palette(picture)
    return numpy.asarray(Image.open(BytesIO(data)).convert("RGB")).astype(int), len(data)


def test_few_colours_stay_what_they_are():
    pixels = numpy.zeros((40, 60, 3), numpy.uint8)
    pixels[:, 20:] = (213, 94, 0)
    pixels[10:, 40:] = (0, 114, 178)
    assert (read_back(Image.fromarray(pixels))[0] == pixels).all()


def test_a_gradient_keeps_its_colours_to_a_step_and_is_smaller():
    ramp = numpy.linspace(0, 1, 400)
    noise = numpy.random.default_rng(1).integers(0, 3, (300, 400, 3))
    pixels = (250 * numpy.stack([ramp, 1 - ramp, ramp**2], -1)[None] + noise).astype(numpy.uint8)
    picture = Image.fromarray(pixels)
    found, size = read_back(picture)
    plain = BytesIO()
    picture.save(plain, "PNG", optimize=True)
    assert numpy.abs(found - pixels).max() <= 8
    assert size < len(plain.getvalue()) / 2
