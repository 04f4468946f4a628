#include "xml_element.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <span>

namespace wavefront {
namespace {

constexpr std::array<std::string_view, 8> property_tags = {"boolean",  "integer", "float", "string",
                                                           "spectrum", "rgb",     "point", "vector"};

bool contains(std::span<const std::string_view> list, std::string_view item) {
  return std::find(list.begin(), list.end(), item) != list.end();
}

/// Numbers separated by commas or spaces; what is not a number ends the list early.
std::vector<double> parse_numbers(std::string_view text) {
  constexpr std::string_view separators = ", \t\r\n";
  std::vector<double> numbers;
  for (std::size_t begin; (begin = text.find_first_not_of(separators)) != text.npos;) {
    text.remove_prefix(begin);
    double number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || !std::isfinite(number)) return {};
    numbers.push_back(number);
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    if (!text.empty() && separators.find(text.front()) == separators.npos) return {};
  }
  return numbers;
}

}  // namespace

std::size_t XmlElement::line() const {
  const auto offset = static_cast<std::ptrdiff_t>(std::max<std::ptrdiff_t>(node_.offset_debug(), 0));
  return 1 + static_cast<std::size_t>(std::count(source_->text.begin(), source_->text.begin() + offset, '\n'));
}

void XmlElement::fail(const std::string& what) const {
  throw SceneError(source_->path.string() + ":" + std::to_string(line()) + ": <" + std::string(tag()) + ">: " + what);
}

void XmlElement::expect_type(std::initializer_list<std::string_view> known) const {
  std::string list;
  for (const std::string_view candidate : known) {
    if (type() == candidate) return;
    list += (list.empty() ? "" : ", ") + std::string(candidate);
  }
  fail("unknown type '" + std::string(type()) + "' (known: " + list + ")");
}

std::string XmlElement::text(const char* attribute) const {
  if (!has(attribute)) fail(std::string("attribute '") + attribute + "' is missing");
  return node_.attribute(attribute).value();
}

std::vector<double> XmlElement::numbers(const char* attribute, std::size_t count) const {
  const std::string value = text(attribute);
  auto result = parse_numbers(value);
  if (result.size() != count)
    fail("attribute '" + std::string(attribute) + "' must be " + std::to_string(count) + " number(s), not '" + value +
         "'");
  return result;
}

double XmlElement::number(const char* attribute, double fallback) const {
  return has(attribute) ? numbers(attribute, 1).front() : fallback;
}

V3f XmlElement::vector(double fallback) const {
  return {static_cast<float>(number("x", fallback)), static_cast<float>(number("y", fallback)),
          static_cast<float>(number("z", fallback))};
}

std::vector<XmlElement> XmlElement::children(std::initializer_list<std::string_view> allowed) const {
  std::vector<XmlElement> result;
  for (const pugi::xml_node node : node_.children()) {
    if (node.type() != pugi::node_element) continue;
    const XmlElement child(*source_, node);
    if (!contains({allowed.begin(), allowed.end()}, child.tag()) && !contains(property_tags, child.tag()))
      child.fail("unknown element '" + std::string(child.tag()) + "' in <" + std::string(tag()) + ">");
    result.push_back(child);
  }
  return result;
}

Properties::Properties(const XmlElement& owner, const std::vector<XmlElement>& children) : owner_(owner.tag()) {
  for (const XmlElement& child : children) {
    if (!contains(property_tags, child.tag())) continue;
    if (child.name().empty()) child.fail("attribute 'name' is missing");
    entries_.push_back({child});
  }
}

void Properties::note_unused(std::vector<std::string>& ignored) const {
  for (const Entry& entry : entries_)
    if (!entry.used)
      ignored.push_back(owner_ + " " + std::string(entry.element.name()) + " (line " +
                        std::to_string(entry.element.line()) + ")");
}

bool Properties::has(std::string_view name) const {
  return std::any_of(entries_.begin(), entries_.end(),
                     [&](const Entry& entry) { return entry.element.name() == name; });
}

const XmlElement* Properties::find(std::string_view name, std::initializer_list<std::string_view> tags) {
  const auto entry =
      std::find_if(entries_.begin(), entries_.end(), [&](const Entry& e) { return e.element.name() == name; });
  if (entry == entries_.end()) return nullptr;
  if (!contains({tags.begin(), tags.end()}, entry->element.tag()))
    entry->element.fail("'" + std::string(name) + "' must be given as <" + std::string(*tags.begin()) + ">");
  entry->used = true;
  return &entry->element;
}

double Properties::number(std::string_view name, double fallback) {
  const XmlElement* element = find(name, {"float", "integer"});
  return element ? element->numbers("value", 1).front() : fallback;
}

int Properties::integer(std::string_view name, int fallback) {
  const XmlElement* element = find(name, {"integer"});
  if (!element) return fallback;
  const double value = element->numbers("value", 1).front();
  if (value != std::trunc(value) || std::abs(value) > 1e9) element->fail("not a usable integer");
  return static_cast<int>(value);
}

bool Properties::boolean(std::string_view name, bool fallback) {
  const XmlElement* element = find(name, {"boolean"});
  if (!element) return fallback;
  const std::string value = element->text("value");
  if (value != "true" && value != "false") element->fail("must be true or false, not '" + value + "'");
  return value == "true";
}

std::string Properties::text(std::string_view name, const std::string& fallback) {
  const XmlElement* element = find(name, {"string"});
  return element ? element->text("value") : fallback;
}

V3f Properties::point(std::string_view name, const V3f& fallback) {
  const XmlElement* element = find(name, {"point", "vector"});
  return element ? element->vector(0) : fallback;
}

Rgb Properties::colour(std::string_view name, const Rgb& fallback) {
  const XmlElement* element = find(name, {"spectrum", "rgb"});
  if (!element) return fallback;
  const auto values = parse_numbers(element->text("value"));
  const bool grey = values.size() == 1;
  if (!grey && (values.size() != 3 || element->tag() != "rgb"))
    element->fail("must be one number" + std::string(element->tag() == "rgb" ? " or three" : ""));
  const auto channel = [&](std::size_t i) { return static_cast<float>(values[grey ? 0 : i]); };
  return {channel(0), channel(1), channel(2)};
}

}  // namespace wavefront
