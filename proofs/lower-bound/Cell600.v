(** * docs/lower-bound.md, section 3: Lemma 1, not all valences are 5

    The boundary of the 600-cell has 600 tetrahedra and 120 vertices, the numbers 1 to 120.  Suppose that all valences of
    a tiling of space are 5.  Then each of these vertices goes to a vertex of the tiling, so that the 600 tetrahedra go to
    tiles with positive orientation: [steps] adds one tetrahedron after the other.  The four other tetrahedra at an edge
    are there before, or the new tetrahedron has a new vertex.
    The boundary of the 600-cell has no boundary.  So the signed volumes of the 600 images add up to 0, and they are
    positive: a contradiction.  No topology is needed. *)
From Coq Require Import Reals Lra Lia List PArith FMapPositive Bool.
From Acutile Require Import Statement Tetrahedra.
From LowerBound Require Import Link Tiling Edge.
Import ListNotations.

Notation four := (positive * positive * positive * positive)%type.
(** [N a b c d]: the tetrahedron abcd is there, and the one on the other side of abc gets the next number as its vertex.
    [F v p c0 c1 c2 c3 c4]: four tetrahedra at the edge vp are there, and the fifth one is v p c4 c0. *)
Inductive step := N (a b c d : positive) | F (v p c0 c1 c2 c3 c4 : positive).
Definition start : four := (1, 2, 3, 4)%positive.
Definition steps : list step := [
  N 1 2 3 4; N 2 1 4 3; N 1 2 5 3; F 1 2 7 5 3 4 6; N 1 3 4 2; N 3 1 5 2; F 1 3 8 4 2 5 9; N 1 4 6 2; F 1 4 10 6 2 3 8; N 5 1 7 2; F 1 5 9 3 2 7 11;
  N 1 6 7 2; F 1 6 12 7 2 4 10; F 1 7 11 5 2 6 12; N 8 1 9 3; F 1 8 10 4 3 9 13; F 1 9 13 8 3 5 11; F 1 10 12 6 4 8 13; F 1 11 13 9 5 7 12; N 3 2 4 1;
  N 2 3 5 1; F 2 3 15 5 1 4 14; N 4 2 6 1; F 2 4 14 3 1 6 16; N 2 5 7 1; F 2 5 17 7 1 3 15; N 6 2 7 1; F 2 6 16 4 1 7 18; F 2 7 18 6 1 5 17;
  N 2 14 15 3; F 2 14 19 15 3 4 16; F 2 15 17 5 3 14 19; F 2 16 19 14 4 6 18; F 2 17 18 7 5 15 19; N 3 4 8 1; F 3 4 20 8 1 2 14; N 5 3 9 1;
  F 3 5 15 2 1 9 21; N 3 8 9 1; F 3 8 22 9 1 4 20; F 3 9 21 5 1 8 22; N 14 3 15 2; F 3 14 20 4 2 15 23; F 3 15 23 14 2 5 21; F 3 20 22 8 4 14 23;
  F 3 21 23 15 5 9 22; N 4 6 10 1; F 4 6 24 10 1 2 16; N 8 4 10 1; F 4 8 20 3 1 10 25; F 4 10 25 8 1 6 24; N 4 14 16 2; F 4 14 26 16 2 3 20;
  F 4 16 24 6 2 14 26; F 4 20 26 14 3 8 25; F 4 24 25 10 6 16 26; N 7 5 11 1; F 5 7 17 2 1 11 27; N 5 9 11 1; F 5 9 28 11 1 3 21; F 5 11 27 7 1 9 28;
  N 15 5 17 2; F 5 15 21 3 2 17 29; F 5 17 29 15 2 7 27; F 5 21 28 9 3 15 29; F 5 27 29 17 7 11 28; N 6 7 12 1; F 6 7 30 12 1 2 18; N 10 6 12 1;
  F 6 10 24 4 1 12 31; F 6 12 31 10 1 7 30; N 6 16 18 2; F 6 16 32 18 2 4 24; F 6 18 30 7 2 16 32; F 6 24 32 16 4 10 31; F 6 30 31 12 7 18 32;
  N 7 11 12 1; F 7 11 33 12 1 5 27; F 7 12 30 6 1 11 33; N 17 7 18 2; F 7 17 27 5 2 18 34; F 7 18 34 17 2 6 30; F 7 27 33 11 5 17 34;
  F 7 30 34 18 6 12 33; N 9 8 13 1; F 8 9 22 3 1 13 35; N 8 10 13 1; F 8 10 36 13 1 4 25; F 8 13 35 9 1 10 36; N 20 8 22 3; F 8 20 25 4 3 22 37;
  F 8 22 37 20 3 9 35; F 8 25 36 10 4 20 37; F 8 35 37 22 9 13 36; N 11 9 13 1; F 9 11 28 5 1 13 38; F 9 13 38 11 1 8 35; N 9 21 22 3;
  F 9 21 39 22 3 5 28; F 9 22 35 8 3 21 39; F 9 28 39 21 5 11 38; F 9 35 38 13 8 22 39; N 10 12 13 1; F 10 12 40 13 1 6 31; F 10 13 36 8 1 12 40;
  N 12 11 13 1; F 11 12 33 7 1 13 41; F 11 13 41 12 1 9 38; F 12 13 40 10 1 11 41; N 24 10 25 4; F 10 24 31 6 4 25 42; F 10 25 42 24 4 8 36;
  F 10 31 40 12 6 24 42; F 10 36 42 25 8 13 40; N 11 27 28 5; F 11 27 43 28 5 7 33; F 11 28 38 9 5 27 43; F 11 33 43 27 7 12 41;
  F 11 38 41 13 9 28 43; N 30 12 31 6; F 12 30 33 7 6 31 44; F 12 31 44 30 6 10 40; F 12 33 41 11 7 30 44; F 12 40 44 31 10 13 41; N 13 35 36 8;
  F 13 35 45 36 8 9 38; F 13 36 40 10 8 35 45; F 13 38 45 35 9 11 41; F 13 40 41 12 10 36 45; N 15 14 23 3; F 14 15 19 2 3 23 46; N 16 14 19 2;
  F 14 16 26 4 2 19 47; F 14 19 47 16 2 15 46; N 20 14 26 4; F 14 20 23 3 4 26 48; F 14 23 46 15 3 20 48; F 14 26 48 20 4 16 47;
  F 14 46 47 19 15 23 48; N 15 17 19 2; F 15 17 49 19 2 5 29; F 15 19 46 14 2 17 49; N 23 15 46 14; F 15 23 21 3 14 46 50; F 15 21 29 5 3 23 50;
  F 15 29 49 17 5 21 50; F 15 46 50 23 14 19 49; N 18 16 19 2; F 16 18 32 6 2 19 51; F 16 19 51 18 2 14 47; N 17 18 19 2; F 17 18 52 19 2 7 34;
  F 17 19 49 15 2 18 52; F 18 19 52 17 2 16 51; N 16 26 47 14; F 16 26 53 47 14 4 24; F 16 24 53 26 4 6 32; F 16 32 53 24 6 18 51;
  F 16 47 51 19 14 26 53; N 20 22 23 3; F 20 22 54 23 3 8 37; F 20 23 48 14 3 22 54; N 22 21 23 3; F 21 22 39 9 3 23 55; F 21 23 55 22 3 15 50;
  F 22 23 54 20 3 21 55; N 26 20 48 14; F 20 26 25 4 14 48 56; F 20 25 37 8 4 26 56; F 20 37 54 22 8 25 56; F 20 48 56 26 14 23 54; N 24 25 26 4;
  F 24 25 57 26 4 10 42; F 24 26 53 16 4 25 57; F 25 26 57 24 4 20 56; N 29 17 49 15; F 17 29 27 5 15 49 58; F 17 27 34 7 5 29 58;
  F 17 34 52 18 7 27 58; F 17 49 58 29 15 19 52; N 21 29 50 15; F 21 29 59 50 15 5 28; F 21 28 59 29 5 9 39; F 21 39 59 28 9 22 55;
  F 21 50 55 23 15 29 59; N 28 27 29 5; F 27 28 43 11 5 29 60; F 27 29 60 28 5 17 58; F 28 29 59 21 5 27 60; N 18 32 51 16; F 18 32 61 51 16 6 30;
  F 18 30 61 32 6 7 34; F 18 34 61 30 7 17 52; F 18 51 52 19 16 32 61; N 37 22 54 20; F 22 37 35 8 20 54 62; F 22 35 39 9 8 37 62;
  F 22 39 55 21 9 35 62; F 22 54 62 37 20 23 55; N 32 24 53 16; F 24 32 31 6 16 53 63; F 24 31 42 10 6 32 63; F 24 42 57 25 10 31 63;
  F 24 53 63 32 16 26 57; N 30 31 32 6; F 30 31 64 32 6 12 44; F 30 32 61 18 6 31 64; F 31 32 64 30 6 24 63; N 25 37 56 20; F 25 37 65 56 20 8 36;
  F 25 36 65 37 8 10 42; F 25 42 65 36 10 24 57; F 25 56 57 26 20 37 65; N 36 35 37 8; F 35 36 45 13 8 37 66; F 35 37 66 36 8 22 62;
  F 36 37 65 25 8 35 66; N 27 34 58 17; F 27 34 67 58 17 7 33; F 27 33 67 34 7 11 43; F 27 43 67 33 11 28 60; F 27 58 60 29 17 34 67; N 33 30 34 7;
  F 30 33 44 12 7 34 68; F 30 34 68 33 7 18 61; F 33 34 67 27 7 30 68; F 30 44 64 31 12 33 68; F 30 61 68 34 18 32 64; N 39 28 59 21;
  F 28 39 38 9 21 59 69; F 28 38 43 11 9 39 69; F 28 43 60 27 11 38 69; F 28 59 69 39 21 29 60; N 35 38 39 9; F 35 38 70 39 9 13 45;
  F 35 39 62 22 9 38 70; F 38 39 70 35 9 28 69; F 35 45 70 38 13 36 66; F 35 62 66 37 22 39 70; N 31 42 63 24; F 31 42 71 63 24 10 40;
  F 31 40 71 42 10 12 44; F 31 44 71 40 12 30 64; F 31 63 64 32 24 42 71; N 40 36 42 10; F 36 40 45 13 10 42 72; F 36 42 72 40 10 25 65;
  F 40 42 71 31 10 36 72; F 36 45 66 35 13 40 72; F 36 65 72 42 25 37 66; N 33 41 44 12; F 33 41 73 44 12 11 43; F 33 43 73 41 11 27 67;
  F 33 44 68 30 12 41 73; F 33 67 73 43 27 34 68; N 38 41 43 11; F 38 41 74 43 11 13 45; F 38 43 69 28 11 41 74; F 41 43 74 38 11 33 73;
  F 38 45 74 41 13 35 70; F 38 69 70 39 28 43 74; N 41 40 44 12; F 40 41 45 13 12 44 75; F 40 44 75 41 12 31 71; F 41 44 73 33 12 40 75;
  F 40 45 72 36 13 41 75; F 41 45 75 40 13 38 74; F 40 71 75 44 31 42 72; F 41 73 74 43 33 44 75; N 46 19 47 14; F 19 46 49 15 14 47 76;
  F 19 47 76 46 14 16 51; F 19 49 52 17 15 46 76; F 19 51 76 47 16 18 52; N 23 46 48 14; F 23 46 77 48 14 15 50; F 23 48 54 20 14 46 77;
  F 23 50 77 46 15 21 55; F 23 54 55 22 20 48 77; N 47 26 48 14; F 26 47 53 16 14 48 78; F 26 48 78 47 14 20 56; F 26 53 57 24 16 47 78;
  F 26 56 78 48 20 25 57; N 46 47 48 14; F 46 47 79 48 14 19 76; F 46 48 77 23 14 47 79; F 47 48 79 46 14 26 78; N 29 49 50 15;
  F 29 49 80 50 15 17 58; F 29 50 59 21 15 49 80; F 29 58 80 49 17 27 60; F 29 59 60 28 21 50 80; N 49 46 50 15; F 46 49 76 19 15 50 81;
  F 46 50 81 49 15 23 77; F 49 50 80 29 15 46 81; F 46 76 79 47 19 49 81; F 46 77 81 50 23 48 79; N 32 61 64 30; F 32 61 82 64 30 18 51;
  F 32 51 82 61 18 16 53; F 32 53 82 51 16 24 63; F 32 63 82 53 24 31 64; N 47 51 53 16; F 47 51 83 53 16 19 76; F 47 53 78 26 16 51 83;
  F 51 53 83 47 16 32 82; F 47 76 83 51 19 46 79; F 47 78 79 48 26 53 83; N 62 37 66 35; F 37 62 54 22 35 66 84; F 37 54 56 20 22 62 84;
  F 37 56 65 25 20 54 84; F 37 65 66 36 25 56 84; N 54 48 56 20; F 48 54 77 23 20 56 85; F 48 56 85 54 20 26 78; F 54 56 84 37 20 48 85;
  F 48 77 79 46 23 54 85; F 48 78 85 56 26 47 79; N 34 67 68 33; F 34 67 86 68 33 27 58; F 34 58 86 67 27 17 52; F 34 52 86 58 17 18 61;
  F 34 61 86 52 18 30 68; N 52 49 58 17; F 49 52 76 19 17 58 87; F 49 58 87 52 17 29 80; F 52 58 86 34 17 49 87; F 49 76 81 46 19 52 87;
  F 49 80 87 58 29 50 81; N 52 51 76 19; F 51 52 61 18 19 76 88; F 51 61 82 32 18 52 88; F 52 61 88 51 18 34 86; F 51 76 88 52 19 47 83;
  F 52 76 87 49 19 51 88; F 51 82 83 53 32 61 88; F 52 86 88 61 34 58 87; N 69 39 70 38; F 39 69 59 28 38 70 89; F 39 59 55 21 28 69 89;
  F 39 55 62 22 21 59 89; F 39 62 70 35 22 55 89; N 50 55 59 21; F 50 55 90 59 21 23 77; F 50 59 80 29 21 55 90; F 55 59 90 50 21 39 89;
  F 50 77 90 55 23 46 81; F 50 80 81 49 29 59 90; N 54 55 77 23; F 54 55 91 77 23 22 62; F 54 62 91 55 22 37 84; F 55 62 89 39 22 54 91;
  F 54 77 85 48 23 55 91; F 55 77 91 54 23 50 90; F 54 84 91 62 37 56 85; F 55 89 90 59 39 62 91; N 42 71 72 40; F 42 71 92 72 40 31 63;
  F 42 63 92 71 31 24 57; F 42 57 92 63 24 25 65; F 42 65 92 57 25 36 72; N 57 53 63 24; F 53 57 78 26 24 63 93; F 53 63 93 57 24 32 82;
  F 57 63 92 42 24 53 93; F 53 78 83 47 26 57 93; F 53 82 93 63 32 51 83; N 57 56 78 26; F 56 57 65 25 26 78 94; F 56 65 84 37 25 57 94;
  F 57 65 94 56 25 42 92; F 56 78 94 57 26 48 85; F 57 78 93 53 26 56 94; F 56 84 85 54 37 65 94; F 57 92 94 65 42 63 93; N 67 43 73 33;
  F 43 67 60 27 33 73 95; F 43 60 69 28 27 67 95; F 43 69 74 38 28 60 95; F 43 73 95 67 33 41 74; N 58 60 67 27; F 58 60 96 67 27 29 80;
  F 58 67 86 34 27 60 96; F 60 67 96 58 27 43 95; F 58 80 96 60 29 49 87; F 58 86 87 52 34 67 96; N 60 59 69 28; F 59 60 80 29 28 69 97;
  F 59 69 97 60 28 39 89; F 60 69 95 43 28 59 97; F 59 80 90 50 29 60 97; F 60 80 97 59 29 58 96; F 59 89 97 69 39 55 90; F 60 95 96 67 43 69 97;
  N 44 64 68 30; F 44 64 98 68 30 31 71; F 44 68 73 33 30 64 98; F 44 71 98 64 31 40 75; F 44 73 75 41 33 68 98; N 64 61 68 30;
  F 61 64 82 32 30 68 99; F 61 68 99 64 30 34 86; F 64 68 98 44 30 61 99; F 61 82 88 51 32 64 99; F 61 86 99 68 34 52 88; N 63 64 71 31;
  F 63 64 100 71 31 32 82; F 63 71 92 42 31 64 100; F 64 71 100 63 31 44 98; F 64 82 99 61 32 63 100; F 63 82 100 64 32 53 93;
  F 63 92 93 57 42 71 100; F 64 98 100 71 44 68 99; N 68 67 73 33; F 67 68 86 34 33 73 101; F 67 73 101 68 33 43 95; F 68 73 98 44 33 67 101;
  F 67 86 96 58 34 68 101; F 68 86 101 67 34 61 99; F 67 95 101 73 43 60 96; F 68 98 99 64 44 73 101; N 66 45 70 35; F 45 66 72 36 35 70 102;
  F 45 70 102 66 35 38 74; F 45 72 75 40 36 66 102; F 45 74 102 70 38 41 75; N 62 66 70 35; F 62 66 103 70 35 37 84; F 62 70 89 39 35 66 103;
  F 66 70 103 62 35 45 102; F 62 84 103 66 37 54 91; F 62 89 91 55 39 70 103; N 66 65 72 36; F 65 66 84 37 36 72 104; F 65 72 104 66 36 42 92;
  F 66 72 102 45 36 65 104; F 66 84 104 65 37 62 103; F 65 84 94 56 37 66 104; F 65 92 104 72 42 57 94; F 66 102 103 70 45 72 104; N 69 70 74 38;
  F 69 70 105 74 38 39 89; F 69 74 95 43 38 70 105; F 70 74 105 69 38 45 102; F 69 89 105 70 39 59 97; F 70 89 103 62 39 69 105;
  F 69 95 97 60 43 74 105; F 70 102 105 74 45 66 103; N 72 71 75 40; F 71 72 92 42 40 75 106; F 71 75 106 72 40 44 98; F 72 75 102 45 40 71 106;
  F 71 92 100 63 42 72 106; F 72 92 106 71 42 65 104; F 71 98 106 75 44 64 100; F 72 102 104 66 45 75 106; N 73 74 75 41; F 73 74 107 75 41 43 95;
  F 73 75 98 44 41 74 107; F 74 75 107 73 41 45 102; F 73 95 107 74 43 67 101; F 74 95 105 69 43 73 107; F 73 98 101 68 44 75 107;
  F 75 98 107 73 44 71 106; F 74 102 107 75 45 70 105; F 75 102 106 72 45 74 107; N 76 79 81 46; F 76 79 108 81 46 47 83; F 76 81 87 49 46 79 108;
  F 76 83 108 79 47 51 88; F 76 87 88 52 49 81 108; N 79 77 81 46; F 79 81 108 76 46 77 109; F 77 79 85 48 46 81 109; F 77 81 109 79 46 50 90;
  F 77 85 91 54 48 79 109; F 77 90 109 81 50 55 91; N 78 79 83 47; F 79 83 110 78 47 76 108; F 78 79 110 83 47 48 85; F 78 83 93 53 47 79 110;
  F 79 85 109 77 48 78 110; F 78 85 110 79 48 56 94; F 78 93 94 57 53 83 110; F 79 108 110 83 76 81 109; N 81 80 87 49; F 81 87 108 76 49 80 111;
  F 80 81 90 50 49 87 111; F 80 87 111 81 49 58 96; F 81 90 111 80 50 77 109; F 80 90 97 59 50 81 111; F 80 96 111 87 58 60 97;
  F 81 108 109 79 76 87 111; N 82 83 88 51; F 83 88 112 82 51 76 108; F 82 83 112 88 51 53 93; F 82 88 99 61 51 83 112; F 83 93 110 78 53 82 112;
  F 82 93 112 83 53 63 100; F 82 99 100 64 61 88 112; F 83 108 112 88 76 79 110; N 84 85 94 56; F 84 85 113 94 56 54 91; F 85 91 109 77 54 84 113;
  F 84 91 113 85 54 62 103; F 85 94 113 84 56 78 110; F 84 94 104 65 56 85 113; F 84 103 113 91 62 66 104; F 85 109 110 79 77 91 113; N 86 87 96 58;
  F 86 87 114 96 58 52 88; F 87 88 108 76 52 86 114; F 86 88 114 87 52 61 99; F 86 96 101 67 58 87 114; F 87 96 114 86 58 80 111;
  F 86 99 114 88 61 68 101; F 88 99 112 82 61 86 114; F 87 108 111 81 76 88 114; F 88 108 114 87 76 83 112; N 90 89 97 59; F 89 90 91 55 59 97 115;
  F 90 91 115 89 55 77 109; F 89 91 103 62 55 90 115; F 89 97 115 90 59 69 105; F 90 97 111 80 59 89 115; F 89 103 105 70 62 91 115;
  F 91 103 115 89 62 84 113; F 90 109 115 91 77 81 111; F 91 109 113 85 77 90 115; N 94 92 104 65; F 92 94 93 57 65 104 116; F 93 94 110 78 57 92 116;
  F 92 93 100 63 57 94 116; F 92 100 106 71 63 93 116; F 93 100 116 92 63 82 112; F 92 104 116 94 65 72 106; F 94 104 113 84 65 92 116;
  F 94 110 116 93 78 85 113; F 93 110 112 83 78 94 116; N 95 96 97 60; F 95 96 117 97 60 67 101; F 95 97 105 69 60 96 117; F 96 97 117 95 60 80 111;
  F 95 101 117 96 67 73 107; F 96 101 114 86 67 95 117; F 95 105 107 74 69 97 117; F 97 105 117 95 69 89 115; F 96 111 117 97 80 87 114;
  F 97 111 115 90 80 96 117; N 99 98 100 64; F 98 99 101 68 64 100 118; F 98 100 118 99 64 71 106; F 99 100 112 82 64 98 118;
  F 98 101 107 73 68 99 118; F 99 101 118 98 68 86 114; F 98 106 118 100 71 75 107; F 100 106 116 92 71 98 118; F 101 107 118 98 73 95 117;
  F 99 112 114 88 82 100 118; F 100 112 118 99 82 93 116; F 101 114 117 96 86 99 118; N 102 103 104 66; F 102 103 119 104 66 70 105;
  F 102 104 106 72 66 103 119; F 103 104 119 102 66 84 113; F 102 105 119 103 70 74 107; F 103 105 115 89 70 102 119; F 102 106 107 75 72 104 119;
  F 104 106 119 102 72 92 116; F 105 107 117 95 74 102 119; F 106 107 119 102 75 98 118; F 104 113 116 94 84 103 119; F 103 113 119 104 84 91 115;
  F 105 115 119 103 89 97 117; F 106 116 118 100 92 104 119; F 107 117 119 105 95 101 118; N 109 108 110 79; F 108 109 111 81 79 110 120;
  F 108 110 120 109 79 83 112; F 109 110 113 85 79 108 120; F 108 111 114 87 81 109 120; F 109 111 120 108 81 90 115; F 108 112 120 110 83 88 114;
  F 110 112 116 93 83 108 120; F 110 113 120 109 85 94 116; F 109 113 115 91 85 110 120; F 111 114 120 108 87 96 117; F 111 115 117 97 90 109 120;
  F 112 114 118 99 88 108 120; F 113 115 120 109 91 103 119; F 112 116 120 110 93 100 118; F 113 116 119 104 94 110 120; F 114 117 118 101 96 111 120;
  F 115 117 120 111 97 105 119; F 116 118 119 106 100 112 120; F 117 118 120 114 101 107 119]%positive.

