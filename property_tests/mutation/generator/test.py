"""Plants errors in a small header of its own and sees that each kind is made, and nothing where nothing may change."""

from pathlib import Path
import sys
import unittest

from calls import put_argument
from generate import Planted
from sites import nested

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from objects import own_text  # noqa: E402

HEADER = '''#pragma once
#include <rayproof/arithmetic.hpp>

namespace rayproof {

/// A comment: a < b.
template <class T>
struct Small {
  static constexpr double bound = 0x1p-40;
  T rx, ry;
  T t_min = T(0);

  template <class U>
  [[nodiscard]] constexpr T all(const vec3<T>& e0, const vec3<T>& e1, const T& t) const {
    step<T>("A title", "And what a < b means.");
    if constexpr (sizeof(T) < sizeof(double)) return t;
    if (t <= T(0) || !is_good(e1)) return T(2) * min(rx, ry);
    const T D = named("D", dot(cross(e0, e1), e0) - t / e0.x);
    ++count_;
    sum += 0x1p-48 * t;
    return select(D > t, -D, abs(D));
  }

 private:
  int count_;
};

}  // namespace rayproof
'''
EXPECTED = {
    ("comparison", "t <= T(0)", "t < T(0)"), ("comparison", "t <= T(0)", "t != T(0)"),
    ("comparison", "t <= T(0) || !is_good(e1)", "t <= T(0) && !is_good(e1)"),
    ("guard", "t <= T(0) || !is_good(e1)", "t <= T(0)"), ("guard", "t <= T(0) || !is_good(e1)", "!is_good(e1)"),
    ("guard", "t <= T(0) || !is_good(e1)", "true"), ("guard", "D > t", "false"),
    ("sign", "!is_good(e1)", "is_good(e1)"), ("sign", "-D", "D"),
    ("sign", "dot(cross(e0, e1), e0) - t / e0.x", "dot(cross(e0, e1), e0) + t / e0.x"),
    ("operand", "dot(cross(e0, e1), e0) - t / e0.x", "dot(cross(e0, e1), e0)"),
    ("operand", "dot(cross(e0, e1), e0) - t / e0.x", "-t / e0.x"),
    ("operation", "t / e0.x", "t * e0.x"), ("operand", "t / e0.x", "t"), ("operand", "t / e0.x", "e0.x / t"),
    ("axis", "e0.x", "e0.y"), ("axis", "e0.x", "e0.z"), ("operand", "e1", "e0"),
    ("arguments", "e0, e1", "e1, e0"), ("arguments", "D > t, -D, abs(D)", "D > t, abs(D), -D"),
    ("min/max", "min(rx, ry)", "max(rx, ry)"), ("operand", "min(rx, ry)", "rx"), ("operand", "abs(D)", "D"),
    ("constant", "T(2)", "2 * T(2)"), ("constant", "T(2)", "T(2) / 2"), ("constant", "T(0)", "1"),
    ("constant", "0x1p-48", "0x1p26 * 0x1p-48"),
    ("sign", "++count_", "--count_"), ("operand", "++count_", "nothing"),
    ("sign", "sum += 0x1p-48 * t", "sum -= 0x1p-48 * t")}


class Generator(unittest.TestCase):
    """What is made of the small header."""

    planted = Planted("small.hpp", HEADER, 100)
    made = {(mutant.kind, mutant.find, mutant.put) for mutant in planted.mutants()}

    def test_makes_a_mutant_of_each_kind(self):
        self.assertFalse(EXPECTED - self.made)

    def test_changes_no_comment_constant_expression_or_narration(self):
        for _, find, _ in self.made:
            self.assertNotIn("a < b", find)
            self.assertNotIn("sizeof", find)
            self.assertNotIn("0x1p-40", find)

    def test_numbers_mutants_one_after_another(self):
        numbers = sorted(mutant.number for mutant in self.planted.mutants())
        self.assertEqual(numbers, list(range(100, self.planted.end)))

    def test_names_each_mutant_once(self):
        keys = [mutant.key for mutant in self.planted.mutants()]
        self.assertEqual(len(keys), len(set(keys)))

    def test_knows_a_mutant_again_when_lines_move(self):
        moved = Planted("small.hpp", HEADER.replace("namespace", "\n\n\nnamespace", 1), 100)
        self.assertEqual([mutant.key for mutant in moved.mutants()], [mutant.key for mutant in self.planted.mutants()])

    def test_writes_the_header_as_it_was_where_all_mutants_are_left_out(self):
        planted = Planted("small.hpp", HEADER, 0)
        for site in planted.sites:
            site.dead = set(range(len(site.puts)))
        self.assertEqual(planted.written().replace('#include "mutation/planted/planting.hpp"\n', ""), HEADER)

    def test_hands_on_a_variable_as_itself_and_all_else_by_value(self):
        for variable in ["ray", "ray.origin", "wide.roots.lo"]:
            self.assertIn("decltype(auto)", put_argument(variable))
        for other in ["leading(x - y)", "sum(v).x", "1", "-x", "a[0]"]:
            self.assertNotIn("decltype(auto)", put_argument(other))

    def test_leaves_out_of_a_sites_text_the_sites_in_it(self):
        text = b"pick([&] { return /*<7*/pick([&] { return b; }, [&] { return a; })/*7>*/.y; }, [&] { return b.z"
        self.assertEqual(own_text(text).count(b"[&] { return "), 2)

    def test_nests_the_sites(self):
        self.assertLess(len(nested([])), 1)
        self.assertTrue(all(inner.start >= site.start and inner.end <= site.end
                            for site in self.planted.sites for inner in site.inner))


if __name__ == "__main__":
    sys.exit(unittest.main())
