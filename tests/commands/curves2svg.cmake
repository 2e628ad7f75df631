# SPDX-License-Identifier: Apache-2.0
program_cases(curves2svg)

command_case(curves2svg/groups-layers-and-ids-come-back
  RUN "svg2curves drawings/plan.svg | curves2svg" STDOUT expected/plan.svg)
command_case(curves2svg/pattern-names-each-document
  RUN [[svg2curves drawings/plan.svg drawings/harbour.svg | curves2svg -o "$OUT/{name}.svg" && ls $OUT]]
  SAME "echo harbour.svg; echo plan.svg")
command_case(curves2svg/several-documents-need-a-pattern
  RUN "svg2curves drawings/plan.svg drawings/harbour.svg | curves2svg -o $OUT/one.svg; test $? = 1 && ls $OUT" EXIT 0
  STDERR "~curves2svg: .*")
command_case(curves2svg/cut-stream
  RUN "curves2svg broken/cut.curves -o $OUT/a.svg; test $? = 1 && test $(ls $OUT | wc -l) = 0"
  STDERR "~curves2svg: broken/cut.curves:3: .*")
command_case(curves2svg/full-disk
  RUN "svg2curves drawings/plan.svg | curves2svg > /dev/full" EXIT 1
  STDERR "curves2svg: stdout: cannot be written: No space left on device")

command_case(curves2svg/keep-going-writes-what-is-whole
  RUN "(head -n 5 drawings/plan.svg; cat broken/cut.curves) > $OUT/bad; curves2svg --keep-going -o $OUT/'{name}.svg' $OUT/bad broken/relative-command.curves drawings/plan.svg; test $? = 1 && rm $OUT/bad && ls $OUT"
  STDERR "~curves2svg: .*bad:[0-9]+: .*
~curves2svg: broken/relative-command.curves:2: .*"
  SAME "echo plan.svg")
command_case(curves2svg/the-same-on-any-number-of-threads
  RUN "svg2curves drawings/*.svg styles/*.svg | curves2svg --threads 1 -o $OUT/'{number}.svg' && cat $OUT/*.svg"
  SAME "svg2curves drawings/*.svg styles/*.svg | curves2svg --threads 5 -o $OUT/'{number}.svg' && cat $OUT/*.svg")
command_case(curves2svg/empty-input RUN "curves2svg < /dev/null" EXIT 1
  STDERR "curves2svg: stdin: holds no document; a document begins with a header line")
