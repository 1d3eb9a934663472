#include "fourwis_navigation/search/search_options.h"

#include "fourwis_navigation/model/option_check.h"

namespace fourwis
{

void check(const SearchOptions& options)
{
  check_ranges(options);
}

}  // namespace fourwis
