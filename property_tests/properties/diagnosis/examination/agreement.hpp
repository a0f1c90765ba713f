#pragma once
/// \file
/// Whether two answers are the same but for rounding.

#include <rayproof/method/contract.hpp>

#include "properties/diagnosis/hypothesis.hpp"

namespace rayproof::diagnosis {

/// Whether the aspect of `got` is that of `other`, to about three digits: a model must hit the very answer of
/// a subject, but the subject may round. Where `got` gives fewer hits than `other` by its nature (the
/// nearest alone, the verdict alone), what it leaves out agrees; a vector agrees with a vector alone.
[[nodiscard]] bool agree(const Case& one, const Answer& got, const Answer& other, Aspect aspect);

/// The detail of the first hit that a claim speaks of; none where it speaks of verdict and t.
[[nodiscard]] std::optional<Aspect> detail_of(Claim claim);
/// Whether the answer says something of that detail; a point that it leaves out is that of its first t.
[[nodiscard]] bool says_detail(const Case& one, Answer& answer, Aspect detail);

/// Whether the hits of `got`, though nearly right, are those of `other`, and not the exact ones: from afar a
/// wrong answer differs little from the right one.
[[nodiscard]] bool is_nearer_to(const Case& one, const Answer& got, const Answer& other, const Answer& exact);

/// Whether two numbers are the same to about three digits, in a problem where lengths of `scale` are rounded.
[[nodiscard]] bool are_close(Precision precision, double x, double y, double scale);

/// An answer as a subject gives it that reports the nearest hit alone, or only whether there is one.
[[nodiscard]] Answer as_reported(const Answer& predicted, const Answer& got);

}  // namespace rayproof::diagnosis
