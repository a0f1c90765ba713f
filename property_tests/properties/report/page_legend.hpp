#pragma once

namespace rayproof {

/// What the words of the table mean; docs/reading-a-check.md says it with examples.
inline constexpr const char* page_legend =
    R"html(<details><summary>What the words mean</summary><dl class="words">
<dt>verdict</dt><dd>Hit or miss, and how many hits (of a quadratic: the kind of its roots; of a point: inside, outside or
boundary). It is right or wrong; it has no size.</dd>
<dt>residual</dt><dd>How far the answer misses its own equation: for a ray, how far the point p(t) lies from the surface.</dd>
<dt>ulp</dt><dd>How far t is from the exact t, counted in units in the last place of the exact t. Measured where the verdict
is right.</dd>
<dt>point, normal, coordinates</dt><dd>What a method says of its first hit beside t, on every eighth case: how far the point lies from
the ray at t, how far the normal turns from the surface's there (a normal on the wrong side by half a circle), and how far the
barycentric coordinates of a triangle are from the exact ones.</dd>
<dt>contract unit</dt><dd>The length in which band and residual are measured: the rounding of one operation, ε (2⁻²⁴ in
float32, 2⁻⁵³ in float64), times the size of the scene. Each shape's header in the library says which size.</dd>
<dt>verdict band</dt><dd>A ray that nearly touches may be called a hit or a miss by any method that rounds. The band is how
far, in contract units, a case may be from a change of verdict where a wrong verdict is still excused. The table shows the widest
that was met, “of” the one that is promised. A wrong verdict within its promised band breaks no contract.</dd>
<dt>robust</dt><dd>Verdict and residual keep the bound that the best plain methods of the shape keep.</dd>
<dt>exact</dt><dd>Where no step of the method is rounded, verdict, t and contact are exactly right and coordinates to a few roundings, boundaries included: no band
excuses anything there. Of a method whose steps nobody can see, the <i>boundary</i> is judged: on cases that some plain method of the shape
decides without a rounding, a wrong verdict nearer to a change of verdict than the robust bound.</dd>
<dt>domain</dt><dd>The sizes of numbers for which a method promises anything: between 2⁻ʳ and 2ʳ, where r is its reach. Outside,
intermediate results over- or underflow. Cases outside the domain are not counted here.</dd>
<dt>far_power</dt><dd>A naive method's contract unit grows: by (size of the scene ÷ size of the shape) to this power; of a
triangle, by 1 ÷ its steepness, which is small where it is thin or seen edge-on. So a naive method can keep its own contract and still err by 10¹⁶ ulps: its contract promises that little.</dd>
<dt>sound, naive, printed</dt><dd>A sound method keeps a small bound everywhere in its domain. A naive one is the right formula
in an arithmetic that loses its digits. A printed one is copied from a lecture together with the lecture's error. Of naive and printed
methods the contract declares what they break, and the check must find a counterexample (‡).</dd></dl></details>
)html";

}  // namespace rayproof
