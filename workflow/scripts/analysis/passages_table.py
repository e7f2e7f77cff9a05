"""One row for every passage of a cell: class, lateral extent, quality, cost. Diverged runs are rows too.

The runs that narrowed the boundary stand in the sweeps boundary/<series>.
"""

from study.analysis.arguments import table_arguments
from study.analysis.passages import COLUMNS, KEYS, STYLES, row_of
from study.analysis.runs import passage_runs
from study.analysis.tables import write_table

arguments = table_arguments(__doc__, "brackets")
runs = passage_runs(arguments.plan, arguments.brackets, arguments.runs)
write_table([row_of(run) for run in runs], COLUMNS, arguments.output, KEYS, STYLES)
