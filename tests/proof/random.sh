#!/bin/sh
# random.sh: the long draws of make proof, each kind of random deck (tests/random/random.mk).
set -e
$MAKE -s random N=1000 SEED=1
for kind in few lift mirror three revolved resume punch; do $MAKE -s random KIND=$kind N=200 SEED=1; done
