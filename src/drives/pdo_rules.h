#pragma once

#include "fourwis_navigation/drives/object_dictionary.h"

namespace fourwis::drives
{

/// The rules of CiA 301 for writing 14xx, 16xx, 18xx and 1Axx. A COB-ID can change only while bit 31 disables the PDO.
/// A mapping can change only then and while its sub-index 0 is zero. When sub-index 0 is set, the mapped objects must
/// exist, be mappable in this direction, have the given length, and fit into eight bytes.
AbortCode pdo_abort_code(const ObjectDictionary& dictionary, ObjectAddress address, std::int64_t value);

}  // namespace fourwis::drives
