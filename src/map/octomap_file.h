#pragma once

#include <cstddef>
#include <string>

#include "input_file.h"

namespace fourwis
{

/// The header of an OctoMap file and where its nodes begin.
struct OctomapHeader
{
  bool is_binary = false;   ///< .bt, two bits per child, rather than .ot, every node in full
  std::string id;           ///< type of the tree
  long long nodes = -1;     ///< as many as the header announces
  double resolution = 0.0;  ///< [m]
  std::size_t data = 0;     ///< position of the first node
};

/// Throws MapFileError.
OctomapHeader read_octomap_header(const InputFile& file);

/// Walks the nodes without building them. Throws MapFileError when they are not a complete tree of the announced size:
/// the OctoMap library trusts its input, and recurses without end or reads garbage on a damaged file.
void check_octomap_nodes(const InputFile& file, const OctomapHeader& header);

}  // namespace fourwis
