#!/bin/sh
# A job for each row of table.csv, as many at once as there are processors; jobs.csv gets a row for each.
rm -f jobs.csv
parallel --colsep , --skip-first-line \
  contact2d run -q ../roller.c2s mu={1} P={2} --response "'max tn; contact edge 1 x'" --row jobs.csv :::: table.csv
