#include "answer_cases.hpp"
#include "triangle.hpp"

int main() { return rayproof::answer_cases(triangle); }
