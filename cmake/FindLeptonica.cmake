# Leptonica's own CMake files are not in Debian's package, and no pkg-config is asked for.
# Target Leptonica::Leptonica; LEPTONICA_INCLUDE_DIRS, LEPTONICA_LIBRARIES. The header is <leptonica/allheaders.h>.
find_path(LEPTONICA_INCLUDE_DIR leptonica/allheaders.h)
find_library(LEPTONICA_LIBRARY NAMES lept leptonica)
mark_as_advanced(LEPTONICA_INCLUDE_DIR LEPTONICA_LIBRARY)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Leptonica REQUIRED_VARS LEPTONICA_LIBRARY LEPTONICA_INCLUDE_DIR)

if(Leptonica_FOUND)
  set(LEPTONICA_INCLUDE_DIRS ${LEPTONICA_INCLUDE_DIR})
  set(LEPTONICA_LIBRARIES ${LEPTONICA_LIBRARY})
  if(NOT TARGET Leptonica::Leptonica)
    add_library(Leptonica::Leptonica UNKNOWN IMPORTED)
    set_target_properties(Leptonica::Leptonica PROPERTIES
      IMPORTED_LOCATION ${LEPTONICA_LIBRARY}
      INTERFACE_INCLUDE_DIRECTORIES ${LEPTONICA_INCLUDE_DIR})
  endif()
endif()
