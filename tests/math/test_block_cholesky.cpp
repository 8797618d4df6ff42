// SPDX-License-Identifier: MIT
// The block Cholesky factorisation against a dense solve, and its work on chains.

#include "sim/math/block_cholesky.h"

#include <Eigen/Dense>
#include <algorithm>
#include <catch2/catch.hpp>
#include <random>
#include <set>

namespace pabd::test_block_cholesky {

namespace {

using Pairs = std::vector<std::pair<Index, Index>>;

template <int N>
using Matrix = Eigen::Matrix<double, N, N>;

template <int N>
Matrix<N> random_block(std::mt19937_64& random) {
  std::uniform_real_distribution<double> number(-1, 1);
  Matrix<N> B;
  for (double& x : B.reshaped()) x = number(random);
  return B;
}

// Largest relative error of the solution of a random positive definite system with that graph.
template <int N>
double error_of(Index n, const Pairs& pairs, std::mt19937_64& random, BlockCholesky<N>& cholesky) {
  cholesky.analyze(n, pairs);
  cholesky.set_zero();
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(N * n, N * n);
  for (const auto& [p, q] : pairs) {  // a bond K between p and q
    const Matrix<N> J = random_block<N>(random);
    A.block<N, N>(N * p, N * p) += Matrix<N>::Identity() * 100;
    A.block<N, N>(N * q, N * q) += J * J.transpose() * 100;
    A.block<N, N>(N * q, N * p) += J * 100;
    A.block<N, N>(N * p, N * q) += J.transpose() * 100;
    if (random() & 1) {
      cholesky.add_off_diagonal(q, p, J * 100);
    } else {
      cholesky.add_off_diagonal(p, q, J.transpose() * 100);
    }
  }
  A.diagonal().array() += 1;
  for (Index p = 0; p < n; ++p) {
    cholesky.diagonal(p).add(A.block<N, N>(N * p, N * p));
  }
  Eigen::VectorXd b(N * n);
  std::vector<typename BlockCholesky<N>::Vector> x(static_cast<std::size_t>(n));
  for (Index p = 0; p < n; ++p) b.segment<N>(N * p) = x[p] = random_block<N>(random).col(0);
  REQUIRE(cholesky.factorize());
  cholesky.solve(x);
  const Eigen::VectorXd expected = A.llt().solve(b);
  double worst = 0;
  for (Index p = 0; p < n; ++p)
    worst = std::max(worst, (x[p] - expected.segment<N>(N * p)).norm() / expected.norm());
  return worst;
}

Pairs chain(Index n) {
  Pairs pairs;
  for (Index p = 0; p + 1 < n; ++p) pairs.emplace_back(p, p + 1);
  return pairs;
}

Pairs grid(Index side) {
  Pairs pairs;
  for (Index p = 0; p < side * side; ++p) {
    if (p % side + 1 < side) pairs.emplace_back(p, p + 1);
    if (p + side < side * side) pairs.emplace_back(p, p + side);
  }
  return pairs;
}

Pairs all_pairs(Index n) {
  Pairs pairs;
  for (Index p = 0; p < n; ++p) {
    for (Index q = p + 1; q < n; ++q) pairs.emplace_back(p, q);
  }
  return pairs;
}

}  // namespace

TEST_CASE("systems of 3×3 blocks: chains, full graphs and grids") {
  std::mt19937_64 random(7);
  BlockCholesky<3> cholesky;
  CHECK(error_of(20, chain(20), random, cholesky) < 1e-10);
  for (const Index n : {2, 3, 4, 5, 6, 7, 12}) {
    INFO("all of " << n);
    CHECK(error_of(n, all_pairs(n), random, cholesky) < 1e-10);
  }
  for (const Index side : {5, 10, 15}) {
    INFO("a grid of side " << side);
    CHECK(error_of(side * side, grid(side), random, cholesky) < 1e-10);
  }
}

TEST_CASE("solves what a dense factorisation solves, on chains, loops, stars and random graphs") {
  std::mt19937_64 random(5);
  BlockCholesky<6> cholesky;
  CHECK(error_of(1, {}, random, cholesky) < 1e-12);
  CHECK(error_of(20, chain(20), random, cholesky) < 1e-10);
  Pairs loop = chain(20);
  loop.insert(loop.begin() + 1, {0, 19});
  CHECK(error_of(20, loop, random, cholesky) < 1e-10);
  Pairs star;
  for (Index q = 1; q < 15; ++q) star.emplace_back(0, q);
  CHECK(error_of(15, star, random, cholesky) < 1e-10);
  for (int k = 0; k < 10; ++k) {
    std::set<std::pair<Index, Index>> edges;
    for (int e = 0; e < 60; ++e) {
      const auto a = static_cast<Index>(random() % 30), b = static_cast<Index>(random() % 30);
      if (a != b) edges.insert(std::minmax(a, b));
    }
    CHECK(error_of(30, {edges.begin(), edges.end()}, random, cholesky) < 1e-10);
  }
}

TEST_CASE("nothing fills on a chain, a star or a tree, in whatever order its rows are numbered") {
  std::mt19937_64 random(6);
  const Index n = 1000;
  BlockCholesky<6> cholesky;
  cholesky.analyze(n, chain(n));
  CHECK(cholesky.graph().blocks() == n - 1);

  std::vector<Index> number(n);
  std::iota(number.begin(), number.end(), 0);
  std::shuffle(number.begin(), number.end(), random);
  Pairs tree;
  for (Index p = 1; p < n; ++p)
    tree.push_back(std::minmax(number[p], number[random() % static_cast<std::size_t>(p)]));
  std::sort(tree.begin(), tree.end());
  cholesky.analyze(n, tree);
  CHECK(cholesky.graph().blocks() == n - 1);
}

TEST_CASE("a matrix that is not positive definite is refused") {
  BlockCholesky<6> cholesky;
  cholesky.analyze(2, chain(2));
  cholesky.set_zero();
  cholesky.diagonal(0).add(Mat6::Identity());
  cholesky.diagonal(1).add(Mat6::Identity());
  cholesky.add_off_diagonal(1, 0, 2 * Mat6::Identity());
  CHECK_FALSE(cholesky.factorize());

  const Index n = 6;
  BlockCholesky<3> wide;
  wide.analyze(n, all_pairs(n));
  for (const double off : {0.9, 1.1}) {
    wide.set_zero();
    for (Index p = 0; p < n; ++p) wide.diagonal(p).add(Mat3::Identity());
    for (const auto& [p, q] : all_pairs(n)) wide.add_off_diagonal(q, p, off * Mat3::Identity());
    CHECK(wide.factorize() == (off < 1));
  }
}

}  // namespace pabd::test_block_cholesky
