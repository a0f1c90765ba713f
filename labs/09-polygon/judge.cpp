#include "answer_cases.hpp"
#include "polygon.hpp"

int main() { return rayproof::answer_cases(polygon); }
