#!/bin/sh
# Dakota's fork interface: driver params.in results.out. The results always exist, and begin with FAIL where the run failed.
contact2d run -q "$(dirname "$0")/../roller.c2s" --params "$1" --response 'max tn; contact edge 1 x' --results "$2"
exit 0
