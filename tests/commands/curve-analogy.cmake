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
  STDERR "~curve-analogy: stdin:2: warning: #far: is too long for its style, which draws lines of up to [0-9]+ px; it stays as it is"
  SAME "echo '{\"type\":\"path\",\"id\":\"far\",\"d\":\"M0 0 L1e+300 0\"}'")
command_case(curve-analogy/without-an-example
  RUN "curve-analogy drawings/plan.svg" EXIT 2
  STDERR "~curve-analogy: give an example of the style: --filtered FILE.*")
command_case(curve-analogy/unfiltered-without-filtered
  RUN "curve-analogy --unfiltered styles/wavy-plain.svg --style sea=styles/wavy.svg drawings/harbour.svg" EXIT 2
  STDERR "~curve-analogy: give an example of the style: --filtered FILE, or --style WHAT=FILE.*")
command_case(curve-analogy/a-brush-gives-widths-to-all-lines
  RUN "curve-analogy --unfiltered styles/brush-plain.svg --filtered styles/brush.curves drawings/harbour.svg | grep -c '\"along\":{\"width\":'"
  SAME "svg2curves drawings/harbour.svg | grep -c '\"type\":\"path\"'")
command_case(curve-analogy/a-brush-from-nothing
  RUN "curve-analogy --filtered styles/brush.curves --synthesize 900 | tail -n 1 | grep -o '\"along\":{\"width\":'"
  SAME "echo '\"along\":{\"width\":'")

# Strokes and frames.
command_case(curve-analogy/a-broken-line-is-a-path-of-many-subpaths
  RUN [[printf '{"curves":1}\n{"type":"path","id":"a","d":"M0 0 L600 0"}\n' | curve-analogy --unfiltered styles/dashes-plain.svg --filtered styles/dashes.svg | tail -n 1 | grep -c '"id":"a","d":"\(M[^M]*\)\{20,60\}"}']]
  SAME "echo 1")
command_case(curve-analogy/fewer-filtered-curves-than-unfiltered
  RUN "curve-analogy --unfiltered styles/dashes.svg --filtered styles/dashes-plain.svg drawings/plan.svg" EXIT 1
  STDERR "~curve-analogy: styles/dashes-plain.svg: the unfiltered example has .* curves, the filtered one 1 curve; .*")
command_case(curve-analogy/greedy-does-not-draw-strokes
  RUN "curve-analogy --unfiltered styles/dashes-plain.svg --filtered styles/dashes.svg --method greedy drawings/plan.svg" EXIT 1
  STDERR "~curve-analogy: .*the greedy search draws a line as one stroke.*")
command_case(curve-analogy/the-first-frame-is-the-drawing
  RUN "curve-analogy --filtered styles/wavy.svg --frames 1 drawings/plan.svg | tail -n +2"
  SAME "curve-analogy --filtered styles/wavy.svg drawings/plan.svg | tail -n +2")
command_case(curve-analogy/coherent-frames-are-equal
  RUN "curve-analogy --filtered styles/wavy.svg --frames 3 --coherence 1 drawings/plan.svg | grep -v '\"curves\":1' | sort | uniq"
  SAME "curve-analogy --filtered styles/wavy.svg drawings/plan.svg | grep -v '\"curves\":1' | sort | uniq")
command_case(curve-analogy/incoherent-frames-are-variants
  RUN "curve-analogy --filtered styles/wavy.svg --frames 3 --coherence 0 drawings/plan.svg | grep -v '\"curves\":1'"
  SAME "curve-analogy --filtered styles/wavy.svg --variants 3 drawings/plan.svg | grep -v '\"curves\":1'")
command_case(curve-analogy/frames-on-one-thread-or-two
  RUN "curve-analogy --filtered styles/wavy.svg --frames 3 --threads 1 drawings/plan.svg"
  SAME "curve-analogy --filtered styles/wavy.svg --frames 3 --threads 2 drawings/plan.svg")
command_case(curve-analogy/frames-are-numbered
  RUN "curve-analogy --filtered styles/wavy.svg --frames 2 drawings/plan.svg | grep -o '\"name\":\"[^\"]*\"'"
  SAME "printf '\"name\":\"plan-1\"\n\"name\":\"plan-2\"\n'")
command_case(curve-analogy/frames-and-variants
  RUN "curve-analogy --filtered styles/wavy.svg --frames 2 --variants 2 drawings/plan.svg" EXIT 2
  STDERR "~curve-analogy: --frames does not go with --variants.*")
command_case(curve-analogy/frames-of-shapes
  RUN "curve-analogy --filtered styles/wavy.svg --frames 2 --shape-weight 2 drawings/plan.svg" EXIT 2
  STDERR "~curve-analogy: --frames is for lines that are drawn at random.*")
command_case(curve-analogy/coherence-without-frames
  RUN "curve-analogy --filtered styles/wavy.svg --coherence 0.5 drawings/plan.svg" EXIT 2
  STDERR "~curve-analogy: --coherence is for --frames.*")
