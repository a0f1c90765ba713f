#include "answer_cases.hpp"
#include "watertight.hpp"

int main() { return rayproof::answer_cases(watertight); }
