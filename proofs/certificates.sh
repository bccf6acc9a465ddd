#!/bin/sh
# Proves the claims of certificates in Coq's kernel.
#
#   certificates.sh ACUTILE CERTIFICATE...
#   certificates.sh --coqchk ACUTILE CERTIFICATE...  and coqchk checks the compiled theorems again: small ones only
#   certificates.sh --self-test ACUTILE TRUE FALSE   shows that exported files cannot cheat
#
# Each is exported by `acutile export --coq`, and coqc must accept the file. The file is not
# believed: words.py looks for commands that do more than define and prove, own.py reads the bytes of
# the certificate again, and Coq must find that the theorem `claim` of the file is about these bytes.
# The exporter is a program that runs with your rights, and no script can hold it. But it writes into a
# folder of its own, all exporters have ended before anything else is done, what they left running
# in their process groups is killed, the certificates are still the same, and their files are copied. Then the axioms of all theorems together are those of
# axioms.txt, names and types, and no others. Two at a time. Fails if one has no theorem, is not proved, or takes longer than ten minutes,
# and if there is none. Needs the built theory (make).
set -eu
here=$(cd "$(dirname "$0")" && pwd)
theories=$here/theories

name_of() { basename "$(basename "$1" .json)" .cbor | tr -c 'A-Za-z0-9\n' _; }

# certificates.sh --export DIRECTORY ACUTILE CERTIFICATE: DIRECTORY/NAME/Claim_NAME.v
if [ "${1:-}" = --export ]; then
    name=$(name_of "$4")
    mkdir "$2/$name"
    # `timeout` and its children are a process group
    timeout 600 "$3" export --coq "$4" -o "$2/$name/Claim_$name.v" </dev/null &
    code=0; wait $! || code=$?
    # until none is left; the bound is for dead ones that nobody waits for
    for _ in 1 2 3 4 5 6 7 8 9 10; do kill -s KILL -- "-$!" 2>/dev/null || break; sleep 0.1; done
    test "$code" -eq 0 || { echo "not exported: $4" >&2; exit 255; }
    exit 0
fi

# compiled DIRECTORY NAME [SECONDS]: DIRECTORY/NAME.vo, what coqc prints in NAME.out, and its errors in NAME.err
compiled() { (cd "$1" && timeout "${3:-600}" coqc -noglob -Q "$theories" Acutile -Q . Claims "$2.v" >"$2.out" 2>"$2.err"); }

# certificates.sh --one DIRECTORY EXPORTED CERTIFICATE: Claim_NAME.vo, Own_NAME.v and Theorem_NAME.v in DIRECTORY
if [ "${1:-}" = --one ]; then
    name=$(name_of "$4")
    test -f "$3/$name/Claim_$name.v" -a ! -h "$3/$name/Claim_$name.v" || { echo "not exported: $4" >&2; exit 255; }
    cp "$3/$name/Claim_$name.v" "$2/Claim_$name.v"
    "$here/words.py" "$2/Claim_$name.v" >"$2/Claim_$name.out" 2>&1 ||
        { tail -5 "$2/Claim_$name.out" >&2; echo "NOT PROVED, the exported file has a forbidden word: $4" >&2; exit 255; }
    # the axioms come at the end, once for all: that takes longer than most proofs
    sed -i '/^Print Assumptions claim\.$/d' "$2/Claim_$name.v"
    # these two are the script's alone; the theorem says what is proved, in the words of Denote.v
    "$here/own.py" "$4" >"$2/Own_$name.v"
    {
        echo "From Acutile Require Denote. From Claims Require Claim_$name."
        echo "Definition theorem : exists c, Own_$name.own = Acutile.Denote.print c /\\ Acutile.Denote.claim_of c = Claims.Claim_$name.claimed /\\"
        echo "  Acutile.Denote.shows c /\\ Acutile.Denote.meaning Claims.Claim_$name.claimed := Claims.Claim_$name.claim."
    } >"$2/Theorem_$name.v"
    start=$(date +%s)
    if ! compiled "$2" "Claim_$name"; then
        tail -5 "$2/Claim_$name.err"
        # the Boolean function does not return the claim, in the lemma `checked`
        if grep -q 'The term "eq_refl" has type' "$2/Claim_$name.err"; then
            echo "NOT PROVED, the checker does not accept: $4" >&2
        else
            echo "NOT PROVED: $4" >&2
        fi
        exit 255
    fi
    echo "compiled in $(($(date +%s) - start)) s: $4"
    exit 0
fi