command_case(curve-analogy/coherence-out-of-range
  RUN "curve-analogy --filtered styles/wavy.svg --frames 2 --coherence 1.5 drawings/plan.svg" EXIT 2
  STDERR "~curve-analogy: --coherence is 0 to 1.*")

# Styles for parts. The sea of the harbour is four lines of class water in a layer "Sea".
command_case(curve-analogy/a-class-a-layer-and-a-label-may-name-the-same
  RUN [[curve-analogy --style Sea=styles/wavy.svg drawings/harbour.svg | tail -n +2 > $OUT/all
        for what in .water layer:Sea sea '#sea' water 'water, none'; do
          curve-analogy --style "$what=styles/wavy.svg" drawings/harbour.svg | tail -n +2 | cmp - $OUT/all || exit
        done]])
command_case(curve-analogy/what-no-style-names-stays-as-it-is
  RUN "curve-analogy --style Sea=styles/wavy.svg drawings/harbour.svg | tail -n +2 | grep -v '\"in\":\"sea\"'"
  SAME "svg2curves drawings/harbour.svg | tail -n +2 | grep -v '\"in\":\"sea\"'")
command_case(curve-analogy/what-no-style-names-has-the-style-of-filtered
  RUN "curve-analogy --style Sea=styles/wavy.svg --filtered styles/zigzag.svg drawings/harbour.svg | tail -n +2 | grep -v '\"in\":\"sea\"'"
  SAME "curve-analogy --filtered styles/zigzag.svg drawings/harbour.svg | tail -n +2 | grep -v '\"in\":\"sea\"'")
command_case(curve-analogy/a-style-for-everything-is-as-filtered
  RUN "curve-analogy --style 'path,polyline,line,circle,rect=styles/grass-plain.svg:styles/grass.svg' drawings/harbour.svg | tail -n +2"
  SAME "curve-analogy --unfiltered styles/grass-plain.svg --filtered styles/grass.svg drawings/harbour.svg | tail -n +2")
command_case(curve-analogy/the-innermost-style-wins
  RUN "curve-analogy --style .roof=styles/zigzag.svg --style Land=styles/wavy.svg drawings/harbour.svg | tail -n +2"
  SAME "curve-analogy --style Land=styles/wavy.svg --style .roof=styles/zigzag.svg drawings/harbour.svg | tail -n +2")
command_case(curve-analogy/the-last-of-equal-styles-wins
  RUN "curve-analogy --style .roof=styles/wavy.svg --style '#gable=styles/zigzag.svg' drawings/harbour.svg | tail -n +2 | grep gable"
  SAME "curve-analogy --style .roof=styles/zigzag.svg drawings/harbour.svg | tail -n +2 | grep gable")
command_case(curve-analogy/a-style-may-have-its-own-scale
  RUN "curve-analogy --style Sea=styles/wavy.svg@.5 --scale 3 drawings/harbour.svg | tail -n +2"
  SAME "curve-analogy --style Sea=styles/wavy.svg --scale 0.5 drawings/harbour.svg | tail -n +2")
command_case(curve-analogy/an-at-sign-may-belong-to-the-name
  RUN "cp styles/wavy.svg $OUT/wavy@2x.svg && curve-analogy --style Sea=$OUT/wavy@2x.svg drawings/harbour.svg | tail -n +2"
  SAME "curve-analogy --style Sea=styles/wavy.svg drawings/harbour.svg | tail -n +2")
command_case(curve-analogy/history-names-the-files-of-styles
  RUN "curve-analogy --style layer:Sea=styles/wavy-plain.svg:styles/wavy.svg@2 drawings/harbour.svg | head -n 1 | grep -o 'curve-analogy [^\"]*'"
  SAME "echo 'curve-analogy --style layer:Sea=wavy-plain.svg:wavy.svg@2'")
command_case(curve-analogy/a-style-for-nothing-is-warned-about
  RUN "svg2curves drawings/plan.svg drawings/harbour.svg | curve-analogy --style Sea=styles/wavy.svg > $OUT/a"
  STDERR "curve-analogy: stdin:1: warning: --style Sea draws no line: nothing in this drawing is called so, or other styles have it all")
command_case(curve-analogy/a-style-that-is-too-large-is-named
  RUN "curve-analogy --style Sea=styles/wavy.svg --style Sky=styles/loops.svg@20 drawings/harbour.svg > $OUT/a"
  STDERR "~curve-analogy: drawings/harbour.svg: warning: --style Sky is large for this drawing: 100 % of its lines .*")
foreach(style "Sea" "=styles/wavy.svg" "Sea=" "Sea=styles/wavy.svg:" "Sea=:styles/wavy.svg" "Sea=a:b:c" "Sea=@2" "a > b=styles/wavy.svg" ".=styles/wavy.svg")
  string(MAKE_C_IDENTIFIER "${style}" name)
  command_case(curve-analogy/style-of-another-form-${name}
    RUN "curve-analogy --style '${style}' drawings/harbour.svg" EXIT 2
    STDERR "~curve-analogy: --style .*: (give WHAT=UNFILTERED.svg:FILTERED.svg or WHAT=FILTERED.svg|\".*\" is not #ID, .CLASS, layer:NAME or a name); see curve-analogy --help")
