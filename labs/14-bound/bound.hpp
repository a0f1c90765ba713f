#pragma once

/// A number and how far it may be from the exact one.
struct ValueAndBound {
  float value, bound;
};

ValueAndBound bound(float a, float b, float c, float d);
