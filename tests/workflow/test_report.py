"""The report: complete, without outside parts, the same bytes twice, and usable in a browser."""

import html
import json
import re
import shutil
import subprocess
import tomllib

import pandas as pd
import pytest
from PIL import Image
from programs import program
from study.paper.report_evidence import EVIDENCE, set_in_words

CHROMIUM = shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")
VERDICTS = """id,verdict,grounds,claim,where,paper_value,unit,measured,note,explanation,verdict_corrected,runs
reynolds,NOT REPRODUCED,,a claim with <angle> & sign,Section 3.1,0.76,,0.461,,as we read it,REPRODUCED,
resistance,REPRODUCED,,another claim,Section 3.1,8.8e8,Pa s/m^2,8.7e8,a note,,REPRODUCED,
table-1,HOLDS WITH ANOTHER VALUE,differs by a bit,a third claim,Table 1,1.2,um,1.3,,as we read it,NOT RUN,
window,REPRODUCED,,a claim of passages,Section 4.2,,,both classes,,,NOT RUN,{runs}
"""
SEPARATION = "variant,row_shift_um,s_um\n" + "".join(f"accurate-0.4,{d / 10},1.5\n" for d in range(20, 100))
UNITS = "capillary_number,length_scale_um,pressure_gradient_bar_per_m\n0.1,7.589,0.2\n0.1,4.8,0.3\n"


@pytest.fixture(scope="module")
def make(results, call, root, tmp_path_factory):
    """Makes the report from made-up results; returns its path."""
    if "smoke" not in results.name:
        pytest.skip("one tier is enough")
    folder = tmp_path_factory.mktemp("report")
    tables, figures, templates = folder / "tables", folder / "figures", root / "workflow/templates"
    tables.mkdir()
    figures.mkdir()
    for name in ("fig01", "fig02", "fig05", "fig06", "fig07", "fig09"):
        Image.new("RGB", (2000, 1000), "white").save(figures / f"{name}.png")
    runs = {"plan": results / "plan.json", "runs": results / "runs", "brackets": results / "brackets"}
    call("passages_table", **runs, output=tables / "passages.csv")
    runs_of_claim = " ".join(pd.read_csv(tables / "passages.csv").run.unique())
    (folder / "claims.csv").write_text(VERDICTS.format(runs=runs_of_claim), encoding="utf-8")
    (tables / "streamline_separation.csv").write_text(SEPARATION, encoding="utf-8")
    (tables / "units.csv").write_text(UNITS, encoding="utf-8")
    boundary = {"offset_um": 2.5, "amplitude_um": 5.0, "rate": 1.5}
    rows = [{"name": "boundary/made-up", "parameter": key, "value": value} for key, value in boundary.items()]
    pd.DataFrame(rows).to_csv(tables / "fits.csv", index=False)
    data = {name: tables / f"{name}.csv" for name in ("trajectories", "provenance")}
    call("report_data", **runs, groups="passages", **data)

    def report(name):
        given = {"tables": tables, "figures": figures, "verdicts": folder / "claims.csv"}
        given |= {"claims": root / "params/claims.json", "captions": templates / "figures.toml"}
        given |= {"template": templates / "report.html.j2", "output": folder / name}
        call("report", plan=runs["plan"], **data, **given)
        return folder / name

    report.passages = pd.read_csv(tables / "passages.csv")
    return report


@pytest.fixture(scope="module")
def page(make):
    return make("report.html")


def data_of(text):
    return json.loads(re.search(r'<script type="application/json" id="data">(.*?)</script>', text)[1])


def test_the_page_stands_alone(page):
    text = page.read_text(encoding="utf-8")
    loaded = re.findall(r'(?:src|srcset|href)\s*=\s*"([^"]*)"', text)
    assert [one for one in loaded if not one.startswith(("#", "data:"))] == []
    assert not re.search(r"@import|url\(|fetch\(|XMLHttpRequest|import\(", text)
    assert page.stat().st_size < 10e6
    assert 'alt="Phase space: the printed boundary' in text


def test_the_page_shows_every_passage_and_verdict(page, make):
    text = page.read_text(encoding="utf-8")
    points = data_of(text)["points"]
    assert sorted(point["run"] for point in points) == sorted(make.passages.run)
    assert text.count('class="point ') - 4 == len(points)  # four more in the legend
    assert "a claim with &lt;angle&gt; &amp; sign" in text
    assert re.search(r'id="claim-reynolds".*?not-reproduced', text, re.DOTALL)
    assert re.search(r'id="claim-table-1".*?holds-with-another-value.*?differs by a bit', text, re.DOTALL)
    assert "<b>1</b> holds with another value" in text and "<b>0</b> print contradicts itself" in text
    assert "made up" in text  # the commit in the provenance of the made-up runs
    assert "boundary: made-up" in text


