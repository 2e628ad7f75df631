# SPDX-License-Identifier: Apache-2.0
program_cases(svg2curves)

command_case(svg2curves/basic-shapes RUN "svg2curves drawings/plan.svg" STDOUT expected/plan.curves)
command_case(svg2curves/layers-and-style-sheet RUN "svg2curves drawings/harbour.svg" STDOUT expected/harbour.curves)
command_case(svg2curves/stdin-gives-the-same-records
  RUN "svg2curves < drawings/plan.svg | tail -n +2" SAME "svg2curves drawings/plan.svg | tail -n +2")
command_case(svg2curves/dash-is-stdin
  RUN "svg2curves - < drawings/plan.svg" SAME "svg2curves < drawings/plan.svg")
command_case(svg2curves/many-files-are-one-stream
  RUN "svg2curves drawings/plan.svg drawings/harbour.svg"
  SAME "svg2curves drawings/plan.svg; svg2curves drawings/harbour.svg")
command_case(svg2curves/output-has-the-same-bytes
  RUN "svg2curves drawings/plan.svg -o $OUT/plan.curves && cat $OUT/plan.curves && test $(ls $OUT | wc -l) = 1"
  STDOUT expected/plan.curves)

command_case(svg2curves/select-a-layer-and-a-class
  RUN [[svg2curves --select 'layer:Walls, .window' drawings/plan.svg | grep -o '"in":"[^"]*"']]
  SAME [[printf '"in":"%s"\n' walls walls walls openings openings openings]])
command_case(svg2curves/select-several-times
  RUN "svg2curves --select .door --select '#bed' drawings/plan.svg | tail -n +2" SAME "svg2curves --select '.door,#bed' drawings/plan.svg | tail -n +2")
command_case(svg2curves/select-nothing
  RUN "svg2curves --select '#nobody' drawings/plan.svg | wc -l" SAME "echo 1"
  STDERR "svg2curves: drawings/plan.svg: warning: --select: nothing in the drawing is called so")
command_case(svg2curves/select-wants-names
  RUN "svg2curves --select 'g > path' drawings/plan.svg" EXIT 2
  STDERR "~svg2curves: --select: .g > path. is not #ID, .* or the name of an element such as rect; see svg2curves --help")
command_case(svg2curves/split-makes-a-path-of-each-subpath
  RUN [[svg2curves drawings/plan.svg | grep -o '"d":"[^"]*"' | grep -o M | wc -l]]
  SAME [[svg2curves --split drawings/plan.svg | grep -c '"type":"path"']])
command_case(svg2curves/flatten-makes-lines
  RUN [[svg2curves --flatten 0.1 drawings/plan.svg | { ! grep '"d":"[^"]*C'; }]])
command_case(svg2curves/flatten-must-be-above-nought
  RUN "svg2curves --flatten 0 drawings/plan.svg" EXIT 2
  STDERR "svg2curves: --flatten must be above 0; see svg2curves --help")
command_case(svg2curves/missing-file
  RUN "svg2curves nowhere.svg" EXIT 1
  STDERR "svg2curves: nowhere.svg: cannot be opened: No such file or directory")
command_case(svg2curves/folder
  RUN "svg2curves drawings" EXIT 1 STDERR "svg2curves: drawings: is a folder; name a file")
command_case(svg2curves/full-disk
  RUN "svg2curves drawings/plan.svg -o /dev/full" EXIT 1
  STDERR "svg2curves: /dev/full: cannot be written: No space left on device")
command_case(svg2curves/full-disk-on-stdout
  RUN "svg2curves drawings/plan.svg > /dev/full" EXIT 1
  STDERR "svg2curves: stdout: cannot be written: No space left on device")
command_case(svg2curves/unwritable-output
  RUN "svg2curves drawings/plan.svg -o $OUT/none/plan.curves" EXIT 1
  STDERR "~svg2curves: .*/none/plan.curves: cannot be written: No such file or directory")
command_case(svg2curves/closed-pipe-is-quiet
  RUN "(cat drawings/plan.svg; :) | svg2curves | head -c 1 | wc -c | grep -q 1")
command_case(svg2curves/bad-input-leaves-no-output
  RUN "svg2curves broken/truncated.svg -o $OUT/a.curves; test $? = 1 && test $(ls $OUT | wc -l) = 0"
  STDERR "~svg2curves: broken/truncated.svg:1: .*")

