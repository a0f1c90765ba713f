#include "answer_cases.hpp"
#include "plane.hpp"

int main() { return rayproof::answer_cases(rayproof::takes<rayproof::ImplicitPlane>(plane)); }
