#include "schemes/json_document.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <memory>

#include <nlohmann/json.hpp>

#include "schemes/input_error.h"
#include "schemes/text.h"

namespace subdiv {
namespace {

/// How far the parser has read. After a number it has read one character more.
struct Progress {
  int line = 1;
  bool at_line_start = false;

  [[nodiscard]] int line_before() const { return at_line_start ? line - 1 : line; }
};

/// Reads characters and counts the lines passed, so that the events of the parser have a line.
class LineCounter {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  LineCounter(const char* at, Progress* progress) : at_(at), progress_(progress) {}
  reference operator*() const { return *at_; }
  LineCounter& operator++() {
    progress_->at_line_start = *at_ == '\n';
    if (progress_->at_line_start) ++progress_->line;
    ++at_;
    return *this;
  }
  LineCounter operator++(int) {
    LineCounter old = *this;
    ++*this;
    return old;
  }
  friend bool operator==(const LineCounter& a, const LineCounter& b) { return a.at_ == b.at_; }

 private:
  const char* at_;
  Progress* progress_;
};

/// Builds a JsonValue from the parser's events.
class Builder : public nlohmann::json::json_sax_t {
 public:
  Builder(std::string_view text, const std::string& place, const Progress& progress)
      : text_(text), place_(place), progress_(progress) {}

  JsonValue take() { return std::move(root_); }

  bool null() override { return leaf(JsonValue::Kind::null, "", progress_.line); }
  bool boolean(bool value) override {
    return leaf(JsonValue::Kind::boolean, value ? "true" : "false", progress_.line);
  }
  bool number_integer(number_integer_t value) override {
    return leaf(JsonValue::Kind::number, std::to_string(value), progress_.line_before());
  }
  bool number_unsigned(number_unsigned_t value) override {
    return leaf(JsonValue::Kind::number, std::to_string(value), progress_.line_before());
  }
  bool number_float(number_float_t /*value*/, const string_t& written) override {
    return leaf(JsonValue::Kind::number, written, progress_.line_before());
  }
  bool string(string_t& value) override {
    return leaf(JsonValue::Kind::string, std::move(value), progress_.line);
  }
  bool binary(binary_t& /*value*/) override { return false; }
  bool start_object(std::size_t /*size*/) override { return open(JsonValue::Kind::object); }
  bool start_array(std::size_t /*size*/) override { return open(JsonValue::Kind::array); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }
  bool key(string_t& name) override {
    constexpr std::size_t most_members = 1000;
    if (open_.back()->members.size() == most_members) fail("more than 1000 entries in one object");
    if (open_.back()->find(name) != nullptr) {
      fail(in_quotes(name) + " occurs twice in one object; keep one of them");
    }
    key_ = std::move(name);
    return true;
  }
  bool parse_error(std::size_t position, const std::string& /*token*/,
                   const nlohmann::json::exception& error) override {
    const std::string_view before = text_.substr(0, std::min(position > 0 ? position - 1 : 0, text_.size()));
    const auto line = 1 + std::count(before.begin(), before.end(), '\n');
    const auto newline = before.find_last_of('\n');
    const auto column = 1 + before.size() - (newline == std::string_view::npos ? 0 : newline + 1);
    throw InputError(place_ + ":" + std::to_string(line) + ": column " + std::to_string(column) +
                     ": not valid JSON: " + explanation(error.what()));
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw InputError(place_ + ":" + std::to_string(progress_.line) + ": " + what);
  }

  /// The library's message without its own place, and with nothing that a terminal would act on.
  static std::string explanation(std::string what) {
    if (const auto column = what.find("column "); column != std::string::npos) {
      if (const auto colon = what.find(": ", column); colon != std::string::npos) what.erase(0, colon + 2);
    } else if (const auto bracket = what.find("] "); bracket != std::string::npos) {
      what.erase(0, bracket + 2);
    }
    std::replace_if(what.begin(), what.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
    return what;
  }

  JsonValue& place(JsonValue value) {
    if (open_.empty()) return root_ = std::move(value);
    JsonValue& parent = *open_.back();
    if (parent.kind == JsonValue::Kind::array) return parent.elements.emplace_back(std::move(value));
    return parent.members.emplace_back(std::move(key_), std::move(value)).second;
  }
  bool leaf(JsonValue::Kind kind, std::string written, int line) {
    place({.kind = kind, .line = line, .text = std::move(written)});
    return true;
  }
  bool open(JsonValue::Kind kind) {
    constexpr std::size_t deepest = 20;
    if (open_.size() == deepest) fail("more than " + std::to_string(deepest) + " nested levels");
    open_.push_back(&place({.kind = kind, .line = progress_.line}));
    return true;
  }
  bool close() {
    open_.pop_back();
    return true;
  }

  std::string_view text_;
  const std::string& place_;
  const Progress& progress_;
  JsonValue root_;
  std::vector<JsonValue*> open_;  // a parent does not grow while its child is open, so the pointers hold
  std::string key_;
};

}  // namespace

const JsonValue* JsonValue::find(std::string_view name) const {
  const auto found =
      std::find_if(members.begin(), members.end(), [&](const auto& m) { return m.first == name; });
  return found == members.end() ? nullptr : &found->second;
}

JsonValue parse_json(std::string_view text, const std::string& place) {
  Progress progress;
  Builder builder(text, place, progress);
  const LineCounter begin(std::to_address(text.begin()), &progress);
  const LineCounter end(std::to_address(text.end()), &progress);
  nlohmann::json::sax_parse(begin, end, &builder);
  return builder.take();
}

std::string describe(JsonValue::Kind kind) {
  switch (kind) {
    case JsonValue::Kind::null:
      return "null";
    case JsonValue::Kind::boolean:
      return "true or false";
    case JsonValue::Kind::number:
      return "a number";
    case JsonValue::Kind::string:
      return "a string";
    case JsonValue::Kind::array:
      return "a list";
    case JsonValue::Kind::object:
      return "an object";
  }
  return "nothing";
}

}  // namespace subdiv
