#!/bin/sh
# Builds the development and fails unless it is complete: no proof left open, no axiom
# beyond those of the classical real numbers, everything re-checked by coqchk.
#
#   check.sh               check this folder
#   check.sh --self-test   show that it fails on an injected Admitted, axiom, and the like
#   check.sh --both        check this folder, then the self-test, which finds everything built and checked
#   check.sh --quick       without coqchk; --words, --axioms, --bounds, --library, --coqchk: that part alone. These believe
#                          compiled files that are newer than their sources; check.sh builds all anew
set -eu
cd "$(dirname "$0")"
theorems="Numbers.z_theorem Numbers.nf_theorem Numbers.z_theorem2 Numbers.nf_theorem2
  RegionNumbers.z_region_theorem RegionNumbers.nf_region_theorem RegionNumbers.z_region_theorem2 RegionNumbers.nf_region_theorem2
  Bytes.accepted Bytes.bytes_theorem MosaicSanity.squares_are_a_mosaic MosaicSanity.segments_are_a_mosaic"
bounds="Normals.lemma_2 Normals.corollary_a Normals.corollary_b Normals.corollary_c Normals.corollary_a_strict Normals.corollary_b_strict
  Normals.corollary_c_strict Normals.proposition_4_angles Corners.corner Triangles.lemma_3 Triangles.lemma_3_at_most Excess.lemma_3_at_least
  Triangles.lemma_4_sum Triangles.lemma_4_bounds Triangles.lemma_5 Excess.CT_below Excess.lemma_6_uuu Excess.lemma_6_utt Steps.step_a_valence
  Steps.step_b_valence Link.theorem_2_link Link.theorem_2 Link.above_theta_star Vertex.theorem_1_at_a_vertex Around.edge_cycle
  Around.star_in_tiling Theorem1.lemma_1_space Theorem1.theorem_2_space Theorem1.theorem_1_space Theorem1.lemma_1 Theorem1.theorem_1 Larger.theorem_8_space
  Larger.theorem_8 Tcp.theorem_7_space Tcp.theorem_7 Valences.proposition_5_space
  Sanity.equality_is_possible Sanity.a_tiling"
axioms="Coq.Logic.Classical_Prop.classic
Coq.Logic.FunctionalExtensionality.functional_extensionality_dep
Coq.Reals.ClassicalDedekindReals.sig_forall_dec
Coq.Reals.ClassicalDedekindReals.sig_not_dec"
fail() { echo "check.sh: $1" >&2; exit 1; }

