// SPDX-License-Identifier: Apache-2.0
// The directions in which vectors differ most.
//
// Source: the paper, section 3.2: principal components that keep 99 % of the variance make the
// vectors of neighbourhoods about ten times shorter. Only the first few are wanted of some 150, so
// they are found by orthogonal iteration on the covariance (Golub and Van Loan, "Matrix
// computations", section 8.2) from a start that is always the same: the subspace that comes out
// holds nearly all that the exact one does, which is all that a search needs.
//
// Cost: O(n d^2 + k d^2) for n vectors of length d and k components.
#pragma once

#include <cstddef>
#include <vector>

namespace libstyle::image {

struct PrincipalComponents {
  std::size_t length = 0;    // d
  std::size_t count = 0;     // k
  std::vector<float> mean;   // of the vectors
  std::vector<float> basis;  // basis[i * count + j]: entry i of component j; orthonormal
  double kept_share = 0;     // of the variance
};

// `vectors` holds n of `length` floats one after the other. At most `most` components, fewer where
// those keep `share` of the variance; at least one.
PrincipalComponents principal_components(const std::vector<float>& vectors, std::size_t length,
                                         std::size_t most, double share);

}  // namespace libstyle::image
