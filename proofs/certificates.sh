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
#
# To load the theory takes coqc longer than most proofs. So small files are modules of one file, a dozen each. If that does not
# compile, each is compiled alone. All.v decides what is proved, and it names each theorem by its full name.
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

# theorem DIRECTORY NAME MODULE: Theorem_NAME.v, what is proved, in the words of Denote.v; the exported theorem is in MODULE
theorem() {
    echo "From Acutile Require Denote. From Claims Require ${3%%.*}." >"$1/Theorem_$2.v"
    echo "Definition theorem : exists c, Own_$2.own = Acutile.Denote.print c /\\ Acutile.Denote.claim_of c = Claims.$3.claimed /\\
  Acutile.Denote.shows c /\\ Acutile.Denote.meaning Claims.$3.claimed := Claims.$3.claim." >>"$1/Theorem_$2.v"
}

# certificates.sh --group DIRECTORY LIST: compiles Claim_NAME.v in DIRECTORY for the certificates in the file LIST, one a line
if [ "${1:-}" = --group ]; then
    start=$(date +%s)
    together=Group_$(basename "$3")
    if [ "$(wc -l <"$3")" -gt 1 ]; then
        while IFS= read -r file; do
            name=$(name_of "$file")
            printf 'Module Claim_%s.\n' "$name"; cat "$2/Claim_$name.v"; printf 'End Claim_%s.\n' "$name"
        done <"$3" >"$2/$together.v"
        if compiled "$2" "$together"; then
            while IFS= read -r file; do name=$(name_of "$file"); theorem "$2" "$name" "$together.Claim_$name"; done <"$3"
            echo "compiled in $(($(date +%s) - start)) s, together: $(tr '\n' ' ' <"$3")"
            exit 0
        fi
    fi
    while IFS= read -r file; do
        start=$(date +%s)
        name=$(name_of "$file")
        if ! compiled "$2" "Claim_$name"; then
            tail -5 "$2/Claim_$name.err"
            # the Boolean function does not return the claim, in the lemma `checked`
            if grep -q 'The term "eq_refl" has type' "$2/Claim_$name.err"; then
                echo "NOT PROVED, the checker does not accept: $file" >&2
            else
                echo "NOT PROVED: $file" >&2
            fi
            exit 255
        fi
        theorem "$2" "$name" "Claim_$name"
        echo "compiled in $(($(date +%s) - start)) s: $file"
    done <"$3"
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
    refused() { # WHY EXPECTED [CERTIFICATE...]: the exporter on standard input must fail with these words
        why=$1; expected=$2; shift 2
        test "$#" -gt 0 || set -- "$false"
        { echo '#!/bin/sh'; echo 'out=$5'; cat; } >"$dir/exporter"
        chmod +x "$dir/exporter"
        if "$0" "$dir/exporter" "$@" >"$dir/log" 2>&1; then echo "proved, by $why: $*" >&2; exit 1; fi
        grep -q "$expected" "$dir/log" || { cat "$dir/log" >&2; echo "not refused for the right reason: $why" >&2; exit 1; }
        echo "refused: $why [$(grep "$expected" "$dir/log" | head -1)]"
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
    # two certificates are in one file for Coq
    cp "$true" "$dir/also true.json"
    "$0" "$acutile" "$true" "$dir/also true.json"
    echo "exec $acutile export --coq \"\$3\" -o \"\$5\"" |
        refused 'an honest exporter, of a true and a false one' "the checker does not accept: $false" "$true" "$false"
    echo "exec $acutile export --coq $true -o \"\$5\"" |
        refused 'the true theorem twice' "about something else: $false" "$true" "$false"
    echo "$acutile export --coq \"\$3\" -o \"\$5\"; echo \"End \$(basename \"\$5\" .v). Section S.\" >>\"\$5\"" |
        refused 'a file that ends its module' "NOT PROVED: $true" "$true" "$dir/also true.json"
    echo "$acutile export --coq \"\$3\" -o \"\$5\"; echo '(* ' >>\"\$5\"" | refused 'an open comment' 'a forbidden word' "$true" "$dir/also true.json"
    echo "$acutile export --coq \"\$3\" -o \"\$5\"; echo '\"' >>\"\$5\"" | refused 'an open text' 'a forbidden word' "$true" "$dir/also true.json"
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
$here/own.py $true "\$TMPDIR/own"
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
mkdir "$dir/alone" "$dir/small"
owns=$(mktemp)
trap 'rm -rf "$dir" "$exported" "$owns"' EXIT
number=0
for file; do
    name=$(name_of "$file")
    test -f "$exported/$name/Claim_$name.v" -a ! -h "$exported/$name/Claim_$name.v" || { echo "not exported: $file" >&2; exit 1; }
    cp "$exported/$name/Claim_$name.v" "$dir/Claim_$name.v"
    # these are the script's alone, as are those of `theorem`
    printf '%s\0%s\0' "$file" "$dir/Own_$name.v" >>"$owns"
    if [ "$(wc -c <"$dir/Claim_$name.v")" -gt 20000 ]; then
        echo "$file" >"$dir/alone/$name"
    else
        # neighbours are often alike, so they are in different groups
        echo "$file" >>"$dir/small/$((number % (($# + 11) / 12)))"
        number=$((number + 1))
    fi
done
if ! "$here/words.py" "$dir"/Claim_*.v >"$dir/words" 2>&1; then
    tail -5 "$dir/words" >&2
    for file; do
        if grep -qF "/Claim_$(name_of "$file").v: " "$dir/words"; then echo "NOT PROVED, the exported file has a forbidden word: $file" >&2; fi
    done
    exit 1
fi
# the axioms come at the end, once for all: that takes longer than most proofs
sed -i '/^Print Assumptions claim\.$/d' "$dir"/Claim_*.v
xargs -0 -n 500 "$here/own.py" <"$owns"
find "$dir/alone" "$dir/small" -type f -print0 | sort -z | xargs -0 -P 2 -n 1 "$0" --group "$dir"
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
    modules=$(for v in "$dir"/*.vo; do printf ' -norec Claims.%s' "$(basename "$v" .vo)"; done)
    # shellcheck disable=SC2086
    (cd "$dir" && timeout 600 coqchk -silent -o -Q "$theories" Acutile -Q . Claims $modules >checked 2>&1) ||
        { tail -5 "$dir/checked" >&2; echo "coqchk does not accept them" >&2; exit 1; }
    for kind in 'type-in-type' 'unsafe (co)fixpoints' 'positivity'; do
        grep -F "$kind" "$dir/checked" | grep -qF '<none>' || { echo "coqchk: something relies on $kind" >&2; exit 1; }
    done
    echo "coqchk accepts them"
fi
