#include "answer_cases.hpp"
#include "parity.hpp"

int main() { return rayproof::answer_cases(parity); }