(** ** The tetrahedra that are there *)

(** Even permutations of the vertices: the least one first, then the least one of the others. *)
Definition rotate (a b c d : positive) : four :=
  if (b <? c)%positive && (b <? d)%positive then (a, b, c, d) else if (c <? d)%positive then (a, c, d, b) else (a, d, b, c).
Definition canon (t : four) : four :=
  let '(a, b, c, d) := t in
  if (a <? b)%positive && (a <? c)%positive && (a <? d)%positive then rotate a b c d
  else if (b <? c)%positive && (b <? d)%positive then rotate b a d c
  else if (c <? d)%positive then rotate c d a b else rotate d c b a.
Definition same (s t : four) : bool :=
  let '(a, b, c, d) := s in let '(a', b', c', d') := t in (a =? a')%positive && (b =? b')%positive && (c =? c')%positive && (d =? d')%positive.
Definition key (t : four) : positive := let '(a, b, c, d) := t in (((a * 128 + b) * 128 + c) * 128 + d)%positive.
Definition table := PositiveMap.t four.
Definition there (M : table) (t : four) : bool := match PositiveMap.find (key (canon t)) M with Some s => same s (canon t) | None => false end.
Definition put (M : table) (t : four) : table := PositiveMap.add (key (canon t)) (canon t) M.

