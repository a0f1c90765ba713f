#include "answer_questions.hpp"
#include "ray.hpp"

int main() { return rayproof::answer_questions(ray); }
