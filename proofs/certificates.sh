#!/bin/sh
# Proves the claims of certificates in Coq's kernel.
#
#   certificates.sh ACUTILE CERTIFICATE...
#
# Each is exported by `acutile export --coq` and compiled; coqc must end in the
# theorem `claim` and print the axioms of the classical real numbers and no others.
# Dimension 2 is skipped, and said to be. Fails on the first that is not proved, and
# if none was. Needs the built theory (make).
set -eu
acutile=$1; shift
theories=$(cd "$(dirname "$0")" && pwd)/theories
dir=$(mktemp -d)
expected='ClassicalDedekindReals.sig_not_dec ClassicalDedekindReals.sig_forall_dec FunctionalExtensionality.functional_extensionality_dep Classical_Prop.classic'
proved=0
for certificate in "$@"; do
    if grep -q '^"dimension":2,' "$certificate"; then echo "skipped, dimension 2: $certificate"; continue; fi
    "$acutile" export --coq "$certificate" -o "$dir/claim.v"
    grep -q '^Theorem claim :' "$dir/claim.v"
    coqc -Q "$theories" Acutile "$dir/claim.v" >"$dir/out" || { cat "$dir/out"; echo "NOT PROVED: $certificate" >&2; exit 1; }
    for name in $(grep -E '^[A-Z][A-Za-z0-9_.]*( |$)' "$dir/out" | sed 's/ .*//' | grep -v '^Axioms:'); do
        case " $expected " in *" $name "*) ;; *) echo "axiom $name: $certificate" >&2; exit 1 ;; esac
    done
    grep -q '^Axioms:' "$dir/out"
    proved=$((proved + 1))
    echo "proved: $certificate"
done
rm -r "$dir"
test "$proved" -gt 0