(** All tetrahedra, if each step is possible; n is the next number of a vertex. *)
Fixpoint run (l : list step) (M : table) (n : positive) (found : list four) : option (list four) :=
  match l with
  | [] => Some found
  | N a b c d :: l => if there M (a, b, c, d) then let t := (b, a, c, n) in run l (put M t) (Pos.succ n) (t :: found) else None
  | F v p c0 c1 c2 c3 c4 :: l =>
      if there M (v, p, c0, c1) && there M (v, p, c1, c2) && there M (v, p, c2, c3) && there M (v, p, c3, c4)
      then let t := (v, p, c4, c0) in run l (put M t) n (t :: found) else None
  end.
Definition all : option (list four) := run steps (put (PositiveMap.empty four) start) 5 [start].

Section Images.
Context {index : Type} {is_tile : index -> Prop} {tile : index -> tetrahedron}.
Hypothesis tiling : space_tiling is_tile tile.
Notation pos := (@pos index is_tile tile).
Hypothesis five : forall v p c0 c1 c2 c3 c4, pos v p c0 c1 -> pos v p c1 c2 -> pos v p c2 c3 -> pos v p c3 c4 -> pos v p c4 c0.

Definition image (f : positive -> point) (t : four) := let '(a, b, c, d) := t in pos (f a) (f b) (f c) (f d).
Definition below (n : positive) (t : four) := let '(a, b, c, d) := t in (a < n /\ b < n /\ c < n /\ d < n)%positive.
Definition fine n f t := below n t /\ image f t.
Lemma fine_rotate n f a b c d : fine n f (rotate a b c d) <-> fine n f (a, b, c, d).
Proof.
  unfold rotate. destruct (_ && _); [reflexivity|]. pose proof (fun a b c d => @pos_turn index is_tile tile a b c d) as T.
  destruct (_ <? _)%positive; unfold fine, below, image; split; intros [B P]; (split; [tauto|]); auto.
