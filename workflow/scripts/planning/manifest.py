"""Are the tables, figures and verdicts of a study as the pipeline made them? Names those that are not, with
exit code 1. With --accept: takes all as they are from now on."""

import argparse
import sys

from study.planning.manifest import Changed, accept, changed, recorded

parser = argparse.ArgumentParser(description=__doc__)
parser.add_argument("folder", help="folder of the results of a study, for example results")
parser.add_argument("--accept", action="store_true", help="what is there is right: write the table anew")
arguments = parser.parse_args()
if arguments.accept:
    print(f"{len(accept(arguments.folder))} files of {arguments.folder} are taken as they are")
elif wrong := changed(arguments.folder):
    sys.exit(str(Changed(wrong)))
else:
    files = len(recorded(arguments.folder))
    print(f"{arguments.folder}: what is there of {files} files is as it was made")
