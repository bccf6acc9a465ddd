#!/bin/sh
# Builds the development and fails unless it is complete: no proof left open, no axiom
# beyond those of the classical real numbers, everything re-checked by coqchk.
#
#   check.sh               check this folder
#   check.sh --self-test   show that it fails on an injected Admitted, Axiom, and the like
#   check.sh --quick       without coqchk
set -eu
cd "$(dirname "$0")"
theorems="z_theorem nf_theorem z_theorem2 nf_theorem2"
allowed="ClassicalDedekindReals.sig_not_dec ClassicalDedekindReals.sig_forall_dec FunctionalExtensionality.functional_extensionality_dep Classical_Prop.classic"
fail() { echo "check.sh: $1" >&2; exit 1; }
is_allowed() { for a in $allowed; do case "$1" in "$a" | *".$a") return 0 ;; esac; done; return 1; }

# 1. Words that leave something open, outside of comments (comments use them nowhere either).
check_words() {
    if grep -nEw 'Admitted|admit|give_up|Axioms?|Parameters?|Conjecture|Unset Guard Checking|bypass_check|Unset Positivity Checking|Unset Universe Checking' theories/*.v; then
        fail "a forbidden word, above"
    fi
}

# 2. Build from the sources that are there.
build() { coq_makefile -f _CoqProject -o CoqMakefile && make -s -j2 -f CoqMakefile >build.tmp 2>&1 || { cat build.tmp >&2; fail "the build"; }; }

# 3. The axioms of the final theorems, by Print Assumptions.
check_axioms() {
    dir=$(mktemp -d)
    { echo "From Acutile Require Import Numbers Sanity."; for t in $theorems; do echo "Print Assumptions $t."; done; } >"$dir/Axioms.v"
    coqc -Q theories Acutile "$dir/Axioms.v" >"$dir/out" || fail "Print Assumptions"
    test "$(grep -c '^Axioms:' "$dir/out")" = "$(echo "$theorems" | wc -w)" || fail "expected one list of axioms for each theorem"
    for name in $(grep -E '^[A-Za-z_][A-Za-z0-9_.'"'"']*( |$)' "$dir/out" | sed 's/ .*//' | grep -v '^Axioms:'); do
        is_allowed "$name" || fail "the axiom $name is not allowed"
    done
    rm -r "$dir"
}

# 4. All compiled files again, and the library files under them, by coqchk.
check_again() {
    modules=$(sed -n 's#^theories/\(.*\)\.v$#Acutile.\1#p' _CoqProject)
    # shellcheck disable=SC2086
    coqchk -silent -o -Q theories Acutile $modules >coqchk.tmp 2>&1 || { tail -5 coqchk.tmp >&2; fail "coqchk"; }
    for name in $(sed -n '/^\* Axioms:/,/^\* Constants/p' coqchk.tmp | grep -v '^\*'); do
        is_allowed "$name" || fail "coqchk: the axiom $name is not allowed"
    done
    for kind in 'type-in-type' 'unsafe (co)fixpoints' 'positivity'; do
        grep -F "$kind" coqchk.tmp | grep -qF '<none>' || fail "coqchk: something relies on $kind"
    done
}

self_test() {
    here=$(pwd)
    for injection in \
        'Lemma injected : 0 = 1. Proof. Admitted.' \
        'Axiom injected : 0 = 1.' \
        'Local Parameter injected : 0 = 1.' \
        'Hypothesis injected : 0 = 1. Theorem z_theorem : 0 = 1. Proof injected.' \
        'Require Import ProofIrrelevance. Theorem z_theorem : forall (P : Prop) (a b : P), a = b. Proof proof_irrelevance.' \
        'Lemma injected : 0 = 1. Proof. reflexivity. Qed.'; do
        dir=$(mktemp -d)
        cp -rp "$here/theories" "$here/_CoqProject" "$here/check.sh" "$dir"
        printf '%s\n' "$injection" >>"$dir/theories/Sanity.v"
        if "$dir/check.sh" --quick >"$dir/log" 2>&1; then fail "accepted: $injection"; fi
        echo "refused: $injection [$(tail -1 "$dir/log")]"
        rm -r "$dir"
    done
}

case "${1:-}" in
--self-test) self_test ;;
--quick) check_words && build && check_axioms && echo "complete; coqchk not run" ;;
"") check_words && build && check_axioms && check_again && echo "complete: no open proof, only the axioms $allowed" ;;
*) fail "usage: check.sh [--self-test | --quick]" ;;
esac
