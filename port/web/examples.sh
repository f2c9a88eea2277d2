#!/bin/sh
# Examples as one JSON object, {"name": "text", ...}: examples.sh FILE ...
printf '{'
comma=
for file; do
  printf '%s"%s":"' "$comma" "$(basename "$file")"
  sed -e 's/\\/\\\\/g' -e 's/"/\\"/g' -e 's/\t/\\t/g' -e 's/\r//g' -e 's/$/\\n/' "$file" | tr -d '\n'
  printf '"'
  comma=,
done
printf '}\n'
