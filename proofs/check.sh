#!/bin/sh
# Builds the development and fails unless it is complete: no proof left open, no axiom
# beyond those of the classical real numbers, everything re-checked by coqchk.
#
#   check.sh               check this folder
#   check.sh --self-test   show that it fails on an injected Admitted, axiom, and the like
#   check.sh --quick       without coqchk; --words, --axioms, --coqchk: that part alone
set -eu
cd "$(dirname "$0")"
theorems="Numbers.z_theorem Numbers.nf_theorem Numbers.z_theorem2 Numbers.nf_theorem2 Bytes.accepted Bytes.bytes_theorem"
axioms="Coq.Logic.Classical_Prop.classic
Coq.Logic.FunctionalExtensionality.functional_extensionality_dep
Coq.Reals.ClassicalDedekindReals.sig_forall_dec
Coq.Reals.ClassicalDedekindReals.sig_not_dec"
fail() { echo "check.sh: $1" >&2; exit 1; }

# 1. Words that leave something open, and hypotheses outside of a section, which are axioms.
# The files that define the words of the theorems are the pinned ones.
check_words() {
    ./words.py theories/*.v >/dev/null || fail "a forbidden word or a hypothesis, above"
    (cd theories && sha256sum --check --quiet ../statements.sha256) || fail "a statement file is not the one of statements.sha256: read it, then pin it"
}

# 2. Build from the sources that are there.
build() { coq_makefile -f _CoqProject -o CoqMakefile && make -s -j2 -f CoqMakefile >build.tmp 2>&1 || { cat build.tmp >&2; fail "the build"; }; }

# 3. The types of the final theorems, and their axioms, by Print Assumptions: axioms.txt, names and types,
# for each of them, by its full name and by its short one.
check_axioms() {
    dir=$(mktemp -d)
    {
        echo "From Acutile Require Numbers Bytes Sanity. Set Printing All."
        for t in $theorems; do echo "Print Assumptions Acutile.$t."; done
        echo "Import Acutile.Numbers Acutile.Bytes Acutile.Sanity."
        for t in $theorems; do echo "Print Assumptions ${t#*.}."; done
    } >"$dir/Axioms.v"
    coqc -Q theories Acutile "$dir/Axioms.v" >"$dir/out" || fail "Print Assumptions"
    for t in $theorems $theorems; do cat axioms.txt; done >"$dir/expected"
    diff "$dir/expected" "$dir/out" >&2 || fail "the axioms are not those of axioms.txt"
    # what the theorems say, written out
    cp types.v "$dir/Types.v"
    coqc -Q theories Acutile "$dir/Types.v" >"$dir/out" || fail "a theorem does not have the type of types.v"
    rm -r "$dir"
}

# 4. All compiled files again, and the library files under them, by coqchk. The axioms of
# all these files together, by their full names, are four.
check_again() {
    modules=$(sed -n 's#^theories/\(.*\)\.v$#Acutile.\1#p' _CoqProject)
    # shellcheck disable=SC2086
    coqchk -silent -o -Q theories Acutile $modules >coqchk.tmp 2>&1 || { tail -5 coqchk.tmp >&2; fail "coqchk"; }
    found=$(sed -n '/^\* Axioms:/,/^\* Constants/p' coqchk.tmp | grep -v '^\*' | tr -d ' ' | grep . | sort)
    test "$found" = "$axioms" || { echo "$found" >&2; fail "coqchk: other axioms than expected"; }
    for kind in 'type-in-type' 'unsafe (co)fixpoints' 'positivity'; do
        grep -F "$kind" coqchk.tmp | grep -qF '<none>' || fail "coqchk: something relies on $kind"
    done
}

# Each injection is refused; with --axioms those that bring an axiom into a theorem,
# by its axioms alone, whatever the words are.
self_test() {
    refused --quick 'Lemma injected : 0 = 1. Proof. Admitted.'
    refused --quick 'Lemma injected : 0 = 1. Proof. reflexivity. Qed.'
    refused --words 'Unset  Guard Checking.'
    refused --words 'Unset
        Positivity (* a comment *) Checking.'
    refused --words 'Hypothesis
        injected : 0 = 1.'
    refused --words '(* Section a. *)Variable injected : 0 = 1.'
    refused --words 'Section a. End a. Context (injected : 0 = 1).'
    refused --words 'Section a.'
    refused --words 'Definition a := 1.' Denote.v
    refused --quick 'Theorem accepted (s : bytes) (k : claim) : accepts s = Some k -> meaning k. Proof. intros H. destruct (bytes_theorem s k H) as [c X]. apply X. Qed.' Bytes.v 's/^Theorem accepted/Theorem accepted_all/; s/(accepted s k H)/(accepted_all s k H)/'
    for option in --quick --axioms; do
        refused $option 'Axiom injected : 0 = 1. Theorem z_theorem : 0 = 1. Proof injected.'
        refused $option 'Axiom injected : 0 = 1. Theorem accepted : 0 = 1. Proof injected.'
        refused $option 'Local Parameter injected : 0 = 1. Theorem nf_theorem : 0 = 1. Proof injected.'
        refused $option 'Hypothesis injected : 0 = 1. Theorem z_theorem : 0 = 1. Proof injected.'
        refused $option 'Hypothesis était : 0 = 1. Theorem z_theorem : 0 = 1. Proof était.'
        refused $option 'Require Import ProofIrrelevance. Theorem z_theorem : forall (P : Prop) (a b : P), a = b. Proof proof_irrelevance.'
        refused $option 'Module Classical_Prop. Hypothesis classic : 0 = 1. End Classical_Prop. Theorem z_theorem : 0 = 1. Proof Classical_Prop.classic.'
    done
    # coqchk looks at what no theorem uses
    refused --coqchk 'Module Classical_Prop. Hypothesis classic : 0 = 1. End Classical_Prop.'
}
refused() { # OPTION TEXT [FILE [CHANGE]]: the text, appended to the file, after a change of it
    dir=$(mktemp -d)
    cp -rp theories _CoqProject check.sh words.py types.v statements.sha256 axioms.txt "$dir"
    if [ -n "${4:-}" ]; then sed -i "$4" "$dir/theories/$3"; fi
    printf '%s\n' "$2" >>"$dir/theories/${3:-Sanity.v}"
    if "$dir/check.sh" "$1" >"$dir/log" 2>&1; then fail "accepted with $1: $2"; fi
    echo "refused with $1: $2 [$(tail -1 "$dir/log")]"
    rm -r "$dir"
}

case "${1:-}" in
--self-test) check_words && build && check_axioms && self_test ;;
--quick) check_words && build && check_axioms && echo "complete; coqchk not run" ;;
--words) check_words ;;
--axioms) build && check_axioms ;;
--coqchk) build && check_again ;;
"") check_words && build && check_axioms && check_again && echo "complete: no open proof, and only these axioms:" && echo "$axioms" ;;
*) fail "usage: check.sh [--self-test | --quick | --words | --axioms | --coqchk]" ;;
esac
