#pragma once

#include <ostream>

namespace fourwis
{

/// The program `plan`: reads its arguments, plans, writes the outputs asked for. Returns the exit status: 0 a verified
/// plan, 1 no plan, 2 unusable input. `out` gets the JSON of `--json -` or the help and nothing else, `err`
/// one line for a person.
int plan_command(int argc, const char* const* argv, std::ostream& out, std::ostream& err);

}  // namespace fourwis