Qed.
Lemma fine_pair n f a b c d : fine n f (a, b, c, d) -> fine n f (b, a, d, c).
Proof. unfold fine, below, image. intros [B P]. split; [tauto|]. apply pos_swap, P. Qed.
Lemma fine_other n f a b c d : fine n f (a, b, c, d) -> fine n f (c, d, a, b).
Proof. unfold fine, below, image. intros [B P]. split; [tauto|]. exact (pos_turn _ _ _ _ (pos_turn _ _ _ _ (pos_swap _ _ _ _ (pos_turn _ _ _ _ P)))). Qed.
Lemma fine_canon n f t : fine n f (canon t) <-> fine n f t.
Proof.
  destruct t as [[[a b] c] d]. unfold canon. destruct (_ && _); [apply fine_rotate|]. destruct (_ && _).
  - rewrite fine_rotate. split; intros H; apply fine_pair, H.
  - destruct (_ <? _)%positive; rewrite fine_rotate; split; intros H.
    + apply fine_other, H.
    + apply fine_other, H.
    + apply fine_pair in H. apply fine_other in H. exact H.
    + apply fine_other in H. apply fine_pair in H. exact H.
Qed.
Lemma same_eq s t : same s t = true -> s = t.
Proof.
  destruct s as [[[a b] c] d], t as [[[a' b'] c'] d']. unfold same. rewrite !andb_true_iff, !Pos.eqb_eq. intros [[[-> ->] ->] ->]. reflexivity.
Qed.
Definition all_fine n f (M : table) := forall k t, PositiveMap.find k M = Some t -> fine n f t.
Lemma there_fine n f M t : all_fine n f M -> there M t = true -> fine n f t.
Proof.
  intros H T. unfold there in T. destruct (PositiveMap.find (key (canon t)) M) as [s|] eqn:E; [|discriminate]. apply same_eq in T. subst s.
  apply fine_canon. exact (H _ _ E).
Qed.
Lemma put_fine n f M t : all_fine n f M -> fine n f t -> all_fine n f (put M t).
Proof.
  intros H T k s E. unfold put in E. destruct (Pos.eq_dec k (key (canon t))) as [->|Ne].
  - rewrite PositiveMap.gss in E. injection E as <-. apply fine_canon, T.
  - rewrite PositiveMap.gso in E by exact Ne. exact (H _ _ E).
Qed.
Lemma fine_more n f e t : fine n f t -> fine (Pos.succ n) (fun x => if (x =? n)%positive then e else f x) t.
Proof.
  destruct t as [[[a b] c] d]. intros [[A [B [C D]]] P]. split.
  - repeat split; lia.
  - unfold image. rewrite !(proj2 (Pos.eqb_neq _ _)) by lia. exact P.
Qed.
Lemma run_images l : forall M n found out f, run l M n found = Some out -> all_fine n f M -> (forall t, In t found -> fine n f t) ->
  exists f', forall t, In t out -> image f' t.
Proof.
  induction l as [|[a b c d|v p c0 c1 c2 c3 c4] l IH]; intros M n found out f R HM HF; cbn [run] in R.
  - injection R as <-. exists f. intros t T. apply HF, T.
  - destruct (there M (a, b, c, d)) eqn:T; [|discriminate]. pose proof (there_fine n f M _ HM T) as [[A [B [C _]]] P].
    destruct P as [Cl O]. destruct (across tiling _ _ _ _ Cl) as [e [Ce Oe]].
    apply IH with (f := fun x => if (x =? n)%positive then e else f x) in R; [exact R| |].
    + apply put_fine; [intros k t E; apply fine_more, (HM k t E)|]. split; [repeat split; lia|]. unfold image.
      rewrite Pos.eqb_refl, !(proj2 (Pos.eqb_neq _ _)) by lia. split; [apply cell_ab; exact Ce|].
      replace (orient (f b) (f a) (f c) e) with (- orient (f a) (f b) (f c) e) by (unf; ring). nra.
    + intros t [<-|T']; [|apply fine_more, HF, T']. split; [repeat split; lia|]. unfold image.
      rewrite Pos.eqb_refl, !(proj2 (Pos.eqb_neq _ _)) by lia. split; [apply cell_ab; exact Ce|].
      replace (orient (f b) (f a) (f c) e) with (- orient (f a) (f b) (f c) e) by (unf; ring). nra.
  - destruct (_ && _) eqn:T in R; [|discriminate]. rewrite !andb_true_iff in T. destruct T as [[[T0 T1] T2] T3].
    apply (there_fine n f M _ HM) in T0, T1, T2, T3. unfold fine, below, image in T0, T1, T2, T3.
    assert (G : fine n f (v, p, c4, c0)).
    { split; [repeat split; tauto|]. apply (five _ _ _ (f c1) (f c2) (f c3)); tauto. }
    apply IH with (f := f) in R; [exact R| |].
    + apply put_fine; assumption.
    + intros t [<-|T']; [exact G|apply HF, T'].
Qed.
End Images.

(** ** No boundary *)

Notation three := (positive * positive * positive)%type.
Definition first_least (a b c : positive) : three :=
  if (a <? b)%positive && (a <? c)%positive then (a, b, c) else if (b <? c)%positive then (b, c, a) else (c, a, b).
Definition facets (t : four) : list three := let '(a, b, c, d) := t in [first_least b c d; first_least a d c; first_least a b d; first_least a c b].
Definition same3 (s t : three) : bool := let '(a, b, c) := s in let '(a', b', c') := t in (a =? a')%positive && (b =? b')%positive && (c =? c')%positive.
Definition other (t : three) : three := let '(a, b, c) := t in (a, c, b).
(** Two facets with opposite orientation cancel. *)
Fixpoint remove (t : three) (l : list three) : option (list three) :=
  match l with
  | [] => None
  | s :: l => if same3 s t then Some l else match remove t l with Some m => Some (s :: m) | None => None end
  end.
Definition toggle (t : three) (l : list three) := match remove (other t) l with Some m => m | None => t :: l end.
Definition boundary (l : list four) := fold_right (fun t B => fold_right toggle B (facets t)) [] l.

Open Scope R_scope.
Section Volumes.
Variable f : positive -> point.
Definition signed (t : three) := let '(a, b, c) := t in det (f a) (f b) (f c).
Definition volume (t : four) := let '(a, b, c, d) := t in orient (f a) (f b) (f c) (f d).
Lemma signed_least a b c : signed (first_least a b c) = det (f a) (f b) (f c).
Proof. unfold first_least. destruct (_ && _); [reflexivity|]. destruct (_ <? _)%positive; cbn [signed]; unf; ring. Qed.
Lemma signed_other t : signed (other t) = - signed t.
Proof. destruct t as [[a b] c]. cbn [signed other]. unf. ring. Qed.
Lemma remove_total t l m : remove t l = Some m -> total l signed = signed t + total m signed.
Proof.
  revert m. induction l as [|s l IH]; intros m H; [discriminate|]. cbn [remove] in H. destruct (same3 s t) eqn:E.
  - injection H as <-. destruct s as [[a b] c], t as [[a' b'] c']. unfold same3 in E. rewrite !andb_true_iff, !Pos.eqb_eq in E. destruct E as [[-> ->] ->]. reflexivity.
  - destruct (remove t l) as [k|]; [|discriminate]. injection H as <-. specialize (IH k eq_refl). unfold total in *. cbn [map fold_right]. lra.
Qed.
Lemma toggle_total t l : total (toggle t l) signed = signed t + total l signed.
Proof.
  unfold toggle. destruct (remove (other t) l) as [m|] eqn:E; [|reflexivity]. apply remove_total in E. rewrite signed_other in E. lra.
Qed.
Lemma boundary_total l : total l volume = total (boundary l) signed.
Proof.
  induction l as [|t l IH]; [reflexivity|]. destruct t as [[[a b] c] d]. unfold boundary. cbn [fold_right facets].
  fold (boundary l). rewrite !toggle_total, !signed_least, <- IH. unfold total. cbn [map fold_right volume]. unf. ring.
Qed.
End Volumes.

Lemma computed : match all with Some (t :: l) => boundary (t :: l) = [] | _ => False end.
Proof. vm_compute. reflexivity. Qed.

Section Lemma_1.
Context {index : Type} {is_tile : index -> Prop} {tile : index -> tetrahedron}.
Hypothesis tiling : space_tiling is_tile tile.
Notation pos := (@pos index is_tile tile).
(** Lemma 1, for the cycles around edges: they do not all close after five tiles. *)
Theorem not_all_close : ~ (forall v p c0 c1 c2 c3 c4, pos v p c0 c1 -> pos v p c1 c2 -> pos v p c2 c3 -> pos v p c3 c4 -> pos v p c4 c0).
Proof.
  intros five. destruct (space_cover _ _ tiling origin) as [i [T _]]. destruct (tile i) as [a b c d] eqn:Ti.
  assert (C : @cell index is_tile tile a b c d) by (exists i; split; [exact T|]; rewrite Ti; apply shuffle_refl).
  assert (P : exists a b c d, pos a b c d).
  { pose proof (cell_solid tiling _ _ _ _ C) as V. destruct (Rlt_dec 0 (orient a b c d)) as [L|L].
    - exists a, b, c, d. split; assumption.
    - exists b, a, c, d. split; [apply cell_ab; exact C|]. replace (orient b a c d) with (- orient a b c d) by (unf; ring). lra. }
  clear i T a b c d Ti C. destruct P as [a [b [c [d P]]]].
  set (f := fun x => match x with 1 => a | 2 => b | 3 => c | _ => d end%positive).
  assert (S : fine 5 f start) by (split; [repeat split; reflexivity|exact P]).
  pose proof computed as Q. destruct all as [out|] eqn:E; [|exact Q]. destruct out as [|t l]; [exact Q|]. unfold all in E.
  destruct (run_images tiling five steps (put (PositiveMap.empty four) start) 5 [start] (t :: l) f E) as [f' H].
  - apply put_fine; [|exact S]. intros k s K. rewrite PositiveMap.gempty in K. discriminate.
  - intros s [<-|[]]. exact S.
  - pose proof (boundary_total f' (t :: l)) as Z. rewrite Q in Z.
    assert (V : forall s, In s (t :: l) -> 0 < volume f' s) by (intros [[[x y] z] w] W; apply H in W; destruct W as [_ W]; exact W).
    pose proof (V t (or_introl eq_refl)) as V0. pose proof (total_le l (fun _ => 0) (volume f') (fun s W => Rlt_le _ _ (V s (or_intror W)))) as V1.
    rewrite total_zero in V1. unfold total in Z, V1. cbn [map fold_right] in Z. lra.
Qed.
End Lemma_1.
