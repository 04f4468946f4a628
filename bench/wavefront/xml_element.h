// An element of a scene file: typed access to its attributes and named properties, errors that tell the place,
// and a record of the properties nobody asked for.
#pragma once

#include "scene.h"

#include <pugixml.hpp>

#include <filesystem>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace wavefront {

struct XmlText {
  std::filesystem::path path;  // for messages, and where relative file names start
  std::string text;
};

class XmlElement {
 public:
  XmlElement(const XmlText& source, pugi::xml_node node) : source_(&source), node_(node) {}

  std::string_view tag() const { return node_.name(); }
  std::string_view type() const { return node_.attribute("type").value(); }
  std::string_view name() const { return node_.attribute("name").value(); }
  bool has(const char* attribute) const { return !node_.attribute(attribute).empty(); }
  std::string text(const char* attribute) const;
  double number(const char* attribute, double fallback) const;
  std::vector<double> numbers(const char* attribute, std::size_t count) const;
  V3f vector(double fallback) const;  // x="" y="" z=""
  std::size_t line() const;
  [[noreturn]] void fail(const std::string& what) const;
  void expect_type(std::initializer_list<std::string_view> known) const;

  /// Its child elements, in order. A tag that is neither a property nor `allowed` is an error.
  std::vector<XmlElement> children(std::initializer_list<std::string_view> allowed) const;

 private:
  const XmlText* source_;
  pugi::xml_node node_;
};

/// The <float name="radius" value="2"/> and the like among the children of an element.
class Properties {
 public:
  Properties(const XmlElement& owner, const std::vector<XmlElement>& children);

  bool has(std::string_view name) const;
  double number(std::string_view name, double fallback);
  int integer(std::string_view name, int fallback);
  bool boolean(std::string_view name, bool fallback);
  std::string text(std::string_view name, const std::string& fallback);
  V3f point(std::string_view name, const V3f& fallback);
  Rgb colour(std::string_view name, const Rgb& fallback);

  /// Adds those that were never asked for to `ignored`.
  void note_unused(std::vector<std::string>& ignored) const;

 private:
  struct Entry {
    XmlElement element;
    bool used = false;
  };
  const XmlElement* find(std::string_view name, std::initializer_list<std::string_view> tags);

  std::string owner_;
  std::vector<Entry> entries_;
};

}  // namespace wavefront
