// A libFuzzer target: what real_roots promises, for any solver and any coefficients. The input is
// a byte for the solver, one for the number type and the range, and the bits of coefficients.
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <vector>

// The templates themselves, so that they are compiled here with the fuzzer's instrumentation.
#include "poly/solver.ipp"

namespace lamina::poly {
namespace {

// Hours could go into exact roots of coefficients that are 2^2000 apart.
constexpr int kMostExactDegree = 2;

void check(bool promise) {
  if (!promise) {
    std::abort();
  }
}

template <typename Number>
void solve(const std::vector<Number>& ascending, Solver solver, const Range<Number>& range) {
  const RealRoots<Number> roots = real_roots(std::span<const Number>(ascending), range, solver);
  check(roots.count >= 0 && roots.count <= kMostDegree);
  check(roots.outcome == Outcome::Found || roots.count == 0);
  for (int i = 0; i < roots.count; ++i) {
    check(roots.t[i] - roots.t[i] == 0);
    check(range.contains(roots.t[i]));
    check(i == 0 || roots.t[i - 1] <= roots.t[i]);
  }
}

template <typename Number>
void solve_bits(const std::uint8_t* data, std::size_t size, Solver solver, int range) {
  const SolverInfo& info = solver_info(solver);
  const int most = solver == Solver::Exact ? kMostExactDegree : info.most_degree;
  std::vector<Number> ascending;
  for (; size >= sizeof(Number) && static_cast<int>(ascending.size()) <= most;
       size -= sizeof(Number), data += sizeof(Number)) {
    Number c;
    std::memcpy(&c, data, sizeof c);
    ascending.push_back(c);
  }
  const std::vector<Range<Number>> ranges{
      {}, {Number(0), Number(1)}, {Number(-3), Number(1e30)}, {Number(1), Number(2)}};
  solve(ascending, solver, ranges[range]);
}

}  // namespace
}  // namespace lamina::poly

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace lamina::poly;
  if (size < 2) {
    return 0;
  }
  const auto solvers = all_solvers();
  const Solver solver = solvers[data[0] % solvers.size()].solver;
  const int range = data[1] / 2 % 4;
  if (data[1] % 2 == 0) {
    solve_bits<double>(data + 2, size - 2, solver, range);
  } else {
    solve_bits<float>(data + 2, size - 2, solver, range);
  }
  return 0;
}
