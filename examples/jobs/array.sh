#!/bin/sh
#SBATCH --array=1-4
#SBATCH --ntasks=1
#SBATCH --output=slurm-%a.txt
# Task i takes row i of table.csv. What has its result already is not run again, so the same array can be submitted once more.
i=${SLURM_ARRAY_TASK_ID:-$1}
out=row-$i.txt
[ -f "$out" ] && ! grep -q '^FAIL' "$out" && exit 0
row=$(sed -n "$((i + 1))p" table.csv)
exec contact2d run -q ../roller.c2s mu="${row%,*}" P="${row#*,}" --response 'max tn; contact edge 1 x' --results "$out"
