"""Design studies: many runs of a case on Snakemake, their responses in one table, and what follows from them.

A study file (TOML) names a base case, what varies and what is wanted. `study_file` reads it, `sampling` chooses the
runs, `cases` has each of them checked and written out, `manifest` remembers them, `workflow` hands them to Snakemake,
`one_run` is what Snakemake runs, `responses`, `table` and `report` gather the results, `optimise` proposes further runs.
"""
