# SPDX-License-Identifier: Apache-2.0
program_cases(image-analogy)

set(garden "image-analogy --unfiltered pictures/garden-regions.png --filtered pictures/garden.png")
command_case(image-analogy/stdin-to-stdout
  RUN "${garden} < pictures/new-garden-regions.png"
  SAME "${garden} --target pictures/new-garden-regions.png -o $OUT/a.png && cat $OUT/a.png")
command_case(image-analogy/the-same-bytes-on-any-number-of-threads
  RUN "${garden} --target pictures/new-garden-regions.png --threads 1"
  SAME "${garden} --target pictures/new-garden-regions.png --threads 7")
command_case(image-analogy/the-same-bytes-without-wide-instructions
  RUN "${garden} --target pictures/new-garden-regions.png"
  SAME "export GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX512F,-AVX2,-AVX,-FMA; ${garden} --target pictures/new-garden-regions.png")
command_case(image-analogy/a-map-of-sources-gives-the-result-again
  RUN "${garden} --target pictures/new-garden-regions.png --source-map $OUT/map.png"
  SAME "image-analogy --filtered pictures/garden.png --apply-map $OUT/map.png")
command_case(image-analogy/options-are-stronger-than-the-application
  RUN "${garden} --target pictures/new-garden-regions.png --for painting --match color --kappa 5"
  SAME "${garden} --target pictures/new-garden-regions.png")
command_case(image-analogy/a-texture-is-another-with-another-seed
  RUN "! cmp -s <(image-analogy --filtered pictures/gravel.png --size 60x50) <(image-analogy --filtered pictures/gravel.png --size 60x50 --seed 2)")
command_case(image-analogy/sixteen-bits-and-floats-go-through
  RUN "image-analogy --filtered pictures/gravel.png --size 40x40 --depth 16 -o $OUT/a.png && image-analogy --filtered $OUT/a.png --size 20x20 -o $OUT/b.png && file -b $OUT/b.png | grep -o '16-bit'"
  SAME "echo 16-bit")
command_case(image-analogy/the-report-tells-of-each-level
  RUN "image-analogy --filtered pictures/gravel.png --size 64x48 --report $OUT/r.json > $OUT/a.png && grep -c coherent_share $OUT/r.json"
  SAME "echo 2")

command_case(image-analogy/no-example RUN "image-analogy --size 9x9" EXIT 2
  STDERR "image-analogy: --filtered is missing: the example, a picture in the style; see image-analogy --help")
command_case(image-analogy/no-size RUN "image-analogy --filtered pictures/gravel.png" EXIT 2
  STDERR "~image-analogy: give --unfiltered and --target .*or --size .*")
command_case(image-analogy/bad-size RUN "image-analogy --filtered pictures/gravel.png --size 9x" EXIT 2
  STDERR "~image-analogy: --size: \"9x\" is not of the form WIDTHxHEIGHT.*")
command_case(image-analogy/bad-guide RUN "image-analogy --filtered pictures/gravel.png --guide a.png" EXIT 2
  STDERR "~image-analogy: --guide: \"a.png\" is not of the form EXAMPLE.*")
command_case(image-analogy/kappa-out-of-range RUN "image-analogy --filtered pictures/gravel.png --size 9x9 --kappa -1" EXIT 2
  STDERR "~image-analogy: coherence must be 0 to 1000.*")
command_case(image-analogy/sizes-that-differ
  RUN "image-analogy --unfiltered pictures/cat.png --filtered pictures/garden.png --target pictures/cat.png" EXIT 1
  STDERR "image-analogy: the unfiltered picture is 190x140 and the filtered picture is 180x140; they must be of one size")
command_case(image-analogy/a-cut-picture
  RUN "head -c 4000 pictures/gravel.png > $OUT/cut.png; image-analogy --filtered $OUT/cut.png --size 9x9 -o $OUT/a.png; test $? = 1 && ls $OUT"
  STDERR "~image-analogy: .*/cut.png: is cut off; the end of the picture is missing"
  SAME "echo cut.png")
command_case(image-analogy/a-folder RUN "image-analogy --filtered pictures --size 9x9" EXIT 1
  STDERR "image-analogy: pictures: is a folder; name a file")
command_case(image-analogy/no-picture RUN "image-analogy --filtered README.md --size 9x9" EXIT 1
  STDERR "~image-analogy: README.md: is no picture that can be read.*")
command_case(image-analogy/full-disk RUN "image-analogy --filtered pictures/gravel.png --size 9x9 > /dev/full" EXIT 1
  STDERR "image-analogy: stdout: cannot be written: No space left on device")
command_case(image-analogy/an-output-of-no-known-kind RUN "image-analogy --filtered pictures/gravel.png --size 9x9 -o $OUT/a.gif" EXIT 2
  STDERR "~image-analogy: --output: .* does not end in .png.*")
