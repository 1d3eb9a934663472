# Ipopt comes without CMake files, and its pkg-config module asks for LAPACK's headers as well.
# Target IPOPT::IPOPT; IPOPT_INCLUDE_DIRS, IPOPT_LIBRARIES. The headers are <Ip*.hpp>.
find_path(IPOPT_INCLUDE_DIR IpIpoptApplication.hpp PATH_SUFFIXES coin-or coin)
find_library(IPOPT_LIBRARY ipopt)
mark_as_advanced(IPOPT_INCLUDE_DIR IPOPT_LIBRARY)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(IPOPT REQUIRED_VARS IPOPT_LIBRARY IPOPT_INCLUDE_DIR)

if(IPOPT_FOUND)
  set(IPOPT_INCLUDE_DIRS ${IPOPT_INCLUDE_DIR})
  set(IPOPT_LIBRARIES ${IPOPT_LIBRARY})
  if(NOT TARGET IPOPT::IPOPT)
    add_library(IPOPT::IPOPT UNKNOWN IMPORTED)
    # The headers of 3.11 do not compile without this definition.
    set_target_properties(IPOPT::IPOPT PROPERTIES
      IMPORTED_LOCATION ${IPOPT_LIBRARY}
      INTERFACE_INCLUDE_DIRECTORIES ${IPOPT_INCLUDE_DIR}
      INTERFACE_COMPILE_DEFINITIONS HAVE_CSTDDEF)
  endif()
endif()
