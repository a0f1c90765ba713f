#include "answer_cases.hpp"
#include "far_sphere.hpp"

int main() { return rayproof::answer_cases(far_sphere); }
