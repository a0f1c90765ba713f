#pragma once
#include <cmath>
#include <vector>

std::vector<double> quadratic(double a, double b, double c);