def test_trajectories_belong_to_the_passages(page, make):
    data = data_of(page.read_text(encoding="utf-8"))
    assert set(data["trajectories"]) <= set(make.passages.run)
    decided = make.passages[make.passages["class"].isin(["displaced", "zigzag"])]
    assert set(decided.run) <= set(data["trajectories"])


def test_the_page_has_the_same_bytes(page, make):
    assert make("again.html").read_bytes() == page.read_bytes()


def in_browser(page, tmp_path, script="", fragment="", width=1200):
    """The document after the page, and then a script of the test, ran in headless Chromium."""
    copy = tmp_path / "page.html"
    text = page.read_text(encoding="utf-8")
    copy.write_text(text.replace("</body>", f"<script>{script}</script></body>"), encoding="utf-8")
    return opened(copy.as_uri() + fragment, tmp_path, width)


def opened(address, tmp_path, width=1200):
    """The document at an address after its scripts ran in headless Chromium."""
    command = [
        CHROMIUM,
        "--headless",
        "--no-sandbox",
        "--disable-gpu",
        "--allow-file-access-from-files",
        f"--user-data-dir={tmp_path / 'user'}",
    ]
    command += [f"--window-size={width},900", "--virtual-time-budget=2000", "--dump-dom", address]
    return subprocess.run(command, capture_output=True, text=True, timeout=240, check=True).stdout


def in_frame(page, tmp_path, script, fragment="", width=400):
    """What a script says of the page in a frame, which can be narrower than a window; `page` in the script is
    the document of the page. The script returns a text."""
    frame = tmp_path / "frame.html"
    look = f"width: {width}px; height: 800px; border: 0"
    frame.write_text(
        f'''<iframe src="{page.as_uri()}{fragment}" style="{look}"></iframe>
        <script>document.querySelector("iframe").addEventListener("load", (event) => {{
          const page = event.target.contentDocument, view = event.target.contentWindow;
          setTimeout(() => {{ document.body.dataset.found = (() => {{ {script} }})(); }}, 500);
        }});</script>''',
        encoding="utf-8",
    )
    return re.search(r'data-found="([^"]*)"', opened(frame.as_uri(), tmp_path))[1]


def details(document):
    """Terms and values of the panel beside the phase space."""
    panel = re.search(r'<div id="details".*?</div>', document, re.DOTALL)[0]
    pairs = re.findall(r"<dt>(.*?)</dt><dd>(.*?)</dd>", panel)
    return {html.unescape(name): html.unescape(value) for name, value in pairs}, panel


needs_chromium = pytest.mark.skipif(not CHROMIUM, reason="Chromium is not installed")


@needs_chromium
def test_a_link_opens_the_page_at_its_run(page, make, tmp_path):
    row = make.passages[make.passages["class"] == "zigzag"].iloc[-1]
    found, panel = details(in_browser(page, tmp_path, fragment=f"#run-{row.run}"))
    assert found["run"] == row.run
    assert found["class"] == "zigzag"
    assert float(found["Ca"]) == pytest.approx(row.capillary_number)
    assert "<polyline" in panel and "<circle" in panel


@needs_chromium
def test_the_panel_has_the_class_in_print_and_two_s_and_the_pressure(page, make, tmp_path):
    row = make.passages[make.passages["class"] == "zigzag"].iloc[-1]
    found, _ = details(in_browser(page, tmp_path, fragment=f"#run-{row.run}"))
    assert found["2 s, without a cell"] == "3 µm"
    assert float(found["pressure, healthy cell"].removesuffix(" bar/m")) == pytest.approx(
        2 * row.capillary_number, rel=5e-3
    )
    assert found["class in print"] in ("displaced", "zigzag", "not stated")
    assert "not measured" not in found.values()


@needs_chromium
def test_a_jump_lands_where_it_points(page, tmp_path):
    script = "return page.getElementById('figure-fig09').getBoundingClientRect().top;"
    assert abs(float(in_frame(page, tmp_path, script, "#figure-fig09", 1200))) < 60


@needs_chromium
def test_verdict_and_measured_value_are_on_a_screen_of_400_pixels(page, tmp_path):
    script = """
    const cells = [...page.querySelectorAll(".verdicts tbody td")];
    const places = cells.map((cell) => cell.getBoundingClientRect());
    const right = Math.max(...places.map((place) => place.right));
    const read = cells.filter((cell) => cell.dataset.label === "Verdict" && cell.offsetWidth > 100).length;
    return [right, page.documentElement.clientWidth, read].join(" ");
    """
    right, there, read = map(float, in_frame(page, tmp_path, script).split(" "))
    assert right <= there <= 400 and read == 4


