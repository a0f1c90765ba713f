#include "answer_cases.hpp"
#include "sphere.hpp"

int main() { return rayproof::answer_cases(sphere); }