# 1. Words that leave something open, and hypotheses outside of a section, which are axioms.
# The files that define the words of the theorems are the pinned ones.
check_words() {
    ./words.py theories/*.v lower-bound/*.v >/dev/null || fail "a forbidden word or a hypothesis, above"
    pinned=$(sed 's/^[0-9a-f]*  //' statements.sha256 | tr '\n' ' ')
    test "$pinned" = "Statement.v PlaneStatement.v RegionStatement.v PlaneRegionStatement.v MosaicStatement.v Denote.v " || fail "statements.sha256 does not pin the six files"
    (cd theories && sha256sum --check --strict --quiet ../statements.sha256) || fail "a statement file is not the one of statements.sha256: read it, then pin it"
    # no options for Coq, no file that is not checked above, no commands for make
    test "$(head -1 _CoqProject)" = "-Q theories Acutile" || fail "_CoqProject has other options"
    test "$(tail -n +2 _CoqProject | LC_ALL=C sort)" = "$(printf '%s\n' theories/*.v | LC_ALL=C sort)" || fail "_CoqProject is not the list of theories/*.v"
    test -z "$(find theories -mindepth 2 -name '*.v*')" || fail "a folder inside of theories"
    test "$(head -2 lower-bound/_CoqProject | tr '\n' ' ')" = "-Q ../theories Acutile -Q . LowerBound " || fail "lower-bound/_CoqProject has other options"
    test "$(tail -n +3 lower-bound/_CoqProject | LC_ALL=C sort)" = "$(cd lower-bound && printf '%s\n' [A-Z]*.v | LC_ALL=C sort)" || fail "lower-bound/_CoqProject is not the list of its files"
    for file in CoqMakefile.local CoqMakefile.local-late; do
        test ! -e $file || fail "there is a file $file"
        test ! -e lower-bound/$file || fail "there is a file lower-bound/$file"
    done
}

# 2. Build from the sources that are there, and for a full check from nothing else.
clean() {
    find theories lower-bound -type f \( -name '*.vo' -o -name '*.vos' -o -name '*.vok' -o -name '*.glob' \) -delete
    for dir in . lower-bound; do (cd $dir && rm -f CoqMakefile CoqMakefile.conf .CoqMakefile.d); done
}
build() { coq_makefile -f _CoqProject -o CoqMakefile && make -s -j2 -f CoqMakefile >build.tmp 2>&1 || { cat build.tmp >&2; fail "the build"; }; }
build_bounds() {
    (cd lower-bound && coq_makefile -f _CoqProject -o CoqMakefile && make -s -j2 -f CoqMakefile) >build.tmp 2>&1 || { cat build.tmp >&2; fail "the build of lower-bound"; }
}

# 3. The types of the final theorems, and their axioms, by Print Assumptions: axioms.txt, names and types, for all of them
# together, under their full names and under their short ones. For each alone it would take ten times as long.
check_axioms() {
    dir=$(mktemp -d)
    {
        echo "From Acutile Require Numbers RegionNumbers Bytes MosaicSanity Sanity. Set Printing All."
        echo "Definition full := ($(printf 'Acutile.%s, ' $theorems)I)."
        echo "Import Acutile.Numbers Acutile.RegionNumbers Acutile.Bytes Acutile.MosaicSanity Acutile.Sanity."
        echo "Definition both := (full, $(for t in $theorems; do printf '%s, ' "${t#*.}"; done)I). Print Assumptions both."
    } >"$dir/Axioms.v"
    coqc -Q theories Acutile "$dir/Axioms.v" >"$dir/out" || fail "Print Assumptions"
    diff axioms.txt "$dir/out" >&2 || fail "the axioms are not those of axioms.txt"
    # what the theorems say, written out
    cp types.v "$dir/Types.v"
    coqc -Q theories Acutile "$dir/Types.v" >"$dir/out" || fail "a theorem does not have the type of types.v"
    rm -r "$dir"
}

# The same for the lemmas of docs/lower-bound.md: folder lower-bound.
check_bounds() {
    dir=$(mktemp -d)
    {
        echo "From LowerBound Require Normals Decimals Corners Triangles Sides Boxes Search Excess Steps Link Vertex Tiling Edge Around Cell600 Theorem1 Larger Tcp Valences Sanity. Set Printing All."
        echo "Definition full := ($(printf '@LowerBound.%s, ' $bounds)I). Print Assumptions full."
    } >"$dir/Axioms.v"
    coqc -Q theories Acutile -Q lower-bound LowerBound "$dir/Axioms.v" >"$dir/out" || fail "Print Assumptions in lower-bound"
    diff axioms.txt "$dir/out" >&2 || fail "the axioms of lower-bound are not those of axioms.txt"
    cp lower-bound/types.v "$dir/Types.v"
    coqc -Q theories Acutile -Q lower-bound LowerBound "$dir/Types.v" >"$dir/out" || fail "a theorem does not have the type of lower-bound/types.v"
    rm -r "$dir"
}

# 4. All compiled files again, and the library files under them, by coqchk. The axioms of
# all these files together, by their full names, are four.
check_again() {
    modules="$(sed -n 's#^theories/\(.*\)\.v$#Acutile.\1#p' _CoqProject) $(sed -n 's#^\([A-Z].*\)\.v$#LowerBound.\1#p' lower-bound/_CoqProject)"
    # shellcheck disable=SC2086
    coqchk -silent -o -Q theories Acutile -Q lower-bound LowerBound $modules >coqchk.tmp 2>&1 || { tail -5 coqchk.tmp >&2; fail "coqchk"; }
    found=$(sed -n '/^\* Axioms:/,/^\* Constants/p' coqchk.tmp | grep -v '^\*' | tr -d ' ' | grep . | sort)
    test "$found" = "$axioms" || { echo "$found" >&2; fail "coqchk: other axioms than expected"; }
    for kind in 'type-in-type' 'unsafe (co)fixpoints' 'positivity'; do
        grep -F "$kind" coqchk.tmp | grep -qF '<none>' || fail "coqchk: something relies on $kind"
    done
}

# 5. The installed library: the example of README.md is a theorem in an empty folder, with one byte
# changed it is not, and library/Shapes.v has the other shapes of goals, with the axioms of axioms.txt.
check_library() {
    dir=$(mktemp -d)
    make -s install DESTDIR="$dir" >"$dir/log" 2>&1 || { cat "$dir/log" >&2; fail "make install"; }
    COQPATH=$dir$(coqc -where)/user-contrib
    export COQPATH
    mkdir "$dir/empty"
    sed -n '/^```coq$/,/^```$/p' README.md | grep -v '^```' >"$dir/empty/Example.v"
    sed 's/00"\.$/01"./' "$dir/empty/Example.v" >"$dir/empty/Changed.v"
    cp library/Shapes.v "$dir/empty"
    cd "$dir/empty"
    test "$(grep -c . Example.v)" -eq 10 || fail "the example of README.md does not have ten lines"
    coqc Example.v >log 2>&1 || { cat log >&2; fail "the example of README.md"; }
    if cmp -s Example.v Changed.v; then fail "no byte was changed"; fi
    if coqc Changed.v >log 2>&1; then fail "the example of README.md is proved with another byte"; fi
    grep -qF 'the checker does not accept these bytes' log || { cat log >&2; fail "the other byte is not the reason"; }
    coqc Shapes.v >log || fail "library/Shapes.v"
    cd - >/dev/null
    sed -n '/^Axioms:/,$p' "$dir/empty/log" | diff axioms.txt - >&2 || fail "the axioms of library/Shapes.v"
    rm -r "$dir"
    unset COQPATH
}

# Each injection is refused; with --axioms those that bring an axiom into a theorem,
# by its axioms alone, whatever the words are.
self_test() {
    # The injected text stands in Sanity.v, whose names hide those of all other files. Where Coq compiles it, it stands there
    # alone, because the theorems of Sanity.v take longer than all else.
    alone='/^Require/,/^From/!d'
    refused --quick 'Lemma injected : 0 = 1. Proof. Admitted.'
    refused --quick 'Lemma injected : 0 = 1. Proof. reflexivity. Qed.' Sanity.v "$alone" 'the build'
    refused --words 'Unset  Guard Checking.'
    refused --words 'Unset
        Positivity (* a comment *) Checking.'
    refused --words 'Hypothesis
        injected : 0 = 1.'
    refused --words '(* Section a. *)Variable injected : 0 = 1.'
    refused --words 'Section a. End a. Context (injected : 0 = 1).'
    refused --words 'Section a.'
    refused --words 'Succeed Section a. Variable injected : 0 = 1. Fail End a.'
    refused --words 'Declare Instance injected : 0 = 1.'
    refused --words 'Program Definition injected : 0 = 1 := _. Admit Obligations.'
    refused --words 'Load injected.'
    refused --words 'Declare ML Module "injected".'
    refused --words 'Extract Inlined Constant Bool.eqb => "(fun _ _ -> True)".'
    refused --words 'Definition a := 1.' Denote.v
    refused --words 'Definition a := 1.' MosaicStatement.v
    # what is built, and which files are pinned
    changed --words 'a pin less' "sed -i '/PlaneStatement/d' statements.sha256"
    changed --words 'a pin that is no digest' "sed -i 's/^./g/' statements.sha256"
    changed --words 'a file that is not built' "sed -i '/Sanity/d' _CoqProject"
    changed --words 'an option for Coq' "echo '-arg -type-in-type' >>_CoqProject"
    changed --words 'other options for Coq' "sed -i 's/^-Q/-R/' _CoqProject"
    changed --words 'a folder inside' 'mkdir theories/a && echo "Axiom injected : 0 = 1." >theories/a/Reals.v'
    changed --words 'a makefile beside' 'echo "post-all::" >CoqMakefile.local'
    # a full check does not believe what was compiled before
    changed '' 'an old compiled file' 'echo "Lemma injected : 0 = 1. Proof. reflexivity. Qed." >>theories/Sums.v && touch -d 2000-01-01 theories/Sums.v'
    # a theorem that says less, and a notation that would make types.v say less too if it were imported there
    refused --axioms 'Theorem accepted s k : accepts s = Some k -> exists c, s = print c /\ claim_of c = k /\ shows c /\ True.
        Proof. intros H. destruct (accepted_all s k H) as [c [X [Y [Z _]]]]. exists c. auto. Qed.
        Theorem bytes_theorem s k : accepts s = Some k -> exists c, s = print c /\ claim_of c = k /\ True.
        Proof. intros H. destruct (bytes_theorem_all s k H) as [c [X [Y _]]]. exists c. auto. Qed.
        Notation "A /\ B" := (ltac:(let b := constr:(B) in lazymatch b with meaning _ => exact (and A True) | _ => exact (and A B) end)) (only parsing).' \
        Bytes.v 's/^Theorem bytes_theorem/&_all/; s/^Theorem accepted/&_all/; s/(accepted s k H)/(accepted_all s k H)/' \
        'does not have the type of types.v'
    # the lemmas of the lower bounds
    changed --words 'a lemma of lower-bound that is not built' "sed -i '/Excess/d' lower-bound/_CoqProject"
    refused --words 'Lemma injected : 0 = 1. Proof. Admitted.' ../lower-bound/Normals.v
    refused --bounds 'Axiom injected : 0 = 1. Theorem theorem_2 : 0 = 1. Proof injected.' ../lower-bound/Link.v 's/^Theorem theorem_2 /Theorem theorem_2_all /'
    refused --bounds 'Theorem theorem_2 dart v darts turn along tip six : star dart v darts turn along tip six -> exists d : dart, In d darts.
        Proof. intros S. destruct (star_some _ _ _ _ _ _ _ S) as [d [D _]]. exists d. exact D. Qed.' ../lower-bound/Link.v 's/^Theorem theorem_2 /Theorem theorem_2_all /'
    refused --bounds 'Axiom injected : 0 = 1. Theorem theorem_8_space : 0 = 1. Proof injected.' ../lower-bound/Larger.v 's/^Theorem theorem_8_space /Theorem theorem_8_all /; s/theorem_8_space _/theorem_8_all _/'
    for injected in \
        'Axiom injected : 0 = 1. Theorem z_theorem : 0 = 1. Proof injected.' \
        'Axiom injected : 0 = 1. Theorem accepted : 0 = 1. Proof injected.' \
        'Axiom injected : 0 = 1. Theorem z_region_theorem : 0 = 1. Proof injected.' \
        'Local Parameter injected : 0 = 1. Theorem nf_theorem : 0 = 1. Proof injected.' \
        'Hypothesis injected : 0 = 1. Theorem z_theorem : 0 = 1. Proof injected.' \
        'Hypothesis était : 0 = 1. Theorem z_theorem : 0 = 1. Proof était.' \
        'Require Import ProofIrrelevance. Theorem z_theorem : forall (P : Prop) (a b : P), a = b. Proof proof_irrelevance.' \
        'Module Classical_Prop. Hypothesis classic : 0 = 1. End Classical_Prop. Theorem z_theorem : 0 = 1. Proof Classical_Prop.classic.'; do
        refused --quick "$injected" Sanity.v "$alone"
        refused --axioms "$injected" Sanity.v "$alone" 'the axioms are not those of axioms.txt'
    done
    refused --axioms 'Axiom injected : 0 = 1. Theorem squares_are_a_mosaic : 0 = 1. Proof injected.' \
        Sanity.v "$alone" 'the axioms are not those of axioms.txt'
    # coqchk looks at what no theorem uses. The copy has two files only, because coqchk takes minutes for all of them.
    changed --coqchk 'an axiom that no theorem uses' "sed -i '2,\${/Sums/!d}' _CoqProject && sed -i '3,\${/Calculus/!d}' lower-bound/_CoqProject &&
        echo 'Module Classical_Prop. Hypothesis classic : 0 = 1. End Classical_Prop.' >>theories/Sums.v"
}
copied() { dir=$(mktemp -d) && cp -rp theories lower-bound _CoqProject check.sh words.py types.v statements.sha256 axioms.txt "$dir"; }
must_fail() { # OPTION WHAT [REASON]: check.sh of the copy
    if "$dir/check.sh" ${1:+"$1"} >"$dir/log" 2>&1; then fail "accepted with $1: $2"; fi
    tail -1 "$dir/log" | grep -qF "${3:-}" || { cat "$dir/log" >&2; fail "not refused for the right reason: $2"; }
    echo "refused with ${1:-everything}: $2 [$(tail -1 "$dir/log")]"
    rm -r "$dir"
}
refused() { # OPTION TEXT [FILE [CHANGE [REASON]]]: the text, appended to the file, after a change of it
    copied
    if [ -n "${4:-}" ]; then sed -i "$4" "$dir/theories/$3"; fi
    # Certificate.v uses the theorem that is changed: without it the build succeeds, and types.v decides
    if [ "${3:-}" = Bytes.v ]; then sed -i /Certificate/d "$dir/_CoqProject"; fi
    printf '%s\n' "$2" >>"$dir/theories/${3:-Sanity.v}"
    must_fail "$1" "$2" "${5:-}"
}
changed() { # OPTION WHAT COMMAND: after the command
    copied
    (cd "$dir" && eval "$3")
    must_fail "$1" "$2"
}

check_all() {
    check_words && clean && build && check_axioms && build_bounds && check_bounds && check_library && check_again &&
        echo "complete: no open proof, and only these axioms:" && echo "$axioms"
}

case "${1:-}" in
--self-test) check_words && build && check_axioms && build_bounds && check_bounds && self_test ;;
--quick) check_words && build && check_axioms && build_bounds && check_bounds && echo "complete; coqchk not run" ;;
--words) check_words ;;
--axioms) build && check_axioms ;;
--bounds) build && build_bounds && check_bounds ;;
--coqchk) build && build_bounds && check_again ;;
--library) build && check_library ;;
"") check_all ;;
--both) check_all && self_test ;;
*) fail "usage: check.sh [--self-test | --both | --quick | --words | --axioms | --bounds | --library | --coqchk]" ;;
esac
