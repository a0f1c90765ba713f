#include "answer_cases.hpp"
#include "slabs.hpp"

int main() { return rayproof::answer_cases(slabs); }
