#include "answer_cases.hpp"
#include "cylinder.hpp"

int main() { return rayproof::answer_cases(cylinder); }
