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

# Documents a, c and d are good; b has a line that is no record, and the header after it another version.
set(three_of_five [[printf '%s\n' '{"curves":1,"name":"a"}' '{"type":"path","d":"M0 0 L9 9"}' \
  '{"curves":1,"name":"b"}' 'half a l' '{"type":"path","d":"M0 0 L9 9"}' '{"curves":2,"name":"b2"}' \
  '{"curves":1,"name":"c"}' '{"type":"path","d":"M0 0 L9 0"}' '{"curves":1,"name":"d"}' '{"type":"path","d":"M0 0 L0 9"}' > $OUT/in.curves]])
set(two_errors "render: in.curves:4: not a JSON object
~render: in.curves:6: .curves.: must be 1, .*")
command_case(render/keep-going-draws-what-is-whole-and-keeps-its-number
  RUN "${three_of_five}; cd $OUT; render --keep-going -o '{number}-{name}.png' in.curves; test $? = 1 && ls"
  STDERR ${two_errors} SAME "printf '%s\n' 1-a.png 4-c.png 5-d.png in.curves")
command_case(render/keep-going-leaves-pages-out
  RUN "${three_of_five}; cd $OUT; render --keep-going --format pdf in.curves; test $? = 1"
  STDERR ${two_errors} SAME "sed -e 3,6d $OUT/in.curves | render --format pdf")
command_case(render/without-keep-going-the-first-error-ends-it
  RUN "${three_of_five}; cd $OUT; render -o a.pdf in.curves; test $? = 1 && ls"
  STDERR "render: in.curves:4: not a JSON object" SAME "echo in.curves")
command_case(render/keep-going-over-inputs
  RUN "render --keep-going -o $OUT/'{name}.png' nowhere.curves broken/cut.curves /dev/null broken/not-xml.svg drawings/plan.svg; test $? = 1 && ls $OUT"
  STDERR "render: nowhere.curves: cannot be opened: No such file or directory
~render: broken/cut.curves:3: .*
render: /dev/null: holds no document; a document begins with a header line
~render: broken/not-xml.svg:1: .*"
  SAME "echo plan.png")
command_case(render/keep-going-over-what-cannot-be-drawn
  RUN [[printf '%s\n' '{"curves":1,"name":"vast","width":1e9,"height":1}' '{"curves":1,"name":"small","width":9,"height":9}' | render --keep-going -o $OUT/'{name}.png'; test $? = 1 && ls $OUT]]
  STDERR "~render: stdin:1: the picture is too large for PNG.*" SAME "echo small.png")
command_case(render/keep-going-does-not-put-two-documents-in-one-png
  RUN "render --keep-going drawings/plan.svg drawings/harbour.svg -o $OUT/a.png; test $? = 1 && test $(ls $OUT | wc -l) = 0"
  STDERR "~render: drawings/harbour.svg: a second document, .*")
command_case(render/keep-going-over-nothing-good-writes-nothing
  RUN "render --keep-going -o $OUT/a.pdf broken/cut.curves; test $? = 1 && test $(ls $OUT | wc -l) = 0"
  STDERR "~render: broken/cut.curves:3: .*")
command_case(render/pictures-are-the-same-on-any-number-of-threads
  RUN "svg2curves drawings/*.svg styles/*.svg | render --threads 1 -o $OUT/'{number}.png' && cat $OUT/*.png"
  SAME "svg2curves drawings/*.svg styles/*.svg | render --threads 7 -o $OUT/'{number}.png' && cat $OUT/*.png")
command_case(render/pages-are-the-same-on-any-number-of-threads
  RUN "render --threads 1 --format pdf drawings/*.svg styles/*.svg" SAME "render --threads 3 --format pdf drawings/*.svg styles/*.svg")
command_case(render/report-names-what-is-missing
  RUN [[printf '%s\n' '{"curves":1,"width":9,"height":9}' '{"type":"path","id":"a","in":"g","d":"M0 0 L9 0"}' | render --quiet --report - -o $OUT/a.png | sed -n 2p | cut -d, -f 1-4]]
  SAME [[echo '{"severity":"warning","file":"stdin","line":2,"id":"a"']])
