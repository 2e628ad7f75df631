// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/greedy/screen.h"

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>

#include "libstyle/analogy/greedy/matching.h"

namespace libstyle {
namespace {

using Complex = std::complex<double>;

constexpr Eigen::Index kDimensions = 12;
constexpr Eigen::Index kBasisPlaces = 64;
constexpr double kLeastShare = 1e-10;  // of the largest principal component; less is rounding
// Places are dealt with so many at a time: a whole number of registers, all in the first cache.
constexpr std::size_t kBlock = 64;
// Sums of 2 * kDimensions products, a root and a few more operations, each within 2^-24, of terms
// that are together at most |a|^2 + |b|^2.
constexpr float kAllowance = 4e-6F;

using Block = Eigen::Array<float, static_cast<int>(kBlock), 1>;

// Writes the weighted vector of a neighborhood: positions, then tangents. Returns its squared norm.
double write_vector(const NeighborhoodView& view, const NeighborhoodShape& shape, bool has_middle,
                    double weight, double tangent_weight, std::span<Complex> out) {
  std::ranges::fill(out, Complex());
  if (view.empty()) return 0;
  const std::size_t n = shape.size(), middle = has_middle ? n : shape.middle();
  Point sum;
  for (std::size_t k = view.begin; k < view.end; ++k) {
    if (k != middle) sum += shape.weight(k) * view.positions[k];
  }
  const Point mean = sum / weight_of(shape, view.begin, view.end, has_middle);
  double norm = 0;
  for (std::size_t k = view.begin; k < view.end; ++k) {
    if (k == middle) continue;
    const double root = std::sqrt(weight * shape.weight(k));
    const Vector p = root * (view.positions[k] - mean);
    out[k] = {p.x, p.y};
    norm += squared_norm(p);
    if (k == view.begin || k == middle + 1) continue;
    const Vector t = root * std::sqrt(tangent_weight) * view.tangents[k];
    out[n + k] = {t.x, t.y};
    norm += squared_norm(t);
  }
  return norm;
}

}  // namespace

class Screen::Implementation {
 public:
  Implementation(std::span<const Part> parts, const NeighborhoodShape& shape, double tangent_weight,
                 bool rotate);

  void lower_bounds(std::span<const NeighborhoodView> query, ScreenedPlaces& result) const;

 private:
  // A neighborhood of every part as one vector; returns the squared norm.
  double write_vectors(std::span<const NeighborhoodView> views, std::span<Complex> out) const;
  // |a|^2 of the places over the samples that the query has, as long as the blocks.
  std::vector<float> norms_within(std::span<const NeighborhoodView> query) const;
  void find_basis(const Eigen::MatrixXcd& vectors);
  void project(const Eigen::MatrixXcd& vectors);
  void bound_block(std::size_t block, const Eigen::VectorXcd& z, float norm, float rest,
                   const float* norms, float* bounds) const;

