// SPDX-License-Identifier: Apache-2.0
// Work in scan-line order on several threads.
//
// Where a cell of a grid needs the cells before it in its row, and those of the rows above as far
// as `reach` columns to its right, scan-line order does not forbid threads: a row may follow the
// row above at a distance. Each cell finds the same cells done on any number of threads, and so
// its result is the same.
#pragma once

#include <functional>

namespace libstyle {

// Calls work(row, begin, end) for pieces of columns begin .. end-1 that cover each of `rows` rows
// from left to right, on at most `threads` threads (0: one a core). When it is called, all of the
// rows above up to column end-1+reach is done. Pieces are short, for rows to follow closely. When
// work throws, the rest is left out and the exception is thrown on.
void wavefront(int rows, int columns, int reach, int threads,
               const std::function<void(int row, int begin, int end)>& work);

}  // namespace libstyle
