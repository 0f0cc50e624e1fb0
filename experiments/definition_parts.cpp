#include "experiments/definition_parts.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "schemes/input_error.h"
#include "schemes/text.h"

namespace subdiv {
namespace {

/// The parts of a text between separators that stand outside all brackets.
std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  int depth = 0;
  std::size_t begin = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '(' || c == '[' || c == '{') ++depth;
    if (c == ')' || c == ']' || c == '}') --depth;
    if (c != separator || depth != 0) continue;
    parts.push_back(trimmed(text.substr(begin, i - begin)));
    begin = i + 1;
  }
  parts.push_back(trimmed(text.substr(begin)));
  return parts;
}

Algebraic end_value(std::string_view text) { return evaluate_constant<Algebraic>(Expression::parse(text)); }

std::optional<Algebraic> end_or_infinity(std::string_view text) {
  if (text == "inf" || text == "-inf") return std::nullopt;
  return end_value(text);
}

/// "(a, b)", "[a, b)", "{a}".
RealInterval parse_brackets(std::string_view text) {
  const std::string place = in_quotes(text) + ": ";
  const std::string_view inside = trimmed(text.substr(1, text.size() - 2));
  if (text.front() == '{' && text.back() == '}') {
    const Algebraic value = end_value(inside);
    return {value, value, true, true};
  }
  const auto ends = split(inside, ',');
  const bool opens = text.front() == '(' || text.front() == '[';
  const bool closes = text.back() == ')' || text.back() == ']';
  if (!opens || !closes || ends.size() != 2)
    throw InputError(place + "expected an interval such as (1/15, 1/9)");
  return {end_or_infinity(ends[0]), end_or_infinity(ends[1]), text.front() == '[', text.back() == ']'};
}

/// "1/15 < mu <= 1/9".
std::optional<RealInterval> parse_inequalities(std::string text) {
  for (const auto& [sign, ascii] : {std::pair<std::string, std::string>{"\u2264", "<="}, {"\u2a7d", "<="}}) {
    for (std::size_t at = text.find(sign); at != std::string::npos; at = text.find(sign, at))
      text.replace(at, sign.size(), ascii);
  }
  const auto parts = split(text, '<');
  if (parts.size() != 3) return std::nullopt;
  const auto closed = [](std::string_view part) { return part.starts_with('='); };
  const auto bare = [&](std::string_view part) { return closed(part) ? trimmed(part.substr(1)) : part; };
  return RealInterval{end_value(parts[0]), end_value(bare(parts[2])), closed(parts[1]), closed(parts[2])};
}

}  // namespace

std::string located_scheme(const std::string& text, const std::filesystem::path& folder) {
  if (folder.empty()) return text;
  std::string result;
  for (const std::string_view step : split(text, '+')) {
    const std::string_view name = step.substr(0, step.find(':'));
    const bool is_file = name.ends_with(".json") && !std::filesystem::path(name).is_absolute();
    result += (result.empty() ? "" : "+") + (is_file ? (folder / name).string() : std::string(name)) +
              std::string(step.substr(name.size()));
  }
  return result;
}

SchemeDescription scheme_of(const DefinitionCall& call) {
  return parse_scheme(located_scheme(call.text("scheme"), call.folder));
}

SchemeDescription fixed_scheme_of(const DefinitionCall& call) {
  SchemeDescription description = scheme_of(call);
  if (!description.free_parameters.empty()) {
    throw InputError("the scheme " + in_quotes(call.text("scheme")) + " leaves " +
                     joined(description.free_parameters, "and") +
                     " free; this definition needs a value for every parameter");
  }
  return description;
}

Answer number_answer(Enclosure value, std::string note) {
  Answer answer;
  answer.rigour = value.rigour;
  answer.number = std::move(value);
  answer.note = std::move(note);
  return answer;
}

Answer property_answer(Decision holds, Rigour rigour, std::string note) {
  Answer answer;
  answer.holds = holds;
  answer.rigour = rigour;
  answer.note = std::move(note);
  return answer;
}

