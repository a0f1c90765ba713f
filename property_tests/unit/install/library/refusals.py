"""What the library must refuse to be compiled for, each in one sentence that a new user can act on."""

import re
import sys

from markdown import section

NO_BATCH = "this method answers no batches of this input: call Method::roots in a loop instead"
FAST_MATH = "rayproof needs NaN, infinity and exact rounding: compile without -ffast-math (docs/library.md)"
LINES = 12  # what a compiler says of one error, with the call it comes from

BATCHES = """#include <rayproof/batch.hpp>
using namespace rayproof;
struct OfNoTopic {};
void call(std::span<float> t, std::span<long double> many) {
  const RayBatch<float> rays{{t, t, t}, {t, t, t}};
  nearest_hits<polygon::Parity>(rays, Polygon<float>{}, t);
  nearest_hits<OfNoTopic>(rays, Sphere<float>{}, t);
  nearest_hits<sphere::Centred>(rays, Triangle<float>{}, t);
  nearest_hits<sphere::Centred>(RayBatch<long double>{{many, many, many}, {many, many, many}}, Sphere<long double>{}, many);
  nearest_hits<quadratic::Kahan>(rays, Sphere<float>{}, t);
  batch_roots<triangle::Woop>(rays, Sphere<float>{}, RootArrays<float>{t, t, t});
  batch_roots<sphere::Centred>(QuadraticBatch<float>{t, t, t}, RootArrays<float>{t, t, t});
}
"""


def errors_of(ended):
    return re.findall(r"error: (.*)", ended.stderr)


def kernels(place):
    """Every call of a batch that has no answer gives one error, the sentence, in few lines. The manual names those with."""
    calls = BATCHES.count("\n  nearest_hits<") + BATCHES.count("\n  batch_roots<")
    ended = place.compile(BATCHES, "-fsyntax-only")
    errors = errors_of(ended)
    if len(errors) != calls or not all(NO_BATCH in error for error in errors) or ended.stderr.count("\n") > LINES * calls:
        sys.exit(f"{calls} calls:\n{ended.stderr}")
    batches = section(place.manual, "Batches")
    named = set(re.findall("`(\\w+)/`", batches))
    batched = {header.parent.name for header in place.headers.rglob("methods.hpp") if "is_batched = true" in header.read_text()}
    if NO_BATCH not in batches or named != batched:
        sys.exit(f"{batched} are batched; the manual names {named}, or does not have the sentence")


def fast_math(place):
    """The flags that remove NaN and infinity are refused, once, unless RAYPROOF_ALLOW_FAST_MATH is defined."""
    source = "#include <rayproof/triangle/woop.hpp>\n"
    is_clang = "__clang__" in place.compile("", "-dM", "-E").stdout
    parts = [] if is_clang else ["-funsafe-math-optimizations", "-freciprocal-math"]
    for flag in ["-ffast-math", "-Ofast", "-ffinite-math-only", *parts]:
        errors = errors_of(place.compile(source, "-fsyntax-only", flag))
        if len(errors) != 1 or FAST_MATH not in errors[0]:
            sys.exit(f"{flag}: {errors}")
        allowed = place.compile(source, "-fsyntax-only", flag, "-DRAYPROOF_ALLOW_FAST_MATH")
        if allowed.returncode != 0:
            sys.exit(f"{flag}, allowed: {allowed.stderr}")
    if FAST_MATH not in place.manual.read_text():
        sys.exit("the manual does not have the sentence")


def reach(place):
    """Every header that computes, by <cmath> or GLM, reaches arithmetic.hpp, where fast math is refused."""
    included = {str(header.relative_to(place.headers)): set(re.findall(r"#include <(.*)>", header.read_text()))
                for header in place.headers.rglob("*.hpp")}

    def closure(names):
        more = names.union(*(included.get(name, ()) for name in names))
        return names if more == names else closure(more)

    reached = {name: closure({name}) for name in included}
    computing = [name for name, all_of in reached.items() if any(one == "cmath" or one.startswith("glm/") for one in all_of)]
    unguarded = [name for name in computing if "rayproof/arithmetic.hpp" not in reached[name]]
    if unguarded or len(computing) < len(included) / 2:
        sys.exit(f"of {len(computing)} headers that compute, these do not refuse fast math: {unguarded}")