endforeach()
command_case(curve-analogy/a-style-is-no-file
  RUN "curve-analogy --style Sea=styles/none.svg drawings/harbour.svg" EXIT 1
  STDERR "~curve-analogy: styles/none.svg: .*")

# Variants.
command_case(curve-analogy/variants-have-the-seeds-that-follow
  RUN "curve-analogy --filtered styles/wavy.svg --seed 7 --variants 3 drawings/plan.svg drawings/harbour.svg | grep -v '^{\"curves'"
  SAME "for name in plan harbour; do for seed in 7 8 9; do curve-analogy --filtered styles/wavy.svg --seed $seed drawings/$name.svg | tail -n +2; done; done")
command_case(curve-analogy/variants-have-names
  RUN [[svg2curves drawings/plan.svg drawings/harbour.svg | curve-analogy --filtered styles/wavy.svg --variants 2 |
          render --output $OUT/{name}.png && ls $OUT | xargs]]
  SAME "echo harbour-1.png harbour-2.png plan-1.png plan-2.png")
command_case(curve-analogy/variants-of-a-nameless-drawing
  RUN [[printf '{"curves":1}\n{"type":"path","d":"M0 0 L100 0"}\n' | curve-analogy --filtered styles/wavy.svg --variants 2 | grep -o '"name":"[^"]*"']]
  SAME [[printf '"name":"unnamed-1"\n"name":"unnamed-2"\n']])
command_case(curve-analogy/variants-warn-once
  RUN "curve-analogy --filtered styles/loops.svg --scale 20 --variants 3 drawings/plan.svg -o $OUT/a.curves"
  STDERR "~curve-analogy: drawings/plan.svg: warning: the style is large for this drawing: 100 % .*")
foreach(count 0 -1 1.5)
  command_case(curve-analogy/variants-are-counted-${count}
    RUN "curve-analogy --filtered styles/wavy.svg --variants ${count} drawings/plan.svg" EXIT 2
    STDERR "~curve-analogy: --variants is (1 or more|a whole number).*")
endforeach()

command_case(curve-analogy/parameter-out-of-range
  RUN "curve-analogy --filtered styles/wavy.svg --samples 3 drawings/plan.svg" EXIT 2
  STDERR "~curve-analogy: .*samples is 3; give 100 to 20000.*")
command_case(curve-analogy/many-more-threads-than-a-system-has
  RUN "curve-analogy --filtered styles/wavy.svg --threads 1000000 drawings/plan.svg"
  SAME "curve-analogy --filtered styles/wavy.svg drawings/plan.svg")
command_case(curve-analogy/threads-are-not-below-zero
  RUN "curve-analogy --filtered styles/wavy.svg --threads -1 drawings/plan.svg" EXIT 2
  STDERR "~curve-analogy: .*--threads.*'-1' is below zero; see curve-analogy --help")
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
# Options that contradict each other, or say nothing.
foreach(symbol levels passes neighborhood w-offset w-delta w-coarse kappa epsilon delta-t)
  command_case(curve-analogy/symbols-are-for-greedy-${symbol}
    RUN "curve-analogy --filtered styles/wavy.svg --${symbol} 3 drawings/plan.svg" EXIT 2
    STDERR "curve-analogy: --${symbol} is for --method greedy; give that too; see curve-analogy --help")
endforeach()
command_case(curve-analogy/faithful-is-no-chain
  RUN "curve-analogy --filtered styles/wavy.svg --faithful --method chain drawings/plan.svg" EXIT 2
  STDERR "curve-analogy: --faithful is greedy; leave out --method chain; see curve-analogy --help")
foreach(option "--shape-weight 2" "--smoothing 1" "--smallest-scale 1" "--corner-angle 20" "--loose-ends")
  string(MAKE_C_IDENTIFIER "${option}" name)
  string(REGEX REPLACE " .*" "" option_name "${option}")
  command_case(curve-analogy/synthesize-does-not-go-with${name}
    RUN "curve-analogy --filtered styles/wavy.svg --synthesize 900 ${option}" EXIT 2
    STDERR "curve-analogy: --synthesize does not go with ${option_name}; see curve-analogy --help")
endforeach()

# Drawings and examples of every kind: a result, or what to change. The line is 300 px long.
function(odd_example_case name data)
  cmake_parse_arguments(PARSE_ARGV 2 CASE "" "OPTIONS;STDERR;EXIT" "")
  command_case(curve-analogy/an-example-of-${name}
    RUN "printf '%s\n' '{\"curves\":1}' '{\"type\":\"path\",\"d\":\"${data}\"}' > $OUT/odd && printf '%s\n' '{\"curves\":1}' '{\"type\":\"path\",\"d\":\"M0 0 L300 0\"}' > $OUT/line && cd $OUT && curve-analogy ${CASE_OPTIONS} line -o drawn"
    EXIT "${CASE_EXIT}" STDERR "${CASE_STDERR}")
