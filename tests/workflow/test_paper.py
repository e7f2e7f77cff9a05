"""The article: no result written by hand, every number declared, the same bytes twice."""

import re
import shutil
import subprocess
import tomllib
from pathlib import Path

import pandas as pd
import pytest
from study.analysis.boundary import UNDISPUTED
from study.paper import article_tables, manuscript
from study.planning.documents import read_json

ROOT = Path(__file__).resolve().parents[2]
PAPER = ROOT / "paper"
TEXT = re.sub(r"(?<!\\)%.*", "", (PAPER / "main.tex").read_text(encoding="utf-8"))
DECLARED = tomllib.loads((PAPER / "numbers.toml").read_text(encoding="utf-8"))

#: Where digits are no results: keys, labels, file names, lengths, names such as D3Q19, places in the article.
ALLOWED = [
    r"(?<!\\)%.*",
    r"\\(?:val|whenknown|verdict|cite|ref|eqref|label|input|restable|name|original|bibliography)\{[^{}]*\}",
    r"\\resultfigure\{[^{}]*\}",
    r"\\(?:begin|end)\{[^{}]*\}|\\(?:vspace|hspace)\{[^{}]*\}|\\emergencystretch=[\d.]+em",
    r"[\^_]\{?\d\}?",  # exponents and indices of one digit
    r"(?<![\d.])2(?=[Rs]\b)",  # twice a symbol: 2R, 2s
]
#: Whole numbers are allowed in displayed equations, where they belong to the formula.
EQUATION = re.compile(r"\\begin\{equation\}.*?\\end\{equation\}", re.DOTALL)
SPELLED = (
    r"\b(?:two|three|four|five|six|seven|eight|nine|ten|eleven|twelve|twenty|thirty|fifty|hundred|half a)"
    r"[ -](?:times|fold|per cent|percent|micrometres?|lattice spacings)\b"
)


def written_by_hand(text):
    """Numbers of a LaTeX text that stand outside the contexts in which digits are allowed."""
    body = text.partition(r"\begin{document}")[2] or text
    body = EQUATION.sub(lambda match: " ".join(re.findall(r"\d*\.\d+", match[0])), body)
    for pattern in ALLOWED:
        body = re.sub(pattern, " ", body)
    return re.findall(r"\d[\d.,]*", body) + re.findall(SPELLED, body)


def test_no_result_is_written_by_hand():
    assert written_by_hand(TEXT) == []


@pytest.mark.parametrize(
    "text",
    [
        "the exponent is 0.71",
        r"$B=0.71\pm 0.01$",
        r"\begin{equation} d = 2.9 + 5.4 \exp(-c) \end{equation}",
        "a factor of 12",
        r"\textbf{17} cells \ref{tab:1}",
        "ten per cent wider",
        r"$10^{11}$",
    ],
)
def test_results_written_by_hand_are_found(text):
    assert written_by_hand(text)


@pytest.mark.parametrize(
    "text",
    [
        r"$B=\val{law/refined/B}$, \cite{huang2004}, Fig.~\ref{fig:fig04}, \original{Fig.~8}, \name{D3Q19}",
        r"\begin{equation} W = \frac{k}{12} I_2^2 \end{equation} % 0.5",
        r"\resultfigure{fig04}{Flow}, s/m$^2$",
    ],
)
def test_names_keys_and_formulas_are_no_results(text):
    assert written_by_hand(text) == []


def test_every_value_and_table_of_the_text_is_declared_and_used():
    keys = {one["key"] for group in DECLARED["numbers"] for one in manuscript.expanded(group)}
    used = set(re.findall(r"\\(?:val|whenknown)\{([^}#]+)\}", TEXT))
    used |= {f"verdict/{name}" for name in re.findall(r"\\verdict\{([^}#]+)\}", TEXT)}
    assert used - keys == set()
    assert set(re.findall(r"\\restable\{([^}#]+)\}", TEXT)) == set(DECLARED["tables"])


def test_references_are_cited_and_there():
    entries = set(re.findall(r"@\w+\{(\w+),", (PAPER / "references.bib").read_text(encoding="utf-8")))
    cited = {key for keys in re.findall(r"\\cite\{([^}]+)\}", TEXT) for key in keys.split(",")}
    assert cited == entries


