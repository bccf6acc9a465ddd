#!/bin/sh
# Proves the claims of certificates in Coq's kernel.
#
#   certificates.sh ACUTILE CERTIFICATE...
#   certificates.sh --self-test ACUTILE TRUE FALSE   shows that an exporter cannot cheat
#
# Each is exported by `acutile export --coq`, and coqc must accept the file. The exporter is not
# believed: own.py reads the bytes of the certificate again, and Coq must find that the theorem
# `claim` of the file is about these bytes. Then the axioms of all theorems together are those of
# axioms.txt, names and types, and no others. Two at a time. Fails if one has no theorem, is not proved, or takes longer than ten minutes,
# and if there is none. Needs the built theory (make).
set -eu
here=$(cd "$(dirname "$0")" && pwd)
theories=$here/theories

# certificates.sh --one DIRECTORY ACUTILE CERTIFICATE: DIRECTORY/Claim_NAME.vo and Own_NAME.vo
if [ "${1:-}" = --one ]; then
    name=$(basename "$(basename "$4" .json)" .cbor | tr -c 'A-Za-z0-9\n' _)
    "$3" export --coq "$4" -o "$2/Claim_$name.v"
    # the axioms come at the end, once for all: that takes longer than most proofs
    sed -i '/^Print Assumptions claim\.$/d' "$2/Claim_$name.v"
    # Own_NAME.v is the script's alone: it says what is proved, in the words of Denote.v
    {
        "$here/own.py" "$4"
        echo "From Acutile Require Denote. From Claims Require Claim_$name."
        echo "Definition theorem : exists c, own = Acutile.Denote.print c /\\ Acutile.Denote.claim_of c = Claims.Claim_$name.claimed /\\"
        echo "  Acutile.Denote.shows c /\\ Acutile.Denote.meaning Claims.Claim_$name.claimed := Claims.Claim_$name.claim."
    } >"$2/Own_$name.v"
    start=$(date +%s)
    compiled() { (cd "$2" && timeout 600 coqc -noglob -Q "$theories" Acutile -Q . Claims "$1.v" >"$1.out" 2>&1); }
    if ! compiled "Claim_$name" "$2"; then
        tail -5 "$2/Claim_$name.out"
        # the Boolean function does not return the claim, in the lemma `checked`
        if grep -q 'The term "eq_refl" has type' "$2/Claim_$name.out"; then
            echo "NOT PROVED, the checker does not accept: $4" >&2
        else
            echo "NOT PROVED: $4" >&2
        fi
        exit 255
    fi
    if ! compiled "Own_$name" "$2"; then
        tail -5 "$2/Own_$name.out"
        echo "NOT PROVED, the exported theorem is about something else: $4" >&2
        exit 255
    fi
    echo "proved in $(($(date +%s) - start)) s: $4"
    exit 0
fi

# A false certificate is not proved by an honest exporter, nor by those that write another true
# theorem, the bytes of another certificate under its own claim, or an axiom.
if [ "${1:-}" = --self-test ]; then
    acutile=$2; true=$3; false=$4
    dir=$(mktemp -d)
    trap 'rm -rf "$dir"' EXIT
    refused() { # WHY EXPECTED: the exporter on standard input must fail with these words
        { echo '#!/bin/sh'; echo 'out=$5'; cat; } >"$dir/exporter"
        chmod +x "$dir/exporter"
        if "$0" "$dir/exporter" "$false" >"$dir/log" 2>&1; then echo "proved, by $1: $false" >&2; exit 1; fi
        grep -q "$2" "$dir/log" || { cat "$dir/log" >&2; echo "not refused for the right reason: $1" >&2; exit 1; }
        echo "refused: $1 [$(grep "$2" "$dir/log" | head -1)]"
    }
    "$0" "$acutile" "$true"
    echo "exec $acutile export --coq \"\$3\" -o \"\$5\"" | refused 'an honest exporter' 'the checker does not accept'
    echo "exec $acutile export --coq $true -o \"\$5\"" | refused 'another true theorem' 'about something else'
    cat <<END | refused 'the bytes of another certificate under this claim' 'the checker does not accept'
$acutile export --coq $true -o "\${5%.v}.t.v"
$acutile export --coq $false -o "\${5%.v}.f.v"
sed -n '/^Definition claimed/,/^\$/p' "\${5%.v}.f.v" >"\$5.c"
awk -v c="\$5.c" '/^Definition claimed/ { while ((getline l <c) > 0) print l; skip = 1 } !skip; skip && /^\$/ { skip = 0 }' "\${5%.v}.t.v" >"\$5"
END
    echo "$acutile export --coq $false -o \"\$5\"; sed -i 's/^Lemma checked/Axiom checked/; /^Proof. vm_cast/d' \"\$5\"" |
        refused 'an axiom' 'other axioms'
    echo "$acutile export --coq $false -o \"\$5\"; sed -i 's/^Proof. vm_cast.*/Admitted./' \"\$5\"" |
        refused 'an open proof' 'other axioms'
    echo "$acutile export --coq $false -o \"\$5\"; echo 'Definition certificate := tt. Theorem claim : True. Proof I.' >\"\$5\"" |
        refused 'a theorem of its own' 'about something else'
    exit 0
fi

acutile=$1; shift
test "$#" -gt 0
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
printf '%s\0' "$@" | xargs -0 -P 2 -n 1 "$0" --one "$dir" "$acutile"
test "$(find "$dir" -name 'Own_*.vo' | wc -l)" -eq "$#"
{
    for v in "$dir"/Own_*.v; do echo "From Claims Require $(basename "$v" .v)."; done
    echo "Definition all := ($(for v in "$dir"/Own_*.v; do printf '%s.theorem, ' "$(basename "$v" .v)"; done)I)."
    echo "Set Printing All. Print Assumptions all."
} >"$dir/All.v"
(cd "$dir" && coqc -noglob -Q "$theories" Acutile -Q . Claims All.v >out)
diff "$here/axioms.txt" "$dir/out" >&2 || { echo "other axioms than those of axioms.txt" >&2; exit 1; }
echo "$# claims proved, with the axioms of axioms.txt"
