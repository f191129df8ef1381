#!/bin/sh
# Runs one study undivided, and in shards under GNU parallel, Snakemake and Slurm (one node on this computer), kills shards at
# random, resumes and merges them, and compares every byte. Installs the three from Debian's packages; Slurm needs root.
#   sh packaging/check-cluster.sh [RUNS]   2000 unless given: about half an hour on two cores
set -eu
cd "$(dirname "$0")/.."

runs=${1:-2000}
study="closed-loop --controller adaptive --count $runs --seed 7" # a run costs a seventh of the level servo's
kills=${KILLS:-20}
bask=$PWD/build/release/app/bask
scripts=$PWD/resources/clusters

missing=
for pair in sbatch:slurm-wlm munged:munge parallel:parallel snakemake:snakemake; do
    command -v "${pair%%:*}" >/dev/null 2>&1 || missing="$missing ${pair#*:}"
done
# Words of $missing are meant to split.
[ -z "$missing" ] || apt-get install --yes --no-install-recommends $missing
sh packaging/install-deps.sh run
[ -n "${BASK:-}" ] && bask=$BASK || sh packaging/build.sh release --target bask

work=$(mktemp -d "${TMPDIR:-/tmp}/bask-cluster.XXXXXX")
servers=
trap 'for server in $servers; do kill "$server" 2>/dev/null || true; done; rm -rf "$work"' EXIT
mkdir "$work/bin" "$work/pids"
# The shards as the scripts start them, their numbers kept for the killer.
cat >"$work/bin/bask" <<EOF
#!/bin/sh
[ "\$1" = merge ] || echo \$\$ >"$work/pids/\$\$"
exec "$bask" "\$@"
EOF
chmod +x "$work/bin/bask"
PATH=$work/bin:$PATH
export PATH

# Kills $kills shards, one at a time, while the file $1 is there.
killer() {
    left=$kills
    while [ -e "$1" ] && [ "$left" -gt 0 ]; do
        sleep "$(awk 'BEGIN { srand(); print 0.3 + 2 * rand() }')"
        for pid in $(ls "$work/pids" | shuf); do
            rm -f "$work/pids/$pid"
            if grep -qs -- --shard "/proc/$pid/cmdline" && kill -9 "$pid" 2>/dev/null; then
                left=$((left - 1))
                break
            fi
        done
    done
    echo "killed $((kills - left))"
}

# Seconds of processor time of all that this script has waited for.
cpu_s() { awk -v hz="$(getconf CLK_TCK)" '{ print int(($16 + $17) / hz) }' "/proc/$$/stat"; }

# same NAME SECONDS: are the files of $work/NAME/merged those of the undivided study?
same() {
    for file in "$work"/one/*.csv "$work"/one/*.png; do
        cmp "$file" "$work/$1/merged/$(basename "$file")" || { echo "$1: FAILED" >&2; exit 1; }
    done
    echo "$1: the same bytes, $(($(date +%s) - $2)) s"
}

start=$(date +%s)
before_s=$(cpu_s)
"$bask" study $study -o "$work/one" >"$work/one.txt"
echo "undivided: $(($(date +%s) - start)) s, of processors $(($(cpu_s) - before_s)) s"

for shards in 1 7 64; do
    name=parallel-$shards
    mkdir "$work/$name"
    start=$(date +%s)
    before_s=$(cpu_s)
    touch "$work/on"
    killer "$work/on" &
    killing=$!
    (cd "$work/$name" && SHARDS=$shards STUDY=$study OUT=study MERGED=merged sh -c '
        until sh '"$scripts"'/study.sh >summary.txt; do sleep 0.2; done') 2>"$work/$name.log"
    rm "$work/on"
    wait "$killing"
    echo "$name: of processors $(($(cpu_s) - before_s)) s"
    same "$name" "$start"
    cmp "$work/one.txt" "$work/$name/summary.txt"
done

name=snakemake
mkdir "$work/$name"
cp "$scripts/Snakefile" "$work/$name"
start=$(date +%s)
touch "$work/on"
killer "$work/on" &
killing=$!
(cd "$work/$name" && until snakemake --cores 2 --retries 5 --config shards=7 study="$study" >log.txt 2>&1; do sleep 0.2; done)
rm "$work/on"
wait "$killing"
same "$name" "$start"

# One node of Slurm, in the foreground of this script.
name=slurm
mkdir -p "$work/$name" "$work/slurm-state" "$work/slurm-spool"
[ -e /etc/munge/munge.key ] || { dd if=/dev/urandom of=/etc/munge/munge.key bs=1024 count=1 2>/dev/null; chown munge: /etc/munge/munge.key; chmod 400 /etc/munge/munge.key; }
if [ ! -S /run/munge/munge.socket.2 ] || ! munge -n >/dev/null 2>&1; then
    mkdir -p /run/munge /var/log/munge /var/lib/munge
    chown munge: /run/munge /var/log/munge /var/lib/munge
    setpriv --reuid munge --regid munge --clear-groups munged --foreground &
    servers="$servers $!"
    until munge -n >/dev/null 2>&1; do sleep 0.1; done
fi
cat >"$work/slurm.conf" <<EOF
ClusterName=check
SlurmctldHost=$(hostname -s)(127.0.0.1)
SlurmUser=root
AuthType=auth/munge
StateSaveLocation=$work/slurm-state
SlurmdSpoolDir=$work/slurm-spool
SlurmctldPidFile=$work/slurmctld.pid
SlurmdPidFile=$work/slurmd.pid
SlurmctldPort=16817
SlurmdPort=16818
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
ReturnToService=2
NodeName=$(hostname -s) NodeAddr=127.0.0.1 CPUs=$(nproc) RealMemory=$(awk '/^MemTotal/ { print int($2 / 1100) }' /proc/meminfo) State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES State=UP
EOF
SLURM_CONF=$work/slurm.conf
export SLURM_CONF
slurmctld -D >"$work/slurmctld.log" 2>&1 &
servers="$servers $!"
slurmd -D >"$work/slurmd.log" 2>&1 &
servers="$servers $!"
until sinfo -h -o %t 2>/dev/null | grep -q idle; do sleep 0.5; done
start=$(date +%s)
touch "$work/on"
killer "$work/on" &
killing=$!
cd "$work/$name"
array=1-64
rounds=0
until bask merge study -o merged >summary.txt 2>merge.log; do
    rounds=$((rounds + 1))
    [ "$rounds" -le 50 ] || { cat sbatch.log merge.log >&2; exit 1; }
    SHARDS=64 STUDY=$study sbatch --wait --array="$array" "$scripts/study.sbatch" >>sbatch.log 2>&1 || true
    # The shards that lack cases, for the next round.
    array=$(bask merge --status study 2>/dev/null | sed -n 's/.*\.\([0-9]*\)-of-64\.part: .*/\1 &/p' | grep -v ', done$' | sed 's/^0*\([0-9]*\) .*/\1/' | paste -sd, -)
    [ -n "$array" ] || array=1-64
done
rm "$work/on"
wait "$killing"
cd - >/dev/null
same "$name" "$start"
cmp "$work/one.txt" "$work/slurm/summary.txt"
echo "The same bytes under all of them."
