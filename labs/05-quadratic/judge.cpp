#include "answer_cases.hpp"
#include "quadratic.hpp"

int main() { return rayproof::answer_cases(quadratic); }
