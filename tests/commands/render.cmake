# SPDX-License-Identifier: Apache-2.0
program_cases(render)

command_case(render/png-has-its-signature
  RUN "svg2curves drawings/plan.svg | render | head -c 4 | od -An -tx1 | tr -d ' '" SAME "echo 89504e47")
command_case(render/pdf-by-extension
  RUN "svg2curves drawings/plan.svg | render -o $OUT/plan.pdf && head -c 5 $OUT/plan.pdf" SAME "printf %%PDF-")
command_case(render/svg-by-extension
  RUN "svg2curves drawings/plan.svg | render -o $OUT/plan.svg && grep -c '<svg' $OUT/plan.svg" SAME "echo 1")
command_case(render/opens-svg-by-name
  RUN "render drawings/plan.svg" SAME "svg2curves drawings/plan.svg | render")
command_case(render/same-bytes-twice-in-pdf
  RUN "svg2curves drawings/plan.svg | render --format pdf" SAME "svg2curves drawings/plan.svg | render --format pdf")
command_case(render/pattern-names-each-document
  RUN [[svg2curves drawings/plan.svg drawings/harbour.svg | render -o "$OUT/{name}.png" && ls $OUT]] SAME "echo harbour.png; echo plan.png")
command_case(render/cut-stream
  RUN "render broken/cut.curves -o $OUT/a.png; test $? = 1 && test $(ls $OUT | wc -l) = 0" STDERR "~render: broken/cut.curves:3: .*")
command_case(render/headerless RUN "render broken/headerless.curves" EXIT 1 STDERR "~render: broken/headerless.curves:1: .*")
command_case(render/relative-command RUN "render broken/relative-command.curves" EXIT 1 STDERR "~render: broken/relative-command.curves:2: .*")
command_case(render/infinite-number RUN "render broken/infinite-number.curves" EXIT 1 STDERR "~render: broken/infinite-number.curves:2: .*")
command_case(render/later-version RUN "render broken/later-version.curves" EXIT 1 STDERR "~render: broken/later-version.curves:1: .*")
command_case(render/empty-input RUN "render < /dev/null" EXIT 1 STDERR "~render: stdin: .*")
command_case(render/missing-file RUN "render nowhere.curves" EXIT 1 STDERR "render: nowhere.curves: cannot be opened: No such file or directory")
command_case(render/full-disk
  RUN "svg2curves drawings/plan.svg | render -o /dev/full --format png" EXIT 1 STDERR "render: /dev/full: cannot be written: No space left on device")
