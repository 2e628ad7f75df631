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
command_case(render/second-document-in-one-png
  RUN "svg2curves drawings/plan.svg drawings/harbour.svg | render -o $OUT/a.png; test $? = 1 && test $(ls $OUT | wc -l) = 0"
  STDERR "~render: stdin:[0-9]+: a second document, .*")
command_case(render/several-documents-in-one-pdf
  RUN "svg2curves drawings/plan.svg drawings/harbour.svg | render --format pdf | grep -ac '/Count 2'" SAME "echo 1")
command_case(render/missing-references-name-file-and-line
  RUN [[printf '%s\n' '{"curves":1,"width":9,"height":9}' '{"type":"path","id":"a","in":"g","clip":"c","fill":"url(#p)","d":"M0 0 L9 0 L9 9 Z"}' | render | head -c 4 | od -An -tx1 | tr -d ' ']] SAME "echo 89504e47"
  STDERR "~render: stdin:2: warning: #a: the group .g. is not there.*
~render: stdin:2: warning: #a: the clip .c. is not there.*
~render: stdin:2: warning: #a: the gradient .p. is not there.*")
command_case(render/width-and-height-are-bounds
  RUN "svg2curves drawings/plan.svg | render -w 100 -h 2000" SAME "svg2curves drawings/plan.svg | render -w 100")
command_case(render/width-must-be-above-nought
  RUN "render --width 0 drawings/plan.svg" EXIT 2 STDERR "render: --width must be above 0; see render --help")
command_case(render/background-must-be-a-color
  RUN "render --background blurple drawings/plan.svg" EXIT 2
  STDERR "~render: --background: .blurple. is not a CSS color; see render --help")
command_case(render/output-must-say-its-format
  RUN "render -o $OUT/plan.jpg drawings/plan.svg" EXIT 2 STDERR "~render: --output: .* --format; see render --help")
command_case(render/picture-too-large
  RUN "render -w 1e9 drawings/plan.svg" EXIT 1 STDERR "~render: drawings/plan.svg: the picture is too large for PNG.*")
command_case(render/scribble-of-a-million-lines
  RUN [[awk 'BEGIN { srand(1); printf "{\"curves\":1,\"width\":200,\"height\":200}\n{\"type\":\"path\",\"fill\":\"#000000\",\"d\":\"M0 0"
              for (i = 0; i < 1000000; ++i) printf " L%d %d", 200 * rand(), 200 * rand()
              print "\"}" }' | render -o $OUT/a.png; test $? = 1 && test $(ls $OUT | wc -l) = 0]]
  STDERR "~render: stdin:2: so many lines side by side would take minutes to draw as PNG; .*")
command_case(render/coordinates-beyond-all-bounds
  RUN "svg2curves --quiet broken/huge-coordinates.svg | render --quiet -o $OUT/a.png && head -c 4 $OUT/a.png | od -An -tx1 | tr -d ' '" SAME "echo 89504e47")
command_case(render/closed-pipe-is-quiet
  RUN "svg2curves drawings/plan.svg | render -w 4000 | head -c 100 | wc -c" SAME "echo 100")
