#include "names.h"

#include <array>
#include <stdexcept>

namespace wavefront {
namespace {

// In the order of the enumerations.
constexpr std::array choices{"uniform", "power", "solid-angle"};
constexpr std::array strategies{"light", "bsdf", "mis"};
constexpr std::array medias{"equiangular", "area-first", "march"};

template <class Names>
std::string list(const Names& names) {
  std::string result;
  for (const char* name : names) result += (result.empty() ? "" : ", ") + std::string(name);
  return result;
}

template <class Enumeration, class Names>
Enumeration find(const Names& names, std::string_view wanted, const char* what) {
  for (std::size_t i = 0; i < names.size(); ++i)
    if (wanted == names[i]) return static_cast<Enumeration>(i);
  throw std::invalid_argument("unknown " + std::string(what) + " '" + std::string(wanted) + "' (known: " + list(names) +
                              ")");
}

}  // namespace

Choice choice_named(std::string_view name) { return find<Choice>(choices, name, "choice of lights"); }
Strategy strategy_named(std::string_view name) { return find<Strategy>(strategies, name, "strategy"); }
Media media_named(std::string_view name) { return find<Media>(medias, name, "way to sample media"); }

const char* name(Choice choice) { return choices[static_cast<std::size_t>(choice)]; }
const char* name(Strategy strategy) { return strategies[static_cast<std::size_t>(strategy)]; }
const char* name(Media media) { return medias[static_cast<std::size_t>(media)]; }

std::string choice_names() { return list(choices); }
std::string strategy_names() { return list(strategies); }
std::string media_names() { return list(medias); }

}  // namespace wavefront
