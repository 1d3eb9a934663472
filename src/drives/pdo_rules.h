#pragma once

#include "fourwis_navigation/drives/object_dictionary.h"

namespace fourwis::drives
{

/// CiA 301's rules for writing 14xx, 16xx, 18xx and 1Axx: a COB-ID changes only while bit 31 takes the PDO away, a
/// mapping only then and while its sub-index 0 is zero, and what sub-index 0 then counts must exist, be mappable in
/// this direction, have the length it says, and fit into eight bytes.
AbortCode pdo_refusal(const ObjectDictionary& dictionary, ObjectAddress address, std::int64_t value);

}  // namespace fourwis::drives
