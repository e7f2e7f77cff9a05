"""Figures of a study, from its tables alone. A new one is a program in scripts/drawing and a rule here."""

if HAS_FLOW:

    rule figure_devices:
        input:
            plan=PLAN_FILE,
            devices=rules.study_devices.output.devices,
            lines=rules.study_devices.output.lines,
            script=f"{SCRIPTS}/drawing/fig_devices.py",
            modules=modules_of(f"{SCRIPTS}/drawing/fig_devices.py"),
        output:
            multiext(f"{FIGURES}/fig_devices", pdf=".pdf", png=".png"),
        log:
            f"{LOGS}/fig_devices.log",
        shell:
            """
            python {input.script} --plan {input.plan} --devices {input.devices} --lines {input.lines} \
                --output {output.pdf} 2> {log}
            """


    rule figure_study_separation:
        input:
            plan=PLAN_FILE,
            table=SEPARATION_TABLE,
            script=f"{SCRIPTS}/drawing/fig_separation.py",
            modules=modules_of(f"{SCRIPTS}/drawing/fig_separation.py"),
        output:
            multiext(f"{FIGURES}/fig_separation", pdf=".pdf", png=".png"),
        log:
            f"{LOGS}/fig_separation.log",
        shell:
            "python {input.script} --plan {input.plan} --table {input.table} --output {output.pdf} 2> {log}"


if HAS_CELLS:

    rule figure_study_phase_space:
        input:
            plan=PLAN_FILE,
            passages=rules.passages_table.output,
            boundary=rules.boundary_tables.output.boundary,
            script=f"{SCRIPTS}/drawing/fig_study_phase_space.py",
            modules=modules_of(f"{SCRIPTS}/drawing/fig_study_phase_space.py"),
        output:
            multiext(f"{FIGURES}/fig_phase_space", pdf=".pdf", png=".png"),
        log:
            f"{LOGS}/fig_phase_space.log",
        shell:
            """
            python {input.script} --plan {input.plan} --passages {input.passages} --boundary {input.boundary} \
                --output {output.pdf} 2> {log}
            """


if HAS_WINDOW:

    rule figure_window:
        input:
            plan=PLAN_FILE,
            window=rules.study_window.output,
            script=f"{SCRIPTS}/drawing/fig_window.py",
            modules=modules_of(f"{SCRIPTS}/drawing/fig_window.py"),
        output:
            multiext(f"{FIGURES}/fig_window", pdf=".pdf", png=".png"),
        log:
            f"{LOGS}/fig_window.log",
        shell:
            "python {input.script} --plan {input.plan} --window {input.window} --output {output.pdf} 2> {log}"


if HAS_STRETCHING:

    rule figure_study_stretching:
        input:
            plan=PLAN_FILE,
            table=rules.study_stretching.output,
            script=f"{SCRIPTS}/drawing/fig_stretching.py",
            modules=modules_of(f"{SCRIPTS}/drawing/fig_stretching.py"),
        output:
            multiext(f"{FIGURES}/fig_stretching", pdf=".pdf", png=".png"),
        log:
            f"{LOGS}/fig_stretching.log",
        shell:
            "python {input.script} --plan {input.plan} --table {input.table} --output {output.pdf} 2> {log}"


if HAS_SENSITIVITY:

    rule figure_study_sensitivity:
        input:
            plan=PLAN_FILE,
            table=rules.sensitivity_table.output,
            script=f"{SCRIPTS}/drawing/fig_sensitivity.py",
            modules=modules_of(f"{SCRIPTS}/drawing/fig_sensitivity.py"),
        output:
            multiext(f"{FIGURES}/fig_sensitivity", pdf=".pdf", png=".png", csv=".csv"),
        log:
            f"{LOGS}/fig_sensitivity.log",
        shell:
            """
            python {input.script} --plan {input.plan} --table {input.table} \
                --csv {output.csv} --output {output.pdf} 2> {log}
            """
