#!/bin/sh
# Proves the claims of certificates in Coq's kernel.
#
#   certificates.sh ACUTILE CERTIFICATE...
#
# Each is exported by `acutile export --coq`, and coqc must end in its theorem `claim`;
# then the axioms of all of them together are those of axioms.txt, names and types, and no
# others. Two at a time. Fails if one has no theorem, is not proved, or takes longer than
# ten minutes, and if there is none. Needs the built theory (make).
set -eu
theories=$(cd "$(dirname "$0")" && pwd)/theories
axioms=$(dirname "$theories")/axioms.txt

# certificates.sh --one DIRECTORY ACUTILE CERTIFICATE: DIRECTORY/Claim_NAME.vo
if [ "${1:-}" = --one ]; then
    name=Claim_$(basename "$4" .json | tr -c 'A-Za-z0-9\n' _)
    "$3" export --coq "$4" -o "$2/$name.v"
    grep -q '^Theorem claim :' "$2/$name.v"
    # the axioms come at the end, once for all: that takes longer than most proofs
    sed -i '/^Print Assumptions claim\.$/d' "$2/$name.v"
    start=$(date +%s)
    if ! (cd "$2" && timeout 600 coqc -Q "$theories" Acutile -Q . Claims "$name.v" >"$name.out" 2>&1); then
        tail -5 "$2/$name.out"
        # what Coq says where the Boolean that it computed is false, in the lemma `checked`
        if grep -Eqx 'The term "eq_refl" has type "true = true" while it is expected to have type' "$2/$name.out"; then
            echo "NOT PROVED, the check is false: $4" >&2
        else
            echo "NOT PROVED: $4" >&2
        fi
        exit 255
    fi
    echo "proved in $(($(date +%s) - start)) s: $4"
    exit 0
fi

acutile=$1; shift
test "$#" -gt 0
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
printf '%s\0' "$@" | xargs -0 -P 2 -n 1 "$0" --one "$dir" "$acutile"
test "$(find "$dir" -name '*.vo' | wc -l)" -eq "$#"
{
    for v in "$dir"/Claim_*.v; do echo "From Claims Require $(basename "$v" .v)."; done
    echo "Definition all := ($(for v in "$dir"/Claim_*.v; do printf '%s.claim, ' "$(basename "$v" .v)"; done)I)."
    echo "Set Printing All. Print Assumptions all."
} >"$dir/All.v"
(cd "$dir" && coqc -Q "$theories" Acutile -Q . Claims All.v >out)
diff "$axioms" "$dir/out" >&2 || { echo "other axioms than those of axioms.txt" >&2; exit 1; }
echo "$# claims proved, with the axioms of axioms.txt"