command_case(svg2curves/truncated RUN "svg2curves broken/truncated.svg" EXIT 1 STDERR "~svg2curves: broken/truncated.svg:1: .*")
command_case(svg2curves/not-xml RUN "svg2curves broken/not-xml.svg" EXIT 1 STDERR "~svg2curves: broken/not-xml.svg:.*")
command_case(svg2curves/empty RUN "svg2curves broken/empty.svg" EXIT 1 STDERR "~svg2curves: broken/empty.svg:.*")
command_case(svg2curves/use-cycle RUN "svg2curves broken/use-cycle.svg | grep -c '\"path\"' | grep -qx 1" STDERR "~svg2curves: broken/use-cycle.svg:.*warning: .*
~svg2curves: broken/use-cycle.svg:.*warning: .*")
command_case(svg2curves/billion-laughs RUN "svg2curves broken/billion-laughs.svg" EXIT 1 STDERR "~svg2curves: broken/billion-laughs.svg:.*")
command_case(svg2curves/external-entity-is-never-read
  RUN "svg2curves broken/external-entity.svg | grep -c '\"path\"' | grep -qx 1" STDERR "~svg2curves: broken/external-entity.svg:.*")
command_case(svg2curves/nan-coordinates
  RUN "svg2curves broken/nan-coordinates.svg | grep -c '\"good\"' | grep -qx 1" STDERR "~svg2curves: .*bad.*
~svg2curves: .*worse.*")
command_case(svg2curves/huge-coordinates
  RUN "svg2curves broken/huge-coordinates.svg | grep -c '\"good\"' | grep -qx 1" STDERR "~svg2curves: .*huge.*")
command_case(svg2curves/deep-nesting
  RUN "yes '<g>' | head -n 10000 | (echo '<svg>'; cat) | svg2curves" EXIT 1 STDERR "~svg2curves: stdin:.*")
command_case(svg2curves/strict-fails-on-a-warning
  RUN "svg2curves --strict -q broken/nan-coordinates.svg > /dev/null" EXIT 1 STDERR "~svg2curves: .*")

set(images [[printf '<svg>\n%s</svg>' "$(printf '<image/>\n%.0s' 1 2 3 4 5 6 7 8)"]])
command_case(svg2curves/same-warnings-are-counted-after-the-fifth
  RUN "${images} | svg2curves > $OUT/a.curves"
  STDERR "svg2curves: stdin:2: warning: image is not carried
svg2curves: stdin:3: warning: image is not carried
svg2curves: stdin:4: warning: image is not carried
svg2curves: stdin:5: warning: image is not carried
svg2curves: stdin:6: warning: image is not carried
svg2curves: stdin: warning: and 3 more: image is not carried")
command_case(svg2curves/report-has-every-warning
  RUN "${images} | svg2curves --quiet --report $OUT/report.json > $OUT/a.curves && grep -c '^{.severity' $OUT/report.json"
  SAME "echo 8")

command_case(svg2curves/packed-by-gzip
  RUN "cp drawings/plan.svg $OUT && gzip -S z $OUT/plan.svg && svg2curves $OUT/plan.svgz" SAME "svg2curves drawings/plan.svg")
command_case(svg2curves/packed-and-cut-off
  RUN "gzip < drawings/plan.svg | head -c 200 | svg2curves" EXIT 1
  STDERR "svg2curves: stdin: is packed by gzip, and damaged or cut off")
command_case(svg2curves/packed-without-end
  RUN "yes '<g>' | head -c 300000000 | gzip -1 | svg2curves" EXIT 1
  STDERR "svg2curves: stdin: is larger than 256 MB when unpacked")

command_case(svg2curves/text-is-drawn-as-by-rsvg-convert
  RUN [[cd ../tests/golden/svg-text && for name in *.svg; do
    rsvg-convert $name -o $OUT/expected.png && svg2curves --strict $name | render -o $OUT/actual.png &&
    pixdiff --envelope --bound 24 --share 0.0005 $OUT/expected.png $OUT/actual.png || exit
  done]])
set(text ../tests/golden/svg-text/spans.svg)
command_case(svg2curves/text-does-not-depend-on-the-language-of-the-user
  RUN "LANG=ja_JP.UTF-8 LC_ALL= LANGUAGE=ja svg2curves ${text}" SAME "svg2curves ${text}")
command_case(svg2curves/text-without-fonts-is-left-out
  RUN "echo '<fontconfig/>' > $OUT/none.conf; FONTCONFIG_FILE=$OUT/none.conf svg2curves ${text} | grep -c 'shape\":\"text'; test $? = 1"
  STDERR "~svg2curves: ${text}:4: warning: #colors: is left out: it needs fonts, .*
~svg2curves: .*#nested.*
~svg2curves: .*#moved.*
~svg2curves: .*#lines.*")

command_case(svg2curves/strict-writes-nothing-of-several
  RUN "svg2curves --strict drawings/plan.svg broken/nan-coordinates.svg drawings/harbour.svg -q -o $OUT/a.curves; test $? = 1 && test $(ls $OUT | wc -l) = 0"
  STDERR "svg2curves: not everything was carried, and --strict asks for that")

command_case(svg2curves/first-error-ends-the-run
  RUN "svg2curves drawings/plan.svg nowhere.svg broken/empty.svg -o $OUT/a.curves; test $? = 1 && test $(ls $OUT | wc -l) = 0"
  STDERR "svg2curves: nowhere.svg: cannot be opened: No such file or directory")
command_case(svg2curves/keep-going-skips-what-is-bad
  RUN "svg2curves --keep-going nowhere.svg drawings/plan.svg . broken/truncated.svg drawings/harbour.svg -o $OUT/a.curves; test $? = 1 && cat $OUT/a.curves"
  STDERR "svg2curves: nowhere.svg: cannot be opened: No such file or directory
svg2curves: .: is a folder; name a file
~svg2curves: broken/truncated.svg:1: .*"
  SAME "svg2curves drawings/plan.svg drawings/harbour.svg")
command_case(svg2curves/keep-going-over-nothing-good-writes-nothing
  RUN "svg2curves --keep-going nowhere.svg broken/empty.svg -o $OUT/a.curves; test $? = 1 && test $(ls $OUT | wc -l) = 0"
  STDERR "svg2curves: nowhere.svg: cannot be opened: No such file or directory
~svg2curves: broken/empty.svg:1: .*")
command_case(svg2curves/keep-going-does-not-hide-a-full-disk
  RUN "svg2curves --keep-going drawings/plan.svg drawings/harbour.svg -o /dev/full" EXIT 1
  STDERR "svg2curves: /dev/full: cannot be written: No space left on device")
command_case(svg2curves/the-same-on-any-number-of-threads
  RUN "for n in 1 1 1; do svg2curves --threads $n --keep-going broken/*.svg drawings/*.svg nowhere.svg ../tests/golden/svg-text/*.svg styles/*.svg 2>&1; done || true"
  SAME "for n in 2 7 0; do svg2curves --threads $n --keep-going broken/*.svg drawings/*.svg nowhere.svg ../tests/golden/svg-text/*.svg styles/*.svg 2>&1; done || true")
command_case(svg2curves/stdin-twice-is-read-once
  RUN "svg2curves --threads 3 --keep-going - drawings/harbour.svg - < drawings/plan.svg | grep -o '\"curves\":1,\"name\":\"[a-z]*\"'" EXIT 1
  STDERR "svg2curves: stdin:1: is no XML: it has no element"
  SAME "printf '\"curves\":1,\"name\":\"%s\"\n' stdin harbour")
command_case(svg2curves/threads-are-not-below-zero
  RUN "svg2curves --threads -1 drawings/plan.svg" EXIT 2
  STDERR "~svg2curves: .*--threads.*'-1' is below zero; see svg2curves --help")

command_case(svg2curves/report-says-what-stderr-says
  RUN "svg2curves --keep-going --quiet --report $OUT/report.json broken/*.svg drawings/plan.svg > /dev/null; test $? = 1 && cat $OUT/report.json"
  STDERR "~svg2curves: broken/billion-laughs.svg:13: .*
~svg2curves: broken/empty.svg:1: .*
~svg2curves: broken/not-xml.svg:1: .*
~svg2curves: broken/truncated.svg:1: .*"
  STDOUT expected/report.json)
command_case(svg2curves/report-is-written-when-strict-fails
  RUN "svg2curves --strict --quiet --report $OUT/report.json -o $OUT/a.curves broken/nan-coordinates.svg; test $? = 1 && ls $OUT && grep -o '^{\"severity\":\"[a-z]*\",\"file\":[^,]*' $OUT/report.json"
  STDERR "svg2curves: not everything was carried, and --strict asks for that"
  SAME [[echo report.json; printf '{"severity":"%s","file":%s\n' warning '"broken/nan-coordinates.svg"' warning '"broken/nan-coordinates.svg"' error null]])
command_case(svg2curves/report-of-a-clean-run
  RUN "svg2curves --report $OUT/report.json drawings/plan.svg -o $OUT/a.curves && cat $OUT/report.json"
  SAME [[printf '{"report":1,"program":"svg2curves","exit":0,"errors":0,"warnings":0,"messages":[\n]}\n']])
command_case(svg2curves/report-on-stdout
  RUN "svg2curves --report - drawings/plan.svg -o $OUT/a.curves"
  SAME "svg2curves --report $OUT/report.json drawings/plan.svg -o $OUT/a.curves && cat $OUT/report.json")
command_case(svg2curves/report-and-output-not-both-on-stdout
  RUN "svg2curves --report - drawings/plan.svg" EXIT 2
  STDERR "svg2curves: --report and --output cannot both be stdout; see svg2curves --help")
command_case(svg2curves/report-that-cannot-be-written
  RUN "svg2curves --report $OUT/none/report.json drawings/plan.svg" EXIT 1
  STDERR "~svg2curves: .*/none/report.json: cannot be written: No such file or directory")
