# make gallery: the page of pictures examples/gallery/README.md, made anew. Included by the Makefile.
#: make gallery                     examples/gallery: pictures and key numbers of all sketches, some minutes
.PHONY: gallery
gallery: $(PROGRAM)
	sh examples/gallery/gallery.sh $(PROGRAM) examples/gallery
	@echo 'The gallery: examples/gallery/README.md'
