# SPDX-License-Identifier: Apache-2.0
program_cases(curve-analogy)

command_case(curve-analogy/one-thread-or-two
  RUN "curve-analogy --filtered styles/wavy.svg --threads 1 drawings/plan.svg"
  SAME "curve-analogy --filtered styles/wavy.svg --threads 2 drawings/plan.svg")
command_case(curve-analogy/more-threads-than-cores
  RUN "curve-analogy --filtered styles/wavy.svg --threads 7 drawings/plan.svg"
  SAME "curve-analogy --filtered styles/wavy.svg drawings/plan.svg")
command_case(curve-analogy/stdin-or-file
  RUN "svg2curves drawings/plan.svg | curve-analogy --filtered styles/zigzag.svg | tail -n +2"
  SAME "curve-analogy --filtered styles/zigzag.svg drawings/plan.svg | tail -n +2")
command_case(curve-analogy/example-as-curves
  RUN [[svg2curves styles/loops.svg > $OUT/loops.svg && curve-analogy --filtered $OUT/loops.svg drawings/plan.svg]]
  SAME "curve-analogy --filtered styles/loops.svg drawings/plan.svg")
command_case(curve-analogy/seeds-differ
  RUN [[curve-analogy --filtered styles/wavy.svg --seed 1 drawings/plan.svg | tail -n +2 > $OUT/1
        curve-analogy --filtered styles/wavy.svg --seed 2 drawings/plan.svg | tail -n +2 > $OUT/2
        ! cmp -s $OUT/1 $OUT/2]])
command_case(curve-analogy/all-documents-of-a-stream
  RUN "svg2curves drawings/plan.svg drawings/harbour.svg | curve-analogy --filtered styles/shaky.svg | grep -o '\"curves\":1,\"name\":\"[a-z]*\"'"
  SAME "svg2curves drawings/plan.svg drawings/harbour.svg | grep -o '\"curves\":1,\"name\":\"[a-z]*\"'")
command_case(curve-analogy/history-names-what-decides
  RUN "curve-analogy --filtered styles/wavy.svg --seed 9 --threads 2 -o $OUT/a.curves drawings/plan.svg && head -n 1 $OUT/a.curves | grep -o 'curve-analogy [^\"]*'"
  SAME "echo 'curve-analogy --filtered wavy.svg --seed 9'")
command_case(curve-analogy/keeps-records-in-their-order
  RUN "curve-analogy --filtered styles/sketchy.svg drawings/plan.svg | tail -n +2 | grep -o '\"id\":\"[^\"]*\"'"
  SAME "svg2curves drawings/plan.svg | tail -n +2 | grep -o '\"id\":\"[^\"]*\"'")
command_case(curve-analogy/scale-auto-leaves-room
  RUN "curve-analogy --unfiltered styles/grass-plain.svg --filtered styles/grass.svg --scale auto drawings/celtic_triskell_01.svg > $OUT/a.curves")
command_case(curve-analogy/too-large-a-style-is-warned-about
  RUN "curve-analogy --filtered styles/loops.svg --scale 20 drawings/plan.svg -o $OUT/a.curves"
  STDERR "~curve-analogy: drawings/plan.svg: warning: the style is large for this drawing: 100 % .*")
command_case(curve-analogy/endless-lines-stay-as-they-are
  RUN [[printf '{"curves":1}\n{"type":"path","id":"far","d":"M0 0 L1e300 0"}\n' | curve-analogy --filtered styles/wavy.svg | tail -n 1]]
  STDERR "curve-analogy: stdin:2: warning: #far: is over a million times as long as a step of the style; it stays as it is"
  SAME "echo '{\"type\":\"path\",\"id\":\"far\",\"d\":\"M0 0 L1e+300 0\"}'")
command_case(curve-analogy/without-an-example
  RUN "curve-analogy drawings/plan.svg" EXIT 2
  STDERR "~curve-analogy: give an example of the style: --filtered FILE.*")
command_case(curve-analogy/parameter-out-of-range
  RUN "curve-analogy --filtered styles/wavy.svg --samples 3 drawings/plan.svg" EXIT 2
  STDERR "~curve-analogy: .*samples is 3; give 100 to 20000.*")
command_case(curve-analogy/scale-is-a-number
  RUN "curve-analogy --filtered styles/wavy.svg --scale big drawings/plan.svg" EXIT 2
  STDERR "~curve-analogy: --scale is a number or auto.*")
command_case(curve-analogy/missing-example
  RUN "curve-analogy --filtered styles/none.svg drawings/plan.svg" EXIT 1
  STDERR "~curve-analogy: styles/none.svg: .*")
command_case(curve-analogy/example-without-curves
  RUN "curve-analogy --filtered broken/empty.svg drawings/plan.svg" EXIT 1
  STDERR "~curve-analogy: broken/empty.svg: .*")
command_case(curve-analogy/examples-that-do-not-match
  RUN "curve-analogy --unfiltered drawings/plan.svg --filtered styles/wavy.svg drawings/plan.svg" EXIT 1
  STDERR "~curve-analogy: styles/wavy.svg: the unfiltered example has [0-9]+ curves, the filtered one 1 curve; .*")
command_case(curve-analogy/cut-stream
  RUN "curve-analogy --filtered styles/wavy.svg -o $OUT/a broken/cut.curves; test $? = 1 && test $(ls $OUT | wc -l) = 0"
  STDERR "~curve-analogy: broken/cut.curves:3: .*")
command_case(curve-analogy/greedy-on-one-thread-or-three
  RUN "curve-analogy --filtered styles/wavy.svg --method greedy --samples 300 --threads 1 drawings/plan.svg"
  SAME "curve-analogy --filtered styles/wavy.svg --method greedy --samples 300 --threads 3 drawings/plan.svg")
command_case(curve-analogy/faithful-differs-from-greedy
  RUN [[curve-analogy --filtered styles/wavy.svg --method greedy --samples 300 drawings/plan.svg | tail -n +2 > $OUT/1
        curve-analogy --filtered styles/wavy.svg --faithful --levels 4 --samples 300 drawings/plan.svg | tail -n +2 > $OUT/2
        ! cmp -s $OUT/1 $OUT/2]])
command_case(curve-analogy/symbols-out-of-range
  RUN "curve-analogy --filtered styles/wavy.svg --method greedy --w-offset -1 drawings/plan.svg" EXIT 2
  STDERR "~curve-analogy: .*offset_weight is -1; give more than 0.*")
command_case(curve-analogy/levels-are-whole
  RUN "curve-analogy --filtered styles/wavy.svg --method greedy --levels 2.5 drawings/plan.svg" EXIT 2
  STDERR "~curve-analogy: --levels is a whole number.*")
