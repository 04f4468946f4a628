// The renderer's choices and the names by which they are asked for.
#pragma once

#include <string>
#include <string_view>

namespace wavefront {

/// What a light is chosen in proportion to: nothing, its power, or its solid angle from the point times its radiance.
enum class Choice { uniform, power, solid_angle };

/// Where directions come from: the lights, the scattering function of the surface (or the phase function), or both,
/// combined by the balance heuristic (Veach and Guibas 1995).
enum class Strategy { light, bsdf, mis };

/// Where on a camera ray light is gathered; see medium_stage.h.
enum class Media { equiangular, area_first, march };

/// Throw std::invalid_argument, which lists the names there are.
Choice choice_named(std::string_view name);
Strategy strategy_named(std::string_view name);
Media media_named(std::string_view name);

const char* name(Choice choice);
const char* name(Strategy strategy);
const char* name(Media media);

/// The names, separated by commas.
std::string choice_names();
std::string strategy_names();
std::string media_names();

}  // namespace wavefront