def test_labels_exist():
    labels = set(re.findall(r"\\label\{([^}#]+)\}", TEXT))
    labels |= {f"fig:{name}" for name in re.findall(r"\\resultfigure\{([^}#]+)\}", TEXT)}
    assert set(re.findall(r"\\(?:eq)?ref\{([^}#]+)\}", TEXT)) <= labels


TABLE = pd.DataFrame(
    {
        "name": ["law/a", "law/a", "law/b"],
        "parameter": ["A", "B", "A"],
        "value": [17.613, -0.0004, None],
        "low": [17.0, None, 3.0],
        "high": [18.0, 1.0, None],
    }
)


def value(**entry):
    return manuscript.number({"key": "x", "table": "fits", "column": "value"} | entry, {"fits": TABLE}, {})


def test_numbers_are_looked_up():
    row = {"name": "law/a", "parameter": "A"}
    assert value(where=row, format=".1f") == "17.6"
    assert value(where={"parameter": "B"}, format=".2f") == "0.00"
    assert value(where={"parameter": "B"}, format=".4f") == r"\ensuremath{-}0.0004"
    assert value(where=row, format="sci:1") == r"\ensuremath{1.8\times10^{1}}"
    assert value(where=row, format="percent:0") == "1761"
    assert value(where={"name": "law/*"}, column="low", reduce="range", format=".0f") == "3--17"
    assert value(where={"name": "law/*"}, column="name", reduce="count", format=".0f") == "2"
    assert value(where=row, column="name", words={"law/a": "first"}) == "first"


def test_rows_that_match_one_of_several_conditions_are_counted_once():
    where = [{"name": "law/a", "parameter": ["A", "B"]}, {"parameter": "B"}]
    assert value(where=where, column="parameter", reduce="count", format=".0f") == "2"
    assert value(where=where, column="low", reduce="range", format=".0f") == "17"
    assert value(where=[{"name": "law/c"}]) == manuscript.MISSING


def test_an_entry_of_a_list_is_found_by_a_number():
    document = {"claims": [{"d": 4.4, "ca": 1.2}, {"d": 6.0, "ca": 0.5}]}
    assert manuscript.at_pointer(document, "/claims/d=6.0/ca") == 0.5
    assert manuscript.at_pointer(document, "/claims/d=5.2/ca") is None


PRINTED = read_json(ROOT / "params/claims.json")
CASE = read_json(ROOT / "workflow/schemas/case.schema.json")
VERDICTS = pd.DataFrame(
    {
        "verdict": ["REPRODUCED", "REPRODUCED", "NOT RUN"],
        "verdict_corrected": ["NOT REPRODUCED", "NOT RUN", "NOT RUN"],
    }
)


def test_the_boundary_stands_beside_the_printed_law_and_classes():
    boundary = {"series": "default", "row_shift_um": [2.0, 6.8], UNDISPUTED[0]: 1.0, UNDISPUTED[1]: 2.0}
    boundary = pd.DataFrame(boundary)
    made = article_tables.article_tables({"claims": VERDICTS, "phase_boundary": boundary}, PRINTED, CASE)
    rows = made["phase_boundary"].set_index(["series", "row_shift_um"])[UNDISPUTED]
    assert rows.loc[("eq-5", 6.8)].round(3).tolist() == [0.189, 0.189]
    assert rows.loc[("eq-5", 2.0)].isna().all()
    assert rows.loc[("text", 6.8)].tolist() == [0.15, 0.3]
    assert ("text", 8.0) not in rows.index
    text = manuscript.table(DECLARED["tables"]["boundary"], made)
    assert r"6.8 & 0.19 & 0.15--0.3 & 1.00--2.00 & " in text


def test_extents_stand_beside_the_print_and_the_tweezer():
    passages = pd.DataFrame({"sweep": ["grid", "corrected", "grid"], "row_shift_um": [6.8, 6.8, 2.0]})
    passages = passages.assign(capillary_number=[0.15, 0.15, 0.3], d_perp_um=[6.0, 6.1, 9.0])
    predictions = passages.assign(tweezer_um=6.5)
    made = article_tables.extents(passages, predictions, article_tables.claim_of(PRINTED, "d-perp-6.8"))
    text = manuscript.table(DECLARED["tables"]["extents"], {"extents": made})
    assert r"0.15 & 6.7 & 6.50 & 6.00 & 6.10 & " in text
    assert "9.00" not in text and "0.30 & " not in text  # another row shift, no cell of the default