  std::vector<Part> parts_;
  NeighborhoodShape shape_;
  double tangent_weight_;
  bool rotate_;
  std::size_t place_count_;
  std::vector<std::size_t> places_;  // those with whole neighborhoods
  Eigen::MatrixXcd basis_;           // orthonormal columns
  std::vector<float> coordinates_;   // [block][dimension][real, imaginary][place]
  std::vector<float> rests_;         // e_a
  std::vector<float> whole_norms_;   // |a|^2 over all samples
};

Screen::Implementation::Implementation(std::span<const Part> parts, const NeighborhoodShape& shape,
                                       double tangent_weight, bool rotate)
    : parts_(parts.begin(), parts.end()),
      shape_(shape),
      tangent_weight_(tangent_weight),
      rotate_(rotate),
      place_count_(parts_[0].example->size()) {
  const auto is_whole = [&](std::size_t j) {
    return std::ranges::all_of(parts_, [&](const Part& part) {
      const NeighborhoodView view = (*part.example)[j];
      return view.begin == 0 && view.end == shape_.size();
    });
  };
  for (std::size_t j = 0; j < place_count_; ++j) {
    if (is_whole(j)) places_.push_back(j);
  }
  if (places_.empty()) return;

  Eigen::MatrixXcd vectors(static_cast<Eigen::Index>(2 * shape_.size() * parts_.size()),
                           static_cast<Eigen::Index>(places_.size()));
  std::vector<NeighborhoodView> views(parts_.size());
  for (std::size_t i = 0; i < places_.size(); ++i) {
    for (std::size_t p = 0; p < parts_.size(); ++p) views[p] = (*parts_[p].example)[places_[i]];
    write_vectors(views, {vectors.col(static_cast<Eigen::Index>(i)).data(),
                          static_cast<std::size_t>(vectors.rows())});
  }
  find_basis(vectors);
  project(vectors);
  whole_norms_.assign(rests_.size(), 0.0F);
  for (std::size_t i = 0; i < places_.size(); ++i) {
    whole_norms_[i] = static_cast<float>(vectors.col(static_cast<Eigen::Index>(i)).squaredNorm());
  }
}

double Screen::Implementation::write_vectors(std::span<const NeighborhoodView> views,
                                             std::span<Complex> out) const {
  double norm = 0;
  const std::size_t size = 2 * shape_.size();
  for (std::size_t p = 0; p < parts_.size(); ++p) {
    norm += write_vector(views[p], shape_, parts_[p].has_middle, parts_[p].weight, tangent_weight_,
                         out.subspan(p * size, size));
  }
  return norm;
}

void Screen::Implementation::find_basis(const Eigen::MatrixXcd& vectors) {
  const Eigen::Index count = std::min(kBasisPlaces, vectors.cols());
  Eigen::MatrixXcd some(vectors.rows(), count);
  for (Eigen::Index i = 0; i < count; ++i) some.col(i) = vectors.col(i * vectors.cols() / count);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXcd> solver(some.adjoint() * some);
  const Eigen::VectorXd& values = solver.eigenvalues();  // rising
  Eigen::Index kept = 0;
  while (kept < std::min(kDimensions, count) &&
         values[count - 1 - kept] > kLeastShare * values[count - 1]) {
    ++kept;
  }
  basis_.resize(vectors.rows(), kept);
  for (Eigen::Index i = 0; i < kept; ++i) {
    basis_.col(i) = (some * solver.eigenvectors().col(count - 1 - i)).normalized();
  }
}

void Screen::Implementation::project(const Eigen::MatrixXcd& vectors) {
  const Eigen::MatrixXcd z = basis_.adjoint() * vectors;
  const std::size_t blocks = (places_.size() + kBlock - 1) / kBlock;
  const auto dimensions = static_cast<std::size_t>(basis_.cols());
  coordinates_.assign(blocks * dimensions * 2 * kBlock, 0.0F);
  rests_.assign(blocks * kBlock, 0.0F);
  for (std::size_t i = 0; i < places_.size(); ++i) {
    const auto column = static_cast<Eigen::Index>(i);
    float* out = &coordinates_[(i / kBlock) * dimensions * 2 * kBlock + i % kBlock];
    for (Eigen::Index c = 0; c < basis_.cols(); ++c, out += 2 * kBlock) {
      out[0] = static_cast<float>(z(c, column).real());
      out[kBlock] = static_cast<float>(z(c, column).imag());
    }
    const double whole = vectors.col(column).squaredNorm();
    const double rest = std::max(0.0, whole - z.col(column).squaredNorm()) + 1e-12 * whole;
    rests_[i] = static_cast<float>(std::sqrt(rest));
  }
}

void Screen::Implementation::bound_block(std::size_t block, const Eigen::VectorXcd& z, float norm,
                                         float rest, const float* norms, float* bounds) const {
  Block real = Block::Zero(), imaginary = Block::Zero();
  const auto dimensions = static_cast<std::size_t>(basis_.cols());
  const float* a = &coordinates_[block * dimensions * 2 * kBlock];
  for (std::size_t c = 0; c < dimensions; ++c, a += 2 * kBlock) {
    const auto value = z[static_cast<Eigen::Index>(c)];
    const auto x = static_cast<float>(value.real()), y = static_cast<float>(value.imag());
    const Eigen::Map<const Block> a_real(a), a_imaginary(a + kBlock);
    real += x * a_real + y * a_imaginary;
    if (rotate_) imaginary += y * a_real - x * a_imaginary;
  }
  const Block product = rotate_ ? Block((real * real + imaginary * imaginary).sqrt()) : real;
  const Eigen::Map<const Block> rests(&rests_[block * kBlock]), a_norms(norms);
  Eigen::Map<Block> result(bounds);
  result = (1 - kAllowance) * (a_norms + norm) - 2 * (product + rest * rests);
}

std::vector<float> Screen::Implementation::norms_within(
    std::span<const NeighborhoodView> query) const {
  std::vector<float> result(rests_.size());
  for (std::size_t i = 0; i < places_.size(); ++i) {
    double norm = 0;
    for (std::size_t p = 0; p < parts_.size(); ++p) {
      const NeighborhoodView& b = query[p];
      if (b.empty()) continue;
      const bool has_middle = parts_[p].has_middle;
      const NeighborhoodSums sums = sums_between((*parts_[p].example)[places_[i]], b.begin, b.end,
                                                 has_middle, shape_.middle());
      norm += parts_[p].weight *
              (sums.position_squares + tangent_weight_ * sums.tangent_squares -
               squared_norm(sums.positions) / weight_of(shape_, b.begin, b.end, has_middle));
    }
    result[i] = static_cast<float>(norm);
  }
  return result;
}

void Screen::Implementation::lower_bounds(std::span<const NeighborhoodView> query,
                                          ScreenedPlaces& result) const {
  std::vector<float>& bounds = result.bounds;
  bounds.assign(place_count_, 0.0F);
  result.likeliest = 0;
  if (places_.empty()) return;
  float least = std::numeric_limits<float>::infinity();
  Eigen::VectorXcd q(basis_.rows());
  const double norm = write_vectors(query, {q.data(), static_cast<std::size_t>(q.size())});
  const Eigen::VectorXcd z = basis_.adjoint() * q;
  const double rest = std::sqrt(std::max(0.0, norm - z.squaredNorm()) + 1e-12 * norm);

  std::vector<float> partial_norms;
  const bool whole = std::ranges::all_of(query, [&](const NeighborhoodView& view) {
    return view.begin == 0 && view.end == shape_.size();
  });
  if (!whole) partial_norms = norms_within(query);
  const std::vector<float>& norms = whole ? whole_norms_ : partial_norms;
  float block_bounds[kBlock];
  for (std::size_t first = 0; first < places_.size(); first += kBlock) {
    const std::size_t count = std::min(kBlock, places_.size() - first);
    bound_block(first / kBlock, z, static_cast<float>(norm), static_cast<float>(rest),
                &norms[first], block_bounds);
    for (std::size_t i = 0; i < count; ++i) {
      bounds[places_[first + i]] = block_bounds[i];
      if (block_bounds[i] >= least) continue;
      least = block_bounds[i];
      result.likeliest = places_[first + i];
    }
  }
}

Screen::Screen(std::span<const Part> parts, const NeighborhoodShape& shape, double tangent_weight,
               bool rotate)
    : implementation_(
          std::make_unique<const Implementation>(parts, shape, tangent_weight, rotate)) {}
Screen::~Screen() = default;
Screen::Screen(Screen&&) noexcept = default;

void Screen::lower_bounds(std::span<const NeighborhoodView> query, ScreenedPlaces& result) const {
  implementation_->lower_bounds(query, result);
}

}  // namespace libstyle
