"""What the rules and scripts of the study share: run identities, tables, fits, claims and the plot style."""