endfunction()
foreach(data "M5 5" "M5 5 L5 5 L5 5" "")
  string(MAKE_C_IDENTIFIER "no-length-${data}" name)
  odd_example_case(${name} "${data}" OPTIONS "--filtered odd" EXIT 1
    STDERR "curve-analogy: odd: the filtered example has no curve; draw one that shows the style")
  odd_example_case(unfiltered-${name} "${data}" OPTIONS "--unfiltered odd --filtered line" EXIT 1
    STDERR "curve-analogy: line: the unfiltered example has no curve; draw one for each filtered one, or leave it out")
endforeach()
odd_example_case(repeated-points "M5 5 L5 5 L50 9 L50 9 L50 9 L99 0 L99 0" OPTIONS "--filtered odd" EXIT 0)
odd_example_case(repeated-points-by-shape "M5 5 L5 5 L50 9 L50 9 L50 9 L99 0 L99 0" OPTIONS "--filtered odd --shape-weight 2" EXIT 0)
odd_example_case(one-straight-piece "M0 0 L10 0" OPTIONS "--filtered odd" EXIT 0)
odd_example_case(less-than-a-window "M0 0 L1 0.5 L2 0" OPTIONS "--filtered odd" EXIT 0)
odd_example_case(less-than-a-window-for-greedy "M0 0 L1 0.5 L2 0" OPTIONS "--filtered odd --method greedy" EXIT 0
  STDERR "~curve-analogy: line:2: warning: is too long for its style, which draws lines of up to [0-9]+ px; it stays as it is")
command_case(curve-analogy/an-example-of-less-than-a-neighborhood
  RUN "curve-analogy --filtered styles/loops.svg --faithful --samples 300 drawings/plan.svg" EXIT 1
  STDERR "curve-analogy: the style: an example is too short for the neighborhoods that are compared: give a longer one, fewer levels, or fewer samples of a neighborhood")
odd_example_case(an-end-at-its-beginning "M5 5 L50 9 L5 5" OPTIONS "--filtered odd" EXIT 0)
foreach(data "M5 5" "M5 5 L5 5 L5 5" "")
  string(MAKE_C_IDENTIFIER "${data}" name)
  command_case(curve-analogy/a-drawing-without-length-stays-${name}
    RUN "printf '%s\n' '{\"curves\":1}' '{\"type\":\"path\",\"d\":\"${data}\"}' > $OUT/odd; for method in chain greedy; do curve-analogy --filtered styles/wavy.svg --method $method $OUT/odd | tail -n 1 | cmp - <(tail -n 1 $OUT/odd) || exit; done")
