#!/bin/sh
# batch.sh FILE...: several tests as one source, as their headers take longer to compile than they do. What stands up to a file's last
# #include stays as it is; the rest has a namespace of its own, so that names that are private to a file stay so.
for file; do
  last=$(awk '/^using namespace|^namespace {|^TEST_CASE/ { exit } /^#if/ { ++depth } /^#endif/ { --depth }
              /^#include/ { last = NR; within = depth } /^#endif/ && depth < within { last = NR; within = depth }
              END { print last }' "$file")
  printf '#line 1 "%s"\n' "$file"
  head -n "$last" "$file"
  printf 'namespace of_%s {\n#line %s "%s"\n' "$(basename "$file" .cpp)" $((last + 1)) "$file"
  tail -n "+$((last + 1))" "$file"
  echo '}'
done
