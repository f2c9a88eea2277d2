# make proof: all that takes longer than a change can wait for, as stages (tests/proof/stages.txt), one after the other: those that
# failed or never ran first, then those whose last pass is of another state of the tree. What is interrupted is begun again at the
# stage that was running. tests/PROOF.md keeps the commit, the date and the result of each stage's last run.
# STAGES='fuzz faults' runs these, whatever they had. Included by the Makefile.
#: make proof                       all long checks, in stages; results in tests/PROOF.md (STAGES=)
.PHONY: proof
STAGES ?=
proof:
	+@MAKE='$(MAKE)' sh tests/proof/proof.sh $(STAGES)