endforeach()
# A million points: a spiral as a drawing, a wave as an example.
command_case(curve-analogy/a-drawing-of-a-million-points
  RUN [[LC_ALL=C awk 'BEGIN { printf "{\"curves\":1}\n{\"type\":\"path\",\"d\":\"M"
          for (i = 0; i < 1000000; ++i) printf "%s%.6g %.6g", i ? " L" : "", (9 + i / 4000) * cos(i / 5000), (9 + i / 4000) * sin(i / 5000)
          print "\"}" }' | curve-analogy --filtered styles/wavy.svg | tail -n 1 | wc -c | awk '{ exit !($1 > 100000 && $1 < 3000000) }']])
command_case(curve-analogy/an-example-of-a-million-points
  RUN [[LC_ALL=C awk 'BEGIN { printf "{\"curves\":1}\n{\"type\":\"path\",\"d\":\"M"
          for (i = 0; i < 1000000; ++i) printf "%s%.6g %.6g", i ? " L" : "", i / 500, 5 * sin(i / 1500)
          print "\"}" }' > $OUT/odd; curve-analogy --filtered $OUT/odd drawings/plan.svg > $OUT/drawn]])

command_case(curve-analogy/symbols-out-of-range
  RUN "curve-analogy --filtered styles/wavy.svg --method greedy --w-offset -1 drawings/plan.svg" EXIT 2
  STDERR "~curve-analogy: .*offset_weight is -1; give more than 0.*")
command_case(curve-analogy/levels-are-whole
  RUN "curve-analogy --filtered styles/wavy.svg --method greedy --levels 2.5 drawings/plan.svg" EXIT 2
  STDERR "~curve-analogy: --levels is a whole number.*")

# What came out.
command_case(curve-analogy/explains-and-draws-the-same
  RUN [[curve-analogy --filtered styles/wavy.svg --explain drawings/plan.svg 2> $OUT/said &&
        test $(grep -cE '^  (example|scale|feature size|samples|states|tolerance|jumps|runs) ' $OUT/said) = 8 >&2]]
  SAME "curve-analogy --filtered styles/wavy.svg drawings/plan.svg")
command_case(curve-analogy/explains-a-style-once
  RUN "curve-analogy --filtered styles/wavy.svg --explain drawings/plan.svg drawings/harbour.svg 2>&1 > $OUT/a | grep '^curve'"
  SAME "echo curve-analogy: the style:")
command_case(curve-analogy/explains-every-symbol-of-greedy
  RUN "curve-analogy --filtered styles/wavy.svg --synthesize 200 --samples 300 --method greedy --kappa 3.25 --w-offset 7.5 --explain 2>&1 > $OUT/a | grep -o 'w_OFFSET 7.5;.*kappa 3.25;'"
  SAME "echo 'w_OFFSET 7.5; w_delta 100; w_B 0; w_B'\\''(l-1) 2; kappa 3.25;'")
command_case(curve-analogy/reports-each-variant-of-each-drawing
  RUN "curve-analogy --filtered styles/wavy.svg --variants 2 --report $OUT/report -o $OUT/a drawings/plan.svg drawings/harbour.svg && grep -o '^{\"file\":.*\"variant\":[0-9]*' $OUT/report"
  SAME [[for name in plan harbour; do for i in 1 2; do
           printf '{"file":"drawings/%s.svg","line":null,"name":"%s-%d","variant":%d\n' $name $name $i $i; done; done]])
command_case(curve-analogy/reports-the-same-on-any-number-of-threads
  RUN "curve-analogy --filtered styles/loops.svg --style Sea=styles/wavy.svg --threads 1 --report - -o $OUT/a drawings/harbour.svg"
  SAME "curve-analogy --filtered styles/loops.svg --style Sea=styles/wavy.svg --threads 3 --report - -o $OUT/a drawings/harbour.svg")
command_case(curve-analogy/reports-a-style-that-holds
  RUN [[curve-analogy --filtered styles/wavy.svg --report - -o $OUT/a drawings/plan.svg |
          grep -o '"style":"[a-z ]*"\|"end-distance":[^,]*\|"kept":[^,]*']]
  SAME [[printf '"style":"the style"\n"kept":0\n"end-distance":0\n']])
command_case(curve-analogy/reports-new-lines
  RUN "curve-analogy --filtered styles/loops.svg --synthesize 900 --report - -o $OUT/a | grep -o '\"curves\":1,\"kept\":0,\"length\":[0-9]*'"
  SAME [[echo '"curves":1,"kept":0,"length":900']])
command_case(curve-analogy/keeps-going
  RUN "curve-analogy --filtered styles/wavy.svg --keep-going drawings/plan.svg broken/cut.curves drawings/none.svg drawings/harbour.svg | tail -n +2 | grep -v '^{\"curves' > $OUT/a; test \${PIPESTATUS[0]} = 1 && cat $OUT/a"
  STDERR "~curve-analogy: broken/cut.curves:3: .*
~curve-analogy: drawings/none.svg: .*"
  SAME "curve-analogy --filtered styles/wavy.svg drawings/plan.svg drawings/harbour.svg | tail -n +2 | grep -v '^{\"curves'")
command_case(curve-analogy/keeps-going-with-nothing-writes-nothing
  RUN "curve-analogy --filtered styles/wavy.svg --keep-going -o $OUT/a broken/cut.curves; test $? = 1 && test ! -e $OUT/a"
  STDERR "~curve-analogy: broken/cut.curves:3: .*")

command_case(curve-analogy/reports-every-frame
  RUN "curve-analogy --unfiltered styles/dashes-plain.svg --filtered styles/dashes.svg --frames 2 --report - -o $OUT/a drawings/plan.svg | grep -o '\"name\":\"[^\"]*\",\"variant\":[0-9]*'"
  SAME [[printf '"name":"%s","variant":%s\n' plan-1 1 plan-2 2]])

# Styles that are kept.
foreach(options
    "--filtered styles/wavy.svg"
    "--filtered styles/loops.svg --scale 0.7 --seed 18446744073709551615"
    "--filtered styles/zigzag.svg --scale auto --mean-run 20 --loose-ends"
    "--filtered styles/shaky.svg --invariance translate --feature-size 5 --smallest-scale 0.5"
    "--filtered styles/sketchy.svg --method greedy --samples 300 --kappa 1.5 --levels 4"
    "--unfiltered styles/grass-plain.svg --filtered styles/grass.svg --smoothing 1"
    "--unfiltered pairs/corners-plain.svg --filtered pairs/corners.svg --shape-weight 2"
    "--unfiltered styles/brush-plain.svg --filtered styles/brush.curves"
    "--unfiltered styles/railway-plain.svg --filtered styles/railway.svg")
  string(MAKE_C_IDENTIFIER "${options}" name)
  command_case(curve-analogy/a-kept-style-draws-the-same-${name}
    RUN "curve-analogy ${options} --save-style $OUT/a.style && curve-analogy --style-file $OUT/a.style drawings/plan.svg | tail -n +2"
    SAME "curve-analogy ${options} drawings/plan.svg | tail -n +2")
endforeach()
command_case(curve-analogy/a-kept-style-is-kept-the-same
  RUN "curve-analogy --unfiltered styles/grass-plain.svg --filtered styles/grass.svg --scale 2 --save-style $OUT/a && curve-analogy --style-file $OUT/a --save-style - | tail -n +2"
  SAME "tail -n +2 $OUT/a")
command_case(curve-analogy/a-kept-style-makes-the-same-lines
  RUN "curve-analogy --filtered styles/coast.svg --seed 3 --save-style $OUT/a && curve-analogy --style-file $OUT/a --synthesize 900 | tail -n +2"
  SAME "curve-analogy --filtered styles/coast.svg --seed 3 --synthesize 900 | tail -n +2")
command_case(curve-analogy/a-kept-style-may-be-for-a-part
  RUN "curve-analogy --unfiltered styles/grass-plain.svg --filtered styles/grass.svg --seed 5 --scale 3 --save-style $OUT/a && curve-analogy --style Sea=$OUT/a@0.5 drawings/harbour.svg | tail -n +2"
  SAME "curve-analogy --style Sea=styles/grass-plain.svg:styles/grass.svg@0.5 --seed 5 drawings/harbour.svg | tail -n +2")
command_case(curve-analogy/options-win-over-a-kept-style
  RUN "curve-analogy --filtered styles/wavy.svg --seed 5 --mean-run 20 --faithful --save-style $OUT/a && curve-analogy --style-file $OUT/a --seed 1 --method chain drawings/plan.svg | tail -n +2"
  SAME "curve-analogy --filtered styles/wavy.svg --mean-run 20 drawings/plan.svg | tail -n +2")
command_case(curve-analogy/a-kept-style-says-what-it-is
  RUN "curve-analogy --filtered styles/wavy.svg --scale 2 --save-style - | head -n 1 | grep -o '\"style\":1,.*\"--scale\":2'"
  SAME [[echo '"style":1,"--seed":1,"--scale":2']])
foreach(option "--style Sea=styles/wavy.svg" "--synthesize 900" "--variants 2" "--frames 2" "drawings/plan.svg")
  string(MAKE_C_IDENTIFIER "${option}" name)
  command_case(curve-analogy/keeping-a-style-is-all-that-is-done-${name}
    RUN "curve-analogy --filtered styles/wavy.svg --save-style $OUT/a ${option}; test $? = 2 && test ! -e $OUT/a"
    STDERR "~curve-analogy: --save-style does not go with .*; see curve-analogy --help")
endforeach()
command_case(curve-analogy/a-style-file-has-its-example
  RUN "curve-analogy --style-file styles/wavy.svg --filtered styles/wavy.svg drawings/plan.svg" EXIT 2
  STDERR "curve-analogy: --style-file has its example in it; leave out --filtered and --unfiltered; see curve-analogy --help")
command_case(curve-analogy/a-drawing-is-no-style-file
  RUN "curve-analogy --style-file styles/wavy.svg drawings/plan.svg" EXIT 1
  STDERR "curve-analogy: styles/wavy.svg: is not a style; make one with --save-style")
command_case(curve-analogy/a-style-file-is-no-example
  RUN "curve-analogy --filtered styles/wavy.svg --save-style $OUT/a && cd $OUT && curve-analogy --filtered a" EXIT 1
  STDERR "curve-analogy: a: is a style; give it as --style-file FILE")
command_case(curve-analogy/a-style-file-has-its-unfiltered-curves
  RUN "curve-analogy --filtered styles/wavy.svg --save-style $OUT/a && curve-analogy --style sea=styles/wavy-plain.svg:$OUT/a drawings/harbour.svg" EXIT 1
  STDERR "~curve-analogy: .*/a: is a style, which has its unfiltered curves in it; leave out styles/wavy-plain.svg")
foreach(case
    [["--speed":3|"--speed" is no option that a style has]]
    [["--output":"x"|"--output" is no option that a style has]]
    [["--seed":-1|"--seed" must be a whole number, 0 or more]]
    [["--seed":1.5|"--seed" must be a whole number, 0 or more]]
    [["--samples":1e3|"--samples" must be a whole number, 0 or more]]
    [["--samples":99999999999|"--samples" must be a whole number, 0 or more]]
    [["--samples":3|the parameter samples is 3; give 100 to 20000]]
    [["--mean-run":"8"|"--mean-run" must be a number]]
    [["--mean-run":null|"--mean-run" must be a number]]
    [["--loose-ends":1|"--loose-ends" must be true or false]]
    [["--method":"fast"|"--method" must be "chain" or "greedy"]]
    [["--method":7|"--method" must be "chain" or "greedy"]]
    [["--scale":true|"--scale" must be a number or a text]]
    [["--scale":"big"|--scale is a number or auto]])
  string(REGEX REPLACE "\\|.*" "" setting "${case}")
  string(REGEX REPLACE "^[^|]*\\|" "" message "${case}")
  string(MAKE_C_IDENTIFIER "${setting}" name)
  command_case(curve-analogy/a-style-file-with-${name}
    RUN "printf '%s\n' '{\"curves\":1,\"style\":1,${setting}}' '{\"type\":\"path\",\"label\":\"filtered\",\"d\":\"M0 0 L50 9 L99 0\"}' > $OUT/a && cd $OUT && curve-analogy --style-file a ${PROJECT_SOURCE_DIR}/fixtures/drawings/plan.svg" EXIT 1
    STDERR "curve-analogy: a:1: ${message}")
endforeach()
command_case(curve-analogy/a-broken-style-file
  RUN [[printf '%s\n' '{"curves":1,"style":1}' '{"type":"path","label":"filtered","d":"M0 0 L50 9"}' '{"type":"path","label":"other","d":"M0 0 L50 9"}' > $OUT/a
        cd $OUT && curve-analogy --style sea=a]] EXIT 1
  STDERR "curve-analogy: a:3: a path of a style has the label \"filtered\", or \"unfiltered\" after one that has the label \"filtered\", or \"stroke\" after these two")

command_case(curve-analogy/synthesize-reads-nothing
  RUN "curve-analogy --filtered styles/coast.svg --synthesize 2000 --seed 3 | grep -c '\"type\":\"path\"'" SAME "echo 1")
command_case(curve-analogy/synthesize-variants-are-seeds
  RUN "curve-analogy --filtered styles/loops.svg --synthesize 900 --variants 3 | grep path | tail -n 1"
  SAME "curve-analogy --filtered styles/loops.svg --synthesize 900 --seed 3 | grep path")
command_case(curve-analogy/synthesize-takes-no-input
  RUN "curve-analogy --filtered styles/loops.svg --synthesize 900 drawings/plan.svg" EXIT 2
  STDERR "curve-analogy: --synthesize does not go with an input; see curve-analogy --help")
command_case(curve-analogy/synthesize-must-be-above-nought
  RUN "curve-analogy --filtered styles/loops.svg --synthesize 0" EXIT 2
  STDERR "curve-analogy: --synthesize must be above 0; see curve-analogy --help")
command_case(curve-analogy/synthesize-by-the-search-of-the-paper
  RUN [[curve-analogy --filtered styles/loops.svg --synthesize 400 --samples 300 --method greedy | grep path > $OUT/1
        curve-analogy --filtered styles/loops.svg --synthesize 400 --samples 300 --faithful --levels 4 | grep path > $OUT/2
        curve-analogy --filtered styles/loops.svg --synthesize 400 --samples 300 | grep path > $OUT/3
        test $(cat $OUT/? | sort -u | wc -l) = 3]])
command_case(curve-analogy/synthesize-by-search-has-variants
  RUN "curve-analogy --filtered styles/loops.svg --synthesize 400 --samples 300 --method greedy --variants 3 | grep path | tail -n 1"
  SAME "curve-analogy --filtered styles/loops.svg --synthesize 400 --samples 300 --method greedy --seed 3 | grep path")
command_case(curve-analogy/synthesize-too-long
  RUN "curve-analogy --filtered styles/loops.svg --synthesize 1e12" EXIT 1
  STDERR "~curve-analogy: styles/loops.svg: the length of a curve to be made must be above 0 px and at most [0-9]+ px")

# Constraints. The drawing has a line of 300 px with the id road.
function(road_case name)
  cmake_parse_arguments(PARSE_ARGV 1 ROAD "" "RECORDS;OPTIONS;STDERR;EXIT;SAME" "")
  if(NOT DEFINED ROAD_EXIT)
    set(ROAD_EXIT 0)
  endif()
  set(drawing [[{"curves":1}\n{"type":"path","id":"road","d":"M0 50 L300 50"}\n]])
  command_case(curve-analogy/${name}
    RUN "printf '${drawing}${ROAD_RECORDS}' | curve-analogy --filtered styles/wavy.svg ${ROAD_OPTIONS}"
    EXIT ${ROAD_EXIT} STDERR "${ROAD_STDERR}" SAME "${ROAD_SAME}")
endfunction()
road_case(through-is-what-a-record-says
  OPTIONS "--through 'road=120,80@0.4' --through 'road=200,45*0.01' | tail -n +2"
  SAME [[printf '{"curves":1}\n{"type":"path","id":"road","d":"M0 50 L300 50"}\n{"type":"constraint","curve":"road","at":[120,80],"t":0.4}\n{"type":"constraint","curve":"road","at":[200,45],"weight":0.01}\n' | curve-analogy --filtered styles/wavy.svg | tail -n +2 | head -n 1]])
road_case(through-is-passed-exactly
  OPTIONS "--through road=120.125,80.0625@0.4 | grep -o ' 120.125 80.0625 '" SAME "echo ' 120.125 80.0625 '")
road_case(through-an-end-moves-it
  OPTIONS "--method greedy --samples 300 --through road=-5,44@0 | grep -o '\"M-5 44 '" SAME [[echo '"M-5 44 ']])
command_case(curve-analogy/one-of-several-strokes-passes-a-place
  RUN "curve-analogy --unfiltered styles/overdrawn-plain.svg --filtered styles/overdrawn.svg drawings/places.curves | grep '\"id\":\"hard\"' | grep -o ' 130 90 '"
  SAME "echo ' 130 90 '")
command_case(curve-analogy/every-frame-passes-a-place
  RUN "curve-analogy --filtered styles/wavy.svg --frames 3 --coherence 0.5 drawings/places.curves | grep '\"id\":\"hard\"' | grep -c ' 130 90 '"
  SAME "echo 3")
command_case(curve-analogy/frames-that-stay-keep-soft-places
  RUN "curve-analogy --filtered styles/wavy.svg --frames 3 --coherence 1 drawings/places.curves | grep '\"id\":\"soft\"' | sort -u | wc -l"
  SAME "echo 1")
road_case(constraints-stay
  RECORDS [[{"type":"constraint","curve":"road","at":[120,80]}\n]]
  OPTIONS "| tail -n 1" SAME [[echo '{"type":"constraint","curve":"road","at":[120,80]}']])
road_case(constraints-do-not-depend-on-threads
  RECORDS [[{"type":"constraint","curve":"road","at":[120,80],"weight":0.001}\n]]
  OPTIONS "--threads 1 | cmp - <(printf '{\"curves\":1}\\n{\"type\":\"path\",\"id\":\"road\",\"d\":\"M0 50 L300 50\"}\\n{\"type\":\"constraint\",\"curve\":\"road\",\"at\":[120,80],\"weight\":0.001}\\n' | curve-analogy --filtered styles/wavy.svg --threads 3)")
road_case(history-names-places
  OPTIONS "--through road=120,80@0.4 | head -n 1 | grep -o 'curve-analogy [^\"]*'"
  SAME "echo 'curve-analogy --filtered wavy.svg --through road=120,80@0.4'")
road_case(through-nothing-is-warned-about
  OPTIONS "--through lane=120,80 > $OUT/a"
  STDERR "curve-analogy: stdin:1: warning: --through lane=120,80 moves no line: no path that is drawn again has this id")
road_case(a-record-that-names-nothing-has-no-effect
  RECORDS [[{"type":"constraint","curve":"lane","at":[120,80]}\n]]
  OPTIONS "| sed -n 2p"
  SAME [[printf '{"curves":1}\n{"type":"path","id":"road","d":"M0 50 L300 50"}\n' | curve-analogy --filtered styles/wavy.svg | sed -n 2p]])
road_case(constraints-that-contradict-each-other
  RECORDS [[{"type":"constraint","curve":"road","at":[120,80],"t":0.5}\n{"type":"constraint","curve":"road","at":[130,80],"t":0.5}\n]]
  EXIT 1
  STDERR "curve-analogy: stdin:4: #road cannot be in two places at once, 120,80 (line 3) and 130,80 (line 4); take one away or give it a weight")
road_case(a-record-and-an-option-that-contradict-each-other
  RECORDS [[{"type":"constraint","curve":"road","at":[120,80],"t":0.5}\n]]
  OPTIONS "--through road=1,2@.5" EXIT 1
  STDERR "curve-analogy: stdin: #road cannot be in two places at once, 120,80 (line 3) and 1,2 (--through road=1,2@.5); take one away or give it a weight")
road_case(a-place-far-beyond-all
  OPTIONS "--through road=1e300,80" EXIT 1
  STDERR "curve-analogy: stdin: the constraint at 1e+300,80 is too far away: the line to it would be over a million times as long as a step of the style")
road_case(a-record-whose-t-is-out-of-range
  RECORDS [[{"type":"constraint","curve":"road","at":[120,80],"t":1.5}\n]] EXIT 1
  STDERR "~curve-analogy: stdin:3: .*\"t\".*")
road_case(a-record-whose-weight-is-negative
  RECORDS [[{"type":"constraint","curve":"road","at":[120,80],"weight":-1}\n]] EXIT 1
  STDERR "~curve-analogy: stdin:3: .*\"weight\".*")
foreach(place "road" "=1,2" "road=" "road=1" "road=1,2@" "road=9,2*" "road=1,2*3@.5" "road=nan,2" "road=1,2x" "1,2@.5")
  string(MAKE_C_IDENTIFIER "${place}" name)
  road_case(through-of-another-form-${name} OPTIONS "--through '${place}'" EXIT 2
    STDERR "~curve-analogy: --through .*: give CURVE=X,Y or CURVE=X,Y@T, and .WEIGHT behind it if you like; see curve-analogy --help")
endforeach()
road_case(through-has-t-in-range OPTIONS "--through road=1,2@1.5" EXIT 2
  STDERR "curve-analogy: --through road=1,2@1.5: T is from 0, where the line begins, to 1, where it ends; see curve-analogy --help")
foreach(weight 0 -1)
  road_case(through-has-a-weight-above-nought-${weight} OPTIONS "--through 'road=1,2*${weight}'" EXIT 2
    STDERR "~curve-analogy: --through .*: WEIGHT is above 0; without it the line passes exactly; see curve-analogy --help")
endforeach()
command_case(curve-analogy/synthesize-from-place-to-place
  RUN "curve-analogy --filtered styles/coast.svg --synthesize 1600 --through 20,150@0 --through 780.5,250@1 | grep -oE '\"M20 150 .*[ L]780.5 250\"' | wc -l"
  SAME "echo 1")
command_case(curve-analogy/synthesize-places-have-a-t
  RUN "curve-analogy --filtered styles/coast.svg --synthesize 1600 --through 20,150" EXIT 2
  STDERR "~curve-analogy: --through 20,150: with --synthesize give X,Y@T, and .WEIGHT behind it if you like; .*")
command_case(curve-analogy/synthesize-places-too-far-apart
  RUN "curve-analogy --filtered styles/coast.svg --synthesize 500 --through 20,150@0 --through 780,150@1" EXIT 1
  STDERR "curve-analogy: styles/coast.svg: two places to pass are 760 px apart, and only 500 px of the line lie between them; make it longer")
