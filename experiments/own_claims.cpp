#include "experiments/own_claims.h"

#include <memory>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "experiments/report/record.h"
#include "experiments/scheme_figures.h"
#include "schemes/expression.h"
#include "schemes/input_error.h"

namespace subdiv {
namespace {

bool is_plain_number(const std::string& printed) {
  try {
    (void)printed_value(printed);
    return true;
  } catch (const std::logic_error&) {
    return false;
  }
}

/// The number in what is printed, as the definition reads it.
std::string number_text(const OwnClaim& claim) {
  const auto read = claim.call.definition->read_printed;
  return read == nullptr ? *claim.head.printed : read(*claim.head.printed);
}

std::string joined_notes(const std::string& a, const std::string& b) {
  return a.empty() || b.empty() ? a + b : a + " " + b;
}

/// Whether a closed form is the value: equality where the value is exact, else only that it is another one.
Verdict compare_closed_form(const std::string& printed, const Enclosure& value) {
  constexpr long precision = 256;
  if (printed == value.exact) return Verdict::reproduced;
  try {
    const Expression expression = Expression::parse(printed);
    const Interval number = evaluate<Interval>(
        expression, expression.root(),
        [&](const std::string& name, const Expression::Node& node) -> Interval {
          throw InputError(expression.locate(node, "unknown name " + name));
        },
        IntervalLiteral{precision});
    if (number.upper() < value.lower || value.upper < number.lower()) return Verdict::refuted;
    if (value.rigour == Rigour::exact && evaluate_constant<Algebraic>(expression).to_string() == value.exact)
      return Verdict::reproduced;
  } catch (const InputError&) {  // a logarithm, say: only its text can be compared
    return Verdict::undecided;
  }
  return Verdict::undecided;
}

Claim settle_number(const OwnClaim& claim, const Answer& answer) {
  const Enclosure& value = *answer.number;
  if (!claim.head.printed) return settle(claim.head, value, answer.note);
  ClaimHead head = claim.head;
  head.printed = number_text(claim);
  Claim settled;
  if (claim.kind == OwnKind::at_most || claim.kind == OwnKind::at_least) {
    const BoundSide side = claim.kind == OwnKind::at_most ? BoundSide::at_most : BoundSide::at_least;
    settled = settle_bound(head, side, value, answer.note);
  } else if (is_plain_number(*head.printed)) {
    settled = settle(head, value, answer.note);
  } else {
    const Verdict verdict = compare_closed_form(*head.printed, value);
    const bool proved = value.rigour != Rigour::approximate;
    settled = settle_as(head, proved ? verdict : Verdict::undecided, value, answer.note);
  }
  settled.head.printed = claim.head.printed;
  // Several minimisers: the enclosure holds one of them, the document may mean another.
  if (value.status == Status::ambiguous) settled.verdict = Verdict::undecided;
  return settled;
}

Claim settle_text(const OwnClaim& claim, const Answer& answer) {
  const bool holds = !claim.head.printed || answer.is_printed(*claim.head.printed);
  return settle_statement(claim.head, holds, answer.text, answer.note, answer.rigour);
}

Claim settle_property(const OwnClaim& claim, const Answer& answer) {
  const std::string text = to_string(*answer.holds);
  if (*answer.holds == Decision::undecided) {
    Claim open{claim.head, "", {}, {}, answer.rigour, Verdict::undecided, answer.note};
    return open;
  }
  // As a finding, that it does not hold is as good as that it does.
  const bool holds = *answer.holds == Decision::yes || !claim.head.printed;
  return settle_statement(claim.head, holds, text, answer.note, answer.rigour);
}

/// What is true, for a claim that is refuted.
std::string truth(const Claim& claim) {
  constexpr std::size_t width = 200;
  return "It is " + value_text(to_record(claim), width) + ".";
}

}  // namespace

Claim settle_own(const OwnClaim& claim) {
  const Answer answer = claim.call.definition->answer(claim.call);
  Claim settled = answer.number  ? settle_number(claim, answer)
                  : answer.holds ? settle_property(claim, answer)
                                 : settle_text(claim, answer);
  const bool says_no = settled.verdict == Verdict::refuted || settled.verdict == Verdict::inconsistent;
  if (says_no && !answer.holds) settled.note = joined_notes(truth(settled), settled.note);
  return settled;
}

std::vector<Experiment> own_experiments(const OwnClaims& own) {
  std::vector<Experiment> list;
  for (const OwnClaim& claim : own.claims) {
    const auto kept = std::make_shared<const OwnClaim>(claim);
    list.push_back({claim.head.id, claim.head.id,
                    [kept] { return std::span<const ClaimHead>(&kept->head, 1); },
                    [kept] { return Results{{settle_own(*kept)}, {}, {}}; }});
  }
  for (const OwnFigure& figure : own.figures) {
    list.push_back({"figure " + figure.name, figure.name, [] { return std::span<const ClaimHead>(); },
                    [figure] { return scheme_figure(figure.name, figure.scheme, figure.over); }});
  }
  return list;
}

}  // namespace subdiv