# A false certificate is not proved by an honest exporter, nor by those that write another true
# theorem, the bytes of another certificate under its own claim, or an axiom, nor by one that goes on
# running beside coqc, or changes the certificate.
if [ "${1:-}" = --self-test ]; then
    acutile=$2; true=$3; false=$4
    dir=$(mktemp -d)
    trap 'rm -rf "$dir"' EXIT
    # the exporters write nowhere else
    mkdir "$dir/tmp"
    export TMPDIR="$dir/tmp"
    refused() { # WHY EXPECTED [CERTIFICATE]: the exporter on standard input must fail with these words
        of=${3:-$false}
        { echo '#!/bin/sh'; echo 'out=$5'; cat; } >"$dir/exporter"
        chmod +x "$dir/exporter"
        if "$0" "$dir/exporter" "$of" >"$dir/log" 2>&1; then echo "proved, by $1: $of" >&2; exit 1; fi
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
        refused 'an axiom' 'a forbidden word'
    # a true theorem, but with an axiom of Coq's library that is none of the four
    echo "$acutile export --coq \"\$3\" -o \"\$5\"; sed -i 's/^Lemma checked/From Coq Require ProofIrrelevance. &/; s/^Proof. exact (/&let _ := @Coq.Logic.ProofIrrelevance.proof_irrelevance in /' \"\$5\"" |
        refused 'an axiom of the library' 'other axioms' "$true"
    echo "$acutile export --coq $false -o \"\$5\"; sed -i 's/^Proof. vm_cast.*/Admitted./' \"\$5\"" |
        refused 'an open proof' 'a forbidden word'
    for command in 'Load other' 'Declare ML Module "other"' 'Redirect "file" Print claim' 'Time native_compute'; do
        echo "$acutile export --coq \"\$3\" -o \"\$5\"; echo '$command.' >>\"\$5\"" | refused "$command" 'a forbidden word' "$true"
    done
    # the bytes of the true certificate are written over those of the false one, once the script has them
    cat <<END | refused 'a process that is left running' 'about something else'
$acutile export --coq $true -o "\$out"
$here/own.py $true >"\$TMPDIR/own"
( exec >/dev/null 2>&1; i=0; while [ \$i -lt 1200 ]; do i=\$((i+1)); sleep 0.05; for f in "\$TMPDIR"/*/Own_*.v; do
  cp "\$TMPDIR/own" "\$TMPDIR/changed"; mv "\$TMPDIR/changed" "\$f"
done; done ) &
END
    cp "$false" "$dir/false.json"
    echo "cp $true \"\$3\"; exec $acutile export --coq \"\$3\" -o \"\$5\"" |
        refused 'another certificate in place of this one' 'is not what it was' "$dir/false.json"
    echo "ln -s $true \"\$5\"" | refused 'a link' 'not exported'
    echo "$acutile export --coq $false -o \"\$5\"; echo 'Definition certificate := tt. Theorem claim : True. Proof I.' >\"\$5\"" |
        refused 'a theorem of its own' 'about something else'
    exit 0
fi

again=
if [ "${1:-}" = --coqchk ]; then again=yes; shift; fi
acutile=$1; shift
test "$#" -gt 0
exported=$(mktemp -d)
trap 'rm -rf "$exported"' EXIT
before=$(sha256sum -- "$@")
printf '%s\0' "$@" | xargs -0 -P 2 -n 1 "$0" --export "$exported" "$acutile"
test "$before" = "$(sha256sum -- "$@")" || { echo "a certificate is not what it was" >&2; exit 1; }
# the folder of the proofs begins after the last exporter has ended
dir=$(mktemp -d)
trap 'rm -rf "$dir" "$exported"' EXIT
printf '%s\0' "$@" | xargs -0 -P 2 -n 1 "$0" --one "$dir" "$exported"
test "$(find "$dir" -name 'Theorem_*.v' | wc -l)" -eq "$#"
# All theorems in one file, because coqc takes longer to start than for most of them. The bytes come before anything exported.
all() { # NAME...
    for part in Own Theorem; do
        for name; do printf 'Module %s_%s.\n' "$part" "$name"; cat "$dir/${part}_$name.v"; printf 'End %s_%s.\n' "$part" "$name"; done
    done
    echo "Definition all := ($(printf 'Theorem_%s.theorem, ' "$@")I)."
    echo "Set Printing All. Print Assumptions all."
}
# shellcheck disable=SC2046
all $(for file; do name_of "$file"; done) >"$dir/All.v"
if ! compiled "$dir" All 3600; then
    for file; do
        all "$(name_of "$file")" >"$dir/One.v"
        compiled "$dir" One || { tail -5 "$dir/One.err"; echo "NOT PROVED, the exported theorem is about something else: $file" >&2; }
    done
    tail -5 "$dir/All.err" >&2
    exit 1
fi
diff "$here/axioms.txt" "$dir/All.out" >&2 || { echo "other axioms than those of axioms.txt" >&2; exit 1; }
echo "$# claims proved, with the axioms of axioms.txt"
# check.sh checks the theory in this way; here it is taken as checked
if [ -n "$again" ]; then
    modules=$(for v in "$dir"/Claim_*.v "$dir"/All.v; do printf ' -norec Claims.%s' "$(basename "$v" .v)"; done)
    # shellcheck disable=SC2086
    (cd "$dir" && timeout 600 coqchk -silent -o -Q "$theories" Acutile -Q . Claims $modules >checked 2>&1) ||
        { tail -5 "$dir/checked" >&2; echo "coqchk does not accept them" >&2; exit 1; }
    for kind in 'type-in-type' 'unsafe (co)fixpoints' 'positivity'; do
        grep -F "$kind" "$dir/checked" | grep -qF '<none>' || { echo "coqchk: something relies on $kind" >&2; exit 1; }
    done
    echo "coqchk accepts them"
fi