AnswerKind set_kind(const DefinitionCall& call) {
  return call.has("end") ? AnswerKind::number : AnswerKind::text;
}

Answer set_answer(const DefinitionCall& call, const RealSet& set, std::string note) {
  if (call.has("end")) {
    const bool lower = call.text("end") == "lower";
    if (set.is_empty()) throw InputError("the set is empty: it has no ends");
    const std::optional<Algebraic>& end = lower ? set.parts.front().lower : set.parts.back().upper;
    if (!end) throw InputError("the set " + set.to_string() + " has no " + call.text("end") + " end");
    if (set.parts.size() > 1)
      note += (note.empty() ? "" : " ") + ("The whole set is " + set.to_string() + ".");
    return number_answer(exact(*end), std::move(note));
  }
  Answer answer;
  answer.text = set.to_string();
  answer.note = std::move(note);
  answer.is_printed = [text = answer.text](std::string_view printed) {
    return parse_set(printed).to_string() == text;
  };
  return answer;
}

RealSet parse_set(std::string_view printed) {
  const std::string_view text = trimmed(printed);
  if (text == "empty") return {};
  try {
    if (auto interval = parse_inequalities(std::string(text))) return {{*std::move(interval)}};
    RealSet set;
    for (const std::string_view part : split(text, 'u')) {
      if (part.size() < 3) throw InputError("no interval");
      set.parts.push_back(parse_brackets(part));
    }
    return set;
  } catch (const InputError& error) {
    throw InputError(
        "the printed text " + in_quotes(printed) +
        " is no set of numbers; expected one such as (1/15, 1/9), [0, 1) u {2} or 1/15 < mu < 1/9 (" +
        error.what() + ")");
  }
}

void check_set(const DefinitionCall& /*call*/, const std::string& printed) { (void)parse_set(printed); }

std::vector<Expression> parse_list(std::string_view printed) {
  std::string_view text = trimmed(printed);
  const std::string_view closing = ")]}";
  const std::size_t kind = text.empty() ? std::string_view::npos : std::string_view("([{").find(text.front());
  // "(1, 2)" is a list in brackets, "(1+w)/2, (1-w)/2" is not: it has a comma outside of them.
  if (kind != std::string_view::npos && text.back() == closing[kind] && split(text, ',').size() == 1)
    text = text.substr(1, text.size() - 2);
  std::vector<Expression> list;
  for (const std::string_view part : split(text, ',')) {
    try {
      list.push_back(Expression::parse(part));
    } catch (const InputError& error) {
      throw InputError("the printed text " + in_quotes(printed) +
                       " is no list of numbers; expected one such as (1/16, -5/8, 0, 5/8, -1/16) (" +
                       error.what() + ")");
    }
  }
  return list;
}

void check_list(const DefinitionCall& /*call*/, const std::string& printed) { (void)parse_list(printed); }

DefinitionArgument scheme_argument() {
  return {.name = "scheme",
          .kind = DefinitionArgument::Kind::scheme,
          .meaning = "NAME or FILE.json, as for analyze"};
}

DefinitionArgument over_argument() {
  return {.name = "over",
          .kind = DefinitionArgument::Kind::over,
          .meaning = "a range for each free parameter, w=LO..HI[,...]"};
}

DefinitionArgument continuity_argument() {
  return {
      .name = "continuity", .kind = DefinitionArgument::Kind::whole, .meaning = "M of C^M", .greatest = 1000};
}

DefinitionArgument end_argument() {
  return {.name = "end",
          .kind = DefinitionArgument::Kind::word,
          .meaning = "one end of the set, as a number, instead of the set",
          .required = false,
          .words = {"lower", "upper"}};
}

DefinitionArgument seconds_argument(std::string seconds) {
  return {.name = "budget",
          .kind = DefinitionArgument::Kind::seconds,
          .meaning = "time; then the enclosure reached is the answer",
          .required = false,
          .default_value = std::move(seconds)};
}

}  // namespace subdiv
