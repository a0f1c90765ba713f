#pragma once

/// A number and how far it may be from the exact one.
struct Bounded {
  float value, bound;
};

Bounded bound(float a, float b, float c, float d);
