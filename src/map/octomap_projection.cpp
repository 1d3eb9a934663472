#include "fourwis_navigation/map/octomap_projection.h"

#include <octomap/ColorOcTree.h>
#include <octomap/OcTree.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "fourwis_navigation/model/home_path.h"
#include "fourwis_navigation/model/option_check.h"
#include "octomap_file.h"

namespace fourwis
{
namespace
{

/// Indices of voxels along one axis, both ends included; voxel k covers [k, k + 1] resolutions.
struct Interval
{
  int first = std::numeric_limits<int>::max();
  int last = std::numeric_limits<int>::min();

  bool is_empty() const { return last < first; }
  long long size() const { return static_cast<long long>(last) - first + 1; }
  bool overlaps(const Interval& other) const { return first <= other.last && other.first <= last; }

  void include(const Interval& other)
  {
    first = std::min(first, other.first);
    last = std::max(last, other.last);
  }
};

constexpr int center_key = 1 << 15;  ///< the tree's key of the voxel that begins at 0

/// The voxels a leaf fills.
struct Block
{
  Interval x, y, z;
  bool is_occupied = false;
};

/// The voxels that share more than a face with the band. A band that ends on a face, give or take rounding, does not
/// reach into the next voxel.
Interval voxels_in(const HeightBand& band, double resolution)
{
  constexpr double rounding = 1e-6;
  const auto to_index = [](double k) { return static_cast<int>(std::clamp<double>(k, -center_key, center_key)); };
  return {to_index(std::floor(band.min / resolution + rounding)),
          to_index(std::ceil(band.max / resolution - rounding) - 1.0)};
}

template <typename Tree>
Block block_of(const Tree& tree, const typename Tree::leaf_iterator& leaf)
{
  const octomap::OcTreeKey corner = leaf.getIndexKey();
  const int size = 1 << (tree.getTreeDepth() - leaf.getDepth());
  const auto along = [&](unsigned axis) {
    const int first = corner[axis] - center_key;
    return Interval{first, first + size - 1};
  };
  return {along(0), along(1), along(2), tree.isNodeOccupied(*leaf)};
}

/// The leaves that overlap the band.
template <typename Tree>
std::vector<Block> blocks_in(const Tree& tree, const Interval& band)
{
  std::vector<Block> blocks;
  const auto end = tree.end_leafs();
  for (auto leaf = tree.begin_leafs(); leaf != end; ++leaf)
  {
    const Block block = block_of(tree, leaf);
    if (block.z.overlaps(band)) blocks.push_back(block);
  }
  return blocks;
}

template <typename Tree>
std::vector<Block> read_blocks(const InputFile& file, const OctomapHeader& header, const HeightBand& band)
{
  Tree tree(header.resolution);
  std::istringstream nodes(file.bytes.substr(header.data));
  if (header.nodes > 0) header.is_binary ? tree.readBinaryData(nodes) : tree.readData(nodes);
  return blocks_in(tree, voxels_in(band, header.resolution));
}

/// An all unknown grid over the blocks, on the tree's lattice.
OccupancyGrid empty_grid(const InputFile& file, const std::vector<Block>& blocks, const Interval& x, const Interval& y,
                         double resolution)
{
  if (blocks.empty()) file.reject("data", "expected known voxels in the height band, got none");
  if (x.size() > max_map_cells / y.size())
    file.reject("data", "expected at most " + std::to_string(max_map_cells) + " cells, got " +
                            std::to_string(x.size()) + " x " + std::to_string(y.size()));
  OccupancyGrid grid{static_cast<int>(x.size()), static_cast<int>(y.size()), resolution, {}, {}};
  grid.origin = {x.first * resolution, y.first * resolution, 0.0};
  grid.data.assign(static_cast<std::size_t>(x.size() * y.size()), -1);
  return grid;
}

OccupancyGrid project(const InputFile& file, const std::vector<Block>& blocks, double resolution)
{
  Interval x, y;
  for (const Block& block : blocks)
  {
    x.include(block.x);
    y.include(block.y);
  }
  OccupancyGrid grid = empty_grid(file, blocks, x, y, resolution);
  for (const Block& block : blocks)
  {
    const std::int8_t value = block.is_occupied ? 100 : 0;
    for (int row = block.y.first - y.first; row <= block.y.last - y.first; ++row)
    {
      const auto cell = grid.data.begin() + static_cast<std::ptrdiff_t>(row) * grid.width + block.x.first - x.first;
      std::transform(cell, cell + block.x.size(), cell, [value](std::int8_t known) { return std::max(known, value); });
    }
  }
  return grid;
}

}  // namespace

void check(const HeightBand& band)
{
  check_ranges(band);
  if (band.max <= band.min)
    reject_option("max_height", to_text(band.max), "more than min_height, " + to_text(band.min) + " m");
}

OccupancyGrid project_octomap_file(const std::string& path, const HeightBand& band)
{
  check(band);
  const InputFile file = read_input_file(expand_home(path), max_map_bytes);
  const OctomapHeader header = read_octomap_header(file);
  check_octomap_nodes(file, header);
  // A binary file of any type holds no colours.
  const bool is_coloured = header.id == "ColorOcTree" && !header.is_binary;
  const std::vector<Block> blocks = is_coloured ? read_blocks<octomap::ColorOcTree>(file, header, band)
                                                : read_blocks<octomap::OcTree>(file, header, band);
  return project(file, blocks, header.resolution);
}

}  // namespace fourwis