def test_grades_are_counted_by_reading():
    made = article_tables.grades_by_reading(VERDICTS, PRINTED["readings"]).set_index("reading")
    assert list(made.index) == ["default", "corrected"]
    assert made.loc["default", ["REPRODUCED", "NOT RUN"]].tolist() == [2, 1]
    assert made.loc["corrected", ["REPRODUCED", "NOT REPRODUCED", "NOT RUN"]].tolist() == [0, 1, 2]


def test_the_fold_of_a_healthy_cell_has_its_modulus():
    laws = pd.DataFrame({"law": ["hinge_half"], "fold_modulus_ratio": [1.5]})
    made = article_tables.with_moduli(laws, CASE).iloc[0]
    assert made.stated_modulus_Nm == pytest.approx(2.0e-19, rel=0.01)
    assert made.fold_modulus_Nm == pytest.approx(3.0e-19, rel=0.01)


def test_the_cells_of_the_print_are_those_whose_class_it_states():
    """Every cell is named once as displaced or zigzag, in accordance with the classes that the boundary is
    judged by."""
    entries = {one["key"]: one for group in DECLARED["numbers"] for one in manuscript.expanded(group)}
    shifts, numbers = [2.0, 4.4, 5.2, 6.0, 6.8, 8.0, 8.8], [0.1, 0.15, 0.3, 0.5, 0.7, 1.2]
    cells = pd.DataFrame([{"row_shift_um": d, "capillary_number": ca} for d in shifts for ca in numbers])
    claim = article_tables.claim_of(PRINTED, "phase-boundary")
    said = {one["row_shift_um"]: one for one in claim["statements"]}
    classes = []
    for row in cells.itertuples():
        low, high = (said[row.row_shift_um][name] for name in ("displaced_to", "zigzag_from"))
        displaced, zigzag = low and row.capillary_number <= low, high and row.capillary_number >= high
        classes.append("displaced" if displaced else "zigzag" if zigzag else "none")
    table = {"passages": cells.assign(sweep="grid", run=cells.index.astype(str), **{"class": classes})}
    found = [manuscript.number(entries[f"cells/grid/{name}"], table, {}) for name in ("all", "as-printed")]
    assert found == ["34", "34"]


def test_what_a_tier_lacks_is_missing_and_a_slip_is_an_error():
    assert value(where={"name": "law/c"}) == manuscript.MISSING
    assert value(where={"name": "law/b"}) == manuscript.MISSING
    assert value(table="elsewhere") == manuscript.MISSING
    for slip in ({"where": {"nmae": "law/a"}}, {"column": "valeu"}, {"column": "name", "where": {}}):
        with pytest.raises((KeyError, ValueError)):
            value(**slip)


def test_tables_are_typeset_with_brackets():
    columns = [{"head": "fit", "value": "name", "drop": "law/"}]
    columns += [{"head": "A", "value": ["low A", "high A"], "format": ".1f", "layout": "r"}]
    entry = {"table": "fits", "columns": columns, "sort": ["name"]}
    entry["pivot"] = {"index": ["name"], "columns": "parameter", "values": ["low", "high"]}
    lines = manuscript.table(entry, {"fits": TABLE}).splitlines()
    assert lines[0] == r"\begin{tabular}{lr}"
    assert lines[4:6] == [r"a & 17.0--18.0 \\", r"b & $>$3.0 \\"]
    assert "no rows" in manuscript.table(entry, {})


@pytest.mark.parametrize(
    ("plain", "latex"),
    [
        ("8.7e+08 Pa", r"$8.7\times10^{8}$ Pa"),
        ("1.1e-02", r"$1.1\times10^{-2}$"),
        ("mean: 880000000.0", r"mean: \ensuremath{8.8\times10^{8}}"),
        ("17 um eps^0.76, D_perp >= 5 %", r"17 \textmu{}m $\varepsilon$$^{0.76}$, $D_\perp$ $\ge$ 5 \%"),
        ("A_um = 17 +- 1", r"A \textmu{}m = 17 $\pm$ 1"),
    ],
)
def test_plain_notation_is_typeset(plain, latex):
    assert manuscript.typeset(plain) == latex


