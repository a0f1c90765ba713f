#include "mutation/program/notes.hpp"

#include <algorithm>

namespace rayproof::mutation {

namespace {

/// Where `State::note`, a plain function, writes.
struct Desk {
  std::vector<Note>* notes = nullptr;
  std::size_t input = 0;
};
Desk desk;

void write_down(int number, Meeting meeting) {
  const auto i = static_cast<std::size_t>(number);
  if (i >= desk.notes->size()) return;
  Note& note = (*desk.notes)[i];
  if (note.differs.empty()) return;  // nobody asks
  note.is_reached = true;
  note.is_met = note.is_met || meeting != Meeting::no_mutant;
  if (meeting == Meeting::other) note.differs[desk.input] = true;
}

}  // namespace

Notes note_all(const Target& target, const std::vector<Input>& inputs, const std::vector<int>& mutants) {
  Notes notes;
  if (mutants.empty()) return notes;
  notes.of.resize(static_cast<std::size_t>(*std::ranges::max_element(mutants)) + 1);
  for (const int number : mutants)
    notes.of[static_cast<std::size_t>(number)].differs.resize(inputs.size() + 1);
  desk = {&notes.of};
  target.state.note = write_down;
  target.state.is_noting = true;
  for (; desk.input < inputs.size() && notes.broken == nullptr; ++desk.input) {
    notes.known.push_back(judged(target.subject, inputs[desk.input]));
    const Subject recording = recorded(target.subject, notes.transcripts.emplace_back());
    notes.broken = broken_by(recording, inputs[desk.input], notes.known.back());
  }
  target.state.is_noting = false;
  if (notes.broken != nullptr) notes.broken_in = &inputs[desk.input - 1];
  return notes;
}

}  // namespace rayproof::mutation
