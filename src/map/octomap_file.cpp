#include "octomap_file.h"

#include <cmath>
#include <cstring>
#include <sstream>

namespace fourwis
{
namespace
{

constexpr int tree_depth = 16;

/// Walks a tree's nodes, depth first as they are stored.
class NodeWalk
{
public:
  NodeWalk(const InputFile& file, const OctomapHeader& header)
    : file_(file),
      position_(header.data),
      payload_(header.id == "ColorOcTree" ? 7 : 4)
  {}

  long long count() const { return count_; }

  /// A node of a .bt file that has children: two bits for each, 0 unknown, 1 free, 2 occupied, 3 has children.
  void binary(int depth)
  {
    const char* bytes = take(2, depth + 1);  // its children lie one deeper
    const unsigned codes = static_cast<unsigned char>(bytes[0]) | static_cast<unsigned char>(bytes[1]) << 8;
    if (codes == 0) file_.reject("data", "damaged, expected an inner node to have children");
    ++count_;
    for (int child = 0; child < 8; ++child)
    {
      const unsigned code = codes >> (2 * child) & 3U;
      if (code == 3)
        binary(depth + 1);
      else if (code != 0)
        ++count_;
    }
  }

  /// A node of a .ot file: log odds, for coloured trees the colour, then one bit for each child.
  void full(int depth)
  {
    const char* bytes = take(payload_ + 1, depth);
    float log_odds = 0.0F;
    std::memcpy(&log_odds, bytes, sizeof log_odds);
    if (!std::isfinite(log_odds)) file_.reject("data", "damaged, expected finite log odds");
    ++count_;
    for (int child = 0; child < 8; ++child)
    {
      if (static_cast<unsigned char>(bytes[payload_]) >> child & 1) full(depth + 1);
    }
  }

private:
  const char* take(std::size_t size, int depth)
  {
    if (depth > tree_depth) file_.reject("data", "damaged, expected a tree of depth " + std::to_string(tree_depth));
    if (file_.bytes.size() - position_ < size) file_.reject("data", "truncated, expected more nodes");
    position_ += size;
    return file_.bytes.data() + position_ - size;
  }

  const InputFile& file_;
  std::size_t position_;
  std::size_t payload_;
  long long count_ = 0;
};

/// Reads "key value" lines up to "data"; unknown keys and comments are skipped, as the library does.
void read_fields(std::istream& lines, OctomapHeader& header)
{
  for (std::string line; std::getline(lines, line);)
  {
    std::istringstream words(line);
    std::string key;
    words >> key;
    if (key == "data")
    {
      header.data = static_cast<std::size_t>(lines.tellg());
      return;
    }
    if (key == "id")
      words >> header.id;
    else if (key == "size" && !(words >> header.nodes))
      header.nodes = -1;
    else if (key == "res")
      words >> header.resolution;
  }
}

}  // namespace

OctomapHeader read_octomap_header(const InputFile& file)
{
  constexpr std::size_t longest_header = 4096;
  std::istringstream lines(file.bytes.substr(0, longest_header));
  std::string first;
  std::getline(lines, first);
  OctomapHeader header;
  header.is_binary = first.compare(0, 28, "# Octomap OcTree binary file") == 0;
  if (!header.is_binary && first.compare(0, 21, "# Octomap OcTree file") != 0)
    file.reject("format", "expected an OctoMap file (.bt or .ot)");
  read_fields(lines, header);
  if (header.data == 0 || header.data > file.bytes.size())
    file.reject("data", "missing, expected the nodes after the header");
  if (header.nodes < 0) file.reject("size", "expected a number of nodes");
  if (!(header.resolution > 0.0) || !std::isfinite(header.resolution * (1 << tree_depth)))
    file.reject("res", "expected a finite number above 0");
  if (header.id != "OcTree" && header.id != "ColorOcTree" && header.id != "OcTreeStamped")
    file.reject("id", "expected OcTree, ColorOcTree or OcTreeStamped, got " + quoted(header.id));
  return header;
}

void check_octomap_nodes(const InputFile& file, const OctomapHeader& header)
{
  NodeWalk walk(file, header);
  if (header.nodes > 0) header.is_binary ? walk.binary(0) : walk.full(0);
  if (walk.count() != header.nodes)
    file.reject("size", "expected " + std::to_string(header.nodes) + " nodes, got " + std::to_string(walk.count()));
}

}  // namespace fourwis
