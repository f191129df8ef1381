#!/bin/sh
# A study in shards on one computer, or on several by ssh, under GNU parallel. Run it again after anything was killed.
set -eu

shards=${SHARDS:-64}
study=${STUDY:-closed-loop --count 2000 --seed 7}
out=${OUT:-study}
# Several computers that share the folder: add --sshlogin host1,host2 --workdir . to parallel.
seq "$shards" | parallel --jobs "${JOBS:-100%}" --retries 5 \
    bask study "$study" --shard "{}/$shards" --resume --threads 1 -o "$out" ">/dev/null"
exec bask merge "$out" -o "${MERGED:-merged}"
