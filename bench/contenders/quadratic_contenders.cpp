#include <memory>
#include <rayproof/batch.hpp>
#include <rayproof/quadratic/methods.hpp>

#include "bench/contenders/contender.hpp"
#include "bench/streaming/streaming.hpp"

namespace rayproof::report {

namespace {

/// Equations and their roots as arrays.
template <class T>
struct Equations {
  std::vector<T> a, b, c;
  std::vector<T> discriminant, lo, hi;

  explicit Equations(const std::vector<Case>& cases)
      : discriminant(cases.size()), lo(cases.size()), hi(cases.size()) {
    for (const Case& one : cases) {
      const auto q = convert<T>(std::get<Quadratic<double>>(one.question));
      a.push_back(q.a);
      b.push_back(q.b);
      c.push_back(q.c);
    }
  }

  template <class Method>
  void solve_one_by_one(std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
      const Roots<T> roots = Method::roots(Quadratic<T>{a[i], b[i], c[i]});
      discriminant[i] = roots.discriminant;
      lo[i] = roots.lo;
      hi[i] = roots.hi;
      one_at_a_time();
    }
  }

  template <class Method>
  void solve_in_batch(std::size_t count, InstructionSet set) {
    const auto first = [count](auto& column) { return std::span(column).first(count); };
    batch_roots<Method>(QuadraticBatch<T>{first(a), first(b), first(c)},
                        RootArrays<T>{first(discriminant), first(lo), first(hi)}, set);
  }

  void only_stream(std::size_t count, InstructionSet set) {
    stream(
        Columns<T, 3, 3>{{a.data(), b.data(), c.data()}, {discriminant.data(), lo.data(), hi.data()}, count},
        set);
  }
};

template <class T>
std::vector<Contender> quadratic_contenders_in(const std::vector<Case>& cases,
                                               const std::vector<InstructionSet>& sets) {
  const auto equations = std::make_shared<Equations<T>>(cases);
  std::vector<Contender> all;
  quadratic::Topic::Methods::for_each([&]<class Method>(std::type_identity<Method>) {
    all.push_back({Method::name, Arrangement::scalar,
                   [equations](std::size_t count) { equations->template solve_one_by_one<Method>(count); }});
    for (const InstructionSet set : sets)
      all.push_back(
          {Method::name, Arrangement::batch,
           [equations, set](std::size_t count) { equations->template solve_in_batch<Method>(count, set); },
           set});
  });
  for (const InstructionSet set : sets)
    all.push_back({floor_name, Arrangement::batch,
                   [equations, set](std::size_t count) { equations->only_stream(count, set); }, set});
  return all;
}

}  // namespace

std::vector<Contender> quadratic_contenders(const std::vector<Case>& cases, Precision precision,
                                            const std::vector<InstructionSet>& sets) {
  return precision == Precision::float32 ? quadratic_contenders_in<float>(cases, sets)
                                         : quadratic_contenders_in<double>(cases, sets);
}

}  // namespace rayproof::report
