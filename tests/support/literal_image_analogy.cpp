// SPDX-License-Identifier: Apache-2.0
#include "tests/support/literal_image_analogy.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace libstyle::test {
namespace {

struct Pixel {
  int x;
  int y;
};

// One level while B' is made.
struct Work {
  const LiteralLevel* images = nullptr;
  Image made;  // B'_l
  std::vector<SourcePixel> sources;
};

double gauss(int dx, int dy, int radius) {
  const double sigma = (2 * radius + 1) / 4.0;
  return std::exp(-(dx * dx + dy * dy) / (2 * sigma * sigma));
}

bool comes_before(int dx, int dy) { return dy < 0 || (dy == 0 && dx < 0); }

double squared_difference(const Image& a, Pixel p, const Image& b, Pixel q) {
  const int x = std::clamp(p.x, 0, a.width - 1);
  const int y = std::clamp(p.y, 0, a.height - 1);
  double sum = 0;
  for (int c = 0; c < a.channels; ++c) {
    const double difference = double{a.pixel(x, y)[c]} - b.pixel(q.x, q.y)[c];
    sum += difference * difference;
  }
  return sum / a.channels;
}

// One part of |F(p) - F(q)|^2: the pixels round q that lie in the target and that count.
template <typename Counts>
double part(const Image& example, Pixel p, const Image& target, Pixel q, int radius,
            Counts counts) {
  double sum = 0;
  double weights = 0;
  for (int dy = -radius; dy <= radius; ++dy) {
    for (int dx = -radius; dx <= radius; ++dx) {
      if (!counts(dx, dy)) continue;
      weights += gauss(dx, dy, radius);
      const Pixel there{q.x + dx, q.y + dy};
      if (there.x < 0 || there.x >= target.width || there.y < 0 || there.y >= target.height) {
        continue;
      }
      sum +=
          gauss(dx, dy, radius) * squared_difference(example, {p.x + dx, p.y + dy}, target, there);
    }
  }
  return sum / weights;
}

double distance(const Work& level, const Work* coarser, Pixel p, Pixel q) {
  const auto all = [](int, int) { return true; };
  double sum = part(level.images->unfiltered, p, level.images->target, q, 2, all) +
               part(level.images->filtered, p, level.made, q, 2, comes_before);
  if (coarser) {
    const Pixel coarse_p{p.x / 2, p.y / 2};
    const Pixel coarse_q{q.x / 2, q.y / 2};
    sum += part(coarser->images->unfiltered, coarse_p, coarser->images->target, coarse_q, 1, all) +
           part(coarser->images->filtered, coarse_p, coarser->made, coarse_q, 1, all);
  }
  return sum;
}

// BESTMATCH(A, A', B, B', s, l, q).
Pixel best_match(const Work& level, const Work* coarser, Pixel q, double kappa) {
  const Image& example = level.images->filtered;
  const int width = level.images->target.width;
  Pixel approximate{0, 0};
  double best = std::numeric_limits<double>::max();
  for (int y = 0; y < example.height; ++y) {
    for (int x = 0; x < example.width; ++x) {
      const double d = distance(level, coarser, {x, y}, q);
      if (d < best) {
        best = d;
        approximate = {x, y};
      }
    }
  }
  Pixel coherent{-1, -1};
  double best_coherent = std::numeric_limits<double>::max();
  for (int dy = -2; dy <= 0; ++dy) {
    for (int dx = -2; dx <= 2; ++dx) {
      const Pixel r{q.x + dx, q.y + dy};
      if (!comes_before(dx, dy) || r.x < 0 || r.x >= width || r.y < 0) continue;
      const SourcePixel& s = level.sources[std::size_t(r.y) * width + r.x];
      const Pixel p{s.x - dx, s.y - dy};
      if (p.x < 0 || p.x >= example.width || p.y < 0 || p.y >= example.height) continue;
      const double d = distance(level, coarser, p, q);
      if (d < best_coherent) {
        best_coherent = d;
        coherent = p;
      }
    }
  }
  return best_coherent <= best * (1 + kappa) ? coherent : approximate;
}

}  // namespace

std::vector<SourcePixel> literal_image_analogy(const std::vector<LiteralLevel>& levels,
                                               double kappa) {
  std::vector<Work> works(levels.size());
  for (std::size_t l = 0; l < levels.size(); ++l) {
    Work& level = works[l];
    level.images = &levels[l];
    const Image& target = levels[l].target;
    level.made = Image(target.width, target.height, levels[l].filtered.channels);
    level.sources.resize(std::size_t(target.width) * target.height);
    const double kappa_l =
        kappa * std::pow(2.0, static_cast<double>(l) - static_cast<double>(levels.size() - 1));
    for (int y = 0; y < target.height; ++y) {
      for (int x = 0; x < target.width; ++x) {
        const Pixel p = best_match(level, l > 0 ? &works[l - 1] : nullptr, {x, y}, kappa_l);
        std::ranges::copy(levels[l].filtered.pixel(p.x, p.y), level.made.pixel(x, y).begin());
        level.sources[std::size_t(y) * target.width + x] = {0, p.x, p.y};
      }
    }
  }
  return works.back().sources;
}

}  // namespace libstyle::test
