#pragma once

#include <optional>
#include <string>

namespace fourwis
{

/// The decimal number that a text begins with, whatever the locale of the process is.
double decimal(const std::string& text);

/// A decimal number and nothing else: "0.02", "2e-2", ".5", "-5.". None for a leading zero: "010" is another number to YAML.
std::optional<double> number_in_text(const std::string& text);

/// Degrees as rosparam reads them from deg(30), in radians; the text is what stands between the parentheses.
std::optional<double> degrees_in_text(const std::string& text);

/// Radians as rosparam reads them from rad(pi/2): numbers and pi, joined by + - * and /.
std::optional<double> radians_in_text(const std::string& text);

}  // namespace fourwis