@pytest.fixture(scope="module")
def generated(results, call, root, tmp_path_factory):
    """Folder of the generated part of the article from made-up results."""
    flow = results / "tables/streamline_separation.csv"
    claims, folder = root / "params/claims.json", tmp_path_factory.mktemp("paper")
    call("streamline_table", plan=results / "plan.json", runs=results / "runs", output=flow)
    call(
        "passages_table",
        plan=results / "plan.json",
        runs=results / "runs",
        brackets=results / "brackets",
        output=flow.with_name("passages.csv"),
    )
    tables, verdicts = folder / "tables", folder / "claims.csv"
    shutil.copytree(results / "tables", tables)
    known = {"plan": results / "plan.json", "brackets": results / "brackets"}
    call("boundary_uncertainty", **known, output=tables / "boundary_uncertainty.csv")
    laws = ["law,prefactor,fold_modulus_ratio,sphere_ratio,squeeze_anisotropy,mesh_frequency"]
    laws += [f"{law},0.9,1.5,0.5,0.3,40" for law in ("hinge_sphere", "hinge_half", "mean_curvature")]
    (tables / "bending_laws.csv").write_text("\n".join(laws) + "\n")
    names = ["id", "claim", "where", "paper_value", "measured", "note", "explanation", "verdict"]
    verdicts.write_text(f"{','.join(names)}\nreynolds,Re,here,1,2,,,NOT RUN\n")
    given = {"declared": PAPER / "numbers.toml", "tables": tables, "verdicts": verdicts}
    given |= {"claims": claims, "case-schema": root / "workflow/schemas/case.schema.json"}
    call("paper_numbers", **given, plan=results / "plan.json", results=results, output=folder)
    return folder


def test_generated_numbers_follow_the_tables(generated, results):
    text = (generated / "numbers.tex").read_text()
    found = dict(re.findall(r"\\definevalue\{([^}]+)\}\{(.*)\}", text))
    assert found["verdict/reynolds"] == "NOT RUN"
    assert found["verdict/tweezer"] == manuscript.MISSING
    assert found["bending/hinge_half/fold_modulus_Nm"] == r"\ensuremath{3.0\times10^{-19}}"
    missing = found["class/grid/4.4/1.2"] == manuscript.MISSING
    assert missing == ("smoke" in results.name)  # a tier without the cells of the print
    assert found["passages/all"] == str(pd.read_csv(results / "tables/passages.csv").run.nunique())


@pytest.mark.skipif(not shutil.which("latexmk"), reason="LaTeX is not installed")
def test_the_article_is_typeset_with_the_same_bytes(generated, tmp_path):
    def build(name):
        pdf = tmp_path / f"{name}.pdf"
        program = ROOT / "workflow/scripts/build_paper"
        command = [program, "paper/main.tex", generated, tmp_path / name, pdf]
        done = subprocess.run(command, cwd=ROOT, capture_output=True, encoding="latin-1", check=False)
        assert done.returncode == 0, done.stdout[-3000:]
        log = (tmp_path / name / "main.log").read_text(encoding="latin-1")
        assert not re.search(r"undefined (?:references|citations)|LaTeX Warning: Reference", log)
        # The commands in the captions carry the folder of the test, which is longer than that of the study.
        boxes = re.findall(r"Overfull \\hbox \(([\d.]+)pt[^\n]*\n([^\n]*)", log)
        assert all(float(width) < 12 for width, text in boxes if "/figures/" not in text)
        return pdf.read_bytes()

    assert build("first") == build("second")


def test_no_number_of_the_article_is_a_whole_table_of_values(generated):
    text = (Path(generated) / "numbers.tex").read_text(encoding="utf-8")
    assert "'factor'" not in text and "\\{'" not in text


def test_a_value_that_is_a_table_is_refused():
    entry = {"key": "printed/factor", "json": "printed", "at": "/value"}
    with pytest.raises(ValueError, match="printed/factor"):
        manuscript.number(entry, {}, {"printed": {"value": {"factor": 1.08}}})