@needs_chromium
def test_every_link_within_the_page_has_its_place(page, tmp_path):
    text = page.read_text(encoding="utf-8")
    ids = set(re.findall(r'\bid="([^"]+)"', text))
    targets = {one[1:] for one in re.findall(r'href="(#[^"]+)"', text)}
    runs = {point["run"] for point in data_of(text)["points"]}
    assert {one for one in targets if not one.startswith("run-")} <= ids
    assert {one.removeprefix("run-") for one in targets if one.startswith("run-")} == runs
    assert {"figure-fig07", "table-passages"} <= targets
    script = """
    view.location.hash = page.querySelector("a.run").hash;
    view.dispatchEvent(new view.Event("hashchange"));
    const text = (place) => page.querySelector(place).textContent;
    return [text("#details dd:last-of-type"), text("a.run")].join(" ");
    """
    shown, wanted = in_frame(page, tmp_path, script, width=1200).split(" ")
    assert shown == wanted


def test_every_claim_rests_on_a_figure_and_a_table_of_the_report(root):
    claims = json.loads((root / "params/claims.json").read_text(encoding="utf-8"))["claims"]
    assert set(EVIDENCE) == {claim["id"] for claim in claims}
    captions = tomllib.loads((root / "workflow/templates/figures.toml").read_text(encoding="utf-8"))[
        "captions"
    ]
    shown = program("report").read_text(encoding="utf-8")
    for figure, table in EVIDENCE.values():
        assert figure in captions
        assert f'"{table}": (' in shown


def test_runs_that_several_readings_judge_are_named_after_the_first():
    readings = [
        {"sweep": "grid", "series": "default", "description": "the first"},
        {"sweep": "grid", "series": "default", "description": "another view"},
    ]
    assert (
        set_in_words("boundary/default", 0.4, "free", readings)
        == "Search for the boundary: the first (lattice 0.4 um)"
    )
    assert set_in_words("second-start", 0.2, "blocked", readings).endswith(
        "(lattice 0.2 um, no net lateral flow)"
    )


def test_grades_are_counted_first_and_by_reading(page):
    text = page.read_text(encoding="utf-8")
    assert text.index("by reading of what the paper leaves open") < text.index('id="claim-reynolds"')
    corrected = re.search(r"<tr><td[^>]*><b>corrected</b>.*?</tr>", text, re.DOTALL)[0]
    assert re.findall(r">(\d+)</td>", corrected) == ["2", "0", "0", "0", "0", "2"]
    assert "hinge_sheet</b>" not in text  # a reading that was not judged has no line


def test_sets_of_runs_are_named_in_words(page):
    labels = re.findall(r"<option[^>]*>([^<]*)</option>", page.read_text(encoding="utf-8"))
    assert any(label.startswith("The grid: every row shift") for label in labels)
    assert not any("dx =" in label or "boundary/" in label for label in labels)


@needs_chromium
def test_hover_click_keys_and_sets(page, tmp_path):
    script = """
    const out = [], panel = document.getElementById("details"), select = document.getElementById("set");
    const run = () => (panel.querySelector("dd:last-of-type") || {}).textContent || "none";
    const shown = () => [...document.querySelectorAll("#plot .point:not([display])")];
    const fire = (mark, event) => mark.dispatchEvent(event);
    out.push(run());
    fire(shown()[1], new PointerEvent("pointerenter"));
    out.push(run());
    fire(shown()[0], new MouseEvent("click", { bubbles: true }));
    fire(shown()[1], new PointerEvent("pointerenter"));
    fire(shown()[1], new PointerEvent("pointerleave"));
    out.push(run(), location.hash);
    fire(shown()[0], new KeyboardEvent("keydown", { key: "ArrowRight", bubbles: true, cancelable: true }));
    fire(shown()[0], new KeyboardEvent("keydown", { key: "ArrowUp", bubbles: true, cancelable: true }));
    out.push(run());
    const before = shown().map((mark) => mark.dataset.set);
    select.selectedIndex = 1;
    select.dispatchEvent(new Event("change"));
    const after = shown().map((mark) => mark.dataset.set);
    out.push(String(new Set(before).size === 1 && new Set(after).size === 1 && before[0] !== after[0]));
    document.body.dataset.found = out.join(" ");
    """
    document = in_browser(page, tmp_path, script)
    nothing, hovered, clicked, link, moved, sets = re.search(r'data-found="([^"]*)"', document)[1].split(" ")
    assert nothing == "none"
    assert re.fullmatch(r"[0-9a-f]{12}", hovered) and hovered != clicked
    assert link == f"#run-{clicked}"
    assert moved != clicked
    assert sets == "true"


@needs_chromium
@pytest.mark.parametrize("width", [500, 1200])
def test_nothing_is_wider_than_the_screen(page, tmp_path, width):
    script = """
    const root = document.documentElement;
    document.body.dataset.found = [root.scrollWidth, root.clientWidth].join(" ");
    """
    document = in_browser(page, tmp_path, script, width=width)
    needed, there = map(int, re.search(r'data-found="([^"]*)"', document)[1].split(" "))
    assert needed <= there <= width
